# SPDX-License-Identifier: MIT
"""Fronts by other executors than our own processes: the same, whatever happens to their workers."""

import multiprocessing
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor

import pytest

import camlaw as cl
from camlaw import executors
from conftest import ROOT, needs, same

CUTTER = ROOT / "problems/spine_cutter/front.toml"


@pytest.fixture(scope="module")
def facts():
    """Of the front that one process of ours finds."""
    return cl.Problem.load(CUTTER).pareto(points=8, workers=1).facts


def found(executor, **how):
    return cl.Problem.load(CUTTER).pareto(points=8, executor=executor, **how)


def pool():
    return ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn"))


@pytest.fixture(scope="module")
def dask():
    distributed = needs("distributed")
    with (
        distributed.LocalCluster(
            n_workers=2,
            threads_per_worker=1,
            processes=True,
            host="127.0.0.1",
            dashboard_address=None,
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


def test_dasks_workers_find_the_same_front(dask, facts):
    assert same(found(dask).facts, facts)


def test_threads_find_the_same_front(facts):
    with ThreadPoolExecutor(3) as threads:
        assert same(found(threads).facts, facts)


@pytest.mark.full
def test_a_pool_of_processes_and_dasks_own_executor(dask, facts):
    with pool() as processes:
        assert same(found(processes).facts, facts)
    assert same(found(dask.get_executor()).facts, facts)


def tolerances():
    """The example without its errors of the profile, which take longer than all parts of a yield."""
    return cl.Problem.from_text(cl.Problem.example("cams/tolerances").text.partition("[profile]")[0])


def test_others_count_the_parts_of_a_yield():
    problem = tolerances()
    alone = problem.tolerance(samples=8000, workers=1).facts
    with ThreadPoolExecutor(2) as threads:
        assert problem.tolerance(samples=8000, executor=threads).facts == alone
    found = cl.Problem.example("cams/roller_least_base").optimize().design
    sizes = {"base_radius": "0.05 mm", "roller_radius": "0.02 mm"}
    with ThreadPoolExecutor(2) as threads:
        shared = found.tolerance(sizes, samples=4096, executor=threads)
    assert shared.facts == found.tolerance(sizes, samples=4096, workers=2).facts


def test_a_yield_goes_on_with_its_record(tmp_path):
    problem = tolerances()
    record = tmp_path / "yield.db"
    first = problem.tolerance(samples=8000, record=record)
    assert first.facts == problem.tolerance(samples=8000).facts
    with pytest.raises(cl.InputError, match="exists already"):
        problem.tolerance(samples=8000, record=record)
    with ThreadPoolExecutor(2) as threads:
        again = problem.tolerance(samples=8000, record=record, resume=True, executor=threads)
    assert again.facts == first.facts
    with pytest.raises(cl.InputError, match="made with seed 1, now it is 2"):
        problem.tolerance(samples=8000, seed=2, record=record, resume=True)
    with pytest.raises(cl.InputError, match="is a yield, not a sweep"):
        cl.Sweep.load(record)


@pytest.mark.full
def test_a_scheduler_and_workers_of_their_own(facts, tmp_path):
    """As on a cluster: each a program, over TCP; one worker joins late, and one is killed."""
    distributed = needs("distributed")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"tcp://127.0.0.1:{free.getsockname()[1]}"
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}

    def started(*words):
        command = [sys.executable, "-m", "distributed.cli." + words[0], *words[1:]]
        return subprocess.Popen(command, env=environment, cwd=tmp_path, stderr=subprocess.DEVNULL)

    def worker():
        return started("dask_worker", address, "--nthreads", "1", "--no-dashboard", "--no-nanny")

    programs = [
        started("dask_scheduler", "--host", "127.0.0.1", "--port", address.rpartition(":")[2],
                "--no-dashboard"),
        worker(),
    ]
    try:
        with distributed.Client(address, timeout=60) as client:
            client.wait_for_workers(1, timeout=60)
            late = threading.Timer(0.5, lambda: programs.append(worker()))
            killed = threading.Timer(4, lambda: programs[1].kill())
            late.start(), killed.start()
            slow = cl.Problem.example("cams/roller_front")
            front = slow.pareto(points=40, executor=client)
            late.join(), killed.join()
        assert same(front.facts, slow.pareto(points=40, workers=2).facts)
    finally:
        for program in programs:
            program.kill()


FULL_DISK = """
import resource, signal, sys
from concurrent.futures import ThreadPoolExecutor
import camlaw as cl

signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (60_000, resource.RLIM_INFINITY))
with ThreadPoolExecutor(2) as threads:
    try:
        cl.Problem.load(sys.argv[1]).pareto(points=8, executor=threads, record=sys.argv[2])
    except (cl.Error, OSError) as error:
        print(type(error).__name__, error)
"""


def test_a_record_whose_disk_is_full_goes_on_later(facts, tmp_path):
    record = tmp_path / "study.db"
    said = subprocess.run(
        [sys.executable, "-c", FULL_DISK, str(CUTTER), str(record)],
        capture_output=True, text=True, check=True, env=os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)},
    ).stdout
    assert "study.db" in said, said
    with ThreadPoolExecutor(2) as threads:
        front = found(threads, record=record, resume=True)
    assert front.facts["points"] == facts["points"]


