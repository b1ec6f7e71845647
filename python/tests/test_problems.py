# SPDX-License-Identifier: MIT
import pickle
import tomllib

import camlaw as cl
import numpy as np
import pytest
from camlaw import units
from conftest import PROBLEMS, program, program_json, same

ROLLER = PROBLEMS / "cams/roller_least_base.toml"


def roller(**changes):
    stated = dict(
        mechanism="disc-cam-roller",
        title="Least base circle of a disc cam with a roller follower",
        constants={
            "stroke": "30 mm",
            "roller_radius": "8 mm",
            "speed": "200 rpm",
            "mass": "1.2 kg",
            "spring_rate": "6 N/mm",
            "spring_preload": "60 N",
        },
        program=[
            {"name": "rise", "angle": "80 deg", "law": "cycloidal"},
            {"name": "high", "angle": "60 deg"},
            {"name": "return", "angle": "100 deg", "law": cl.law("modified-sine")},
            {"name": "low"},
        ],
        variables={"base_radius": {"lower": "10 mm", "upper": "120 mm", "start": "60 mm"}},
        objective="base_radius",
        constraints={
            "pressure_angle": ("-40 deg", "30 deg"),
            "undercut": {"upper": 0.8},
            "follower_force": ("0 N", None),
        },
        buildable={"require": True},
    )
    return cl.Problem(**(stated | changes))


def without_design(facts):
    return {key: value for key, value in facts.items() if key not in ("design", "checksum")}


def test_a_problem_of_dicts_is_the_one_of_the_file():
    ours, theirs = roller().optimize(), cl.Problem.load(ROLLER).optimize()
    assert same(without_design(ours.facts), without_design(theirs.facts))


def test_the_tables_of_every_problem_file_are_taken():
    files = sorted(p for p in PROBLEMS.rglob("*.toml") if "published" not in p.parts)
    seen = set()
    for path in files:
        tables = tomllib.loads(path.read_text(encoding="utf-8"))
        seen |= set(tables)
        ours = cl.Problem(**tables, source=str(path))
        assert ours.check().facts == cl.Problem.load(path).check().facts, path
    assert {"machine", "profile", "cams", "cases", "parts", "ranges"} <= seen


def test_the_table_of_a_profile_is_stated():
    text = (PROBLEMS / "cams/tolerances.toml").read_text(encoding="utf-8")
    tables = tomllib.loads(text)
    assert "profile" in tables
    path = str(PROBLEMS / "cams/tolerances.toml")
    without = cl.Problem(**{k: v for k, v in tables.items() if k != "profile"}, source=path)
    assert cl.Problem(**tables, source=path).text != without.text
    with pytest.raises(cl.InputError, match="profile"):
        cl.Problem(**(tables | {"profile": {"wavines": "2 um"}}), source=path)
    with pytest.raises(cl.InputError, match="machine: 'mine' is neither"):
        cl.Problem(machine="mine")


def test_quantities_of_pint_are_taken_with_their_units():
    units = pytest.importorskip("pint").UnitRegistry()
    constants = {
        "stroke": 3 * units.cm,
        "roller_radius": 8 * units.mm,
        "speed": 200 * units.rpm,
        "mass": 1200 * units.g,
        "spring_rate": 6 * units.N / units.mm,
        "spring_preload": 60 * units.N,
    }
    assert roller(constants=constants).constants == pytest.approx(roller().constants, rel=1e-12)
    with pytest.raises(cl.InputError, match="a length is needed"):
        roller(constants={"stroke": 3 * units.kg})
    many = roller().evaluate_many({"base_radius": np.array([5, 6]) * units.cm}, ["outer_radius"])
    assert many["base_radius"].tolist() == [50, 60]
    with pytest.raises(cl.InputError, match="a length is needed"):
        roller().evaluate_many({"base_radius": np.array([5, 6]) * units.s})


def test_errors_have_the_line_and_what_is_accepted():
    with pytest.raises(cl.InputError, match=r"constants.stroke.*a length is needed"):
        roller(constants={"stroke": "30 N"})
    with pytest.raises(cl.InputError, match="roller_radius"):
        roller(constants={"roler_radius": "8 mm"})
    with pytest.raises(cl.InputError, match="nothing.toml"):
        cl.Problem.load("nothing.toml")
    with pytest.raises(cl.InputError, match="is not a number"):
        roller(constants={"stroke": object()})
    with pytest.raises(cl.InputError, match="outside"):
        cl.Problem.load(ROLLER).evaluate(base_radius="5 m")


