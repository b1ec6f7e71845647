# SPDX-License-Identifier: MIT
"""Problems: a machine, what may vary, what is wanted, what must hold.

How one is stated is in stating, what is said of it without a search in evaluations.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import plots, tables, units
from .errors import InputError, Interrupted
from .evaluations import Check, Evaluation, Range, Sensitivity, Tolerance
from .formulas import Machine
from .motion_laws import Law
from .native import native
from .outputs import export_options, written
from .progress import Progress, shown
from .stating import problem_table
from .toml_text import toml_text

if TYPE_CHECKING:
    from .fronts import Front
    from .results import Result
    from .sweeps import Sweep


#: Of curves, as many as the program tabulates.
_MOST_POINTS = 1_000_000


class Problem:
    """A design problem, as a problem file states one (docs/problem-files.md).

    Problem.load(path) reads a file. Otherwise it is stated by the same tables as a file has, as
    dicts; values are numbers, texts with units such as "30 mm", or quantities of pint:

        cl.Problem(mechanism="disc-cam-roller",
                   constants={"stroke": "30 mm", "speed": "200 rpm"},
                   program=[{"name": "rise", "angle": "80 deg", "law": "cycloidal"}, ...],
                   variables={"base_radius": ("10 mm", "120 mm")},
                   objective="base_radius",
                   constraints={"pressure_angle": ("-40 deg", "30 deg")})

    mechanism: the name of one; or machine: a Machine of one's own. law: a name, a Law, a list of
    them to choose from, or the table [law]. program: its segments, or the table [program].
    variables: (lower, upper), or a table of lower, upper, start, type, values. objective: what is
    to be least, or {"minimize": ...} or {"maximize": ...}; objectives: a list of such, for a front.
    constraints: a dict of (lower, upper) or tables, or a list of tables. responses: formulas of
    one's own, each a Response. cases: load cases, [{"name": "fast", "speed": "400 rpm"}, ...].
    ranges: parameters that take any value within, {"speed": ("100 rpm", "400 rpm")}. parts: tables
    [parts.NAME] with a catalogue. cams: several cams on one shaft by name, each with the keywords
    of a problem, {"press": {"mechanism": ..., "constants": ..., "program": ...}}. Raises InputError.
    """

    def __init__(
        self,
        mechanism: str | Machine | None = None,
        *,
        machine: Machine | None = None,
        title: str | None = None,
        constants: Mapping[str, Any] | None = None,
        law: Any = None,
        free: Mapping[str, Any] | None = None,
        program: Any = None,
        variables: Mapping[str, Any] | None = None,
        objective: Any = None,
        objectives: Sequence[Any] | None = None,
        constraints: Any = None,
        responses: Mapping[str, Any] | None = None,
        parts: Mapping[str, Any] | None = None,
        cams: Mapping[str, Mapping[str, Any]] | None = None,
        cases: Sequence[Mapping[str, Any]] | None = None,
        ranges: Mapping[str, Any] | None = None,
        buildable: Mapping[str, Any] | None = None,
        solver: Mapping[str, Any] | None = None,
        source: str = "problem",
        _native: Any = None,
    ) -> None:
        if _native is not None:
            self._native = _native
            return
        table = problem_table(
            mechanism,
            machine=machine,
            title=title,
            constants=constants,
            law=law,
            free=free,
            program=program,
            variables=variables,
            objective=objective,
            objectives=objectives,
            constraints=constraints,
            responses=responses,
            parts=parts,
            cams=cams,
            cases=cases,
            ranges=ranges,
            buildable=buildable,
            solver=solver,
        )
        self._native = native.problem(toml_text(table), source)

    @classmethod
    def load(cls, path: str | Path) -> Problem:
        """Reads a problem file. Raises InputError with the line and what is accepted."""
        return cls(_native=native.problem_file(str(path)))

    @classmethod
    def from_text(cls, text: str, source: str = "problem") -> Problem:
        """Reads the text of a problem file; `source` names it in errors."""
        return cls(_native=native.problem(text, source))

    def save(self, path: str | Path) -> None:
        """Writes the problem's text. What set() has changed since is not in it."""
        if self.settings:
            raise InputError(
                f"values were set beside the problem's text: {', '.join(self.settings)}"
            )
        written(self.text, path)

    @property
    def text(self) -> str:
        """The problem file."""
        return self._native.text

    @property
    def title(self) -> str:
        return self._native.title

    @property
    def mechanism(self) -> str:
        return self._native.mechanism

    @property
    def settings(self) -> list[str]:
        """What set() has changed, as the program's --set takes it."""
        return self._native.settings

    @property
    def law(self) -> Law | None:
        """Its law or motion program, of several the first; None of a machine that none moves."""
        found = self._native.law()
        return None if found is None else Law(found)

    @property
    def variables(self) -> Any:
        """A table: name, unit, lower, upper, start, integer, values."""
        return tables.of_rows(self._native.variables(), index="name")

    @property
    def constants(self) -> dict[str, float]:
        """Every parameter of the mechanism with its value, in its listed unit."""
        return {name: value for name, (value, _) in self._native.constants().items()}

    @property
    def units(self) -> dict[str, str]:
        """The listed unit of every parameter of the mechanism, and of the variables."""
        known = {name: unit for name, (_, unit) in self._native.constants().items()}
        return known | {row["name"]: row["unit"] for row in self._native.variables()}

    @property
    def responses(self) -> Any:
        """A table of what the machine has: response, kind, unit, meaning."""
        return tables.of_rows(self._native.machine()["responses"], index="response")

    def set(self, values: Mapping[str, Any] | None = None, /, **more: Any) -> Problem:
        """The problem with other starts of its variables, constants, coefficients of its law, values
        in load cases ("fast.speed") or bounds of its limits ("pressure_angle.upper")."""
        settings = units.settings_of({**(values or {}), **more})
        return Problem(_native=self._native.with_settings(settings))

    def check(self) -> Check:
        """Says the problem back in words, with what depends on what and in which shape."""
        facts, text, html = self._native.check()
        return Check(text, facts, html)

    def check_derivatives(self) -> Any:
        """A table of every derivative compared with differences, a row for each law and objective:
        agrees, worst_error and of what it is, shapes that do not hold."""
        return tables.of_rows(self._native.check_derivatives(), index="problem")

    def scaling(self) -> Any:
        """A table of what variables, objective and limits are divided by, and their tolerances."""
        return tables.of_rows(self._native.scaling(), index="of")

    def formula(self, response: str) -> str:
        """How a response is worked out, in the grammar of docs/formulas.md."""
        return self._native.formula(response)

    def evaluate(self, values: Mapping[str, Any] | None = None, /, **more: Any) -> Evaluation:
        """Every response at the variables' starts, or at these values, proved over the cycle."""
        problem = self.set(values, **more) if values or more else self
        return Evaluation(problem._native.evaluate())

    def evaluate_many(
        self, values: Mapping[str, Any], responses: Sequence[str] | None = None
    ) -> Any:
        """Many designs at once: a table with a row for each, of responses and of limits' margins.

        `values` has arrays of one length by the names of variables, constants or coefficients of
        the law, in their listed units, or quantities of pint. `responses` names what is wanted, in the words of problem
        files; by default all that the machine has. Of a curve there are columns "lowest NAME" and
        "highest NAME". Values are searched as a search does, and not proved.
        """
        names = list(values)
        arrays = [self._numbers(name, v) for name, v in values.items()]
        longest = max((len(a) for a in arrays), default=0)
        arrays = [np.full(longest, a[0]) if len(a) == 1 else a for a in arrays]
        found = native.evaluate_many(
            self._native, names, arrays, None if responses is None else list(responses)
        )
        given = dict(zip(names, arrays))
        return tables.of_columns(
            given | {name: column for name, _, column in found},
            {name: unit for name, unit, _ in found},
        )

    def _numbers(self, name: str, values: Any) -> np.ndarray:
        """An array in the listed unit of a variable or a constant."""
        if units.is_pint(values):
            unit = self.units.get(name)
            if unit is None:
                raise InputError(f"{name}: give plain numbers; it is not a size of the machine")
            one = native.quantity(f"1 {units.pint_unit(values.units)}", unit, unit, name)
            values = np.asarray(values.magnitude, dtype=np.float64) * one
        return np.ascontiguousarray(np.atleast_1d(values), dtype=np.float64)

    def curves(self, points: int = 720) -> Any:
        """A table of every curve at even places of the cycle, "NAME [UNIT]"; the place first.

        points: how many stretches the cycle is cut into; there is a row more. Raises InputError.
        """
        if not 1 <= points <= _MOST_POINTS:
            raise InputError(f"points: {points} is outside 1 .. {_MOST_POINTS}")
        return tables.of_columns(self._native.curves(points))

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
        start: Mapping[str, Any] | None,
        progress: Progress,
    ) -> Result:
        from .results import Result

        problem = self.set(start) if start else self
        with shown(progress, what) as tell:
            found, interrupted = native.search(
                problem._native,
                synthesize,
                solver,
                units.whole(starts, "starts", 1),
                units.whole(seed, "seed"),
                units.seconds(time_limit),
                units.size_in_bytes(memory),
                units.whole(workers, "workers", 1),
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
        start: Mapping[str, Any] | None = None,
        progress: Progress = None,
    ) -> Result:
        """The best design, with a verdict.

        What is not given is as the problem has it. starts: how many places to search from. start:
        the values to begin at. time_limit: seconds, or such as "1 min"; the best so far is the answer
        then. memory: bytes that the search may take, or such as "4 GB". workers: processes that search
        side by side, from several starts and in several combinations of choices, where that takes
        longer than some seconds; the result does not depend on them. Ctrl-C raises Interrupted, whose
        result is the best so far.
        """
        return self._search(
            False, "optimize", solver, starts, seed, time_limit, memory, workers, start, progress
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
        start: Mapping[str, Any] | None = None,
        progress: Progress = None,
    ) -> Result:
        """The same of a problem with a free law, which is measured with what is possible and with
        the laws that have names: facts["rulers"]."""
        return self._search(
            True, "synthesize", solver, starts, seed, time_limit, memory, workers, start, progress
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
        time_limit: Any = None,
        progress: Progress = None,
    ) -> Front:
        """The front of two objectives or more.

        workers: processes at work side by side; the front does not depend on them. They are started
        afresh, so that it does not matter which threads are running here. executor: who carries the
        searches out in their place, on other machines perhaps: a client of Dask, an executor of
        concurrent.futures, or a function that makes one, which is called again if the executor
        breaks; the front is the same (docs/scale.md). record: a file that the study is written to as
        it goes; with resume what is in it is not searched again. time_limit: seconds, or such as
        "1 min"; what has been found by then is the answer, which is `stopped`.
        """
        from .executors import labour
        from .fronts import Front

        with labour(executor, workers) as carrier, shown(progress, "pareto") as tell:
            found, interrupted = native.pareto(
                self._native,
                units.whole(points, "points", 2),
                method,
                units.whole(workers, "workers", 1),
                carrier,
                "" if record is None else str(record),
                resume,
                units.seconds(time_limit),
                tell,
            )
        front = Front(found)
        if interrupted:
            raise Interrupted(front)
        return front

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
        time_limit: Any = None,
        progress: Progress = None,
        **more: Any,
    ) -> Sweep:
        """The best design for each combination of settings, as 'camlaw sweep' finds it.

        values: what is swept, by the names that set() takes: {"speed": "60:15:120 rpm"} from, step,
        to; {"law": ["cycloidal", "modified-sine"]} one after the other; "all" is every law; a single
        value is the same in all. sample: "sobol 64" or "lhs 64" samples from the ranges of `over`,
        such as {"stroke": ("18 mm", "22 mm")}; seed is that of lhs. evaluate: the design as it stands
        in each combination, without a search. cold: each search begins as optimize() does, not at its
        neighbour's design. workers, executor, record, resume, time_limit: as pareto() has them.
        """
        from .executors import labour
        from .sweeps import Sweep, axes_of, ranges_of

        with (
            labour(executor, workers) as carrier,
            shown(progress, "sweep") as tell,
        ):
            found, interrupted = native.sweep(
                self._native,
                axes_of({**(values or {}), **more}),
                sample,
                units.whole(seed, "seed"),
                ranges_of(over),
                evaluate,
                cold,
                units.whole(workers, "workers", 1),
                carrier,
                "" if record is None else str(record),
                resume,
                units.seconds(time_limit),
                tell,
            )
        sweep = Sweep(found)
        if interrupted:
            raise Interrupted(sweep)
        return sweep

    def sensitivity(
        self,
        *,
        over: Mapping[str, Any] | None = None,
        samples: int = 512,
        seed: int = 1,
        progress: Progress = None,
    ) -> Sensitivity:
        """How objective and limits depend on the parameters at the variables' starts.

        Derivatives are exact, by every parameter, with elasticities. Sobol indices are over ranges:
        those of `over`, such as {"stroke": ("18 mm", "22 mm")}, else the problem's, else 1 % to
        either side.
        """
        from .sweeps import ranges_of

        with shown(progress, "sensitivity") as tell:
            return Sensitivity(
                native.sensitivity(
                    self._native,
                    ranges_of(over),
                    units.whole(samples, "samples", 16),
                    units.whole(seed, "seed"),
                    tell,
                )
            )

    def tolerance(
        self,
        tolerances: Mapping[str, Any] | None = None,
        /,
        *,
        samples: int = 100_000,
        seed: int = 1,
        time_limit: Any = None,
        progress: Progress = None,
        **more: Any,
    ) -> Tolerance:
        """What manufacture makes of the design at the variables' starts: worst case and yield.

        tolerances: to either side, such as {"base_radius": "0.02 mm"}; without any, the problem's
        variations. samples: parts that the yield is estimated from. time_limit: what is known by then
        is the answer.
        """
        stated = units.settings_of({**(tolerances or {}), **more})
        with shown(progress, "tolerance") as tell:
            return Tolerance(
                native.tolerance(
                    self._native,
                    stated,
                    units.whole(samples, "samples", 32),
                    units.whole(seed, "seed"),
                    units.seconds(time_limit),
                    tell,
                )
            )

    def plot(self) -> Any:
        """Every curve over the cycle, drawn by matplotlib; returns the axes."""
        return plots.draw(self._native.curves_figure())

    def plot_profile(self) -> Any:
        """The cam's profile, pitch curve and path of the tool."""
        return plots.draw(self._native.profile_figure(), equal=True)

    def report(self, path: str | Path | None = None) -> str:
        """A page for the browser on the design at the variables' starts; written to `path`."""
        return written(native.report_of_problem(self._native), path)

    def export(self, path: str | Path | None = None, **options: Any) -> str:
        """The cam's curves, motion or law as a file's text; see Result.export."""
        text = native.export_problem(self._native, export_options(path, options))
        return written(text, path)

    def __repr__(self) -> str:
        return f"<camlaw problem {self.title or self.mechanism}: {len(self._native.variables())} variables>"

    def _repr_html_(self) -> str:
        return f"<p><b>{escape(self.title or self.mechanism)}</b></p>{self.check().html}"


__all__ = ["Check", "Evaluation", "Problem", "Range"]
