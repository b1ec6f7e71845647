# SPDX-License-Identifier: MIT
"""Sweeps, tolerances and sensitivities of a problem: what the program says, digit for digit."""

import copy
import pickle
import sys
from concurrent.futures import ThreadPoolExecutor

import camlaw as cl
import pytest
from conftest import PROBLEMS, program_json, same

ROLLER = PROBLEMS / "cams/roller_least_base.toml"
TOLERANCES = PROBLEMS / "cams/tolerances.toml"
SWEPT = {"law": ["cycloidal", "modified-sine"], "stroke": "20:5:30 mm"}


@pytest.fixture(scope="module")
def sweep():
    return cl.Problem.load(ROLLER).sweep(SWEPT, workers=2)


def test_a_sweep_is_the_programs(sweep):
    theirs = program_json(
        "sweep", ROLLER, "--set", "law=cycloidal,modified-sine", "--set", "stroke=20:5:30 mm"
    )
    assert same(sweep.facts, theirs)
    assert len(sweep) == len(sweep.table) == 6 and not sweep.stopped


def test_a_combination_is_a_problem_with_its_design(sweep):
    design = sweep[sweep.best]
    assert design.evaluate().feasible
    with pytest.raises(IndexError, match="combination 6: there are 6, counted from 0"):
        sweep[6]


def test_a_sweep_goes_to_other_processes_with_its_designs(sweep):
    stopped = cl.Problem.load(ROLLER).sweep(SWEPT, workers=1, time_limit=1e-6)
    for one in (sweep, stopped):
        for again in (pickle.loads(pickle.dumps(one)), copy.copy(one), copy.deepcopy(one)):
            assert again == one and same(again.facts, one.facts) and again.notes == one.notes
            assert str(again) == str(one) and again.csv() == one.csv()
    again = pickle.loads(pickle.dumps(sweep))
    assert again[sweep.best] == sweep[sweep.best] and again != stopped
    assert again[-1] == sweep[5]


def test_a_sweep_is_read_from_its_record_and_begins_at_a_result(sweep, tmp_path):
    problem = cl.Problem.load(ROLLER)
    problem.sweep(SWEPT, workers=1, record=tmp_path / "sweep.db")
    assert cl.Sweep.load(tmp_path / "sweep.db") == sweep
    assert cl.Sweep.load(tmp_path / "sweep.db").notes == []
    problem.sweep(SWEPT, workers=1, record=tmp_path / "cut.db", time_limit=1e-6)
    assert cl.Sweep.load(tmp_path / "cut.db").stopped
    front = cl.Problem.load(PROBLEMS / "spine_cutter/front.toml")
    front.pareto(points=3, workers=1, record=tmp_path / "front.db")
    with pytest.raises(cl.InputError, match="Front.load"):
        cl.Sweep.load(tmp_path / "front.db")
    with pytest.raises(cl.InputError):
        cl.Front.load(tmp_path / "sweep.db")
    found = problem.optimize()
    swept = {"stroke": [29, 30]}
    begun = problem.sweep(swept, evaluate=True, workers=1, start=found)
    assert begun[1].constants["base_radius"] == found["base_radius"]
    at_design = found.design.sweep(swept, evaluate=True, workers=1)
    assert at_design[1].constants["base_radius"] == found["base_radius"]


def test_executors_and_records_give_the_same_sweep(sweep, tmp_path):
    problem = cl.Problem.load(ROLLER)
    with ThreadPoolExecutor(2) as threads:
        assert same(problem.sweep(SWEPT, executor=threads).facts, sweep.facts)
    record = tmp_path / "sweep.db"
    for resume in (False, True):
        again = problem.sweep(SWEPT, workers=1, record=record, resume=resume)
        assert same(again.facts, sweep.facts)


def test_samples_are_evaluated():
    sweep = cl.Problem.load(ROLLER).sweep(
        sample="sobol 8", over={"stroke": ("18 mm", "22 mm")}, evaluate=True
    )
    assert len(sweep) == 8 and sweep.facts["evaluated"]
    for wrong in ({"stroke": ("18 mm", "2 cm")}, {"stroke": 20}):
        with pytest.raises(cl.InputError, match="over: stroke"):
            cl.Problem.load(ROLLER).sweep(sample="sobol 8", over=wrong)
    with pytest.raises(cl.InputError, match="law: the list is empty"):
        cl.Problem.load(ROLLER).sweep({"law": []})


def test_sweeps_have_pages(sweep, tmp_path):
    assert "<html" in sweep.report(tmp_path / "sweep.html")
    assert sweep.csv().count("\n") == 7
    assert "cycloidal" in str(sweep) and "cycloidal" in sweep._repr_html_()


def test_a_tolerance_is_the_programs():
    ours = cl.Problem.load(TOLERANCES).tolerance(samples=4096)
    assert same(ours.facts, program_json("tolerance", TOLERANCES, "--samples", "4096"))
    assert ours.finished and 0 <= ours.failing <= 1 and len(ours.worst) >= 4
    stated = cl.Problem.load(ROLLER).tolerance({"base_radius": "0.1 mm"}, samples=64)
    theirs = program_json(
        "tolerance", ROLLER, "--tolerance", "base_radius=0.1 mm", "--samples", "64"
    )
    assert same(stated.facts, theirs)