def test_texts_of_any_kind_come_through_the_statement():
    title = 'A "roller" \\ of \u00fcmlauts \u043a\u0443\u043b\u0430\u0447\u043e\u043a'
    assert roller(title=title).title == title


def test_an_evaluation_is_the_programs():
    problem = cl.Problem.load(ROLLER)
    found = problem.evaluate(base_radius="55 mm")
    assert found["outer_radius"] == pytest.approx(85, abs=1e-6)
    angle = found["pressure_angle"]
    assert angle.proved and angle.highest < 30 and angle.unit == "deg"
    assert found.feasible and not problem.evaluate(base_radius=20).feasible
    theirs = program_json("evaluate", ROLLER, "--set", "base_radius=55 mm")
    assert angle.highest == theirs["responses"]["pressure_angle"]["highest"]
    for name, row in theirs["responses"].items():
        mine = found[name]
        value = row.get("value")
        assert (
            (mine == value or value in ("inf", None))
            if "value" in row
            else mine.lowest == row["lowest"] or row["lowest"] is None
        )
    with pytest.raises(cl.InputError, match="the machine has no response 'nonsense'; it has"):
        found["nonsense"]


def test_the_proofs_of_an_evaluation_end_after_a_time_limit(tmp_path):
    text = (PROBLEMS / "cams/elastic_valve.toml").read_text()
    text = text.replace('speed = "900 rpm"\n', "").replace('lower = "20 N"', 'lower = "-900 N"')
    path = tmp_path / "valve.toml"
    path.write_text(text + "[ranges.speed]\nlower = '600 rpm'\nupper = '900 rpm'\n")
    problem = cl.Problem.load(path)
    found = problem.evaluate(time_limit=1e-3)
    assert found.facts["cut_short"] and not found.margins.loc["lowest elastic_force", "proved"]
    assert found.margins.loc["lowest elastic_force", "undecided"]["to"] > 0
    whole = problem.evaluate(time_limit="10 min")
    assert whole.facts["cut_short"] == "" and whole.margins.loc["lowest elastic_force", "proved"]
    with pytest.raises(cl.InputError, match="time_limit: 0 s is not above zero"):
        problem.evaluate(time_limit=0)


def test_a_check_says_what_the_program_says():
    text = program("check", ROLLER)
    assert text.startswith(str(cl.Problem.load(ROLLER).check()).rstrip("\n"))


def test_derivatives_scaling_and_formulas_are_told():
    problem = cl.Problem.load(ROLLER)
    assert problem.check_derivatives()["agrees"].all()
    assert "base_radius" in problem.scaling().index
    text = program("mechanisms", "disc-cam-roller", "--formula", "pressure_angle")
    assert text.startswith(problem.formula("pressure_angle").rstrip("\n"))
    assert problem.formula("pressure_angle") == cl.mechanism("disc-cam-roller").formula(
        "pressure_angle"
    )


def test_curves_are_those_of_the_programs_table(tmp_path):
    program("evaluate", ROLLER, "--curves", tmp_path / "curves.csv")
    theirs = np.genfromtxt(tmp_path / "curves.csv", delimiter=",", names=None, skip_header=1)
    mine = cl.Problem.load(ROLLER).curves()
    assert np.array_equal(np.column_stack([mine[name] for name in mine]), theirs, equal_nan=True)


def test_without_pandas_tables_are_dicts_of_arrays(monkeypatch):
    import sys

    monkeypatch.setitem(sys.modules, "pandas", None)
    curves = cl.Problem.load(ROLLER).curves(36)
    assert isinstance(curves, dict) and len(curves["pressure_angle [deg]"]) == 37
    assert "<table>" in cl.Problem.load(ROLLER).evaluate()._repr_html_()


def test_problems_and_laws_go_to_other_processes():
    problem = cl.Problem.load(ROLLER).set(base_radius="55 mm")
    again = pickle.loads(pickle.dumps(problem))
    assert again.evaluate()["pressure_angle"] == problem.evaluate()["pressure_angle"]
    law = cl.law("modified-sine", crossover=0.42)
    assert pickle.loads(pickle.dumps(law)) == law


