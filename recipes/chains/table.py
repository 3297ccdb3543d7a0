"""Reports what a user's sweep would compute, and its results (docs/sweeps.md)."""

import re
import sys
from collections import Counter
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import h5py
import numpy as np

from rupture.replacing import replacing
from rupture.tools.command_line import in_one_line, plural
from rupture.units import without_unit
from chains.expressions import Expression
from chains.point import UNFINISHED
from chains.programs import ELEMENT, PATH
from chains.sweeps import result
from measure.tables import write_table
from measure.front_map import TYPES
from chains.picture import draw
from rupture import figures

SHOWN = 5  # sentences of failed points
TWO_DECADES = 100
FORMULA = re.compile(r"[=@]|[-+](?![\d.])")  # of a spreadsheet


# --- the table ---------------------------------------------------------------------------------


@dataclass(frozen=True)
class Column:
    name: str
    unit: str  # 1: a dimensionless number; empty: a text
    cells: list  # texts and numbers of JSON; None where there is none
    symbol: str = ""  # for Matplotlib, in place of the name
    axis: str = ""  # log or linear; empty: by the numbers

    @property
    def heading(self):
        return self.name if self.unit in ("", "1") else f"{self.name} [{self.unit}]"

    @property
    def has_texts(self):
        """Whether an expression gave a text, or a truth value."""
        return self.unit == "1" and any(isinstance(cell, (str, bool)) for cell in self.cells)

    @property
    def has_lists(self):
        return any(isinstance(cell, list) for cell in self.cells)

    @property
    def texts(self):
        return [text_of(cell) for cell in self.cells]

    @cached_property
    def categories(self):
        """Texts at 0, 1, ... of an axis: those of fronts from arrested to fast, then others in the
        order in which they appear. Empty for numbers."""
        present = [] if self.unit else [text for text in self.texts if text]
        return [text for text in dict.fromkeys(("none", *TYPES, *present)) if text in present]

    @cached_property
    def positions(self):
        """Where each point is along an axis: its number, or the place of its category."""
        if self.unit:
            return np.array(self.cells, dtype=float)
        places = {text: place for place, text in enumerate(self.categories)}
        return np.array([places.get(text, np.nan) for text in self.texts])

    @property
    def scale(self):
        """Logarithmic where positive numbers span two decades, or three or more of them are spaced
        by a factor."""
        places = np.unique(self.positions[np.isfinite(self.positions)])
        if self.axis and self.unit:
            return self.axis
        if not self.unit or not len(places) or places[0] <= 0:
            return "linear"
        spans = places[-1] >= TWO_DECADES * places[0]
        return "log" if spans or (len(places) > 2 and is_geometric(places)) else "linear"


def text_of(cell):
    if isinstance(cell, str):
        cell = in_one_line(cell)
        return f"'{cell}" if FORMULA.match(cell) else cell
    return "" if cell is None else str(cell).lower() if isinstance(cell, bool) else str(cell)


def find(tree, path):
    """The value that a path such as front.v_c.3 leads to, with * to a list of them; None where it
    leads nowhere."""
    key, _, rest = path.partition(".")
    try:
        if key == "*":
            return [find(one, rest) if rest else one for one in tree]
        one = tree[int(key)] if isinstance(tree, list) else tree[key]
    except (KeyError, IndexError, TypeError, ValueError):
        return None
    return find(one, rest) if rest else one


def measured(point, found, text):
    """What a point has of a quantity; nothing where an expression cannot be worked out."""
    value = find(found["reports"], text) if PATH.fullmatch(text) else None
    with suppress(ValueError):
        if not PATH.fullmatch(text) and found["status"] == "done":
            value = Expression(text, point.names).value(point.known)
    return [*map(in_cell, value)] if isinstance(value, list) else in_cell(value)


def in_cell(value):
    """A number, a text or a truth value; None for parts of reports and lists in lists."""
    return value if isinstance(value, (int, float, str)) else None


def is_geometric(places):
    even, even_logs = (
        np.ptp(steps) / steps.mean() for steps in map(np.diff, (places, np.log(places)))
    )
    return even_logs < min(0.1, even)


def rows(sweep, results):
    """One dict per point, of which `results` are known."""
    for point, found in zip(sweep.points, results):
        state = {name: found[name] for name in ("status", "sentence")}
        quantities = {n: measured(point, found, path) for n, path in sweep.columns.items()}
        yield {**point.texts(point.known), **state, **quantities, "point": point.id}


def columns_of(sweep, table):
    """Numbers are in the unit of their column, whatever unit they were written with."""
    others = ("status", "sentence", *sweep.columns, "point")
    values = list(dict.fromkeys(name for row in table for name in row if name not in others))
    names = [*values, *others]
    for row in table:
        row |= {n: without_unit(row[n]) for n in values if row.get(n) and sweep.units.get(n)}
    columns = [Column(n, sweep.units.get(n, ""), [row.get(n) for row in table]) for n in names]
    texts = [one.name for one in columns if one.name in sweep.columns and one.has_texts]
    return [replace(one, unit="") if one.name in texts else one for one in columns]


