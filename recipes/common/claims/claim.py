"""Claims of the paper, beside what was measured: results/figN/claims.json."""

import json
import re
from dataclasses import asdict, dataclass, replace

from rupture.errors import Failure
from rupture.replacing import write_whole

CLAIMS = "claims.json"  # a recipe has run if this is among its results
REPRODUCED = "reproduced"
DEPENDS = "depends"
DIFFERS = "differs"
NOT_COMPARABLE = "not comparable"
VERDICTS = (REPRODUCED, DEPENDS, DIFFERS, NOT_COMPARABLE)
PRIMARY = "primary"  # the convention by which the shown case is measured
SHOWN_ONLY = "shown case only"  # begins the reason of a verdict without units
HOLDS, FAILS = "holds as shown", "fails as shown"
STANDINGS = (REPRODUCED, HOLDS, DEPENDS, FAILS, DIFFERS, NOT_COMPARABLE)  # in counts


@dataclass(frozen=True)
class Share:
    """The units for which a claim holds under one convention; `low` and `high` bound their part,
    None for one state."""

    convention: str
    holds: int
    units: int
    low: float | None
    high: float | None

    def part(self):
        return self.holds / self.units

    def text(self, unit):
        return f"{self.holds} of {self.units} {plural(unit)} ({self.convention})"


def plural(unit):
    return re.sub(r"^(load|event|seed)\b", r"\1s", unit)


@dataclass(frozen=True)
class Claim:
    """One row. `measured` has numbers by name and unit: {"slow speed [m/s]": 9.8}. `shown`
    says whether the claim holds for the case that the picture shows; None if that could not be
    measured. `note` says what a reader has to know to judge the verdict; where a claim differs,
    why."""

    id: str
    paper: str
    acceptance: str
    measured: dict
    shown: bool | None
    shares: list  # of Share, the primary convention first
    verdict: str
    reason: str
    note: str = ""
    closeness_of: str = ""  # the leading row, of one that asks for more than the paper says

    @property
    def standing(self):
        """The verdict for readers; without units, it refers only to the shown case."""
        if not self.reason.startswith(SHOWN_ONLY):
            return self.verdict
        return HOLDS if self.shown else FAILS

    def __post_init__(self):
        if self.verdict not in VERDICTS:
            raise ValueError(f"claim {self.id}: not a verdict: '{self.verdict}'")


def plain(value):
    """NumPy's numbers and arrays as Python's, for JSON."""
    return value.tolist()


def write_claims(path, claims):
    """Writes all or nothing. NaN is an error: a missing value is None."""
    rows = [asdict(claim) for claim in claims]
    text = json.dumps(rows, indent=2, ensure_ascii=False, allow_nan=False, default=plain) + "\n"
    write_whole(path, text)


def read_claims(path):
    try:
        claims = [Claim(**row) for row in json.loads(path.read_text(encoding="utf-8"))]
        return [replace(c, shares=[Share(**share) for share in c.shares]) for c in claims]
    except (OSError, ValueError, TypeError) as error:
        recipe = path.parent.name
        raise Failure(
            f"{path} is not a table of claims ({error}): delete it and run ./reproduce.sh {recipe}."
        ) from error


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
