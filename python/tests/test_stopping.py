# SPDX-License-Identifier: MIT
"""Every long call ends at Ctrl-C within about a second, and lets other threads run meanwhile."""

import gc
import signal
import threading
import time
from contextlib import contextmanager

import camlaw as cl
import numpy as np
import pytest
from conftest import PROBLEMS

BUILDABLE = PROBLEMS / "cams/smallest_buildable.toml"


def rises_and_returns(number):
    """A problem of which everything takes a while: a cycle of so many rises and returns."""
    segments = [
        {"name": f"{motion}_{k}", "angle": f"{180 / number} deg", "law": "modified-sine"}
        for k in range(number)
        for motion in ("rise", "return")
    ]
    del segments[-1]["angle"]  # what is left of the turn
    return cl.Problem(
        mechanism="disc-cam-roller",
        constants={"stroke": "5 mm", "roller_radius": "8 mm", "speed": "20 rpm", "mass": "1 kg"},
        program=segments,
        variables={"base_radius": {"lower": "100 mm", "upper": "900 mm", "start": "400 mm"}},
        objective="base_radius",
        constraints={"pressure_angle": ("-40 deg", "30 deg"), "undercut": {"upper": 0.8}},
    )


@pytest.fixture(scope="module")
def many_segments():
    return rises_and_returns(50)


@pytest.fixture(scope="module")
def found(many_segments):
    return many_segments.optimize(time_limit=1)


@pytest.fixture(scope="module")
def front():
    return cl.Problem.load(PROBLEMS / "cams/roller_front.toml").pareto(points=8, workers=2)


def recorded(rows):
    """A recorded torque of so many rows, with noise."""
    machine = cl.Problem.load(PROBLEMS / "cams/recorded_torque.toml")
    curves = machine.curves(720)
    names = list(curves)
    angle = np.linspace(0, 360, rows, endpoint=False)
    torque = next(name for name in names if name.startswith("drive_torque"))
    value = np.interp(angle, np.asarray(curves[names[0]]), np.asarray(curves[torque]))
    noise = np.random.default_rng(1).normal(size=rows) * 0.05 * np.abs(value).max()
    return machine, {names[0]: angle, torque: value + noise}


def fit_of_a_recorded_curve(given):
    machine, table = recorded(20_000)
    return lambda: cl.fit(table, mechanism=machine, loss="huber")


def fit_of_a_motion(given):
    x = np.linspace(0, 1, 1800)
    lift = 20 * cl.law("cycloidal")(x).s + np.random.default_rng(1).normal(size=x.size) * 1e-3
    return lambda: cl.fit({"angle [deg]": 90 * x, "lift [mm]": lift})


def fit_of_a_cam(given):
    cam, roller = PROBLEMS / "cams/worn_cam.csv", {"roller_radius": "8 mm"}
    return lambda: cl.fit(cam, mechanism="disc-cam-roller", set=roller)


def check_of_derivatives(given):
    problem = cl.Problem.load(PROBLEMS / "spine_cutter/moving_front.toml")
    return problem.check_derivatives


def many_points_of_a_pickle(given):
    """A front that is unpickled: one of many times as many points, as that is short."""
    native = given("front")._native
    state = list(native.__getstate__())
    objectives, points, *others = state[3]
    state[3] = (objectives, 160 * points, *others)

    def load():
        type(native).__new__(type(native)).__setstate__(tuple(state))

    return load


#: Each makes a call that takes a while.
CALLS = {
    "evaluate": lambda given: given("many_segments").evaluate,
    "evaluate_many": lambda given: lambda: given("many_segments").evaluate_many(
        {"base_radius": np.linspace(200, 800, 100_000)}
    ),
    "check_derivatives": check_of_derivatives,
    "report of a problem": lambda given: given("many_segments").report,
    "export": lambda given: lambda: given("many_segments").export(
        format="json", tolerance="0.05 um", decimals=9
    ),
    "report of a result": lambda given: given("found").report,
    "verify": lambda given: given("found").verify,
    "report of a front": lambda given: given("front").report,
    "sensitivity": lambda given: lambda: given("front").sensitivity(0),
    "front of a pickle": many_points_of_a_pickle,
    "study": lambda given: lambda: cl.study("spine-cutter", workers=1),
    "study of what laws cost": lambda given: lambda: cl.study("sheet-delivery"),
    "reproduce": lambda given: lambda: cl.reproduce("cam-shape"),
    "cam_shape": lambda given: lambda: cl.cam_shape(20_000),
    "fit of a recorded curve": fit_of_a_recorded_curve,
    "fit of a motion": fit_of_a_motion,
    "fit of a cam": fit_of_a_cam,
    "fit of constants": lambda given: lambda: cl.fit_constants("C_v=1.6125, C_a=4.66, C_j=21.3"),
}


@contextmanager
def ctrl_c_after(seconds):
    """Ctrl-C, by a timer of the process: it comes while the library is at work."""

    def handler(number, frame):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, handler)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def slowness():
    """How many times as long as where the limits were stated this machine takes for the same work; 1 for
    less."""

    def seconds():
        began = time.process_time()
        sum(i * i for i in range(1_000_000))
        return time.process_time() - began

    return max(1, min(seconds() for _ in range(3)) / 0.031)


