"""What varies: lists, ranges, tables, arithmetic of numbers, and their combinations. Mistakes are
ValueErrors or UsageErrors."""

import ast
import csv
import itertools
import math
import operator
import re
from collections.abc import Callable
from functools import cache

from rupture.errors import UsageError
from rupture.units import NUMBER, PREFIXES, UNIT, amount, in_si
from sweeps.text import check_letters, read_text

RANGE = re.compile(r"(.+?)\s+to\s+(.+?)(?:\s+(by|in)\s+(.+))?")
WITH_UNIT = re.compile(rf"[-+]?{NUMBER}\s*{UNIT}")
REFERENCE = re.compile(r"\{([^{}]+)\}")
HEADING = re.compile(r"^(.*?)((?<!\s)\s*\[([^\[\]]*)\])?$")  # of a table: a name, perhaps a unit
LIMIT = 100_000  # points of a sweep
LONGEST = 200  # letters of a value
FORMULA = re.compile(r"[-+*/(). 0-9eEsqrt]+")
MAY_HAVE = "it may have numbers, {names}, + - * / **, parentheses, and sqrt"
NOT_REAL = "it is not a finite real number"
ARITHMETIC: dict[type, Callable] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: math.pow,
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
}


def is_along_x(text):
    return " from " in text


def text_of(number):
    """A number with 12 digits: 0.1 + 0.2 is 0.3."""
    return f"{number:.12g}"


def check_length(text):
    if len(text) > LONGEST:
        raise UsageError(f"'{text[:20]}…' is longer than {LONGEST} letters")


# --- arithmetic --------------------------------------------------------------------------------


@cache
def references(text):
    return frozenset(REFERENCE.findall(text))


def real(operation, *numbers):
    try:
        return operation(*numbers)
    except (OverflowError, ValueError):
        raise ValueError(NOT_REAL) from None


def worth(node):
    """Of a parsed formula. All numbers are floats, so that no power is without end."""
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
        return float(node.value)
    if isinstance(node, ast.BinOp) and type(node.op) in ARITHMETIC:
        return real(ARITHMETIC[type(node.op)], worth(node.left), worth(node.right))
    if isinstance(node, ast.UnaryOp) and type(node.op) in ARITHMETIC:
        return ARITHMETIC[type(node.op)](worth(node.operand))
    if isinstance(node, ast.Call) and ast.unparse(node.func) == "sqrt" and len(node.args) == 1:
        return real(math.sqrt, worth(node.args[0]))
    raise ValueError(MAY_HAVE)


def number_in(text):
    try:
        return f"({in_si(text)[0]!r})"
    except ValueError:
        raise ValueError(f"'{text}' is no number") from None


def calculate(text, values):
    """The number, as a text, that follows from other values; a name alone is its text."""
    if alone := REFERENCE.fullmatch(text):
        return values[alone[1]]
    try:
        formula = REFERENCE.sub(lambda name: number_in(values[name[1]]), text).strip()
        if not FORMULA.fullmatch(formula):
            raise ValueError(MAY_HAVE)
        found = worth(ast.parse(formula, mode="eval").body)
        if not math.isfinite(found):
            raise ValueError(NOT_REAL)
        return text_of(found)
    except (ArithmeticError, SyntaxError, MemoryError, RecursionError, ValueError) as error:
        why = error if isinstance(error, (ArithmeticError, ValueError)) else "it is no formula"
        raise ValueError(f"'{text}' cannot be calculated: {why}") from None


@cache  # many points have the same
def worked_out(text, values):
    """`values`: pairs of a name and its text. In values along x, each number may be calculated."""
    parts = re.split(r"(\s+(?:from|to|and)\s+)", text) if is_along_x(text) else [text]
    known = dict(values)
    found = "".join(calculate(one, known) if references(one) else one for one in parts)
    check_length(found)  # of others that are filled in, too
    return found