def test_a_law_of_any_kind_is_taken_and_goes_along(tmp_path):
    cl.law("modified-sine", crossover=0.42).save(tmp_path / "own.json")
    own = cl.law_file(tmp_path / "own.json")
    x = np.linspace(0, 1, 101)
    fitted = cl.fit(
        {"angle [deg]": x, "lift [mm]": np.round(cl.law("cycloidal")(x).s, 5)}, law="cycloidal"
    ).law
    for law in (own, fitted):
        program = [{"name": "rise", "angle": "80 deg", "law": law},
                   {"name": "return", "law": "cycloidal"}]  # fmt: skip
        problem = roller(program=program, objective=None, variables=None)
        assert problem.evaluate()["displacement"].highest == pytest.approx(30)
        assert pickle.loads(pickle.dumps(problem)) == problem
        problem.save(tmp_path / "problem.toml")
        again = cl.Problem.load(tmp_path / "problem.toml")
        assert again.evaluate()["pressure_angle"] == problem.evaluate()["pressure_angle"]
        again.save(tmp_path / "problem.toml")
    (tmp_path / "own.json").write_text("{}")
    with pytest.raises(cl.InputError, match="is there already"):
        roller(program=[{"name": "rise", "angle": "80 deg", "law": own},
                        {"name": "return", "law": "cycloidal"}]).save(tmp_path / "other.toml")  # fmt: skip
    assert not (tmp_path / "other.toml").exists()


def test_problems_to_begin_with():
    for name in ("disc-cam-roller", "geneva"):
        problem = cl.Problem.new(name)
        assert problem.text == program("new", name) and problem.mechanism == name
        assert problem.check().text
    text = roller().text
    assert text.startswith('format = "camlaw problem 1"\n')
    assert tomllib.loads(text)["format"] == "camlaw problem 1"
    with pytest.raises(cl.InputError, match="camlaw problem 2.*newer than this program"):
        roller(format="camlaw problem 2")
    assert cl.Problem.example("cams/roller_least_base").text == ROLLER.read_text()
    assert "smallest base circle" in cl.examples().loc["cams/roller_least_base", "about"]
    with pytest.raises(cl.InputError, match="roller_least_base"):
        cl.Problem.example("roller_least_bas")


def test_variations_are_stated_and_a_search_begins_at_a_result():
    varied = roller(variation={"base_radius": "0.05 mm", "roller_radius": {"plus": "0.02 mm"}})
    stated = roller().tolerance({"base_radius": "0.05 mm"}, samples=64)
    assert varied.tolerance(samples=64).worst.shape == stated.worst.shape
    assert "+0.05/-0.05" in varied.check().text or "+-0.05" in varied.check().text
    first = roller().optimize()
    again = roller().optimize(start=first, starts=1)
    assert again["base_radius"] == pytest.approx(first["base_radius"], rel=1e-9)


def test_one_of_several_cams_is_exported():
    shaft = cl.Problem.load(PROBLEMS / "shaft/two_cams.toml")
    with pytest.raises(cl.InputError, match="such as cam="):
        shaft.export(format="csv")
    first, *_ = tomllib.loads(shaft.text)["cams"]
    assert "profile" in shaft.export(format="csv", cam=first)


def test_mechanisms_are_listed():
    assert "disc-cam-roller" in cl.mechanisms()
    cam = cl.mechanism("disc-cam-roller")
    assert cam.parameters.loc["stroke", "unit"] == "mm"
    assert "pressure_angle" in cam.responses.index
    with pytest.raises(cl.InputError):
        cl.mechanism("no-such-cam")


def test_load_cases_and_ranges_are_stated_as_in_a_file():
    cases = roller(
        cases=[{"name": "slow", "speed": "60 rpm"}, {"name": "fast", "speed": "240 rpm"}],
        constants={"stroke": "30 mm", "roller_radius": "8 mm", "mass": "1.2 kg",
                   "spring_rate": "6 N/mm", "spring_preload": "60 N"},
    )  # fmt: skip
    result = cases.optimize()
    assert result.verdict == "certified optimum"
    names = list(result.margins.index)
    assert "slow.follower_force" in names and "fast.follower_force" in names
    eased = cases.set({"pressure_angle.upper": "35 deg", "fast.speed": "200 rpm"}).optimize()
    assert eased["base_radius"] < result["base_radius"]
    with pytest.raises(cl.InputError, match="no limit"):
        cases.set({"pressure_angel.upper": "35 deg"})

    ranged = roller(
        ranges={"speed": ("60 rpm", "240 rpm")},
        constants={"stroke": "30 mm", "roller_radius": "8 mm", "mass": "1.2 kg",
                   "spring_rate": "6 N/mm", "spring_preload": "60 N"},
    )  # fmt: skip
    found = ranged.optimize()
    assert found.verdict == "certified optimum"
    assert found["base_radius"] == pytest.approx(result["base_radius"], rel=1e-6)