def stopped_by_ctrl_c(call, delay):
    """What Ctrl-C raises, and after how many seconds; nothing where the call had ended. Of a machine
    with other things to do those seconds count that this process was let work, and a third at least."""
    began, worked = time.monotonic(), time.process_time()
    try:
        with ctrl_c_after(delay):
            call()
    except KeyboardInterrupt as stopped:
        late = time.monotonic() - began - delay
        return stopped, min(late, max(late / 3, time.process_time() - worked - delay))
    return None, 0


@pytest.mark.parametrize("name", CALLS)
def test_ctrl_c_ends_a_long_call(name, request, many_segments):
    call = CALLS[name](request.getfixturevalue)
    # Where Python itself was at work, on a busy machine, the library had not begun.
    for delay in (0.05, 0.2, 0.8):
        stopped, late = stopped_by_ctrl_c(call, delay)
        if isinstance(stopped, cl.Interrupted):
            break
    assert isinstance(stopped, cl.Interrupted)
    assert late < 2 * slowness()  # a second, and as much again for what it waits for
    assert stopped.result is None
    assert cl.law("cycloidal").C_v == pytest.approx(2)  # all goes on
    assert len(many_segments.curves(36)) == 37


def test_a_fit_to_a_recorded_curve_keeps_its_time():
    machine, table = recorded(40_000)
    began = time.monotonic()
    found = cl.fit(table, mechanism=machine, loss="huber", time_limit=0.02)
    assert time.monotonic() - began < 60
    assert not found.trusted
    assert found.reason.startswith("the time limit of 0.02 s was reached before the fit had ended")
    assert found.machine.constants["mass"] > 0


def test_a_fit_whose_time_has_passed_says_so():
    machine, table = recorded(400)
    found = cl.fit(table, mechanism=machine, time_limit=1e-9)
    assert not found.trusted
    assert found.reason.startswith("the time limit of 1e-09 s was reached before the fit had ended")
    assert found.machine.constants["mass"] == machine.constants["mass"]
    with pytest.raises(cl.InputError, match="time_limit: 0 s is not above zero"):
        cl.fit(table, mechanism=machine, time_limit=0)
    with pytest.raises(cl.InputError, match="time_limit: -1 s is not above zero"):
        cl.fit(PROBLEMS / "cams/worn_cam.csv", mechanism="disc-cam-roller", time_limit=-1)


@contextmanager
def another_thread():
    """A thread of Python that looks at how long the process has worked; yields what it saw. What other
    tests have left behind is kept from the collector meanwhile, which holds the lock while it looks through
    all of that."""
    seen, ended = [], threading.Event()
    gc.collect()
    gc.freeze()

    def look():
        while not ended.is_set():
            seen.append(time.process_time())
            time.sleep(0.0005)

    other = threading.Thread(target=look)
    other.start()
    while not seen:
        time.sleep(0.001)
    try:
        yield seen
    finally:
        ended.set()
        other.join()
        gc.unfreeze()


BESIDE = {
    "evaluate": lambda problem, front: problem.evaluate(),
    "check": lambda problem, front: problem.check(),
    "check_derivatives": lambda problem, front: problem.check_derivatives(),
    "scaling": lambda problem, front: problem.scaling(),
    "curves": lambda problem, front: problem.curves(7200),
    "curves_figure": lambda problem, front: problem._native.curves_figure(),
    "profile_figure": lambda problem, front: problem._native.profile_figure(),
    "report": lambda problem, front: problem.report(),
    "export": lambda problem, front: problem.export(format="dxf"),
    "reading": lambda problem, front: cl.Problem.from_text(problem.text),
    "law": lambda problem, front: cl.law("modified-sine")(np.linspace(0, 1, 4_000_000)),
    "report of a front": lambda problem, front: front.report(),
    "words of a front": lambda problem, front: (front.facts, str(front)),
}


def held_up(call):
    """How long another thread waited at most while a call took so many seconds, both of the process's own
    work, and how often it ran."""
    with another_thread() as seen:
        time.sleep(0.005)
        began = time.process_time()
        while time.process_time() - began < 0.3:  # the same again where it is short
            call()
        ended = time.process_time()
    times = [began, *(t for t in seen if began < t < ended), ended]
    return max(b - a for a, b in zip(times, times[1:])), ended - began, len(times)


@pytest.mark.parametrize("name", BESIDE)
def test_other_threads_run_beside_a_call(name, front):
    call, some_segments = BESIDE[name], rises_and_returns(8)
    call(some_segments, front)  # what is done once is done
    # Held by the call, the lock would come free between two calls only, each time. A machine with other
    # things to do holds a thread up now and then.
    for _ in range(8):
        blocked, took, looks = held_up(lambda: call(some_segments, front))
        if blocked < max(0.1, 0.3 * took) and looks > 8:
            break
    assert blocked < max(0.1, 0.3 * took), (blocked, took)
    assert looks > 8
