# SPDX-License-Identifier: MIT
"""Whatever is wrong with an argument is an InputError that names it, in one sentence."""

import camlaw as cl
import numpy as np
import pytest
from camlaw.adapters.model import Model
from conftest import PROBLEMS

ROLLER = PROBLEMS / "cams/roller_least_base.toml"


class Odd:
    def __repr__(self):
        raise RuntimeError("not even this works")


#: None of these is a text, a path, a dict, a list of names, a whole number or a switch.
WRONG = [1.5, float("nan"), b"x", Odd(), np.zeros((2, 2)), {3: 4}, object]

PROBLEM = cl.Problem.load(ROLLER)
LAW = cl.law("cycloidal")
X = np.linspace(0, 80, 41)
SAMPLES = {"angle [deg]": X, "lift [mm]": np.round(12 * LAW(X / 80).s, 3)}


def stated(**changes):
    return cl.Problem(**({"mechanism": "disc-cam-roller"} | changes))


CALLS = {
    "law": cl.law,
    "crossover": lambda value: cl.law("modified-sine", crossover=value),
    "path": cl.law_file,
    "count": LAW.samples,
    "proved": LAW.peaks,
    "title": lambda value: LAW.save("/nowhere/law.json", title=value),
    "mechanism": cl.mechanism,
    "load": cl.Problem.load,
    "from_text": cl.Problem.from_text,
    "new": cl.Problem.new,
    "example": cl.Problem.example,
    **{
        name: lambda value, name=name: stated(**{name: value})
        for name in ("machine", "title", "constants", "law", "free", "program", "variables",
                     "objective", "objectives", "constraints", "responses", "parts", "cams", "cases",
                     "ranges", "variation", "buildable", "solver", "source")
    },
    "set": PROBLEM.set,
    "evaluate": PROBLEM.evaluate,
    "response": PROBLEM.evaluate().__getitem__,
    "formula": PROBLEM.formula,
    "values": PROBLEM.evaluate_many,
    "responses of many": lambda value: PROBLEM.evaluate_many({"base_radius": [50.0]}, value),
    "points of curves": PROBLEM.curves,
    **{
        f"{name} of optimize": lambda value, name=name: PROBLEM.optimize(**{name: value})
        for name in ("solver", "starts", "seed", "memory", "workers", "start")
    },
    **{
        f"{name} of sweep": lambda value, name=name: PROBLEM.sweep(
            {"stroke": [20, 25]}, **({"workers": 1, "evaluate": True} | {name: value})
        )
        for name in ("sample", "over", "seed", "evaluate", "cold", "record", "resume")
    },
    "swept": PROBLEM.sweep,
    "over": lambda value: PROBLEM.sensitivity(over=value),
    "tolerances": lambda value: PROBLEM.tolerance(value),
    "report": PROBLEM.report,
    "export": PROBLEM.export,
    "format": lambda value: PROBLEM.export(format=value),
    "drawing": lambda value: PROBLEM.export("cam.dxf", drawing=value),
    "result": cl.Result.load,
    "front": cl.Front.load,
    "sweep": cl.Sweep.load,
    "data": cl.fit,
    **{
        f"{name} of fit": lambda value, name=name: cl.fit(SAMPLES, **({"law": "cycloidal"} | {name: value}))
        for name in ("law", "mechanism", "set", "response", "shift", "loss", "workers", "progress")
    },
    "constants of fit": cl.fit_constants,
    "system": cl.reproduce,
    "study": cl.study,
    "Response": lambda value: cl.Response(value) if value is not object else cl.Response(1),
    "Machine": cl.Machine,
    "Model": Model,
}  # fmt: skip


@pytest.mark.parametrize("name", CALLS)
def test_wrong_types_are_input_errors(name):
    for value in WRONG:
        if name == "progress of fit" and value is object:
            continue  # a class can be called
        with pytest.raises(cl.InputError) as refused:
            CALLS[name](value)
        said = str(refused.value)
        assert said and "\n" not in said and "incompatible function arguments" not in said