def calculated(values):
    """The values, with those that follow from others, in whatever order they do."""
    waiting = [name for name, text in values.items() if "{" in text]
    for name in waiting:
        for other in references(values[name]) - values.keys():
            raise ValueError(f"'{values[name]}': there is no value '{other}'")
    while waiting:
        ready = [n for n in waiting if references(values[n]).isdisjoint(waiting)]
        if not ready:
            raise ValueError(f"{', '.join(waiting)}: a value cannot depend on itself")
        for name in ready:
            others = sorted(references(values[name]))
            values[name] = worked_out(values[name], tuple((n, values[n]) for n in others))
        waiting = [name for name in waiting if name not in ready]
    return values


# --- lists and ranges --------------------------------------------------------------------------


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
    """The values that one line of [values] lists, as texts."""
    listed = [part.strip() for part in text.split(",")]
    for one in listed:
        check_length(one)
    try:
        if not is_along_x(text) and (match := RANGE.fullmatch(", ".join(listed))):
            return span(*match.groups())
    except ValueError as error:
        raise ValueError(f"'{text}' is not a range: {error}") from None
    if not all(listed):
        raise ValueError(f"'{text}' has an empty value")
    bare = [one for one in listed if re.fullmatch(f"[-+]?{NUMBER}", one)]
    if bare and any(map(WITH_UNIT.fullmatch, listed)):
        decimals = "; decimals have a point" * (len(listed) == 2)
        raise ValueError(f"'{text}' is unclear: {bare[0]} needs a unit, too{decimals}")
    return listed


# --- tables, combinations ----------------------------------------------------------------------


def table_in(path):
    """{line: its cells} of a CSV table (docs/runs.md), without blanks around them, empty ones at
    the end, comments and empty lines: as cells_of() of src/tools/cli/profile.cpp."""
    found = {}
    for number, line in enumerate(read_text(path).split("\n"), 1):
        cells = [cell.strip(" ") for cell in next(csv.reader([line], skipinitialspace=True), ())]
        while cells and not cells[-1]:
            cells.pop()
        if cells and not cells[0].startswith("#"):
            found[number] = cells
    return found


def rows_in(path):
    """The points of a table, {name: text} of each. The unit in a heading is that of its cells; in a
    table of results, values come before `status`."""
    try:
        table = table_in(path)
    except csv.Error:
        raise UsageError(f"{path} is not a CSV table") from None
    headings = table.pop(first := min(table, default=0), [])
    columns = [HEADING.findall(heading)[0][::2] for heading in headings]
    if len({name for name, _ in columns} - {""}) < len(headings):
        raise UsageError(f"{path}: each column needs a heading of its own")
    values = columns[: [*headings, "status"].index("status")]
    for number, row in {first: headings, **table}.items():
        sentence = ""
        if len(row) > len(headings) or len(row) < len(values) or "" in row[: len(values)]:
            sentence = "it needs as many cells as the first line, none of them empty"
        try:
            check_letters("".join(row))
            check_length(max(row, key=len, default=""))
        except UsageError as error:
            sentence = f"{error}"
        if sentence:
            raise UsageError(f"{path}, line {number}: {sentence}")
    units = {name: "" if unit == "1" else unit.strip(" ") for name, unit in values}
    return [
        {name: cell + unit for (name, unit), cell in zip(units.items(), row)}
        for row in table.values()
    ]


def combined(lists, rows):
    """The values of all points: `lists` by section, combined with each row of a table. The last
    name varies fastest."""
    common, variants = lists.get("values", {}), [one for one in lists if one != "values"]
    for name in {name for one in lists.values() for name in one} & next(iter(rows), {}).keys():
        raise UsageError(f"'{name}' is a value and a column of the table: keep one of them")
    made = []
    for section in variants or ["values"]:
        own = {"variant": [section.removeprefix("variant ")]} if variants else {}
        made.append(own | common | lists.get(section, {}))
    count = len(rows) * sum(math.prod(map(len, one.values())) for one in made)
    if count > LIMIT:
        raise UsageError(f"there are {count:,} points; at most {LIMIT:,} are possible")
    for own in made:
        for row in rows:
            for texts in itertools.product(*own.values()):
                yield calculated(dict(zip(own, texts)) | row)
