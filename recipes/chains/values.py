"""Values in sweep files: lists, ranges, expressions of other values. Mistakes are ValueErrors."""

import functools
import math
import re

from chains.expressions import Expression, as_number
from rupture.units import NUMBER, PREFIXES, UNIT, amount

RANGE = re.compile(r"(.+?)\s+to\s+(.+?)(?:\s+(by|in)\s+(.+))?")
# A number without a unit before one with a unit, which may be that of both, or the comma a decimal
# one: 0,4mm/s. Only a 0 with a blank behind its comma is clear.
BARE = rf"\s*[-+]?{NUMBER}\s*"
MIXED = re.compile(rf"(?:^|,)(?!\s*[0.]+\s*,\s){BARE},{BARE}({UNIT})\s*(?:,|$)")
REFERENCE = re.compile(r"\{([^{}]+)\}")
LIMIT = 100_000  # points of a sweep


def text_of(number):
    """A number with 12 digits: 0.1 + 0.2 is 0.3."""
    return f"{number:.12g}"


@functools.cache  # the points of a sweep repeat it
def parsed(text, names):
    return Expression(REFERENCE.sub(r"\1", text), names)


def calculate(text, values):
    """The number, as a text, that follows from other values, whose names are in braces."""
    numbers = {name: as_number(values[name]) for name in references(text) if name in values}
    try:
        number = parsed(text, (*numbers,)).value(numbers.__getitem__)
        if isinstance(number, bool) or not isinstance(number, (int, float)):
            raise ValueError("it is no number")
        return text_of(number)
    except (ArithmeticError, ValueError) as error:
        raise ValueError(f"'{text}' cannot be calculated: {error}") from None


@functools.cache
def references(text):
    return REFERENCE.findall(text)


def numbers_between(first, last, how, step):
    """Numbers from first to last, so many of them or so far apart."""
    if not all(math.isfinite(end) for end in (first, last, last - first, step)):
        raise ValueError("its numbers must be finite")
    if not how and not (first.is_integer() and last.is_integer()):
        raise ValueError("give its step (by 0.1) or how many values it has (in 5)")
    if how == "in" and step != int(step):
        raise ValueError("the number of values must be whole")
    if how == "in":
        count, step = step, (last - first) / max(1, step - 1)
    else:
        count = 1 + (last - first) / step * (1 + 1e-12) if step else 0
    if count < 1:
        raise ValueError("it has no values: the step must lead from the first number to the last")
    if count >= LIMIT + 1:
        raise ValueError(f"it has more than {LIMIT:,} values")
    return [first + i * step for i in range(int(count))]


def span(first, last, how, step):
    """The values of a range, in the unit in which they are written."""
    texts, units, *parts = zip(*map(amount, (first, last, step or "1")))
    written = {(PREFIXES[prefix], symbol) for prefix, symbol in zip(*parts) if symbol}
    if len(written) > 1 or (how == "in" and units[2]):
        raise ValueError("all its numbers need the same unit")
    first, last, step = map(float, texts)
    return [text_of(number) + max(units) for number in numbers_between(first, last, how, step)]


def values_of(text):
    """The values that one line of [values] lists, as texts; an expression stays as it is."""
    try:
        if match := RANGE.fullmatch(text.strip()):
            return span(*match.groups())
    except ValueError as error:
        raise ValueError(f"'{text}' is not a range: {error}") from None
    listed = [part.strip() for part in text.split(",")]
    if not all(listed):
        raise ValueError(f"'{text}' has an empty value")
    if unit := MIXED.search(text):
        each = re.sub(r"(?<=[\d.])(?=,|$)", unit[1], ", ".join(listed))
        one = re.sub(r"(?<![.\d])(\d+),(?=\d+(?![.\d]))", r"\1.", text)
        raise ValueError(f"'{text}' is unclear: write {', or '.join([one, each][one == text :])}")
    return listed