class Killing(ProcessPoolExecutor):
    """A pool, one worker of which is killed when all have been started.

    Of one that is killed earlier Python 3.11 itself may start another while the pool breaks, and then
    waits for it for ever.
    """

    made = 0
    has_killed = False

    def submit(self, work, *rest):
        future = super().submit(work, *rest)
        if Killing.made <= 2 and not self.has_killed and len(self._processes) == 2:
            self.has_killed = True
            os.kill(next(iter(self._processes)), signal.SIGKILL)
        return future


def made_to_be_killed():
    Killing.made += 1
    return Killing(2, mp_context=multiprocessing.get_context("spawn"))


@pytest.mark.full
def test_a_pool_that_breaks_is_made_anew(facts):
    Killing.made = 0
    front = found(made_to_be_killed)
    assert Killing.made >= 3
    # What workers that were killed had looked at is not counted; the front is the same.
    assert same(front.facts, facts)


class Closing(Executor):
    """A pool of processes that breaks while it starts one: submit() says OSError."""

    made = 0

    def __init__(self):
        Closing.made += 1
        self.threads = ThreadPoolExecutor(1)

    def submit(self, work, *rest):
        if Closing.made <= 2:
            raise OSError("handle is closed")
        return self.threads.submit(work, *rest)

    def shutdown(self, wait=True, *, cancel_futures=False):
        self.threads.shutdown(wait, cancel_futures=cancel_futures)


def test_a_pool_that_breaks_while_it_starts_a_process_is_made_anew(facts):
    Closing.made = 1  # the first that is made then works
    assert same(found(Closing).facts, facts)
    Closing.made = 0
    with pytest.raises(cl.Error, match="OSError: handle is closed"):
        found(Closing)  # twice in a row is no accident


@pytest.mark.full
def test_a_pool_that_breaks_and_cannot_be_made_anew_is_an_error_and_the_record_goes_on(
    tmp_path, facts
):
    Killing.made = 0
    record = tmp_path / "study.db"
    with made_to_be_killed() as broken:
        with pytest.raises(cl.Error, match="BrokenProcessPool.*a function that makes an executor"):
            found(broken, record=record)
    assert same(found(None, workers=1, record=record, resume=True).facts, facts)


@pytest.mark.full
def test_workers_of_dask_that_are_killed_and_added_are_no_matter(dask):
    problem = cl.Problem.load(ROOT / "problems/cams/roller_front.toml")
    expected = problem.pareto(points=30, workers=1).facts
    workers = list(dask.run(os.getpid).values())

    def disturb():
        time.sleep(0.3)
        os.kill(workers[0], signal.SIGKILL)
        dask.cluster.scale(3)

    disturber = threading.Thread(target=disturb)
    disturber.start()
    front = problem.pareto(points=30, executor=dask)
    disturber.join()
    assert same(front.facts, expected)


class Altering(Executor):
    """Workers of another version, as far as they can tell."""

    def __init__(self, how):
        self.how = how

    def submit(self, work, problem, *rest):
        future = Future()
        future.set_result(work(self.how(problem), *rest))
        return future


def test_a_worker_of_another_version_is_refused_by_its_name():
    older = Altering(lambda problem: problem.replace(b"camlaw 0.1", b"camlaw 0.0"))
    with pytest.raises(cl.Error, match=f"on {socket.gethostname()}.*camlaw 0.0"):
        found(older)


def test_what_is_no_executor_is_refused():
    for wrong in (3, "dask"):
        with pytest.raises(cl.InputError, match="executor: (int|str) has no submit"):
            found(wrong)
    with ThreadPoolExecutor(1) as threads, pytest.raises(cl.InputError, match="workers"):
        found(threads, workers=2)


class Failing(Executor):
    def submit(self, work, *rest):
        future = Future()
        future.set_exception(ModuleNotFoundError("No module named 'camlaw'"))
        return future


def test_an_executor_whose_workers_have_no_camlaw_is_an_error():
    with pytest.raises(cl.Error, match="the executor failed: .*No module named 'camlaw'"):
        found(Failing())


def test_a_worker_keeps_what_it_has_read_of_a_problem(monkeypatch):
    sent = []

    class Keeping(Altering):
        def submit(self, work, *rest):
            sent.append(rest)
            return super().submit(work, *rest)

    found(Keeping(lambda problem: problem))
    assert len(sent) > 3
    began = time.perf_counter()
    first = executors.carry_out(*sent[0])
    again = executors.carry_out(*sent[0])
    assert first[0] == again[0] == "done"
    assert first[1] == again[1]
    assert time.perf_counter() - began < 60
