"""Claims of the paper beside what was measured, and its numbers beside ours:
results/figN/claims.json."""

import json
import re
from dataclasses import MISSING, asdict, dataclass, fields, replace

from rupture.commands.folder import fits, in_lines, parsed, read_own
from rupture.errors import Failure
from rupture.replacing import write_whole

CLAIMS = "claims.json"  # a recipe has run if this is among its results
REPRODUCED = "reproduced"
BY_THE_MEASURE = "by the measure"
IN_PART = "in part"
UNDECIDED = "undecided"
DIFFERS = "differs"
NOT_COMPARABLE = "not comparable"
VERDICTS = (REPRODUCED, BY_THE_MEASURE, IN_PART, UNDECIDED, DIFFERS, NOT_COMPARABLE)
HOLDS, DOES_NOT_HOLD = "holds", "does not hold"  # for what a picture shows
STANDINGS = (*VERDICTS[:1], HOLDS, *VERDICTS[1:4], DOES_NOT_HOLD, *VERDICTS[4:])  # in counts
SCHEMA = 3  # of claims.json; before, samples were units, and ways conventions


@dataclass(frozen=True)
class Share:
    """The samples for which a claim holds in one way to measure; `low` and `high` bound their part,
    None for one state."""

    way: str
    holds: int
    samples: int
    runs: int  # of which the samples are
    low: float | None
    high: float | None

    def __post_init__(self):
        is_part = 0 <= self.holds <= self.samples and 0 <= self.runs <= self.samples
        if not is_part or (self.low is None) != (self.high is None):
            raise ValueError(f"not a share: {self}")

    def part(self):
        return self.holds / self.samples if self.samples else 0.0


@dataclass(frozen=True)
class Claim:
    """One row. `measured` has numbers by name and unit: {"slow speed [m/s]": 9.8}. `shown` says
    whether the claim holds for what the picture shows; None if that was chosen because it does, or
    has not been measured. `verdict` is None where no samples are known. `note` says what a reader
    has to know to judge it; where a claim differs, why."""

    id: str
    kind: str  # finding or check, as in claims.toml
    fixed: str
    paper: str
    acceptance: str
    measured: dict
    shown: str | None
    shares: list  # of Share, the primary way first
    verdict: str | None
    reason: str
    note: str = ""

    @property
    def standing(self):
        """For readers: the verdict, or what is known without one."""
        return self.verdict or self.shown

    def __post_init__(self):
        if self.verdict not in (*VERDICTS, None):
            raise ValueError(f"claim {self.id}: not a verdict: '{self.verdict}'")
        if self.shown not in (HOLDS, DOES_NOT_HOLD, None):
            raise ValueError(f"claim {self.id}: neither holds nor not: '{self.shown}'")


@dataclass(frozen=True)
class Number:
    """A number of the paper beside ours, without pass or fail. `paper` is None where the paper has
    none, `shown` belongs to the event or set in the picture, `most_like` to the event most like the
    paper's. The others are the median and where 5 and 95 % of what `of` names lie."""

    quantity: str  # with its unit, as in "l_0 [mm]"
    paper: float | None
    shown: float | None = None
    most_like: float | None = None
    median: float | None = None
    low: float | None = None
    high: float | None = None
    of: str = ""
    note: str = ""

    @property
    def ratio(self):
        """Our median, or without one the shown value, over the paper's number."""
        ours = self.shown if self.median is None else self.median
        return ours / self.paper if ours is not None and self.paper is not None else None


def plain(value):
    """NumPy's numbers and arrays as Python's, for JSON."""
    return value.tolist()


def write_claims(path, claims, numbers=(), builds=()):
    """Writes all or nothing. NaN is an error: a missing value is None. `builds`: of the programs
    that have computed what was judged (report/jobs.py)."""
    content = {"schema": SCHEMA, "claims": [*map(asdict, claims)]}
    content |= {"numbers": [*map(asdict, numbers)], "builds": builds}
    content = in_lines(content)  # a store may say anything
    text = json.dumps(content, indent=2, ensure_ascii=False, allow_nan=False, default=plain) + "\n"
    write_whole(path, text)


def is_number(value):
    return isinstance(value, (int, float)) and abs(value) < 1e300


def is_value(value):
    """Of what was measured."""
    if isinstance(value, list):
        return all(map(is_value, value))
    return value is None or isinstance(value, str) or is_number(value)


def is_number_or_none(value):
    return value is None or is_number(value)


def is_build(value):
    """A text about a build, and how many commands it has done."""
    return isinstance(value, list) and [*map(type, value)] == [str, int]


def form_of(kind, **forms):
    """Of a dataclass as JSON (rupture/commands/folder.py), with these for some of its fields."""
    found = {}
    for each in fields(kind):
        form = is_number_or_none if each.type == float | None else each.type
        is_needed = each.default is each.default_factory is MISSING
        found[each.name + "?" * (not is_needed)] = forms.get(each.name, form)
    return found


CLAIM = form_of(Claim, measured={"": is_value}, shares=[form_of(Share)])
TABLE = {"schema": int, "claims": [CLAIM], "numbers": [form_of(Number)], "builds": [is_build]}


def read_results(path):
    """The claims, the numbers, and the builds."""
    try:
        content = parsed(read_own(path), {"schema": int, "": object}, in_lines)
        if content["schema"] != SCHEMA:
            raise ValueError(f"its schema is {content['schema']}, not {SCHEMA}")
        if not fits(content, TABLE):
            raise ValueError("values are missing, or of another type")
        claims = [Claim(**row) for row in content["claims"]]
        claims = [replace(c, shares=[Share(**share) for share in c.shares]) for c in claims]
        return claims, [Number(**row) for row in content["numbers"]], content["builds"]
    except (OSError, ValueError) as error:
        raise Failure(f"{path} is not a table of claims ({error})") from error


# --- for readers ---------------------------------------------------------------------------


def number(value):
    if value is None:
        return "none"
    if isinstance(value, list):
        return ", ".join(map(number, value))
    if isinstance(value, float):
        text = f"{value:.3g}"
        return f"{float(text):.0f}" if "e+" in text and abs(float(text)) < 1e6 else text
    return str(value)


def split_unit(name):
    """Quantity and unit of "speed [m/s]"."""
    match = re.fullmatch(r"(.*?)\s*\[(.*)\]", name)
    return match.group(1, 2) if match else (name, "")
