# SPDX-License-Identifier: MIT
"""Long work: it is told of, it can be stopped, and other threads go on meanwhile."""

import os
import signal
import subprocess
import sys
import threading
import time

import camlaw as cl
import pytest
from conftest import PROBLEMS

FRONT = PROBLEMS / "cams/roller_front.toml"
QUICK = PROBLEMS / "spine_cutter/front.toml"


def test_progress_is_told_and_ends_with_what_it_throws():
    told = []
    cl.Problem.load(QUICK).pareto(
        points=8, workers=2, progress=lambda done, words: told.append((done, words))
    )
    assert told and all(done is None or 0 <= done <= 1 for done, _ in told)
    assert any("searches" in words for _, words in told)

    def refuse(done, words):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        cl.Problem.load(QUICK).pareto(points=40, workers=2, progress=refuse)


def test_a_bar_is_shown_where_it_is_asked_for(capsys):
    pytest.importorskip("tqdm")
    cl.Problem.load(QUICK).pareto(points=12, workers=2, progress=True)
    assert "searches" in capsys.readouterr().err


def test_ctrl_c_stops_a_front_with_what_it_has(tmp_path):
    problem, record = cl.Problem.load(FRONT), tmp_path / "study.db"

    def interrupt():
        while not record.exists():  # which the study begins with
            time.sleep(0.01)
        time.sleep(0.5)
        os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=interrupt, daemon=True).start()
    began = time.monotonic()
    with pytest.raises(KeyboardInterrupt) as stopped:
        problem.pareto(points=400, workers=2, record=record)
    assert time.monotonic() - began < 60
    assert isinstance(stopped.value, cl.Interrupted)
    assert stopped.value.result is None or stopped.value.result.stopped
    assert cl.law("cycloidal").C_v == pytest.approx(2)  # all goes on


def test_a_time_limit_ends_a_front_with_what_it_has(tmp_path):
    problem, record = cl.Problem.load(FRONT), tmp_path / "study.db"
    began = time.monotonic()
    front = problem.pareto(points=400, workers=2, time_limit="1 s", record=record)
    assert time.monotonic() - began < 60
    assert front.stopped and not front.complete
    whole = cl.Problem.load(QUICK).pareto(points=6, workers=2, time_limit=600)
    assert not whole.stopped and len(whole) >= 6
    with pytest.raises(cl.InputError, match="time_limit: 0 s is not above zero"):
        problem.pareto(points=4, time_limit=0)


def test_limits_of_a_search_are_numbers_texts_and_quantities():
    problem = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml")
    alone = problem.optimize()
    for time_limit, memory in ((60, 4e9), ("1 min", "4 GB"), (60.0, "2 GiB"), ("60", None)):
        found = problem.optimize(time_limit=time_limit, memory=memory)
        assert found["base_radius"] == alone["base_radius"]
    with pytest.raises(cl.InputError, match="the search needs about"):
        problem.optimize(memory="1 kB")
    for wrong in ("4 apples", "much", True):
        with pytest.raises(cl.InputError):
            problem.optimize(memory=wrong)
    with pytest.raises(cl.InputError, match="time_limit"):
        problem.optimize(time_limit="3 mm")
    with pytest.raises(cl.InputError, match="above zero"):
        problem.optimize(time_limit=-1)
    for name, wrong in (("seed", -1), ("seed", 1.5), ("starts", 0), ("starts", True)):
        with pytest.raises(cl.InputError, match=f"{name}: {wrong}"):
            problem.optimize(**{name: wrong})
    for name, wrong in (("points", 1), ("points", 5.0), ("workers", 0)):
        with pytest.raises(cl.InputError, match=f"{name}: {wrong}"):
            cl.Problem.load(QUICK).pareto(**{name: wrong})


def without_files(facts):
    return {name: fact for name, fact in facts.items() if name not in ("wall_s", "seal")}


def test_the_workers_of_one_search_are_no_matter():
    press = cl.Problem.load(PROBLEMS / "die_press/least_approach.toml")
    one = press.optimize(workers=1)
    assert without_files(press.optimize(workers=2).facts) == without_files(one.facts)
    free = cl.Problem.load(PROBLEMS / "free_law/least_acceleration_at_jerk.toml")
    one = free.synthesize(workers=1)
    assert without_files(free.synthesize(workers=3).facts) == without_files(one.facts)
    worn = {"mechanism": "disc-cam-roller", "set": {"roller_radius": "8 mm"}}
    one = cl.fit(PROBLEMS / "cams/worn_cam.csv", workers=1, **worn)
    assert cl.fit(PROBLEMS / "cams/worn_cam.csv", workers=2, **worn).facts == one.facts


def test_a_number_of_workers_must_make_sense():
    press = cl.Problem.load(PROBLEMS / "die_press/least_approach.toml")
    for wrong in (0, -1, 257):
        with pytest.raises(cl.InputError, match="workers"):
            press.optimize(workers=wrong)
        with pytest.raises(cl.InputError, match="workers"):
            cl.fit(PROBLEMS / "cams/worn_cam.csv", mechanism="disc-cam-roller", workers=wrong)
        with pytest.raises(cl.InputError, match="workers"):
            cl.study("spine-cutter", workers=wrong)


def test_other_threads_run_while_a_search_does():
    counts, ended = [0], threading.Event()

    def count():
        while not ended.is_set():
            counts[0] += 1
            time.sleep(0.001)

    other = threading.Thread(target=count)
    other.start()
    before = counts[0]
    try:
        cl.Problem.load(QUICK).pareto(points=400, workers=1)
    finally:
        ended.set()
        other.join()
    assert counts[0] - before > 20


def test_several_threads_get_the_bits_that_one_gets():
    problem = cl.Problem.load(PROBLEMS / "cams/roller_least_base.toml")
    alone = problem.optimize()["base_radius"]
    found = []
    threads = [
        threading.Thread(target=lambda: found.append(problem.optimize()["base_radius"]))
        for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [alone] * 4


def test_a_yield_tells_how_far_it_is():
    told = []
    cl.Problem.load(PROBLEMS / "cams/tolerances.toml").tolerance(
        samples=400_000, progress=lambda done, words: told.append((done, words))
    )
    assert told and all(0 <= done <= 1 for done, _ in told)
    assert told[-1][1] == "parts of the yield"
