"""Every combination of values is a point: products, rows of a table, options, batches."""

import csv
import math
import re
import shlex
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

from rupture.errors import UsageError
from chains.values import calculate, references

MOST_BATCHES = 64  # of up to LARGEST_BATCH points, so that many cores have work until the end
LARGEST_BATCH = 60  # points
HEADING = re.compile(r"^(.*?)(\s*\[([^\[\]]*)\])?$")


def evaluate(values):
    """Replaces expressions by their values, in whatever order they depend on each other."""
    known = dict(values)
    graph = TopologicalSorter({name: references(text) for name, text in values.items()})
    try:
        for name in graph.static_order():
            if references(known.get(name, "")):
                known[name] = calculate(known[name], known)
    except CycleError as error:
        names = ", ".join(error.args[1][1:])
        raise UsageError(f"{names}: a value cannot depend on itself") from None
    return known


def options(values):
    """The values as options of a tool."""
    return " ".join(
        f"--set {shlex.quote(f'{name}={value}')}"
        if "." in name
        else f"--{name} {shlex.quote(value)}"
        for name, value in values.items()
        if name != "variant"
    )


def rows_in(path):
    """The points of a table, each as lists of one value; none while the table is still to come. The
    unit in a heading is that of its cells; in a table of results, values come before `status`."""
    if not Path(path).exists():
        return []
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            table = csv.DictReader(file, restkey="", skipinitialspace=True)
            rows = {table.line_num: row for row in table}
            names = table.fieldnames or []
    except (UnicodeDecodeError, csv.Error):
        raise UsageError(f"{path} is not a CSV table in UTF-8") from None
    columns = [(heading, *HEADING.findall(heading)[0][::2]) for heading in names]
    if len({name for _, name, _ in columns}) < len(names) or "" in names:
        raise UsageError(f"{path}: each column needs a heading of its own")
    for number, row in rows.items():
        if "" in row or None in row.values():
            raise UsageError(f"{path}, line {number}: it needs as many cells as the first line")
    values = columns[: [*names, "status"].index("status")]
    return [{name: [row[at] + unit] for at, name, unit in values} for row in rows.values()]


def products(lists, rows):
    """{name: its values} of each product: `lists` by section, combined with each of the rows."""
    common = lists.pop("values", {})
    if not lists:
        return [common | row for row in rows]
    return [
        {"variant": [section.removeprefix("variant ").strip()]} | common | row | own
        for section, own in lists.items()
        for row in rows
    ]


def batches_of(points):
    """The points of each job, in their order."""
    size = min(LARGEST_BATCH, math.ceil(len(points) / MOST_BATCHES))
    return [points[start : start + size] for start in range(0, len(points), size or 1)]
