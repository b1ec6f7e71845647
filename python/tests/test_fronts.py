# SPDX-License-Identifier: MIT
import threading

import camlaw as cl
import numpy as np
import pytest
from conftest import PROBLEMS, program, program_json, same

CUTTER = PROBLEMS / "spine_cutter/front.toml"


@pytest.fixture(scope="module")
def front():
    return cl.Problem.load(CUTTER).pareto(points=8, workers=2)


def test_a_front_is_the_programs(front):
    theirs = program_json("pareto", CUTTER, "--points", "8")
    assert same(front.facts, theirs)


def test_the_workers_are_no_matter_and_run_beside_numpys_threads(front):
    a = np.random.default_rng(1).normal(size=(400, 400))
    ended = threading.Event()

    def multiply():
        while not ended.is_set():
            a @ a

    others = [threading.Thread(target=multiply) for _ in range(2)]
    for other in others:
        other.start()
    try:
        beside = cl.Problem.load(CUTTER).pareto(points=8, workers=2)
    finally:
        ended.set()
        for other in others:
            other.join()
    assert same(beside.facts, front.facts) and beside.notes == []
    assert same(cl.Problem.load(CUTTER).pareto(points=8, workers=1).facts, front.facts)


def test_a_front_is_a_table_of_designs(front):
    assert len(front.table) == len(front) == len(list(front)) >= 8
    objectives = list(front.units)[:2]
    first, second = (np.asarray(front.table[name]) for name in objectives)
    assert np.all(np.diff(first) > 0) and np.all(np.diff(second) < 0)
    assert set(front.table["verdict"]) == {"certified optimum"}


def test_the_knee_is_a_result_of_its_own(front, tmp_path):
    knee = front.knee()
    assert knee.verdict == "certified optimum" and knee.verify().holds
    knee.save(tmp_path / "knee.json")
    assert cl.Result.load(tmp_path / "knee.json").review == []
    assert same(front[front.knee_index].facts, knee.facts)
    assert front.compromise([1, 1]).verdict == "certified optimum"
    with pytest.raises(IndexError):
        front[len(front)]
    assert "tolerance" in str(front.sensitivity(0)) or front.sensitivity(0).facts


def test_a_study_is_recorded_resumed_and_read(front, tmp_path):
    record = tmp_path / "study.db"
    problem = cl.Problem.load(CUTTER)
    few = problem.pareto(points=4, workers=2, record=record)
    assert len(few) < len(front)
    more = problem.pareto(points=8, workers=2, record=record, resume=True)
    assert np.array_equal(more.table[list(front.units)[0]], front.table[list(front.units)[0]])
    again = cl.Front.load(record)
    assert len(again) == len(front) and again.complete == front.complete
    assert again.csv() == more.csv()
    program("front", record, "--csv", tmp_path / "front.csv")
    assert (tmp_path / "front.csv").read_text() == more.csv()
    with pytest.raises(cl.InputError, match="study.db"):
        problem.pareto(points=4, record=record)


def test_it_shows_itself(front, tmp_path):
    assert "<table>" in front._repr_html_() and "hypervolume" in str(front)
    assert front.report(tmp_path / "front.html").startswith("<!DOCTYPE html>")
    pytest.importorskip("matplotlib").use("Agg")
    front.plot()


def test_what_is_asked_must_make_sense():
    problem = cl.Problem.load(CUTTER)
    for wrong in ({"points": 1}, {"workers": 0}, {"method": "magic"}, {"resume": True}):
        with pytest.raises(cl.InputError):
            problem.pareto(**wrong)
    with pytest.raises(cl.InputError, match="one objective|objectives"):
        cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml").pareto(points=4)
