# SPDX-License-Identifier: MIT
"""Studies on other machines: parcels of searches carried by an executor that exists already."""

from __future__ import annotations

import contextlib
import os
import socket
import threading
import time
from collections.abc import Iterator
from concurrent.futures import BrokenExecutor, CancelledError
from typing import Any

from .errors import Error, InputError
from .native import native

_desks = threading.local()


def carry_out(problem: bytes, parcel: int, orders: list[bytes]) -> tuple[Any, ...]:
    """A worker's part: what came of the orders, and the seconds that it took.

    parcel: makes the call unlike any other, so that no engine takes it for one that it has seen.
    """
    began = time.perf_counter()
    known = getattr(_desks, "known", None)
    if known is None or known[0] != problem:
        try:
            known = (problem, native.Desk(problem))
        except InputError as error:
            return ("refused", f"the worker {os.getpid()} on {socket.gethostname()}: {error}")
        _desks.known = known
    answers = known[1].carry_out(orders)
    return ("done", answers, time.perf_counter() - began)


def _is_dask(executor: Any) -> bool:
    return type(executor).__module__.split(".")[0] == "distributed"


@contextlib.contextmanager
def labour(executor: Any, workers: int | None) -> Iterator[Carrier | None]:
    """A carrier for an executor; None where processes of this machine do the work."""
    if executor is None:
        yield None
        return
    if workers is not None:
        raise InputError("workers: an executor has workers of its own; give one of the two")
    with contextlib.closing(Carrier(executor)) as carrier:
        yield carrier


def _end(executor: Any) -> None:
    """Shuts an executor down that was made here, which may be broken.

    A pool of processes that broke while it started one more process never ends that one, and waits
    for it when Python ends (seen in 3.11): the processes that it still has are killed.
    """
    if _is_dask(executor):
        executor.close()  # a client, whose workers may go on
        return
    processes = list((getattr(executor, "_processes", None) or {}).values())
    executor.shutdown(wait=False, cancel_futures=True)
    for process in processes:
        process.kill()


class Carrier:
    """What the library calls: sends parcels through an executor and puts down what arrives.

    executor: a client of Dask; any executor of concurrent.futures; or a function that makes one, which
    is called again where the executor breaks because a worker died.
    """

    def __init__(self, executor: Any) -> None:
        self._make = None
        if isinstance(executor, type) or not hasattr(executor, "submit"):
            if not callable(executor):
                raise InputError(
                    f"executor: {type(executor).__name__} has no submit(); a client of Dask, an executor "
                    "of concurrent.futures or a function that makes one is accepted"
                )
            self._make = executor
            executor = executor()
            if not (hasattr(executor, "submit") and hasattr(executor, "shutdown")):
                raise InputError(
                    f"executor: the function made a {type(executor).__name__}, which is not an executor of "
                    "concurrent.futures"
                )
        self._executor = executor
        self._broken: BaseException | None = None
        self._problem = b""
        self._futures: dict[int, Any] = {}
        self._lock = threading.RLock()
        self._counted = (float("-inf"), 1)
        self._arrivals: Any = None

    def begin(self, arrivals: Any, problem: bytes) -> None:
        """Before the first parcel: where parcels arrive, and what the orders are about."""
        self._arrivals = arrivals
        self._problem = problem

    def workers(self) -> int:
        """Orders that can be carried out at a time now. A client of Dask is asked once a second."""
        when, count = self._counted
        if time.monotonic() < when + 1:
            return count
        if _is_dask(self._executor) and hasattr(self._executor, "scheduler_info"):
            count = sum(self._threads_of_dask())
        else:
            count = getattr(self._executor, "_max_workers", None) or os.cpu_count() or 1
        self._counted = (time.monotonic(), max(1, count))
        return self._counted[1]

    def least_work(self) -> float:
        """Seconds of work in a parcel. Dask's client and scheduler take some 10 ms for one, in threads of
        their own, and work on the same processors where the workers are of this machine."""
        return 0.2 if _is_dask(self._executor) else 0.0

    def _threads_of_dask(self) -> list[int]:
        try:
            return list(self._executor.nthreads().values())
        except Exception as error:
            raise Error(f"the scheduler of Dask does not answer: {error}") from error

    def send(self, parcel: int, orders: list[bytes]) -> None:
        try:
            future = self._submitted(parcel, orders)
        except Exception as error:  # whatever an engine raises
            return self._failed(parcel, error)
        with self._lock:
            self._futures[parcel] = future
        future.add_done_callback(lambda done: self._arrived(parcel, done))

    def _submitted(self, parcel: int, orders: list[bytes]) -> Any:
        options = {"pure": False, "retries": 0} if _is_dask(self._executor) else {}
        work = (carry_out, self._problem, parcel, orders)
        try:
            return self._executor.submit(*work, **options)
        except (BrokenExecutor, OSError):
            # A pool of processes that is just breaking says OSError: its pipe is closed already when
            # it starts one more process.
            if self._make is None:
                raise
            _end(self._executor)
            self._executor = self._make()
            return self._executor.submit(*work)

    def _arrived(self, parcel: int, future: Any) -> None:
        with self._lock:
            known = self._futures.pop(parcel, None)
        try:
            what = future.result()
        except CancelledError as error:
            # By us, when the parcel is not waited for any more, or by the engine.
            if known is not None:
                self._broken = error
            return self._arrivals.put(parcel, died="the executor gave it up", deaths=0)
        except BaseException as error:  # whatever an engine raises
            return self._failed(parcel, error)
        if what[0] == "refused":
            self._arrivals.put(parcel, refused=what[1])
        else:
            self._arrivals.put(parcel, answers=what[1], seconds=what[2])

    def _failed(self, parcel: int, error: BaseException) -> None:
        why = f"{type(error).__name__}: {error}"
        if type(error).__name__ == "KilledWorker":
            # Dask has tried it already, on one worker after another. It blames all that waited there.
            deaths = int(getattr(error, "allowed_failures", 2)) + 1
            self._arrivals.put(parcel, died=why, deaths=deaths, shared=True)
        elif isinstance(error, BrokenExecutor) and self._make is not None:
            self._arrivals.put(parcel, died="a process of the executor ended", shared=True)
        else:
            self._broken = error
            self._arrivals.put(parcel, died=why, deaths=0)

    def check(self) -> None:
        """Raises what broke the executor."""
        if self._broken is None:
            return
        error, self._broken = self._broken, None
        again = "give a function that makes an executor: it is called again if one breaks"
        hint = f"; {again}" if isinstance(error, BrokenExecutor) else ""
        raise Error(f"the executor failed: {type(error).__name__}: {error}{hint}") from error

    def cancel(self) -> None:
        with self._lock:
            futures = list(self._futures.values())
            self._futures.clear()
        for future in futures:
            future.cancel()

    def close(self) -> None:
        """Drops what is under way, and ends an executor that was made here."""
        self.cancel()
        if self._make is not None:
            with contextlib.suppress(Exception):  # the study is done, whatever becomes of the engine
                _end(self._executor)