def elements_of(columns):
    """A row for each element of the lists, with the values and the name of the point, and the
    number of the element; nothing without lists."""
    lists = [column for column in columns if column.has_lists]
    state = columns.index(next(column for column in columns if column.name == "status"))
    heads = [*columns[:state], columns[-1]]
    lists = [
        replace(one, cells=[cell if isinstance(cell, list) else [] for cell in one.cells])
        for one in lists
    ]
    longest = [max(map(len, cells)) for cells in zip(*(one.cells for one in lists))]
    rows = [(row, n) for row, length in enumerate(longest) for n in range(length)]
    own = [replace(head, cells=[head.cells[row] for row, _ in rows]) for head in heads]
    own.append(Column(ELEMENT, "1", [n for _, n in rows]))
    for one in lists:
        cells = [one.cells[row][n : n + 1] for row, n in rows]
        own.append(replace(one, cells=[cell[0] if cell else None for cell in cells]))
    return own if lists else []


def write_csv(path, columns):
    cells = zip(*(column.texts for column in columns))
    write_table(path, [column.heading for column in columns], cells)


def fixed(texts):
    """The texts as UTF-8, all as long as the longest one."""
    encoded = [text.encode() for text in texts]
    return np.array(encoded, h5py.string_dtype("utf-8", max([1, *map(len, encoded)])))


def write_hdf5(path, title, columns):
    with replacing(path) as part, h5py.File(part, "w", locking=False) as file:
        file.attrs["title"] = fixed([title]).reshape(())
        for column in columns:
            cells = column.positions if column.unit else fixed(column.texts)
            dataset = file.create_dataset(column.name, data=cells, track_times=False)
            dataset.attrs["unit"] = fixed([column.unit or "1"]).reshape(())


# --- what is said ------------------------------------------------------------------------------


def preview(own, folder_of_tools):
    title, missing = in_one_line(own.sweep.title), own.missing()
    before = [point for point in own.before if not point.is_done]
    if own.points is None:
        what = f"its points follow from what other points report; {len(before)} of these to compute"
    else:
        count, done = plural(len(own.points), "point"), len(own.points) - len(missing)
        what = f"{count}: {done} done, {len(missing)} to compute"
        what += f" after {plural(len(before), 'other')}" if before else ""
    print(f"{title}: {what}")
    if first := [*before, *missing][:1]:
        print("Commands of the first point to compute:")
        for command in first[0].commands.values():
            print(f"  {folder_of_tools}/{command}")


def print_summary(sweep, table, missing):
    """`missing`: how many points were unfinished before. A quantity without a value is, for
    instance, the front speed at a block that does not exist."""
    counts = Counter(row["status"] for row in table)
    states = ", ".join(f"{counts[s]} {s}" for s in ("done", "failed", UNFINISHED) if counts[s])
    print(f"\n{in_one_line(sweep.title)}: {plural(len(table), 'point')}: {states}.")
    computed = missing - counts[UNFINISHED]
    print(f"Computed now: {computed}; already done: {len(table) - missing}.")
    for status in ("failed", UNFINISHED):
        said = Counter(row["sentence"] for row in table if row["status"] == status)
        lines = [
            f"  {times} x {in_one_line(sentence)}" for sentence, times in said.most_common(SHOWN)
        ]
        if len(said) > SHOWN:
            lines.append(f"  and {plural(len(said) - SHOWN, 'other sentence')}; the table has all")
        if lines:
            print(f"{status.capitalize()}:", *lines, sep="\n")
    for heading, path in sweep.columns.items() if counts["done"] else ():
        if all(row[heading] is None for row in table):
            print(f"No point has a value for {path} ({heading}).")
    return counts[UNFINISHED]


def origin_lines(command, results):
    """For the metadata of pictures: what draws them, and the files behind these results, which are
    given as (path, result)."""
    sums = ((Path(path).stem, one.get("checksums", {})) for path, one in results)
    files = ((point, *item) for point, found in sums for item in found.items())
    return [command, *(f"{point}.{name}: content-sha256 {sum[:16]}" for point, name, sum in files)]


def report_sweep(sweep, missing):
    """The exit code: 1 if points are unfinished. `missing`: how many were before."""
    results = [result(point) for point in sweep.points]
    table = list(rows(sweep, results))
    columns = columns_of(sweep, table)
    plan = Path(sweep.file).resolve()
    stem = plan.with_suffix("")
    elements, columns = elements_of(columns), [c for c in columns if not c.has_lists]
    for name, content in ((f"{stem}", columns), (f"{stem}-elements", elements)):
        if content:
            write_csv(Path(f"{name}.csv"), content)
            write_hdf5(Path(f"{name}.hdf5"), sweep.title, content)
        else:
            for ending in (".csv", ".hdf5"):
                Path(f"{name}{ending}").unlink(missing_ok=True)
    unfinished = print_summary(sweep, table, missing)
    print(f"Table: {stem}.csv and .hdf5", flush=True)  # before anything of Matplotlib
    if elements:
        print(f"Table of lists: {stem}-elements.csv and .hdf5", flush=True)
    paths = (point.path for point in sweep.points)
    figures.made_by = origin_lines(f"./reproduce.sh sweep {plan.name}", zip(paths, results))
    print(draw(stem, sweep, columns) or f"Picture: {stem}.png and .pdf", flush=True)
    if unfinished:
        print("To retry the unfinished points, run the same command again.", file=sys.stderr)
    return 1 if unfinished else 0
