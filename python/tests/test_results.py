# SPDX-License-Identifier: MIT
import json
import pickle
import sys

import camlaw as cl
import pytest
from conftest import PROBLEMS, program, program_json, same

FILES = [
    "cams/roller_least_base.toml",
    "cams/flat_least_base.toml",
    "spine_cutter/least_force.toml",
    "own/slider_crank.toml",
    "motions/in_step.toml",
    pytest.param("balancing_cam/fewest_springs.toml", marks=pytest.mark.full),
]


@pytest.fixture(scope="module")
def roller():
    return cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml").optimize()


@pytest.mark.parametrize("file", FILES)
def test_an_optimum_is_the_programs_digit_for_digit(file, tmp_path):
    path = f"problems/{file}"
    mine = cl.Problem.load(path).optimize()
    assert same(mine.facts, program_json("optimize", path))
    mine.save(tmp_path / "result.json")
    assert (tmp_path / "result.json").read_text() == program("optimize", path, "--json")


def test_a_synthesis_is_the_programs():
    path = "problems/free_law/least_acceleration_at_jerk.toml"
    mine = cl.Problem.load(path).synthesize()
    assert same(mine.facts, program_json("synthesize", path))
    with pytest.raises(
        cl.InputError, match="no law of the problem is free|no segment's law is free"
    ):
        cl.Problem.load("problems/spine_cutter/least_force.toml").synthesize()


def test_a_table_tells_how_far_each_law_is_from_a_free_one(tmp_path):
    path = tmp_path / "laws.toml"
    path.write_text(
        "mechanism = 'law'\n[law]\nname = ['cosine', 'polynomial-5']\n"
        "[objective]\nminimize = 'C_a'\n[[constraints]]\nresponse = 'C_v'\nupper = 1.9\n"
    )
    problem = cl.Problem.load(path)
    assert "from_free_law" not in problem.optimize().table.columns
    found = problem.optimize(table=True)
    theirs = program_json("optimize", str(path), "--table")
    assert same(found.facts, theirs)
    far = [row["from_free_law"] for row in theirs["table"]]
    assert list(found.table["from_free_law"]) == far and min(far) > 0
    assert str(pickle.loads(pickle.dumps(found)).table) == str(found.table)


def test_a_result_tells_its_design(roller):
    assert roller.verdict == "certified optimum" and roller.certified and roller.is_global
    assert roller["base_radius"] == roller.objective == roller.variables["base_radius"]
    assert roller["stroke"] == 30
    assert (
        roller.margins.loc["pressure_angle", "met"]
        and roller.margins.loc["undercut", "margin"] > 0.6
    )
    assert len(roller.curves) == 721
    assert roller.design.evaluate()["pressure_angle"].highest == pytest.approx(30, abs=1e-9)
    with pytest.raises(cl.InputError, match="it has base_radius"):
        roller["nonsense"]


def test_a_result_comes_back_from_its_file_and_its_claim_holds(roller, tmp_path):
    path = tmp_path / "result.json"
    roller.save(path)
    again = cl.Result.load(path)
    assert same(again.facts, roller.facts) and again.review == []
    for one in (roller, again):
        claim = one.verify()
        assert claim.holds and claim.claimed == claim.verdict == "certified optimum"
    theirs = program_json("verify", path)
    assert theirs["objective"] == again.verify().objective


def test_a_result_that_was_changed_is_not_believed(roller, tmp_path):
    path = tmp_path / "result.json"
    facts = json.loads(json.dumps(roller.facts))
    facts["design"]["variables"]["base_radius"] = 40.0
    path.write_text(json.dumps(facts))
    again = cl.Result.load(path)
    assert any("was changed after it was written" in words for words in again.review)
    assert not again.verify().holds


def test_how_to_search_can_be_told():
    problem = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml")
    result = problem.optimize(solver="ipopt", starts=2, seed=3, start={"base_radius": "80 mm"})
    assert result.facts["solver_asked"] == "ipopt" and result.facts["seed"] == 3
    assert result["base_radius"] == pytest.approx(52.6479193, rel=1e-7)
    with pytest.raises(cl.InputError, match="solver"):
        problem.optimize(solver="nonsense")
    with pytest.raises(cl.InputError, match="starts"):
        problem.optimize(starts=0)


def test_what_cannot_be_met_is_named():
    problem = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml")
    text = problem.text.replace('upper = "120 mm"', 'upper = "30 mm"').replace(
        'start = "60 mm"', 'start = "20 mm"'
    )
    result = cl.Problem.from_text(text).optimize()
    assert result.verdict == "infeasible" and "pressure_angle" in result.facts["blamed"]


def test_a_report_is_one_page(roller, tmp_path):
    page = roller.report(tmp_path / "cam.html")
    assert page.startswith("<!DOCTYPE html>") and "certified optimum" in page
    assert (tmp_path / "cam.html").read_text() == page
    assert "base_radius" in cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml").report()


@pytest.mark.parametrize(
    "ending, options",
    [
        ("dxf", []),
        ("csv", ["--step", "1 deg"]),
        ("svg", []),
        ("json", []),
        ("nc", ["--tolerance", "2 um", "--decimals", "5"]),
        ("nc", ["--lead", "6 mm", "--allowances", "0.5, 0.1 mm", "--unit", "mm"]),
        ("txt", ["--format", "codesys"]),
    ],
)
def test_exports_are_the_programs_byte_for_byte(roller, tmp_path, ending, options):
    source = tmp_path / "result.json"
    roller.save(source)
    theirs = tmp_path / f"theirs.{ending}"
    program("export", source, "--out", theirs, *options)
    told = dict(zip((name.removeprefix("--") for name in options[::2]), options[1::2]))
    cl.Result.load(source).export(tmp_path / f"mine.{ending}", **told)
    assert (tmp_path / f"mine.{ending}").read_text() == theirs.read_text()


