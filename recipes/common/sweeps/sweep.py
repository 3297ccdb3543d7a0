"""Sweeps: one chain of commands for many values of some parameters, described by an INI file.

    [sweep]
    title = Front type of prepared interfaces

    [commands]                      # as typed by hand; {values} are the options of the point
    prepare = prepare {values} -o start.h5
    restart = restart start.h5 -o end.h5 --until-quiet --record record.h5
    front   = analyze front record.h5 --json

    [values]                        # every combination is a point
    tau-bar       = 0 to 0.4 by 0.02
    sigma-bar     = 0, 0.05, 0.1
    numerics.seed = 1 to 5 by 1

    [table]                         # columns beside the values: where to find them
    type            = front.type
    slow speed [m/s] = front.slow.speed

A name without a dot is an option (--tau-bar 0.1), one with a dot a parameter (--set
numerics.seed=1). Values are a list, a range (`a to b`: in ones, `a to b by step`, `a to b in n`:
n values, both ends included), or an arithmetic expression of other values: `0.3 * {junctions.t_R}`.
Sections [variant NAME] add to or replace those of [values]; each is a product of its own, and its
name becomes the column `variant`. `points = FILE.csv` in [sweep] takes the points from a table
instead, whose columns are names; columns in [values] are combined with each of its rows. `base =
FILE` in [sweep] names a checkpoint that the commands use as {base}; `memory` and `threads` say what
the computer is to provide for a point (needs.py). A comment begins with # or ;.

`seeds = 2 to 5` in [sweep] of a recipe: the same sweep again with each of these seeds, in tables of
its own, results/data/NAME/SWEEP-seed-2.csv. Its name as a file is SWEEP.ini#2.

Each point is one file, results/data/points/ID.json, where ID follows from its commands: what is
there already is not computed again, whichever sweep it belonged to, and adding values adds points.

A user's own file (docs/sweeps.md) may be shorter: this folder expands it to one like this.
"""

import configparser
import csv
import hashlib
import itertools
import math
import re
import string
from dataclasses import dataclass
from pathlib import Path

from sweeps.needs import Needs, needs_of
from sweeps.sweep_values import LIMIT, SweepError, calculate, references, values_of

BATCHES_OF_ONE = 64  # of a large sweep, so that many cores have work until its end
BATCHES_OF_MANY = 12  # of each if there are many sweeps: planning takes 1.5 ms for a job
LARGEST_BATCH = 60  # points
SEED = "numerics.seed"


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
    needs: Needs  # of each point
    varied: list  # names of the values that differ between points, without those that follow others
    units: dict  # of values and columns, where the file has them


# --- points --------------------------------------------------------------------------------


def evaluate(values):
    """Replaces expressions by their values, in whatever order they depend on each other."""
    known = {name: text for name, text in values.items() if not references(text)}
    waiting = {name: text for name, text in values.items() if references(text)}
    while waiting:
        ready = [n for n, text in waiting.items() if not set(references(text)) & set(waiting)]
        if not ready:
            raise SweepError(f"{', '.join(waiting)} depend on each other")
        for name in ready:
            known[name] = calculate(waiting.pop(name), known)
    return {name: known[name] for name in values}


def product(lists):
    """Every combination, the last name varying fastest."""
    for combination in itertools.product(*lists.values()):
        yield evaluate(dict(zip(lists, combination)))


def options(values):
    """The values as options of a tool."""
    return " ".join(
        f"--set {name}={value}" if "." in name else f"--{name} {value}"
        for name, value in values.items()
        if name != "variant"
    )


def fill(command, fields):
    try:
        return string.Formatter().vformat(command, (), fields)
    except (AttributeError, KeyError, IndexError, TypeError, ValueError):
        known = " and ".join(f"{{{name}}}" for name in fields)
        raise SweepError(f"'{command}' may refer to {known} only") from None


def make_point(commands, values, base):
    fields = {"values": options(values)} | ({"base": base} if base else {})
    return Point(values, {name: fill(line, fields) for name, line in commands.items()}, base)


