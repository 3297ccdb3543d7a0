"""Values in chain files: lists, ranges, tables, arithmetic on other values, and their products.
Mistakes are ValueErrors."""

import csv
import functools
import math
import re
from pathlib import Path

from chains.expressions import Expression, as_number
from rupture.errors import UsageError
from rupture.units import NUMBER, PREFIXES, UNIT, amount, one_name

RANGE = re.compile(r"(.+?)\s+to\s+(.+?)(?:\s+(by|in)\s+(.+))?")
# A number without a unit before one with a unit, which may be that of both, or the comma a decimal
# one: 0,4mm/s. Only a 0 with a blank behind its comma is clear.
BARE = rf"\s*[-+]?{NUMBER}\s*"
MIXED = re.compile(rf"(?:^|,)(?!\s*[0.]+\s*,\s){BARE},{BARE}({UNIT})\s*(?:,|$)")
REFERENCE = re.compile(r"\{([^{}]+)\}")
HEADING = re.compile(r"^(.*?)(\s*\[([^\[\]]*)\])?$")  # of a table: a name, and perhaps a unit
LIMIT = 100_000  # points of a sweep


def is_expression(text):
    """Whether it is one expression in braces, whose value is known when it is needed."""
    return bool(REFERENCE.fullmatch(text))


def text_of(number):
    """A number with 12 digits: 0.1 + 0.2 is 0.3."""
    return f"{number:.12g}"


@functools.cache
def references(text):
    return {*REFERENCE.findall(text)}


@functools.cache  # many points have the same
def calculate(text, values):
    """The number, as a text, that follows from other values: pairs of a name and its text."""
    numbers = {name: as_number(value) for name, value in values}
    try:
        number = Expression(REFERENCE.sub(r"\1", text), numbers).value(numbers.__getitem__)
        if isinstance(number, bool) or not isinstance(number, (int, float)):
            raise ValueError("it is no number")
        return text_of(number)
    except (ArithmeticError, ValueError) as error:
        raise ValueError(f"'{text}' cannot be calculated: {error}") from None


def calculated(values):
    """The values, with the results of arithmetic on others (0.3 * {junctions.t_R}) in whatever
    order they depend on each other. One expression in braces stays unless it is another value."""
    waiting = {n: text for n, text in values.items() if references(text)}
    lazy = {n: t for n, t in waiting.items() if is_expression(t) and t[1:-1] not in values}
    known = {name: text for name, text in values.items() if name not in waiting}
    waiting = {name: text for name, text in waiting.items() if name not in lazy}
    while waiting:
        ready = [name for name, text in waiting.items() if not references(text) & waiting.keys()]
        if not ready:
            raise UsageError(f"{', '.join(waiting)}: a value cannot depend on itself")
        for name in ready:
            others = sorted(references(waiting[name]) & known.keys())
            known[name] = calculate(waiting.pop(name), tuple((n, known[n]) for n in others))
    return values | known


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
    bare = [one for one in listed if re.fullmatch(BARE, one) and 0 < abs(float(one)) < math.inf]
    if bare and any(re.fullmatch(BARE + UNIT, one) for one in listed):
        raise ValueError(f"'{text}' is unclear: {bare[0]} needs a unit, too")
    return listed


def table_in(path):
    """{line: its cells} of a CSV table (docs/runs.md), without blanks around them, empty ones at
    the end, comments and empty lines: as cells_of() of src/tools/cli/profile.cpp."""
    found = {}
    with open(path, encoding="utf-8-sig") as file:
        for number, line in enumerate(file, 1):
            plain = one_name(line.rstrip("\n").replace("\t", " "))
            cells = [cell.strip(" ") for cell in next(csv.reader([plain], skipinitialspace=True))]
            while cells and not cells[-1]:
                cells.pop()
            if cells and not cells[0].startswith("#"):
                found[number] = cells
    return found


def rows_in(path):
    """The points of a table, each as lists of one value. The unit in a heading is that of its
    cells; in a table of results, values come before `status`."""
    if not Path(path).is_file():
        raise UsageError(f"there is no table of points {path}")
    try:
        table = table_in(path)
    except (UnicodeDecodeError, csv.Error):
        raise UsageError(f"{path} is not a CSV table in UTF-8") from None
    headings = table.pop(min(table, default=0), [])
    columns = [HEADING.findall(heading)[0][::2] for heading in headings]
    if len({name for name, _ in columns} - {""}) < len(headings):
        raise UsageError(f"{path}: each column needs a heading of its own")
    values = columns[: [*headings, "status"].index("status")]
    for number, row in table.items():
        if len(row) > len(headings) or len(row) < len(values) or "" in row[: len(values)]:
            sentence = "it needs as many cells as the first line, none of them empty"
            raise UsageError(f"{path}, line {number}: {sentence}")
    units = {name: "" if unit == "1" else unit.strip(" ") for name, unit in values}
    rows = (zip(units.items(), row) for row in table.values())
    return [{name: [cell + unit] for (name, unit), cell in row} for row in rows]


def products(lists, rows):
    """{name: its values} of each product: `lists` by section, combined with each of the rows."""
    common = lists.pop("values", {})
    for name in common.keys() & next(iter(rows), {}).keys():
        raise ValueError(f"'{name}' is a value and a column of the table; keep one of them")
    if not lists:
        return [common | row for row in rows]
    return [
        {"variant": [section.removeprefix("variant ").strip()]} | common | row | own
        for section, own in lists.items()
        for row in rows
    ]
