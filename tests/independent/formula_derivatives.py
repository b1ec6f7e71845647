#!/usr/bin/env python3
"""Compares values, gradients and Hessians of every machine's formulas with those of CasADi.

    camlaw_tests "[.formula-derivatives]"     writes FORMULAS, by the path in CAMLAW_FORMULAS
    formula_derivatives.py FORMULAS           reads the formulas as they are printed

CasADi differentiates the printed text. Choices, by the sign of a number and the like, are made in
plain numbers at the design, so that each formula is smooth there; a root is found by bisection,
and two Newton steps from it have its first two derivatives. Ends with 0 where all agree, with 1
where something does not, and with 3, and a word, where there is no CasADi.
"""

import ast
import json
import math
import sys

try:
    import casadi
except ImportError:
    print("formula_derivatives.py: skipped: the Python package casadi is not installed")
    sys.exit(3)

CLOSE = 1e-9  # of the largest of the terms that a derivative is summed from


class Number:
    """A number at the design, and the expression that it comes from."""

    def __init__(self, value, sx=None):
        self.value = value
        self.sx = casadi.SX(value) if sx is None else sx


def plain(f, *numbers):
    """f of plain numbers; not a number outside its domain."""
    try:
        result = f(*(n.value for n in numbers))
        return math.nan if isinstance(result, complex) else result
    except (ValueError, ZeroDivisionError, OverflowError):
        return math.nan


def applied(f, of_sx, *numbers):
    return Number(plain(f, *numbers), of_sx(*(n.sx for n in numbers)))


BINARY = {
    ast.Add: lambda a, b: a + b,
    ast.Sub: lambda a, b: a - b,
    ast.Mult: lambda a, b: a * b,
    ast.Div: lambda a, b: a / b,
}
SMOOTH = {
    "sqrt": (math.sqrt, casadi.sqrt),
    "sin": (math.sin, casadi.sin),
    "cos": (math.cos, casadi.cos),
    "tan": (math.tan, casadi.tan),
    "asin": (math.asin, casadi.asin),
    "atan": (math.atan, casadi.atan),
    "log": (math.log, casadi.log),
    "exp": (math.exp, casadi.exp),
}
NAN = Number(math.nan)


def negated(x):
    return Number(-x.value, -x.sx)


def size_of(x):
    return negated(x) if x.value < 0 else x


def along(direction, x):
    if direction.value == 0:
        return Number(0.0)
    return negated(size_of(x)) if direction.value < 0 else size_of(x)


CHOICES = {
    "abs": size_of,
    "max": lambda a, b: b if a.value < b.value else a,
    "min": lambda a, b: b if a.value > b.value else a,
    "select": lambda force, pushing, pulling: pulling if force.value < 0 else pushing,
    "along": along,
    "where_positive": lambda condition, x: x if condition.value > 0 else NAN,
    "unless_zero": lambda force, x: Number(0.0) if force.value == 0 else x,
}


def power(base, exponent):
    p = exponent.value
    return Number(plain(lambda x: x**p, base), base.sx**p)


def bisected(f, low, high):
    f_low = f(low)
    for _ in range(200):
        middle = (low + high) / 2
        value = f(middle)
        if value == 0:
            return middle
        if (value < 0) == (f_low < 0):
            low = middle
        else:
            high = middle
    return (low + high) / 2


def root(call, names):
    """root(NAME, low, high, equation, level): of several roots the one of the highest level."""
    unknown = call.args[0].id
    low, high = (evaluated(a, names) for a in call.args[1:3])
    equation = call.args[3]

    def at(tree, place):
        return evaluated(tree, {**names, unknown: place})

    def level(x):
        return at(call.args[4], Number(x)).value if len(call.args) > 4 else 0.0

    cells = 96
    places = [low.value + (high.value - low.value) * i / cells for i in range(cells + 1)]
    values = [at(equation, Number(x)).value for x in places]
    found = []
    for i in range(cells):
        if (values[i] < 0 <= values[i + 1]) or (values[i] > 0 >= values[i + 1]):
            f = lambda x: at(equation, Number(x)).value  # noqa: E731
            found.append(bisected(f, places[i], places[i + 1]))
    if not found:
        return NAN
    place = max(found, key=level)
    y = casadi.SX.sym("y")
    f = at(equation, Number(place, y)).sx
    slope = casadi.jacobian(f, y)
    sx = casadi.SX(place)
    for _ in range(2):
        sx = sx - casadi.substitute(f / slope, y, sx)
    return Number(place, sx)


