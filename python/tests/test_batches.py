# SPDX-License-Identifier: MIT
"""Many designs at once: the numbers of each are those of one design alone."""

import camlaw as cl
import numpy as np
import pytest
from conftest import PROBLEMS

ROLLER = PROBLEMS / "cams/roller_least_base.toml"


def test_many_designs_at_once_are_those_that_are_proved_one_by_one():
    problem = cl.Problem.load(ROLLER)
    radii = np.linspace(30, 110, 7)
    table = problem.evaluate_many({"base_radius": radii})
    for i, radius in enumerate(radii):
        one = problem.evaluate(base_radius=radius)
        for name in ("pressure_angle", "contact_stress", "pitch_curvature", "drive_torque"):
            assert table[f"highest {name}"][i] == pytest.approx(
                one[name].highest, rel=1e-9, abs=1e-9
            )
            assert table[f"lowest {name}"][i] == pytest.approx(one[name].lowest, rel=1e-9, abs=1e-9)
        assert table["outer_radius"][i] == pytest.approx(one["outer_radius"], rel=1e-12)
        margins = one.margins
        assert table["margin of undercut"][i] == pytest.approx(
            margins.loc["undercut", "margin"], rel=1e-9
        )
    few = problem.evaluate_many(
        {"base_radius": radii, "roller_radius": [8.0]}, ["peak pressure_angle"]
    )
    assert np.allclose(few["peak pressure_angle"], table["peak_pressure_angle"], rtol=1e-12)
    with pytest.raises(cl.InputError, match="outside"):
        problem.evaluate_many({"base_radius": [1e6]})
    with pytest.raises(cl.InputError, match="did you mean|known|near"):
        problem.evaluate_many({"base_radios": [50.0]})


@pytest.mark.parametrize(
    "file",
    [
        "cams/flat_least_base.toml",
        "cams/oscillating_least_peak_angle.toml",
        "die_press/least_approach.toml",
        "own/slider_crank.toml",
        "motions/in_step.toml",
        "geneva/fastest.toml",
        "follower_train/quiet_rise.toml",
    ],
)
def test_many_designs_of_any_machine_are_those_that_are_proved(file):
    problem = cl.Problem.load(PROBLEMS / file)
    starts = {row["name"]: [row["start"]] for row in problem._native.variables()}
    table, one = problem.evaluate_many(starts), problem.evaluate()
    for name, row in one._rows.items():
        if not row["curve"]:
            assert table[name][0] == pytest.approx(row["value"], rel=1e-8, nan_ok=True), name
            continue
        size = max(abs(row["highest"]), abs(row["lowest"]), 1e-12)
        if np.isfinite(size):
            for side in ("highest", "lowest"):
                assert abs(table[f"{side} {name}"][0] - row[side]) <= 1e-9 * size, (side, name)


def test_many_designs_have_the_margins_of_one():
    # Not a number where the machine is not possible, several limits on one response, a curve that
    # jumps, and laws of which not all have the variables.
    press = cl.Problem.example("die_press/least_approach")
    design = {"alpha": -9.59026476, "roller_radius": 73.8021307, "spring_preload": 189.5533567}
    one, many = press.evaluate(design), press.evaluate_many(design)
    for limit in one._limits:
        margin = np.asarray(many[f"margin of {limit['name']}"])[0]
        assert np.isnan(margin) == np.isnan(limit["margin"])
    for name in ("cams/tolerances", "index_drives/parallel_eight", "sheet_delivery/front"):
        problem = cl.Problem.example(name)
        starts = {row["name"]: row["start"] for row in problem._native.variables()}
        if name == "sheet_delivery/front":
            assert len(problem.evaluate_many(starts)) >= 1
            continue
        many = problem.evaluate_many(starts)
        for limit in problem.evaluate()._limits:
            margin = np.asarray(many[f"margin of {limit['name']}"])[0]
            assert margin == pytest.approx(limit["margin"], rel=1e-6, abs=1e-6), limit["name"]