def test_a_sensitivity_is_the_programs():
    ours = cl.Problem.load(ROLLER).sensitivity(over={"stroke": ("18 mm", "22 mm")}, samples=16)
    theirs = program_json(
        *("evaluate", ROLLER, "--sensitivity", "--over", "stroke=18:22 mm", "--samples", "16")
    )
    assert same(ours.facts["sensitivity"], theirs["sensitivity"])
    assert len(ours.derivatives) > 0 and len(ours.indices) > 0


def test_a_front_and_a_sweep_of_a_design_have_the_laws_of_its_segments():
    front = cl.Problem.load(PROBLEMS / "cams/roller_front.toml").pareto(points=3, workers=1)
    design = front[len(front) - 1].design
    law = next(w for w in str(front.facts["points"][-1]["law"]).split() if w.startswith("rise="))
    assert law.replace("=", ".law=") in design._native.found_settings()
    again = design.pareto(points=3, workers=1)
    assert all(law in point["law"].split() for point in again.facts["points"])
    swept = design.sweep({"stroke": ["30 mm", "31 mm"]}, evaluate=True)
    assert all(f"{law} " in one._native.laws()[0] for one in swept)


def test_a_sweep_is_parquet_with_types_and_units(sweep, tmp_path):
    arrow = pytest.importorskip("pyarrow")
    read = pytest.importorskip("pyarrow.parquet").read_table
    data = sweep.parquet(tmp_path / "sweep.parquet")
    assert (tmp_path / "sweep.parquet").read_bytes() == data
    assert [one.name for one in tmp_path.iterdir()] == ["sweep.parquet"]
    table = read(tmp_path / "sweep.parquet")
    rows = sweep.facts["combinations"]
    assert table.num_rows == len(rows) and table.column_names == list(rows[0])
    kinds = {field.name: field.type for field in table.schema}
    assert kinds["law"] == kinds["verdict"] == kinds["active"] == arrow.string()
    assert kinds["global"] == arrow.bool_()
    units = {
        field.name: field.metadata[b"unit"].decode()
        for field in table.schema
        if field.type == arrow.float64()
    }
    assert units["stroke [mm]"] == units["design base_radius [mm]"] == "mm"
    assert units["margin of pressure_angle [deg]"] == "deg"
    assert units["margin of undercut"] == units["evaluations"] == "1"
    assert set(units) == {name for name, value in rows[0].items() if type(value) in (int, float)}
    assert table.to_pylist() == rows
    assert table.schema.metadata[b"title"].decode() == sweep.facts["title"]


def test_parquet_has_null_where_a_combination_has_nothing(tmp_path):
    arrow = pytest.importorskip("pyarrow")
    read = pytest.importorskip("pyarrow.parquet").read_table
    problem = cl.Problem.load(ROLLER)
    stopped = problem.sweep(SWEPT, workers=1, time_limit=1e-6)
    table = read(arrow.BufferReader(stopped.parquet()))
    assert table.num_rows == len(stopped)
    for name, field in zip(table.column_names, table.schema):
        known = [row.get(name) for row in stopped.facts["combinations"]]
        got = table.column(name).to_pylist()
        assert [value is None for value in got] == [value is None for value in known]
        if name.startswith(("margin of", "design ")):
            assert field.type == arrow.float64()
    assert table.schema.field("verdict").type == arrow.string()


def test_parquet_without_pyarrow_says_what_is_missing(sweep, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(cl.MissingPackage, match="Parquet needs pyarrow.*pip install pyarrow"):
        sweep.parquet(tmp_path / "sweep.parquet")
    assert list(tmp_path.iterdir()) == []


def test_names_with_commas_are_swept_whole():
    from camlaw.sweeps import axes_of

    assert axes_of({"roller": ["A, long", "608-2RS"]}) == ['roller="A, long",608-2RS']
    assert axes_of({"law": ["legendre c=1,2", "cosine"]}) == ["law=legendre c=1,2,cosine"]
    assert axes_of({"speed": "60:15:120 rpm"}) == ["speed=60:15:120 rpm"]


def test_parts_are_swept_whatever_their_names_hold(tmp_path):
    names = ["608-2RS", "A, long", "10..20", '3/8" wide', "M:1", "M=1", "plain"]
    rows = (f"{name}; {k + 8}" for k, name in enumerate(names))
    (tmp_path / "rollers.csv").write_text("\n".join(["name; roller_radius [mm]", *rows]) + "\n")
    (tmp_path / "cam.toml").write_text(
        ROLLER.read_text().replace('roller_radius = "8 mm"\n', "")
        + "\n[parts.roller]\ncatalogue = 'rollers.csv'\n"
    )
    problem = cl.Problem.load(tmp_path / "cam.toml")
    swept = problem.sweep({"roller": names}, evaluate=True, workers=1)
    assert len(swept) == len(names) and swept.facts["designs"] == len(names)
    assert [swept[k].constants["roller_radius"] for k in range(len(names))] == list(range(8, 15))
    for k in (1, 2, 3, 4):
        one = problem.sweep({"roller": [names[k]], "stroke": [25, 30]}, evaluate=True, workers=1)
        assert one[0].constants["roller_radius"] == 8 + k