def evaluated(tree, names):
    if isinstance(tree, ast.Constant):
        return Number(float(tree.value))
    if isinstance(tree, ast.Name):
        return names[tree.id]
    if isinstance(tree, ast.UnaryOp) and isinstance(tree.op, ast.USub):
        return negated(evaluated(tree.operand, names))
    if isinstance(tree, ast.BinOp):
        a, b = evaluated(tree.left, names), evaluated(tree.right, names)
        if isinstance(tree.op, ast.Pow):
            return power(a, b)
        f = BINARY[type(tree.op)]
        return applied(f, f, a, b)
    if isinstance(tree, ast.Call):
        function = tree.func.id
        if function == "root":
            return root(tree, names)
        numbers = [evaluated(a, names) for a in tree.args]
        if function in SMOOTH:
            return applied(*SMOOTH[function], *numbers)
        return CHOICES[function](*numbers)
    raise ValueError(f"what is {ast.dump(tree)}?")


def differences(formula, design):
    """The largest differences of value, gradient and Hessian, by the sizes of their terms."""
    inputs = formula["inputs"]
    u = casadi.SX.sym("u", len(inputs))
    names = {"pi": Number(math.pi)}
    for i, one in enumerate(inputs):
        names[one["name"]] = Number(one["factor"] * design["at"][i], one["factor"] * u[i])
    # A peak's name has two words.
    lines = formula["text"]
    for name in [one["name"] for one in inputs if " " in one["name"]]:
        names[name.replace(" ", "_")] = names[name]
        lines = lines.replace(name, name.replace(" ", "_"))
    for line in lines.splitlines():
        name, _, text = line.partition(" = ")
        names[name] = evaluated(ast.parse(text.replace("^", "**"), mode="eval").body, names)
        last = names[name]
    result = formula["factor"] * last.sx
    hessian, gradient = casadi.hessian(result, u)
    f = casadi.Function("f", [u], [result, gradient, hessian])
    value, gradient, hessian = (x.full() for x in f(design["at"]))
    at = design["at"]
    n = len(at)
    own_h = [[0.0] * n for _ in range(n)]
    for i, k, second in design["hessian"]:
        own_h[i][k] = own_h[k][i] = second
    size = abs(design["value"])
    for i in range(n):
        size = max(size, abs(at[i] * design["gradient"][i]))
        size = max([size] + [abs(at[i] * at[k] * own_h[i][k]) for k in range(n)])
    if not math.isfinite(size):
        return None
    of_value = abs(float(value[0, 0]) - design["value"])
    of_gradient = max(
        (abs(at[i] * (gradient[i, 0] - design["gradient"][i])) for i in range(n)), default=0.0
    )
    of_hessian = max(
        (abs(at[i] * at[k] * (hessian[i, k] - own_h[i][k])) for i in range(n) for k in range(n)),
        default=0.0,
    )
    return [d / size if size > 0 else d for d in (of_value, of_gradient, of_hessian)]


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        formulas = [json.loads(line) for line in file]
    compared, apart, largest = 0, [], [0.0, 0.0, 0.0]
    for formula in formulas:
        for design in formula["designs"]:
            found = differences(formula, design)
            if found is None:
                continue
            compared += 1
            largest = [max(a, b) for a, b in zip(largest, found)]
            if not all(d <= CLOSE for d in found):
                apart.append((formula["machine"], formula["response"], found))
    for machine, response, found in apart:
        print(f"{machine} {response}: value, gradient and Hessian differ by {found}")
    print(
        f"{len(formulas)} formulas at {compared} designs agree with CasADi but for {len(apart)}; "
        f"the largest differences are {', '.join(f'{d:.1e}' for d in largest)} of the terms' size"
    )
    return 1 if apart or compared < len(formulas) else 0


if __name__ == "__main__":
    sys.exit(main())
