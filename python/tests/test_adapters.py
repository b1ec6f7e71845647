# SPDX-License-Identifier: MIT
"""Problems within the real libraries of others."""

import camlaw as cl
import numpy as np
import pytest
from conftest import PROBLEMS, needs

ROLLER = PROBLEMS / "cams/roller_least_base.toml"
BEST = 52.64791933


def two_objectives():
    return cl.Problem.load(PROBLEMS / "cams/roller_front.toml")


def test_derivatives_are_those_of_differences():
    from camlaw.adapters.model import Model

    model = Model(two_objectives())
    x, step = model.start, 1e-5
    exact = np.vstack(model.derivatives(x))
    for k in range(len(x)):
        ahead, behind = x.copy(), x.copy()
        ahead[k] += step
        behind[k] -= step
        slope = (np.concatenate(model.values(ahead)) - np.concatenate(model.values(behind))) / (
            2 * step
        )
        assert np.allclose(exact[:, k], slope, rtol=1e-5, atol=1e-5)
    rows = model.values(np.array([x, x]))
    assert np.array_equal(rows[0][0], rows[0][1]) and rows[1].shape == (2, len(model.margins))


def test_scipy_finds_the_optimum():
    needs("scipy")
    from camlaw.adapters.scipy import ScipyObjective
    from scipy import optimize

    objective = ScipyObjective(cl.Problem.load(ROLLER))
    found = optimize.minimize(
        objective,
        objective.start,
        jac=objective.gradient,
        bounds=objective.bounds,
        constraints=objective.constraints,
        method="SLSQP",
    )
    assert found.success and found.x[0] == pytest.approx(BEST, abs=1e-5)
    assert objective.model.design(found.x + 1e-6).evaluate().feasible
    with pytest.raises(cl.InputError, match="objectives"):
        ScipyObjective(two_objectives())


def test_pymoo_finds_the_front():
    needs("pymoo")
    from camlaw.adapters.pymoo import PymooProblem
    from pymoo.algorithms.moo.nsga2 import NSGA2
    from pymoo.optimize import minimize

    problem = two_objectives()
    found = minimize(PymooProblem(problem), NSGA2(pop_size=24), ("n_gen", 12), seed=1)
    assert found.F is not None and found.F.shape[1] == 3
    assert np.all(found.G <= 1e-9)


def test_pygmo_finds_the_optimum():
    pygmo = needs("pygmo")
    from camlaw.adapters.pygmo import PygmoProblem

    problem = pygmo.problem(PygmoProblem(cl.Problem.load(ROLLER)))
    assert problem.get_nobj() == 1 and problem.get_nic() == len(
        PygmoProblem(cl.Problem.load(ROLLER)).model.margins
    )
    start = pygmo.population(problem, size=0)
    start.push_back([80.0])
    found = pygmo.algorithm(pygmo.nlopt("mma")).evolve(start)
    assert found.champion_x[0] == pytest.approx(BEST, abs=1e-4)


def test_openmdao_finds_the_optimum_and_believes_the_partials():
    needs("openmdao")
    import openmdao.api as om
    from camlaw.adapters.openmdao import CamlawComponent

    group = om.Problem(reports=False)
    cam = CamlawComponent(problem=cl.Problem.load(ROLLER))
    group.model.add_subsystem("cam", cam, promotes=["*"])
    group.driver = om.ScipyOptimizeDriver(optimizer="SLSQP", disp=False)
    group.model.add_design_var("base_radius", lower=10, upper=120)
    group.model.add_objective("objective_base_radius")
    for margin in ("pressure_angle_upper", "pressure_angle_lower", "undercut_upper"):
        group.model.add_constraint(f"margin_{margin}", lower=0)
    group.setup()
    group.run_driver()
    assert group.get_val("base_radius", units="mm")[0] == pytest.approx(BEST, abs=1e-4)
    checked = group.check_partials(out_stream=None, compact_print=True, step=1e-6)
    for of in checked["cam"].values():
        assert of["J_fwd"] == pytest.approx(of["J_fd"], abs=1e-3)
