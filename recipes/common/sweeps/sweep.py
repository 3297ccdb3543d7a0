"""Sweeps: one chain of commands for many values. docs/sweeps.md describes their files, those of the
recipes and those of users, recipes/README.md what is for recipes only."""

import configparser
import csv
import difflib
import hashlib
import itertools
import math
import os
import re
import shlex
from collections.abc import Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

from rupture.errors import Failure, UsageError
from sweeps.values import LIMIT, calculate, references, values_of

BATCHES_OF_ONE = 64  # of a large sweep, so that many cores have work until its end
BATCHES_OF_MANY = 12  # of each if there are many sweeps: planning takes 1.5 ms for a job
LARGEST_BATCH = 60  # points
SEED = "numerics.seed"
KEYS = ("title", "like", "base", "points", "seeds", "memory", "threads")
SECTIONS = ("sweep", "commands", "values", "quantities", "units")
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
class Point:
    values: dict  # name: text, as the commands have it
    commands: dict  # name: command line
    base: str  # file that the commands read, or ""

    @property
    def id(self):
        return hashlib.sha256(repr([self.base, *self.commands.items()]).encode()).hexdigest()[:16]


@dataclass(frozen=True)
class Sweep:
    title: str
    points: list
    columns: dict  # heading: path inside the point's file
    varied: list  # names of the values that differ between points, without those that follow others
    units: dict  # of values and columns, where the file has them
    megabytes: int = 1000  # that each point needs
    threads: int = 1
    seeds: Sequence = ()  # with which it is run again, in tables of their own
    seed: str = ""  # with which this is run again
    files: Sequence = ()  # its own, and those that it is like


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


def make_point(commands, values, base):
    fields = {"{values}": options(values)} | ({"{base}": shlex.quote(base)} if base else {})
    for line in commands.values():
        if any(part not in fields for part in re.findall(r"\{[^{}]*\}|[{}]", line)):
            lacks_base = "{base" in line and not base
            why = "; {base} needs base = FILE.h5 in [sweep]" if lacks_base else ""
            raise UsageError(f"'{line}' may refer to {' and '.join(fields)} only{why}")
    place = re.compile("|".join(fields))
    filled = {n: place.sub(lambda at: fields[at[0]], line) for n, line in commands.items()}
    return Point(values, filled, base)


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


def combinations(ini, seed):
    """The products whose elements are the points, all with the seed if there is one."""
    repeated = {SEED: [seed]} if seed else {}
    lists = {
        section: {name: values_of(text) for name, text in ini[section].items()} | repeated
        for section in filter(is_values, ini.sections())
    }
    table = ini["sweep"].get("points")
    return products(lists, rows_of(table) if table else [{}])


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


def batches_of(points, most=BATCHES_OF_ONE):
    """The points of each job. Neighbours, which take about the same time, go to different jobs."""
    size = min(LARGEST_BATCH, math.ceil(len(points) / most))
    count = math.ceil(len(points) / size) if points else 0
    return [points[number::count] for number in range(count)]


def names_of_values(points):
    return list(dict.fromkeys(name for point in points for name in point.values))


def varied_in(products, points):
    lists = [item for product in products for item in product.items()]
    follows = {name for name, texts in lists if len(texts) == 1 and references(texts[0])}
    names = [name for name in names_of_values(points) if name not in follows]
    return [name for name in names if len({point.values.get(name) for point in points}) > 1]


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


def check_form(ini):
    for key in ini["sweep"] if "sweep" in ini else ():
        check_known(key, KEYS, "[sweep] has no key")
    for section in ini.sections():
        if not is_values(section):
            check_known(section, SECTIONS, "there is no section")
        for name, text in ini[section].items():
            if not text and section != "units":
                raise UsageError(f"'{name}' in [{section}] has no value")
    for section in ("sweep", "commands"):
        if section not in ini:
            raise UsageError(f"it has no section [{section}]")


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


def parse_ini(path, read=()):
    """Sections that it lacks are those of the file `like`, variants only if it has none. Paths in
    [sweep], which are relative to the file's folder, become relative to the working directory.
    `read`: the files that led here."""
    if path in read:
        raise UsageError("'like' leads back to the same file")
    ini = read_ini(path)
    ini.files = (str(path),)  # type: ignore[attr-defined]
    if "sweep" not in ini:
        return ini
    section = ini["sweep"]
    for key in {"base", "points", "like"} & {*section}:
        section[key] = os.path.normpath(Path(path).parent / section[key])
    if "like" in section:
        other = parse_ini(section.pop("like"), (*read, path))
        ini.files += other.files  # type: ignore[attr-defined]
        present = {name.partition(" ")[0] for name in ini.sections()}
        ini.read_dict({n: other[n] for n in other.sections() if n.partition(" ")[0] not in present})
    return ini


def sweep_of(ini, name, seed=""):
    """The sweep that a parsed file of this name describes; with a seed, the same for that one."""
    check_form(ini)
    section = ini["sweep"]
    base = section.get("base", "")
    commands = {name: line.removeprefix("rupture ") for name, line in ini["commands"].items()}
    products = combinations(ini, seed)
    count = sum(math.prod(len(texts) for texts in lists.values()) for lists in products)
    if count > LIMIT:
        raise UsageError(f"there are {count:,} points; at most {LIMIT:,} are possible")
    points = [
        make_point(commands, evaluate(dict(zip(lists, texts))), base)
        for lists in products
        for texts in itertools.product(*lists.values())  # the last name varies fastest
    ]
    columns, units = (dict(ini[name]) if name in ini else {} for name in ("quantities", "units"))
    return Sweep(
        title=section.get("title", name),
        points=points,
        columns=columns,
        varied=varied_in(products, points),
        units=units,
        seeds=values_of(section["seeds"]) if "seeds" in section else (),
        seed=seed,
        files=ini.files,
        **needs_of(section),
    )


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


def read_sweep(path, seed=""):
    """The sweep that an INI file describes; with a seed, the same for that one."""
    with errors_of(path):
        return sweep_of(parse_ini(path), Path(path).stem, seed)
