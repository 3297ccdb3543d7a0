"""Claims of the paper, beside what was measured: results/figN/claims.json."""

import json
import os
import re
from dataclasses import asdict, dataclass
from pathlib import Path

REPRODUCED = "reproduced"
DIFFERS = "differs"
NOT_COMPARABLE = "not comparable"
VERDICTS = (REPRODUCED, DIFFERS, NOT_COMPARABLE)


@dataclass(frozen=True)
class Claim:
    """One row. `measured` is text, or numbers by name and unit: {"slow speed [m/s]": 9.8}. `note`
    says what a reader has to know to judge the verdict; where a claim differs, why."""

    id: str
    paper: str
    measured: str | dict
    acceptance: str
    verdict: str
    note: str = ""

    def __post_init__(self):
        if self.verdict not in VERDICTS:
            raise ValueError(f"claim {self.id}: '{self.verdict}' is none of {', '.join(VERDICTS)}")


def verdict(accepted):
    """The verdict for True, False or None (there was nothing to compare)."""
    if accepted is None:
        return NOT_COMPARABLE
    return REPRODUCED if accepted else DIFFERS


def plain(value):
    """NumPy's numbers and arrays as Python's, for JSON."""
    return value.tolist()


def write_claims(path, claims):
    """Writes all or nothing. NaN is an error: what has no value is None."""
    path = Path(path)
    rows = [asdict(claim) for claim in claims]
    text = json.dumps(rows, indent=2, ensure_ascii=False, allow_nan=False, default=plain) + "\n"
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(path.name + ".part")
    temporary.write_text(text, encoding="utf-8")
    os.replace(temporary, path)


def read_claims(path):
    with open(path, encoding="utf-8") as file:
        return [Claim(**row) for row in json.load(file)]


# --- for readers ---------------------------------------------------------------------------


def number(value):
    if value is None:
        return "none"
    if isinstance(value, list):
        return ", ".join(map(number, value))
    if isinstance(value, float):
        return f"{value:.4g}"
    return str(value)


def split_unit(name):
    """Quantity and unit of "speed [m/s]"."""
    match = re.fullmatch(r"(.*?)\s*\[(.*)\]", name)
    return match.group(1, 2) if match else (name, "")


def measured_parts(measured):
    """{"speed [m/s]": 9.81} reads: speed = 9.81 m/s"""
    if not isinstance(measured, dict):
        return [str(measured)]
    parts = []
    for name, value in measured.items():
        quantity, unit = split_unit(name)
        parts.append(f"{quantity} = {number(value)} {unit}".rstrip())
    return parts
