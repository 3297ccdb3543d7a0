"""Chain files and sweep files as text: sections, tables of points, products of values, and errors
that name the place."""

import configparser
import csv
import difflib
import math
import re
import shlex
from contextlib import contextmanager
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

from rupture.errors import Failure, UsageError
from sweeps.values import calculate, references

MOST_BATCHES = 64  # of up to LARGEST_BATCH points, so that many cores have work until the end
LARGEST_BATCH = 60  # points
FORMER = {  # sections and keys of [sweep] up to version 0.3, and what is written instead
    "prepare": "write a command in [commands], as prepare = prepare {values} -o start.h5 --quiet",
    "load": "write a command in [commands], as load = load --until 0.5 {values} -o end.h5 --quiet",
    "restart": "write a command in [commands], as restart = restart {base} --for 0.01 {values}"
    " -o end.h5 --record record.h5 --quiet",
    "analyze": "write commands in [commands], as front = analyze front record.h5 --json",
    "seeds": "write seed = 1 to 5 in [values]",
    "table": "call this section [quantities]",
}
HEADING = re.compile(r"^(.*?)(\s*\[([^\[\]]*)\])?$")
MEGABYTES = {"MB": 1, "GB": 1000}


@dataclass(frozen=True)
class Sweep:
    title: str
    points: list
    columns: dict  # heading: path inside the point's file
    varied: list  # names of the values that differ between points, without those that follow others
    units: dict  # of values and columns, where the file has them
    file: str  # as it was run


# --- points --------------------------------------------------------------------------------


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


def rows_of(path):
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


def is_values(section):
    return section == "values" or section.startswith("variant ")


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
    """The points of each job. Neighbours, which take about the same time, go to different jobs."""
    size = min(LARGEST_BATCH, math.ceil(len(points) / MOST_BATCHES))
    count = math.ceil(len(points) / size) if points else 0
    return [points[number::count] for number in range(count)]


def names_of_values(points):
    return list(dict.fromkeys(name for point in points for name in point.values))


# --- files ---------------------------------------------------------------------------------


def suggestion(name, known):
    """Of a similar name, or one that differs only in capitals."""
    by_lower = {other.lower(): other for other in known}
    near = difflib.get_close_matches(name.lower(), by_lower, n=1)
    return f": did you mean '{by_lower[near[0]]}'?" if near else ""


def check_known(name, known, what):
    if name not in known and name in FORMER and what != "there is no program":
        raise UsageError(f"'{name}' belongs to an older form of sweeps: {FORMER[name]}")
    if name not in known:
        raise UsageError(f"{what} '{name}'{suggestion(name, known)}")


def needs_of(section):
    """Megabytes and threads of each point."""
    memory, threads = section.get("memory", "1 GB"), section.get("threads", "1")
    amount = re.fullmatch(r"(\d*\.?\d+)\s*(MB|GB)", memory)
    megabytes = math.ceil(float(amount[1]) * MEGABYTES[amount[2]]) if amount else 0
    if not megabytes:
        wanted = "give a number and MB or GB, as in memory = 2 GB"
        raise UsageError(f"'memory = {memory}' is not understood: {wanted}")
    if not re.fullmatch("[1-9][0-9]{0,3}", threads):
        raise UsageError(f"'threads = {threads}' is not understood: give a whole number from 1")
    return {"megabytes": megabytes, "threads": int(threads)}


def read_ini(path):
    """The sections of a file as they are written."""
    ini = configparser.RawConfigParser(
        default_section="", delimiters="=", inline_comment_prefixes="#;"
    )
    ini.optionxform = str  # type: ignore[method-assign, assignment]  # names are case-sensitive
    with open(path, encoding="utf-8-sig") as file:
        ini.read_file(file)
    return ini


def place_and_sentence(error):
    """The place and sentence of a configparser.Error, whose own message has several lines."""
    if hasattr(error, "errors"):
        line = str(error).splitlines()[1].partition("]: ")[2]  # in errors, some Pythons quote it
        said = f"expected NAME = VALUE or [SECTION] (got {line})".replace("\\n", "")
        return f"{error.source}, line {error.errors[0][0]}: {said}"
    said = str(error).partition("]: ")[2]
    said = said or f"expected [SECTION] first (got {error.line.strip()!r})"
    return f"{error.source}, line {error.lineno}: {said}"


@contextmanager
def errors_of(path):
    """Raises one sentence with the file: UsageErrors, but a Failure if the system refuses."""
    try:
        yield
    except OSError as error:
        paths = dict.fromkeys((str(path), str(error.filename or path)))
        raise Failure(f"{': '.join(paths)}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise UsageError(f"{path}: it is not UTF-8 text") from None
    except configparser.Error as error:
        raise UsageError(place_and_sentence(error)) from None
    except (Failure, ValueError) as error:
        raise UsageError(f"{path}: {' '.join(str(error).split())}") from None