def lines_of(path):
    """(number, cells) of each line of a CSV file."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as file:
            table = csv.reader(file)
            return [(table.line_num, cells) for cells in table if cells]
    except OSError as error:
        raise SweepError(f"{path} cannot be read ({error.strerror})") from None
    except (UnicodeDecodeError, csv.Error):
        raise SweepError(f"{path} is no table of CSV in UTF-8") from None


def rows_of(path):
    """The points of a table, each as lists of one value; none while the table is still to come."""
    if not Path(path).exists():
        return []
    (_, names), *lines = lines_of(path) or [(0, [])]
    if len({*names}) < len(names) or "" in names:
        raise SweepError(f"{path}: each column needs a heading of its own")
    for number, cells in lines:
        if len(cells) != len(names):
            raise SweepError(
                f"{path}, line {number}: the number of cells is {len(cells)},"
                f" in the first line {len(names)}"
            )
    return [{name: [cell] for name, cell in zip(names, cells)} for _, cells in lines]


def lists_of(section):
    return {name: values_of(text) for name, text in section.items()}


def is_values(section):
    return section == "values" or section.startswith("variant ")


def combinations(ini):
    """The products whose elements are the points."""
    common = lists_of(ini["values"]) if "values" in ini else {}
    table = ini["sweep"].get("points")
    variants = [name for name in ini.sections() if name.startswith("variant ")]
    rows = rows_of(table) if table else [{}]
    if not variants:
        return [common | row for row in rows]
    return [
        {"variant": [name.removeprefix("variant ").strip()]} | common | row | lists_of(ini[name])
        for name in variants
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
    follows = {
        name
        for lists in products
        for name, texts in lists.items()
        if len(texts) == 1 and references(texts[0])
    }
    return [
        name
        for name in names_of_values(points)
        if name not in follows and len({point.values.get(name) for point in points}) > 1
    ]


def empty_ini():
    """Names in it are case-sensitive."""
    ini = configparser.ConfigParser(
        interpolation=None, delimiters=("=",), inline_comment_prefixes=("#", ";")
    )
    ini.optionxform = str  # type: ignore  # it is a method, replaced as configparser's manual says
    return ini


def parse_ini(path):
    ini = empty_ini()
    try:
        with open(path, encoding="utf-8-sig") as file:
            ini.read_file(file)
    except OSError as error:
        raise SweepError(f"it cannot be read ({error.strerror})") from None
    return ini


def sweep_of(ini, name):
    """The sweep that a parsed file of this name describes."""
    for section in ("sweep", "commands"):
        if section not in ini:
            raise SweepError(f"it has no section [{section}]")
    base = ini["sweep"].get("base", "")
    commands = dict(ini["commands"])
    products = combinations(ini)
    count = sum(math.prod(len(texts) for texts in lists.values()) for lists in products)
    if count > LIMIT:
        raise SweepError(f"there are {count:,} points; at most {LIMIT:,} are possible")
    points = [make_point(commands, values, base) for lists in products for values in product(lists)]
    title = ini["sweep"].get("title", name)
    columns, units = (dict(ini[name]) if name in ini else {} for name in ("table", "units"))
    return Sweep(title, points, columns, needs_of(ini["sweep"]), varied_in(products, points), units)


def file_and_seed(name):
    """("SWEEP.ini", "2") of SWEEP.ini#2; ("SWEEP.ini", "") of SWEEP.ini."""
    match = re.fullmatch(r"(.*\.ini)#(\d+)", str(name), re.DOTALL)
    return match.groups() if match else (str(name), "")


def seeds_of(path):
    """Those with which the sweep is run again, in tables of their own."""
    text = parse_ini(path)["sweep"].get("seeds")
    return values_of(text) if text else []


def with_seed(ini, seed):
    """The same for another seed, as the last value of each point."""
    for section in filter(is_values, ini.sections() if seed else []):
        ini[section][SEED] = seed
    return ini


def read_sweep(path):
    """The sweep that an INI file describes, or SWEEP.ini#2. SweepErrors name the file."""
    try:
        file, seed = file_and_seed(path)
        return sweep_of(with_seed(parse_ini(file), seed), Path(file).stem)
    except (OSError, ValueError, configparser.Error) as error:
        raise SweepError(f"{path}: {sentence_of(error)}") from None


def sentence_of(error):
    """One line; the caller has named the file."""
    if isinstance(error, OSError):
        return f"{error.filename} cannot be read ({error.strerror})"
    if isinstance(error, UnicodeDecodeError):
        return "it is no text in UTF-8"
    if isinstance(error, configparser.MissingSectionHeaderError):
        return f"line {error.lineno} comes before the first section, which begins with [sweep]"
    if isinstance(error, configparser.DuplicateSectionError):
        return f"section [{error.section}] is there twice (line {error.lineno})"
    if isinstance(error, configparser.DuplicateOptionError):
        return f"'{error.option}' is in [{error.section}] twice (line {error.lineno})"
    if isinstance(error, configparser.ParsingError):
        number, line = error.errors[0]
        return f"line {number} is neither [SECTION] nor NAME = VALUE: {line}"
    return str(error)


def is_sweep(path):
    return "[commands]" in Path(path).read_text(encoding="utf-8").splitlines()