def test_a_quantity_without_a_unit_is_no_size():
    pint = pytest.importorskip("pint")
    u = pint.UnitRegistry()
    problem = cl.Problem.example("cams/roller_least_base")
    for wrong in (u.Quantity(25, ""), u.Quantity(1.5, "m/m")):
        with pytest.raises(cl.InputError):
            problem.set(stroke=wrong)
    assert problem.set(mass=u.Quantity(7500, "carat")).constants["mass"] == pytest.approx(1.5)
    assert problem.set(stroke=u.Quantity(25, "mm")).constants["stroke"] == 25
    assert problem.set(speed=u.Quantity(300, "rpm")).constants["speed"] == 300
    assert cl.law("modified-sine", crossover=u.Quantity(0.4, "")) == cl.law(
        "modified-sine", crossover=0.4
    )
    angles = problem.evaluate_many({"rise_angle": u.Quantity([80.0, 90.0], "deg")})
    plain = problem.evaluate_many({"rise_angle": [80.0, 90.0]})
    column = "highest pressure_angle"
    assert list(np.asarray(angles[column])) == list(np.asarray(plain[column]))


def test_files_in_folders_are_saved_with_a_problem(tmp_path):
    (tmp_path / "laws").mkdir()
    cl.law("modified-sine", crossover=0.4).save(tmp_path / "laws/mine.json")
    text = cl.Problem.example("cams/flat_least_base").text
    (tmp_path / "p.toml").write_text(text.replace('law = "', 'law = "laws/mine.json" # "', 1))
    problem = cl.Problem.load(tmp_path / "p.toml")
    problem.save(tmp_path / "elsewhere.toml")
    (tmp_path / "a").mkdir()
    outside = text.replace('law = "', 'law = "../laws/mine.json" # "', 1)
    (tmp_path / "a/p.toml").write_text(outside)
    cl.Problem.load(tmp_path / "a/p.toml").save(tmp_path / "a/p2.toml")
    (tmp_path / "b/c").mkdir(parents=True)
    with pytest.raises(cl.InputError, match="outside the folder"):
        cl.Problem.load(tmp_path / "a/p.toml").save(tmp_path / "b/c/p.toml")
    (tmp_path / "new").mkdir()
    problem.save(tmp_path / "new/p.toml")
    assert cl.Problem.load(tmp_path / "new/p.toml").law.C_a == problem.law.C_a


def test_memory_as_a_quantity():
    pint = pytest.importorskip("pint")
    size = pint.UnitRegistry().Quantity(4, "GB")
    assert units.size_in_bytes(size) == 4e9
    with pytest.raises(cl.InputError, match="is not a size"):
        units.size_in_bytes(pint.UnitRegistry().Quantity(4, "m"))
    with pytest.raises(cl.InputError, match="is not a size above zero"):
        units.size_in_bytes("1e999 GB")


def test_memory_and_records_that_cannot_be():
    problem = cl.Problem.example("spine_cutter/front")
    with pytest.raises(cl.InputError, match="memory: -1 is not a size above zero"):
        problem.pareto(memory=-1)
    with pytest.raises(FileNotFoundError):
        problem.pareto(record="/nowhere/study.db")


def test_pictures_are_those_of_the_program(tmp_path):
    name = PROBLEMS / "cams/roller_least_base.toml"
    program("evaluate", str(name), "--svg", str(tmp_path / "c.svg"), "--profile", str(tmp_path / "p.svg"))
    problem = cl.Problem.load(name)
    assert problem.svg() == (tmp_path / "c.svg").read_text()
    assert problem.svg(tmp_path / "q.svg", profile=True) == (tmp_path / "p.svg").read_text()
    assert (tmp_path / "q.svg").read_text() == (tmp_path / "p.svg").read_text()
    program("law", "cycloidal", "--svg", str(tmp_path / "l.svg"))
    assert cl.law("cycloidal").svg() == (tmp_path / "l.svg").read_text()
    page = program("mechanisms", "disc-cam-roller", "--formulas")
    assert cl.mechanism("disc-cam-roller").formulas() == page
    study = tmp_path / "study.db"
    front = cl.Problem.example("spine_cutter/front").pareto(points=4, record=study)
    program("front", str(study), "--svg", str(tmp_path / "f.svg"))
    assert front.svg() == (tmp_path / "f.svg").read_text()
    for wrong in (lambda: cl.law("x\n"), lambda: problem.set(stroke="30 mm\n")):
        with pytest.raises(cl.InputError, match="control characters"):
            wrong()


def test_none_is_not_a_constant():
    with pytest.raises(cl.InputError, match="constants.stroke: None is not a value"):
        cl.Problem(mechanism="disc-cam-roller", constants={"stroke": None}, law="cycloidal")
