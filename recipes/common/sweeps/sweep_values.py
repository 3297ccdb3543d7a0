"""Values in sweep files (sweep.py): lists, ranges, and expressions of other values."""

import ast
import functools
import math
import operator
import re
from collections.abc import Callable

RANGE = re.compile(r"(?P<first>\S+)\s+to\s+(?P<last>\S+)(\s+(?P<how>by|in)\s+(?P<number>\S+))?")
OPERATORS: dict[type, Callable] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: operator.pow,
    ast.USub: operator.neg,
}


LIMIT = 100_000  # points of a sweep


class SweepError(ValueError):
    """A sweep file that cannot be understood."""


def text_of(number):
    """12 digits: 0.1 + 0.2 is 0.3."""
    return f"{number:.12g}"


def evaluate(node):
    """A syntax tree of numbers, + - * / ** and sqrt()."""
    if isinstance(node, ast.Expression):
        return evaluate(node.body)
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
        return float(node.value)  # powers of whole numbers could have any number of digits
    if isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
        return OPERATORS[type(node.op)](evaluate(node.left), evaluate(node.right))
    if isinstance(node, ast.UnaryOp) and type(node.op) in OPERATORS:
        return OPERATORS[type(node.op)](evaluate(node.operand))
    if (
        isinstance(node, ast.Call)
        and getattr(node.func, "id", "") == "sqrt"
        and len(node.args) == 1
    ):
        return math.sqrt(evaluate(node.args[0]))
    raise SweepError("an expression may use numbers, {names}, + - * / ** and sqrt() only")


@functools.cache  # the points of a sweep repeat most of what they calculate
def number_of(text):
    return evaluate(ast.parse(text, mode="eval"))


def calculate(expression, values):
    filled = expression
    for name in references(expression):
        if name not in values:
            raise SweepError(f"'{expression}' refers to {{{name}}}, which has no value")
        filled = filled.replace(f"{{{name}}}", f"({values[name]})")
    try:
        number = number_of(filled)
    except (ArithmeticError, MemoryError, RecursionError, SyntaxError, ValueError) as error:
        why = ", ".join(text for text in error.args if isinstance(text, str))
        raise SweepError(f"'{expression}' cannot be calculated ({why}), as {filled}") from None
    if isinstance(number, complex) or not math.isfinite(number):
        raise SweepError(f"'{expression}' is no finite real number, as {filled}")
    return text_of(number)


@functools.cache
def references(text):
    return re.findall(r"\{([^{}]+)\}", text)


def span(first, last, how, number):
    """Values from first to last, so many of them or so far apart."""
    if not all(math.isfinite(end) for end in (first, last, last - first, number)):
        raise SweepError("its numbers must be finite")
    if how == "in":
        if number != int(number):
            raise SweepError("the number of values must be whole")
        count = int(number)
        step = (last - first) / (count - 1) if count > 1 else 0.0
    else:
        step = number
        steps = (last - first) / step * (1 + 1e-12) if step else -1
        count = math.floor(max(-1, min(steps, LIMIT))) + 1
    if count > LIMIT:
        raise SweepError(f"there are more than {LIMIT:,} values in it")
    if count < 1:
        raise SweepError("there is no value in it")
    return [text_of(first + i * step) for i in range(count)]


def values_of(text):
    """The values that one line of [values] lists, as texts; an expression stays as it is."""
    match = RANGE.fullmatch(text.strip())
    try:
        if match:
            first, last = float(match["first"]), float(match["last"])
            return span(first, last, match["how"] or "by", float(match["number"] or 1))
    except ValueError as error:
        raise SweepError(f"'{text}' is no range ({error})") from None
    listed = [part.strip() for part in text.split(",")]
    if not all(listed):
        raise SweepError(f"'{text}' has an empty value")
    return listed
