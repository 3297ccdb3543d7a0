"""A user's sweep (docs/sweeps.md): its chain, checked against what the programs say of themselves,
and what is there of its points. RESULTS/sweeps/NAME/NAME.ini is the sweep as it was run."""

import io
import os
import re
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from chains.check import check, names_of
from chains.expressions import as_number
from chains.point import UNFINISHED
from chains.plan import FILES
from chains.points import Waiting
from chains.selection import Chains
from chains.store import RESULTS, read, result_of, write_own
from rupture.errors import UsageError
from rupture.units import unit_in
from report.written import take
from chains.programs import check_columns, check_points
from chains.ini import check_known, errors_of, new_ini
from chains.values import references

ENDINGS = (".ini", ".csv", ".hdf5", "-elements.csv", "-elements.hdf5", ".png", ".pdf")
NOT_REACHED = "it was not reached, or its process was ended"


@dataclass(frozen=True)
class Sweep:
    title: str
    points: list
    columns: dict  # heading: path inside the point's file, or an expression
    varied: list  # names of the values that differ between points, without those that follow others
    units: dict  # of values and columns, where the file has them
    file: str  # as it was run
    axis: str = ""  # log or linear; empty: by the numbers
    symbols: dict = field(default_factory=dict)  # of parameters, as `rupture parameters` has them
    typed: dict = field(default_factory=dict)  # units, where all numbers of a name have the same


class OwnSweep:
    """One file. `points`: None as long as others must be computed before they are known."""

    def __init__(self, path):
        path = Path(path)
        if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]*", path.stem):
            raise UsageError(
                f"{path}: rename the file: its results take its name, which may contain only"
                " letters, digits, '.', '_' and '-'"
            )
        with errors_of(path):
            path.stat()
        self.stem = RESULTS / "sweeps" / path.stem / path.stem
        self.chains = Chains()
        self.chain = self.chains.load(path)
        check(self.chains, self.chain)
        self.points = None
        with suppress(Waiting):
            self.points = self.chains.points(self.chain)
        self.check_some()
        units: dict[str, str] = {}
        for chain in self.lineage:
            if points := self.chains.made.get(chain.path):
                with chain.errors_at("values", ""):
                    units |= check_points(points, self.chains.programs)
        lists = [one for chain in self.lineage for one in chain.lists.values()]
        self.lists = [item for one in lists for item in one.items()]
        values, names = [name for name, _ in self.lists], names_of(self.chains, self.chain)
        columns, of_columns = check_columns(self.chain, values, names, self.chains.programs)
        self.sweep = Sweep(
            title=self.chain.keys.get("title", self.chain.path.stem),
            points=self.points or [],
            columns=columns,
            varied=self.varied(),
            units=units | of_columns,
            file=f"{self.stem}.ini",
            axis=self.chain.keys.get("axis", ""),
            symbols={n: row["symbol"] for n, row in self.chains.programs.parameters.items()},
            typed=self.typed(),
        )
        self.check_axis()

    def check_axis(self):
        """That a logarithmic axis has positive numbers only."""
        with self.chain.errors_at("chain", "axis"):
            check_known(self.sweep.axis, ("", "log", "linear"), "an axis is log or linear, not")
            if self.sweep.axis != "log":
                return
            for name, text in ((n, row.get(n)) for row in self.texts for n in self.sweep.varied):
                if isinstance(value := as_number(text), float) and value <= 0:
                    raise UsageError(f"{name} is {text}: a logarithmic axis has no place for it")

    def check_some(self):
        """That there are points, if they are known."""
        above = self.chains.above(self.chain)
        what = "[values] or a table says for which values to run"
        if above:
            what = f"none of {above.path.name} is as 'points' says"
        if self.points == [] or not above and not any(one.values for one in self.points or ()):
            raise self.chain.error("values", "", f"there are no points: {what}")

    @property
    def lineage(self):
        """The chains from which its points come, then its own."""
        found = [self.chain]
        while above := self.chains.above(found[0]):
            found.insert(0, above)
        return found

    @cached_property
    def texts(self):
        """{name: its value as a text} of each point."""
        return [point.texts(point.look_up) for point in self.points or ()]

    def varied(self):
        """Names of the values that differ between points, and follow no others."""
        follows = {name for name, texts in self.lists if len(texts) == 1 and references(texts[0])}
        names = dict.fromkeys(name for row in self.texts for name in row if name not in follows)
        found = [name for name in names if len({row.get(name) for row in self.texts}) > 1]
        return [name for name in found if name == "variant" or not self.names_variant(name)]

    def names_variant(self, name):
        """Whether each variant has one value of it, so that it varies with the variant."""
        pairs = {(row.get("variant"), row.get(name)) for row in self.texts}
        return len(pairs) == len({variant for variant, _ in pairs}) > 1

    def typed(self):
        found: dict[str, set] = {}
        for name, text in (item for row in self.texts for item in row.items()):
            found.setdefault(name, set()).add(unit_in(text or ""))
        return {name: units.pop() for name, units in found.items() if len(units) == 1}

    @property
    def before(self):
        """Points that decide about its points, or from which these start."""
        made = self.chains.made.items()
        return [point for path, points in made if path != self.chain.path for point in points]

    def missing(self):
        """Points that are to be computed."""
        return [point for point in self.points or () if not point.is_done]

    def write(self):
        """Replaces the former plan, which tells what the table is of."""
        files = [self.stem.with_name(self.stem.name + ending) for ending in ENDINGS]
        sections = {"sweep" if n == "chain" else n: {**s} for n, s in self.chain.sections.items()}
        own = sections.setdefault("sweep", {})
        sections |= {"units": self.sweep.units}
        own.pop("like", None)
        if len(self.chain.copies) == 1:
            own["base"] = os.path.relpath(next(iter(self.chain.copies.values())), self.stem.parent)
        ini, text = new_ini(), io.StringIO()
        with errors_of(self.chain.path):
            take(RESULTS, *files, *(self.stem.parent / "plan" / name for name in FILES))
            if self.chain.table:
                copy = self.stem.with_name(f"{self.stem.name}-points.csv")
                write_own(copy, self.chain.table.read_bytes())
                own["points"] = own["points"].replace(self.chain.points["chain"], copy.name)
            ini.read_dict(sections)
            ini.write(text)
            write_own(files[0], text.getvalue().encode())


def result(point):
    """What is known of a point; a program that crashed left a sentence."""
    if point.is_done:
        return result_of(point.path)
    sentence = read(point.path.with_suffix(".crash")) or NOT_REACHED
    return {"status": UNFINISHED, "sentence": sentence, "reports": {}}