def test_a_table_for_a_controller(roller):
    table = roller.export(format="table", step="0.5 deg")
    assert len(table.splitlines()) >= 720
    with pytest.raises(cl.InputError, match="no option 'colour'; it accepts allowances"):
        roller.export(format="csv", colour="red")
    with pytest.raises(cl.InputError, match="format"):
        roller.export()


def test_it_shows_itself(roller):
    assert "certified optimum" in roller._repr_html_() and "<table>" in roller._repr_html_()
    assert str(roller).splitlines()[1].startswith("certified optimum")
    pytest.importorskip("matplotlib").use("Agg")
    roller.plot()
    roller.plot_profile()


def test_tables_are_columns_without_pandas(monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    result = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml").optimize()
    margins = result.margins
    some = margins[["name", "bound", "met"]]
    assert list(some) == ["name", "bound", "met"] and some["bound"] is margins["bound"]
    assert repr(some).splitlines()[1].split() == ["pressure_angle", "30", "True"]
    with pytest.raises(KeyError):
        margins[["price"]]
    curves = result.curves
    assert len(repr(curves).splitlines()) == 43 and "(721 rows)" in repr(curves)
    assert "<table>" in margins._repr_html_()
    assert pickle.loads(pickle.dumps(some))["name"] == some["name"]


def test_a_changed_file_shows_what_its_design_is(tmp_path):
    found = cl.Problem.example("cams/roller_least_base").optimize()
    found.save(tmp_path / "r.json")
    value = repr(found["base_radius"])
    text = (tmp_path / "r.json").read_text()
    assert value in text
    (tmp_path / "t.json").write_text(text.replace(value, "50.0"))
    changed = cl.Result.load(tmp_path / "t.json")
    assert changed.review
    assert changed.verdict not in ("certified optimum", "feasible") and not changed.is_global
    limits = {row["name"]: row for row in changed.facts["constraints"]}
    assert limits["pressure_angle"]["margin"] < -0.9
    with pytest.warns(UserWarning, match="limit not met: pressure_angle"):
        assert "judged again" in changed.export(format="json")
    assert set(found.margins.columns) == set(changed.margins.columns)
    claim = json.loads(text)
    claim["variables"]["base_radius"] = -1
    claim["best_possible"] = 1
    (tmp_path / "v.json").write_text(json.dumps(claim))
    false = cl.Result.load(tmp_path / "v.json")
    assert false.variables["base_radius"] == found["base_radius"]
    assert false.facts["best_possible"] is None
    whole = cl.Result.load(tmp_path / "r.json")
    assert whole.certified and whole.review == []


def test_an_output_replaces_nothing_that_the_problem_is_read_from(tmp_path):
    law, file = tmp_path / "mine.json", tmp_path / "p.toml"
    cl.law("modified-sine", crossover=0.4).save(law)
    text = (PROBLEMS / "cams/roller_least_base.toml").read_text()
    file.write_text(text.replace('law = "cycloidal"', 'law = "mine.json"', 1))
    assert "mine.json" in file.read_text()
    problem = cl.Problem.load(file)
    (tmp_path / "out").mkdir()
    problem.optimize().save(tmp_path / "out" / "r.json")
    swept = problem.sweep(stroke="20,22 mm", evaluate=True)
    result = cl.Result.load(tmp_path / "out" / "r.json")
    moved = tmp_path / "moved.csv"
    moved.write_bytes(law.read_bytes())
    kept = {place: place.read_bytes() for place in (law, file, moved)}
    for call in (
        lambda: problem.svg(law),
        lambda: problem.export(law, format="csv"),
        lambda: problem.save(law),
        lambda: result.export(law, format="csv"),
        lambda: result.export(moved, format="csv"),
        lambda: result.save(law),
        lambda: result.design.svg(law),
        lambda: swept.csv(law),
    ):
        with pytest.raises(cl.InputError, match="the problem is read from"):
            call()
    with pytest.raises(cl.InputError, match="is the file that was read"):
        cl.law_file(law).svg(law)
    assert kept == {place: place.read_bytes() for place in kept}
    swept.csv(tmp_path / "sweep.csv")


def test_an_output_replaces_no_file_of_another_kind(roller, tmp_path):
    (tmp_path / "mine.toml").write_text(
        (PROBLEMS / "cams/roller_least_base.toml").read_text()
    )
    plain = tmp_path / "plain"
    plain.write_text((tmp_path / "mine.toml").read_text())
    roller.save(tmp_path / "result.json")
    kept = {file: file.read_bytes() for file in tmp_path.iterdir()}
    problem, named = cl.Problem.load(tmp_path / "mine.toml"), cl.Problem.load(plain)
    result = cl.Result.load(tmp_path / "result.json")
    for call, why in (
        (lambda: problem.export(tmp_path / "mine.toml", format="csv"), "ending of problem files"),
        (lambda: problem.svg(tmp_path / "mine.toml"), "ending of problem files"),
        (lambda: cl.law("cycloidal").svg(tmp_path / "mine.toml"), "ending of problem files"),
        (lambda: problem.report(tmp_path / "mine.toml"), "ends in .html"),
        (lambda: result.report(tmp_path / "result.json"), "ends in .html"),
        (lambda: result.export(tmp_path / "study.db", format="csv"), "ending of studies"),
        (lambda: result.export(tmp_path / "result.json"), "is the file that was read"),
        (lambda: named.export(plain, format="csv"), "is the file that was read"),
    ):
        with pytest.raises(cl.InputError, match=why):
            call()
    assert {file: file.read_bytes() for file in tmp_path.iterdir()} == kept
