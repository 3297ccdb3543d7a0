"""Cases: what a row of claims.toml measures at points of chains (chains/results.py).

A unit is a point; its cases are one, or one for each element of a list that it reports."""

from chains.chain import SELECTION
from chains.expressions import Expression
from claims.claim import PRIMARY
from rupture.errors import Failure


class Names:
    """What expressions of a row see: its own names (`with`), an element of a list, and the values
    and reports of a point; of reports with several ways to measure (`under`), that of one way."""

    def __init__(self, row, point, way=PRIMARY, elements=()):
        self.row, self.point, self.way = row, point, way
        self.given = dict(elements)

    def value(self, text):
        own = [name for name in (*self.given, *self.row.get("with", ())) if "-" in name]
        try:
            return Expression(text, (*own, *self.point.names)).value(self.look_up)
        except ValueError as error:
            raise Failure(f"claims.toml, claim {self.row['id']}: {error}") from None

    def look_up(self, name):
        if name not in self.given:
            self.given[name] = self.found(name)
        return self.given[name]

    def found(self, name):
        if name in self.row.get("with", ()):
            return self.value(self.row["with"][name])
        value = self.point[name]
        is_by_way = isinstance(value, dict) and "under" in value and self.way != PRIMARY
        return value["under"][self.way] if is_by_way else value

    def case(self, quantities=None):
        """{quantity: value}, of all that is measured or of some; what is so or not is "yes" or
        "no"."""
        measured = self.row["measured"]
        found = {name: self.value(measured[name]) for name in quantities or measured}
        return {n: "yes" if v is True else "no" if v is False else v for n, v in found.items()}


def of_selection(text):
    """What `CHAIN where CONDITION` or `NAME in CHAIN: LIST where CONDITION` says, by the names in
    SELECTION."""
    if not (found := SELECTION.fullmatch(text)):
        raise Failure(f"claims.toml: '{text}' names no points: write CHAIN where CONDITION")
    return found.groupdict()


def selected(text, chains):
    """The points that it names, and what it says."""
    found = of_selection(text)
    points = chains[found["chain"]]
    if condition := found["condition"]:
        points = [p for p in points if Expression(condition, p.names).value(p.__getitem__)]
    return points, found


def of_shown(row, chains, way=PRIMARY):
    """{name of a case in the picture: its Names}, that which decides first; none if it has not been
    computed."""
    shown = row["shown"]
    instead = row | {"with": row.get("with", {}) | row.get("in_picture", {})}
    found: dict[str, Names] = {}
    for name, text in ({"": shown} if isinstance(shown, str) else shown).items():
        points, _ = selected(text, chains)
        found |= {name: Names(instead, point, way) for point in points[:1]}
    return found


def one_exists(row):
    """Whether one of the cases of a unit is enough: "there is such an event"."""
    return "each" in row and bool(of_selection(row["each"])["element"])


def of_unit(row, point, way, where):
    """[Names of each case] of a point; None if it is no unit, because there is nothing to compare.
    A point that failed has no case, which counts against the claim."""
    if point.status == "failed":
        return []
    names = Names(row, point, way)
    if where["element"]:
        elements = names.value(where["list"])
        return [Names(row, point, way, {where["element"]: one}) for one in elements]
    return [names] if "if" not in row or names.value(row["if"]) else None


def run_of(point):
    """The seed of the run that it comes from: events of one run share a history. A point without a
    seed is a run of its own."""
    return point["numerics.seed"] if "numerics.seed" in point.names else id(point)


def units(row, chains, way=PRIMARY):
    """{unit: [Names of each case]}; a unit is (its number, the run that it is from)."""
    points, where = selected(row["each"], chains)
    found = {(n, run_of(one)): of_unit(row, one, way, where) for n, one in enumerate(points)}
    return {unit: cases for unit, cases in found.items() if cases is not None}


def conventions(row, chains):
    """{convention: (row, way)}, the primary one first: ways to measure, all that the reports have
    or those that the row names, and what its `under` replaces."""
    found = {PRIMARY: (row, PRIMARY)}
    if ways := row.get("ways"):
        points, _ = selected(row.get("each", row["shown"]), chains)
        named = ways_in(points) if ways is True else ways
        found |= {way: (row, way) for way in named}
    for name, instead in row.get("under", {}).items():
        names = row.get("with", {}) | instead.get("with", {})
        found[name] = (row | instead | {"with": names}, PRIMARY)
    return found


def ways_in(points):
    """The ways to measure that the first point has which did not fail."""
    for point in points:
        if point.status == "done":
            reports = [report for of in point.results for report in of["reports"].values()]
            return max((list(r.get("under", ())) for r in reports if r), key=len, default=[])
    return []