def test_sentences_name_the_argument_and_what_is_accepted():
    for action, sentence in {
        lambda: cl.law(3): "law: 3 is not a text",
        lambda: PROBLEM.curves(0): "points: 0 is not a whole number from 1 to 1000000",
        lambda: PROBLEM.set(stroke=None): "stroke: None is not a number, a text with a unit or",
        lambda: PROBLEM.optimize(seed=2**70): "seed: .* is not a whole number from 0 to",
        lambda: PROBLEM.tolerance(base_radius=0.1, time_limit="nan"): "time_limit: nan s is not above",
        lambda: PROBLEM.report(""): "path: '' is not the name of a file",
        lambda: PROBLEM.report(3): "path: 3 is not a path; a text or a pathlib.Path is accepted",
        lambda: LAW(np.array([1j])): "x: .* is not an array of real numbers",
        lambda: LAW(b"x"): "x: b'x' is not an array of real numbers",
        lambda: LAW(Odd()): "x: a Odd is not an array of real numbers",
        lambda: LAW(None): "x: None is not an array of real numbers",
        lambda: LAW(True): "x: True is not an array of real numbers",
        lambda: LAW(["0.5"]): "x: .* is not an array of real numbers",
        lambda: stated(variables={"base_radius": 3}): r"variables.base_radius: 3 is neither \(lower, upper\)",
        lambda: stated(cams={"press": {"speed": 3}}): "cams.press: a cam has no 'speed'; it accepts",
        lambda: stated(constants={'foo "\n': 1}): "constants: the name .* has a control character",
        lambda: stated(constants={"stroke": 10**400}): "constants.stroke: the number is larger than",
        lambda: PROBLEM.optimize(progress=3): "progress: 3 is none of True, False, None and a function",
        lambda: cl.fit(SAMPLES, set={"mass": 3}): "set: it sets values of a mechanism; give mechanism",
        lambda: cl.fit(SAMPLES, loss="least"): "loss: 'least' is not a loss; none, huber and cauchy",
        lambda: PROBLEM.evaluate_many({"base_radius": [50.0, float("nan")]}): "base_radius: nan mm, number 1",
        lambda: PROBLEM.evaluate_many({"base_radius": [50, 60], "stroke": [1, 2, 3]}): "of one length",
        lambda: PROBLEM.sweep(executor=lambda: 3): "executor: the function made a int",
        lambda: Model(PROBLEM).design([1, 2]): "x: a design has 1 numbers, not 2",
    }.items():
        with pytest.raises(cl.InputError, match=sentence):
            action()


def test_arrays_of_other_kinds_are_read_or_refused():
    assert LAW(np.float32([0.5])).s[0] == 0.5 and LAW(np.zeros(3, ">f8")).s.tolist() == [0] * 3
    masked = np.ma.array([0.25, 0.5], mask=[True, False])
    assert np.isnan(LAW(masked).s[0]) and LAW(masked).s[1] == 0.5
    row = np.zeros(3)
    with pytest.raises(cl.InputError, match="share numbers"):
        LAW.into(np.zeros(3), row, row, np.zeros(3), np.zeros(3))
    row.flags.writeable = False
    with pytest.raises(cl.InputError, match="float64"):
        LAW.into(np.zeros(3), row, np.zeros(3), np.zeros(3), np.zeros(3))
    units = pytest.importorskip("pint").UnitRegistry()
    assert LAW(np.array([50.0]) * units.percent).s[0] == LAW(0.5).s[0]
    with pytest.raises(cl.InputError, match="plain numbers are accepted here, not 'millimeter'"):
        LAW(np.array([0.5]) * units.mm)


def test_expressions_have_no_value_to_compare():
    for function in (lambda m: 1 if m.a == m.v else 2, lambda m: 1 if m.a != 0 else 2, lambda m: float(m.a)):
        with pytest.raises(cl.InputError, match="has no value"):
            cl.Response(function)
    with pytest.raises(cl.InputError, match="cannot be part of a formula"):
        cl.Response(lambda m: None)


def test_files_that_cannot_be_written_are_os_errors(tmp_path):
    with pytest.raises(FileNotFoundError) as refused:
        LAW.save("/nowhere/law.json")
    assert str(refused.value) == "[Errno 2] No such file or directory: '/nowhere/law.json'"
    with pytest.raises(IsADirectoryError):
        PROBLEM.report(tmp_path)


def test_sentences_name_keywords_and_not_the_programs_switches():
    problem = cl.Problem.example("cams/roller_least_base")
    with pytest.raises(cl.InputError, match="^format is missing"):
        problem.export()
    with pytest.raises(cl.InputError, match="form_tolerance") as said:
        problem.export(format="csv", form_tolerance="0.01 mm")
    assert "--" not in str(said.value)
