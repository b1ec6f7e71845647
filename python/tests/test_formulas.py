# SPDX-License-Identifier: MIT
import camlaw as cl
import numpy as np
import pytest
from camlaw import formulas as f
from conftest import PROBLEMS

ROLLER = PROBLEMS / "cams/roller_least_base.toml"


def pressure_angle(m):
    """Between the force and the follower's way."""
    height = m.stroke * m.s + f.sqrt(
        (m.base_radius + m.roller_radius) * (m.base_radius + m.roller_radius) - m.offset * m.offset
    )
    slope = m.stroke * (1 / (2 * m.pi)) * m.v
    return f.atan((slope - m.offset) / f.where_positive(height, height))


def test_the_pressure_angle_written_so_gives_the_built_in_bits():
    built_in = cl.Problem.load(ROLLER)
    name, own = "angle_of_pressure", cl.Response(pressure_angle, unit="deg")
    import tomllib

    table = tomllib.loads(built_in.text)
    mine = cl.Problem(**(table | {"program": table["program"], "responses": {name: own}}))
    for radius in (30, 52.6479193310059, 60, 111.1):
        one, other = (problem.evaluate(base_radius=radius) for problem in (mine, built_in))
        assert one[name][:4] == other["pressure_angle"][:4]
        assert one[name].proved
    columns = mine.curves(360)
    assert np.array_equal(columns[f"{name} [deg]"], columns["pressure_angle [deg]"])


def test_an_optimum_with_it_has_the_same_bits_and_verdict():
    import tomllib

    table = tomllib.loads(cl.Problem.load(ROLLER).text)
    for limit in table["constraints"]:
        if limit["response"] == "pressure_angle":
            limit["response"] = "angle_of_pressure"
    mine = cl.Problem(
        **table, responses={"angle_of_pressure": cl.Response(pressure_angle, "deg")}
    ).optimize()
    theirs = cl.Problem.load(ROLLER).optimize()
    assert mine["base_radius"] == theirs["base_radius"]
    assert mine.verdict == theirs.verdict == "certified optimum" and mine.is_global
    assert (
        mine.margins.loc["angle_of_pressure", "multiplier"]
        == theirs.margins.loc["pressure_angle", "multiplier"]
    )


def slider_crank():
    machine = cl.Machine(
        "slider-crank",
        moved_by="nothing",
        parameters={
            "crank_radius": {"symbol": "r", "unit": "mm", "default": 40, "lower": 1, "upper": 1000},
            "rod_length": {"symbol": "l", "unit": "mm", "default": 160, "lower": 1, "upper": 5000},
            "speed": {"unit": "rpm", "default": 120, "lower": 0, "upper": 3000},
            "slider_mass": {"unit": "kg", "default": 25, "lower": 0, "upper": 10000},
        },
    )

    @machine.response()
    def rod_sine(m):
        return m.crank_radius / m.rod_length * np.sin(m.angle)

    @machine.response()
    def rod_cosine(m):
        return f.sqrt(1 - m.rod_sine**2)

    @machine.response(unit="deg", meaning="between the rod and the slider's path")
    def rod_angle(m):
        return f.asin(m.rod_sine)

    @machine.response(unit="m/s2")
    def acceleration(m):
        ratio = m.r / m.l
        return (
            m.speed**2
            * m.r
            * (
                f.cos(m.angle)
                + ratio
                * (
                    f.cos(2 * m.angle) / m.rod_cosine
                    + ratio**2 * f.sin(2 * m.angle) ** 2 / (4 * m.rod_cosine**3)
                )
            )
        )

    @machine.response(unit="N")
    def inertia_force(m):
        return m.slider_mass * m.acceleration

    @machine.response(unit="N")
    def side_force(m):
        return m.inertia_force * f.tan(m.rod_angle)

    return machine


def test_a_machine_of_ones_own_is_optimised_as_the_files_is():
    mine = cl.Problem(
        slider_crank(),
        variables={"rod_length": ("90 mm", "400 mm")},
        objective="rod_length",
        constraints=[
            {"response": "peak inertia_force", "upper": "200 N"},
            {"response": "peak side_force", "upper": "20 N"},
            {"response": "rod_angle", "upper": "20 deg", "lower": "-20 deg"},
        ],
    )
    theirs = cl.Problem.load(PROBLEMS / "own/slider_crank.toml")
    one, other = mine.optimize(), theirs.optimize()
    assert (
        one["rod_length"] == other["rod_length"]
        and one.verdict == other.verdict == "certified optimum"
    )


