# SPDX-License-Identifier: MIT
"""Searches and studies of a problem: the best design, fronts, sweeps, sensitivities, tolerances."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from . import units
from .arguments import flag, mapping, optional_text, optional_whole, record_path, shown, text, whole
from .errors import InputError, Interrupted
from .evaluations import Sensitivity, Tolerance
from .native import native
from .progress import Progress
from .progress import shown as shown_to

if TYPE_CHECKING:
    from .fronts import Front
    from .problems import Problem
    from .results import Result
    from .sweeps import Sweep

#: As many as the program takes.
_MOST_WORKERS = 256
_MOST_STARTS = 1_000_000
_MOST_POINTS = 100_000
_MOST_SEED = 2**63 - 1
_MOST_SOBOL = 1 << 20
_MOST_SAMPLES = 100_000_000


_Answer = TypeVar("_Answer")


def _carried_out(
    what: str,
    run: Callable[..., Any],
    question: tuple[Any, ...],
    answer: Callable[[Any], _Answer],
    how: tuple[int | None, Any, str | Path | None, bool, Any, Any, Progress],
) -> _Answer:
    """What a study of many searches finds: `run` of the question, carried out as `how` says (workers,
    executor, record, resume, time_limit, memory, progress). Raises Interrupted with what was found."""
    from .executors import labour

    workers, executor, record, resume, time_limit, memory, progress = how
    with labour(executor, workers) as carrier, shown_to(progress, what) as tell:
        found, interrupted = run(
            *question,
            optional_whole(workers, "workers", 1, _MOST_WORKERS),
            carrier,
            record_path(record),
            flag(resume, "resume"),
            units.seconds(time_limit),
            units.size_in_bytes(memory),
            tell,
        )
    result = answer(found)
    if interrupted:
        raise Interrupted(result)
    return result


class Searches:
    """The methods of Problem that may take long: they show progress, end at Ctrl-C and let other threads
    run."""

    _native: Any

    if TYPE_CHECKING:

        def set(self, values: Mapping[str, Any] | None = None, /, **more: Any) -> Problem: ...

    def _beginning_at(self, start: Mapping[str, Any] | Result | None) -> Any:
        """The problem with other starts, as the library has it."""
        from .results import Result

        if start is None:
            return self._native
        if isinstance(start, Result):
            return native.beginning_at(self._native, start._native)
        if not isinstance(start, Mapping):
            raise InputError(
                f"start: {shown(start)} is neither a dict of values by name nor a camlaw.Result"
            )
        return self.set(mapping(start, "start"))._native

    def _search(
        self,
        synthesize: bool,
        what: str,
        solver: str | None,
        starts: int | None,
        seed: int | None,
        time_limit: Any,
        memory: Any,
        workers: int | None,
        start: Mapping[str, Any] | Result | None,
        table: bool,
        progress: Progress,
    ) -> Result:
        from .results import Result

        problem = self._beginning_at(start)
        with shown_to(progress, what) as tell:
            found, interrupted = native.search(
                problem,
                synthesize,
                optional_text(solver, "solver"),
                optional_whole(starts, "starts", 1, _MOST_STARTS),
                optional_whole(seed, "seed", 0, _MOST_SEED),
                units.seconds(time_limit),
                units.size_in_bytes(memory),
                optional_whole(workers, "workers", 1, _MOST_WORKERS),
                flag(table, "table"),
                tell,
            )
        result = Result(found)
        if interrupted:
            raise Interrupted(result)
        return result

    def optimize(
        self,
        *,
        solver: str | None = None,
        starts: int | None = None,
        seed: int | None = None,
        time_limit: Any = None,
        memory: Any = None,
        workers: int | None = None,
        start: Mapping[str, Any] | Result | None = None,
        table: bool = False,
        progress: Progress = None,
    ) -> Result:
        """Finds the best design, with a verdict.

        Arguments that are left out are taken from the problem. starts: how many places to search from. start: the
        values to begin at, or a Result whose design to begin at. time_limit: seconds, or a text such as
        "1 min", after which the best design so far is the answer. memory: bytes that the search may
        use, or a text such as "4 GB". workers: processes that search side by side, from several starts
        and in several combinations of choices, if that takes longer than a few seconds; the result
        does not depend on them. table: searches once more with a free law in place of the laws to choose
        from, as --table of the program does; result.table then says how far each combination is from it.
        Ctrl-C raises Interrupted, whose result is the best design so far.
        """
        return self._search(
            False, "optimize", solver, starts, seed, time_limit, memory, workers, start, table, progress
        )

    def synthesize(
        self,
        *,
        solver: str | None = None,
        starts: int | None = None,
        seed: int | None = None,
        time_limit: Any = None,
        memory: Any = None,
        workers: int | None = None,
        start: Mapping[str, Any] | Result | None = None,
        table: bool = False,
        progress: Progress = None,
    ) -> Result:
        """Finds the best law for a problem with a free law. facts["rulers"] compares it with what is
        possible and with named laws. The arguments are those of optimize()."""
        return self._search(
            True, "synthesize", solver, starts, seed, time_limit, memory, workers, start, table, progress
        )

    def pareto(
        self,
        *,
        points: int = 50,
        workers: int | None = None,
        executor: Any = None,
        method: str = "auto",
        record: str | Path | None = None,
        resume: bool = False,
        start: Mapping[str, Any] | Result | None = None,
        time_limit: Any = None,
        memory: Any = None,
        progress: Progress = None,
    ) -> Front:
        """Finds the front of two or more objectives.

        workers: processes that search side by side; the front does not depend on them. They are new
        processes, so threads of this one do no harm. executor: carries the searches out
        instead, perhaps on other machines: a client of Dask, an executor of concurrent.futures, or a
        function that makes one, which is called again if the executor breaks; the front is the same
        (docs/scale.md). record: a file to which the study is written while it runs; with resume, what
        it has is not searched for again. start and memory: as in optimize(). time_limit: seconds, or a
        text such as "1 min", after which the answer is what was found, and is `stopped`.
        """
        from .fronts import Front

        return _carried_out(
            "pareto",
            native.pareto,
            (
                self._beginning_at(start),
                whole(points, "points", 2, _MOST_POINTS),
                text(method, "method"),
            ),
            Front,
            (workers, executor, record, resume, time_limit, memory, progress),
        )

    def sweep(
        self,
        values: Mapping[str, Any] | None = None,
        /,
        *,
        sample: str | None = None,
        over: Mapping[str, Any] | None = None,
        seed: int = 1,
        evaluate: bool = False,
        cold: bool = False,
        workers: int | None = None,
        executor: Any = None,
        record: str | Path | None = None,
        resume: bool = False,
        start: Mapping[str, Any] | Result | None = None,
        time_limit: Any = None,
        memory: Any = None,
        progress: Progress = None,
        **more: Any,
    ) -> Sweep:
        """Finds the best design for each combination of settings, as 'camlaw sweep' does.

        values: what is swept, by the names that set() accepts: {"speed": "60:15:120 rpm"} is from, step,
        to; {"law": ["cycloidal", "modified-sine"]} is a list of values, and the law "all" is every law;
        a single value is the same in all combinations. In a list the name of a part may hold anything.
        sample: "sobol 64" or "lhs 64" draws samples from the ranges of `over`, such as
        {"stroke": ("18 mm", "22 mm")}; seed is the seed of lhs. evaluate: evaluates the present
        design in each combination, without a search. cold: begins each search as optimize() does, not at
        the design of a neighbour. workers, executor, record, resume, start, time_limit and memory: as in
        pareto().
        """
        from .sweeps import Sweep, axes_of, ranges_of

        return _carried_out(
            "sweep",
            native.sweep,
            (
                self._beginning_at(start),
                axes_of({**mapping(values, "sweep"), **more}),
                optional_text(sample, "sample"),
                whole(seed, "seed", 0, _MOST_SEED),
                ranges_of(over),
                flag(evaluate, "evaluate"),
                flag(cold, "cold"),
            ),
            Sweep,
            (workers, executor, record, resume, time_limit, memory, progress),
        )

    def sensitivity(
        self,
        *,
        over: Mapping[str, Any] | None = None,
        samples: int = 512,
        seed: int = 1,
        progress: Progress = None,
    ) -> Sensitivity:
        """Finds how objective and limits depend on the parameters at the variables' starts.

        The answer has the exact derivative with respect to every parameter, and its elasticity. Sobol indices are taken
        over ranges: those of `over`, such as {"stroke": ("18 mm", "22 mm")}, or else the problem's, or
        else 1 % to either side.
        """
        from .sweeps import ranges_of

        with shown_to(progress, "sensitivity") as tell:
            return Sensitivity(
                native.sensitivity(
                    self._native,
                    ranges_of(over),
                    whole(samples, "samples", 16, _MOST_SOBOL),
                    whole(seed, "seed", 0, _MOST_SEED),
                    tell,
                )
            )

    def tolerance(
        self,
        tolerances: Mapping[str, Any] | None = None,
        /,
        *,
        samples: int | None = None,
        seed: int = 1,
        workers: int | None = None,
        executor: Any = None,
        record: str | Path | None = None,
        resume: bool = False,
        time_limit: Any = None,
        progress: Progress = None,
        **more: Any,
    ) -> Tolerance:
        """Finds what manufacturing tolerances do to the design at the variables' starts: worst case
        and yield.

        tolerances: deviations, plus and minus, such as {"base_radius": "0.02 mm"}; without any, the
        problem's variations are used. samples: the number of parts from which the yield is estimated, by
        default 100000, and fewer if a limit needs a search for each part. workers and executor:
        what counts the parts, as in pareto(), if that takes longer than a few seconds; the yield does not
        depend on them. record and resume: a file that keeps which parts have been counted, as in
        pareto(). time_limit: seconds, or a text such as "1 min", after which the answer is what is
        known.
        """
        from .executors import labour

        stated = units.settings_of({**mapping(tolerances, "tolerances"), **more})
        with (
            labour(executor, workers) as carrier,
            shown_to(progress, "tolerance") as tell,
        ):
            return Tolerance(
                native.tolerance(
                    self._native,
                    stated,
                    optional_whole(samples, "samples", 32, _MOST_SAMPLES),
                    whole(seed, "seed", 0, _MOST_SEED),
                    optional_whole(workers, "workers", 1, _MOST_WORKERS),
                    carrier,
                    record_path(record),
                    flag(resume, "resume"),
                    units.seconds(time_limit),
                    tell,
                )
            )
