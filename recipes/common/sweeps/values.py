"""Values in sweep files: lists, ranges, expressions of other values; numbers may have a unit."""

import functools
import math
import re
from decimal import Decimal

NUMBER = r"(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
AMOUNT = re.compile(rf"([-+]?{NUMBER})\s*(\S*)")
RANGE = re.compile(r"(?P<first>.+?)\s+to\s+(?P<last>.+?)(\s+(?P<how>by|in)\s+(?P<number>.+))?")
MULTIPLES = {"": 0, "G": 9, "M": 6, "k": 3, "m": -3, "u": -6, "µ": -6, "μ": -6, "n": -9}
UNITS = ("m", "s", "m/s", "kg", "N", "N/m", "N/m^2", "Pa")  # of the parameters
LIMIT = 100_000  # points of a sweep


class SweepError(ValueError):
    """A sweep file that cannot be understood."""


def text_of(number):
    """12 digits: 0.1 + 0.2 is 0.3."""
    return f"{number:.12g}"


# --- numbers with units -----------------------------------------------------------------------


def amount(text):
    """The number as it is written and the word behind it."""
    match = AMOUNT.fullmatch(text.strip())
    if not match:
        raise ValueError(f"'{text}' is not a number")
    return match.groups()


def number_in(text, unit):
    """The number in this unit, such as 0.01 of 10ms in s; None if it is none."""
    match = AMOUNT.fullmatch(text)
    if not match or not match[2]:
        return float(match[1]) if match else None
    symbol, own = ("g", 3) if unit == "kg" else (unit, 0)
    prefix = match[2].removesuffix(symbol)
    if prefix not in MULTIPLES or not match[2].endswith(symbol):
        return None
    return float(Decimal(match[1]).scaleb(MULTIPLES[prefix] - own))


def without_unit(text):
    """10ms as 0.01. What has no unit stays as it is."""
    match = AMOUNT.fullmatch(text)
    known = (number_in(text, unit) for unit in UNITS if match and match[2])
    return next((repr(number) for number in known if number is not None), text)


# --- expressions ------------------------------------------------------------------------------


@functools.cache  # the points of a sweep repeat most of what they calculate
def number_of(expression):
    if not re.fullmatch(r"(?:sqrt\b|[-+*/() ])*", re.sub(NUMBER, "", expression)):
        raise SweepError("it may use numbers, {names}, + - * / ** and sqrt() only")
    # powers of whole numbers could have any number of digits
    floats = re.sub(NUMBER, lambda match: repr(float(match[0])), expression)
    return eval(floats, {"__builtins__": {}, "sqrt": math.sqrt})


def calculate(expression, values):
    filled = expression
    for name in references(expression):
        if name not in values:
            raise SweepError(f"'{expression}' refers to {{{name}}}, which has no value")
        filled = filled.replace(f"{{{name}}}", f"({without_unit(values[name])})")
    try:
        number = number_of(filled)
    except (ArithmeticError, MemoryError, SyntaxError, TypeError, ValueError) as error:
        why = ", ".join(text for text in error.args if isinstance(text, str))
        raise SweepError(f"'{expression}' cannot be calculated ({why}), as {filled}") from None
    if isinstance(number, complex) or not math.isfinite(number):
        raise SweepError(f"'{expression}' is no finite real number, as {filled}")
    return text_of(number)


@functools.cache
def references(text):
    return re.findall(r"\{([^{}]+)\}", text)


# --- lists and ranges -------------------------------------------------------------------------


def numbers_between(first, last, how, step):
    """Numbers from first to last, so many of them or so far apart."""
    if not all(math.isfinite(end) for end in (first, last, last - first, step)):
        raise SweepError("its numbers must be finite")
    if how == "in":
        if step != int(step):
            raise SweepError("the number of values must be whole")
        count = int(step)
        step = (last - first) / (count - 1) if count > 1 else 0.0
    else:
        steps = (last - first) / step * (1 + 1e-12) if step else -1
        count = math.floor(max(-1, min(steps, LIMIT))) + 1
    if not 1 <= count <= LIMIT:
        raise SweepError(f"it must have from 1 to {LIMIT:,} values")
    return [first + i * step for i in range(count)]


def span(match):
    """The values of a range, in the unit in which they are written."""
    numbers, words = zip(*(amount(match[part] or "1") for part in ("first", "last", "number")))
    units = {word for word in words if word}
    if len(units) > 1 or (match["how"] == "in" and words[2]):
        raise SweepError("all its numbers need the same unit")
    first, last, step = map(float, numbers)
    return [
        text_of(number) + "".join(units)
        for number in numbers_between(first, last, match["how"], step)
    ]


def values_of(text):
    """The values that one line of [values] lists, as texts; an expression stays as it is."""
    match = RANGE.fullmatch(text.strip())
    try:
        if match:
            return span(match)
    except ValueError as error:
        raise SweepError(f"'{text}' is no range ({error})") from None
    listed = [part.strip() for part in text.split(",")]
    if not all(listed):
        raise SweepError(f"'{text}' has an empty value")
    return listed