def test_no_python_runs_while_a_search_does():
    calls = []

    def counted(m):
        calls.append(1)
        return m.base_radius + m.stroke

    problem = cl.Problem(
        mechanism="disc-cam-roller",
        constants={"stroke": 20},
        program=[
            {"name": "rise", "angle": 180, "law": "cycloidal"},
            {"name": "return", "angle": 180, "law": "cycloidal"},
        ],
        variables={"base_radius": (10, 90)},
        responses={"size": cl.Response(counted, "mm")},
        objective="size",
        constraints={"pressure_angle": (None, "30 deg")},
    )
    assert problem.optimize().verdict == "certified optimum" and calls == [1]


def test_formulas_are_written_with_their_order():
    a, b, c = (f.Expression(name) for name in "abc")
    written = {
        a + b + c: "a + b + c",
        a - (b - c): "a - (b - c)",
        (a + b) * c: "(a + b) * c",
        a / (b * c): "a / (b * c)",
        a / b / c: "a / b / c",
        -(a**2): "-a^2",
        (-a) ** 2: "(-a)^2",
        a**b**c: "a^(b^c)",
        2 * a: "2 * a",
        a * -2.5: "a * -2.5",
        1 - abs(a): "1 - abs(a)",
        f.quantity("9.81 m/s^2") * a: "9.81 [m/s^2] * a",
        f.root(0, 7, lambda y: y - a): "root(root_1, 0, 7, root_1 - a)",
        f.atan2(a, np.float64(2)): "atan2(a, 2.0)",
        np.sqrt(a): "sqrt(a)",
        np.float64(2) * a: "2.0 * a",
        f.select(a, b, 0): "select(a, b, 0)",
    }
    for expression, text in written.items():
        assert expression.text == text


def test_what_is_no_formula_is_refused():
    m = f.Names()
    with pytest.raises(cl.InputError, match="select"):
        cl.Response(lambda m: m.stroke if m.stroke > 1 else 0)
    with pytest.raises(cl.InputError, match="cannot be part of a formula"):
        m.stroke + "mm"
    with pytest.raises(cl.InputError, match="responses.wrong.formula.*different kinds"):
        cl.Problem(
            mechanism="disc-cam-roller",
            program=[
                {"name": "a", "angle": 180, "law": "cycloidal"},
                {"name": "b", "angle": 180, "law": "cycloidal"},
            ],
            responses={"wrong": cl.Response(lambda m: m.mass + m.stroke, "kg")},
        )


def test_formulas_that_cannot_be_recorded_are_refused_in_a_sentence():
    def doubled(m):
        e = m.contact_force
        for _ in range(60):
            e = e + e
        return e

    with pytest.raises(cl.InputError, match="response of its own"):
        cl.Problem(
            mechanism="disc-cam-roller",
            constants={"stroke": "30 mm"},
            program=[{"name": "rise", "angle": "120 deg", "law": "cycloidal"}, {"name": "low"}],
            variables={"base_radius": ("20 mm", "90 mm")},
            responses={"q": cl.Response(doubled, unit="N")},
            objective="peak q",
        )
    for number in (float("nan"), float("inf")):
        with pytest.raises(cl.InputError, match="finite number"):
            f.expression(number)
        with pytest.raises(cl.InputError, match="finite number"):
            f.quantity(number, "N")
    pint = pytest.importorskip("pint")
    u = pint.UnitRegistry()
    assert f.quantity(3.0 * u.N).text == f.quantity("3 N").text == f.quantity(3.0, "N").text
    machine = cl.Machine("toggle", moved_by="law", parameters={"mass": {"unit": "kg", "default": 1}})
    with pytest.raises(cl.InputError, match="unit"):

        @machine.response
        def force(m):
            return m.mass

    @machine.response(unit="kg")
    def weight(m):
        return m.mass

    with pytest.raises(cl.InputError, match="has a response 'weight' already"):
        machine.response(unit="kg")(weight)
