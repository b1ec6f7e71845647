# SPDX-License-Identifier: MIT
"""Prints docs/python-api.md: the package's names with what their documentation says.

./run python python/tools/reference.py > docs/python-api.md      (a test compares)
"""

import importlib
import inspect
import re
import textwrap
import types

import camlaw

ADAPTERS = {
    "model": ["Model", "Variable", "Output"],
    "scipy": ["ScipyObjective"],
    "pymoo": ["PymooProblem"],
    "pygmo": ["PygmoProblem"],
    "openmdao": ["CamlawComponent"],
}
CLASSES = [
    "Law",
    "Motion",
    "Peaks",
    "Problem",
    "Evaluation",
    "Check",
    "Result",
    "Verification",
    "Front",
    "Sweep",
    "Sensitivity",
    "Tolerance",
    "Fit",
    "Reproduction",
    "Study",
    "Machine",
    "Response",
    "Expression",
]
FUNCTIONS = [
    "law",
    "law_file",
    "law_table",
    "laws",
    "mechanism",
    "mechanisms",
    "fit",
    "fit_constants",
    "reproduce",
    "reproducible",
    "cam_shape",
    "study",
    "examples",
]
ERRORS = ["Error", "InputError", "MissingPackage", "Interrupted"]


def signature(thing):
    text = re.sub(r"(: |-> )'([^']*)'", r"\1\2", str(inspect.signature(thing)))
    return (
        text.replace("camlaw.", "")
        .replace("self, ", "")
        .replace("(self)", "()")
        .replace("cls, ", "")
    )


def documentation(thing):
    return inspect.cleandoc(thing.__doc__ or "")


def members(class_):
    own = [base for base in class_.__mro__ if base.__module__.startswith("camlaw")]
    all_of_them = {}
    for base in own:
        all_of_them |= {name: value for name, value in vars(base).items() if name not in all_of_them}
    for name, value in all_of_them.items():
        if name.startswith("_") and name not in ("__call__", "__getitem__"):
            continue
        if isinstance(value, property) and value.__doc__:
            yield f"`{name}`", value
        elif isinstance(value, (types.FunctionType, classmethod, staticmethod)):
            function = value if isinstance(value, types.FunctionType) else value.__func__
            if function.__doc__:
                yield f"`{name.replace('__call__', 'law')}{signature(function)}`", function


def linked(names, before=""):
    return ", ".join(f"[{name}](#{(before + name).lower()})" for name in names)


def contents():
    """The sections, with the functions and classes in them."""
    text = (
        f"**Contents:** [Functions](#functions): {linked(FUNCTIONS)} · [Classes](#classes): "
        f"{linked(CLASSES, 'class-')} · [Formulas](#formulas-camlawformulas) · [Errors](#errors) · "
        "[Adapters](#adapters-camlawadapters)"
    )
    return textwrap.fill(text, 120, break_long_words=False, break_on_hyphens=False)


def show_class(name, class_):
    print(f"\n### class {name}\n\n{documentation(class_)}")
    rows = [(title, documentation(member)) for title, member in members(class_)]
    for title, text in rows:
        print(f"\n{title}\n\n: " + text.replace("\n", "\n  ").replace("\n  \n", "\n\n"))


def main():
    print(
        "# The package camlaw: reference\n\nPrinted by `./run python python/tools/reference.py` from the "
        f"package. [python.md](python.md) is a tutorial.\n\n{contents()}\n\n## Functions"
    )
    for name in FUNCTIONS:
        function = getattr(camlaw, name)
        print(f"\n### {name}\n\n`{name}{signature(function)}`\n\n{documentation(function)}")
    print("\n## Classes")
    for name in CLASSES:
        show_class(name, getattr(camlaw, name))
    print("\n## Formulas: camlaw.formulas\n")
    for name, function in vars(camlaw.formulas).items():
        is_own = getattr(function, "__module__", "") == camlaw.formulas.__name__
        if isinstance(function, types.FunctionType) and is_own and not name.startswith("_"):
            line = " ".join(documentation(function).split())
            print(
                f"- `{name}{signature(function).split(' ->')[0].replace(': Any', '')}`"
                + (f": {line}" if line else "")
            )
    print("\n## Errors")
    for name in ERRORS:
        class_ = getattr(camlaw, name)
        bases = ", ".join(base.__name__ for base in class_.__bases__)
        print(f"\n### {name}({bases})\n\n{documentation(class_)}")
    print(
        f"\n## Adapters: camlaw.adapters\n\n{documentation(importlib.import_module('camlaw.adapters'))}"
    )
    for module in ("model", "scipy"):  # the others need their libraries to be read at all
        for name in ADAPTERS[module]:
            show_class(
                f"{module}.{name}",
                getattr(importlib.import_module(f"camlaw.adapters.{module}"), name),
            )
    print(
        "\n`pymoo.PymooProblem(problem)`, `pygmo.PygmoProblem(problem)` and "
        "`openmdao.CamlawComponent(problem=problem)` are what their libraries call a problem or a component."
    )


main()
