"""Results of our own, which no claim of the paper speaks of: measured, without verdict."""

import json
from dataclasses import asdict, dataclass
from pathlib import Path

from claims.claim import measured_parts, plain
from rupture.replacing import write_whole

OWN = "own.json"  # beside a recipe's claims.json


@dataclass(frozen=True)
class OwnResult:
    """`measured` as in Claim: numbers by name and unit, or texts."""

    id: str
    question: str
    measured: dict


def text_of(result):
    lines = [f"{result.id} (ours, without verdict): {result.question}"]
    return "\n".join([*lines, *(f"  {part}" for part in measured_parts(result.measured))])


def write_own(folder, results, before=""):
    """The file for programs, and what the terminal shows, with another text before it."""
    folder = Path(folder)
    rows = json.dumps([asdict(result) for result in results], indent=2, default=plain)
    write_whole(folder / OWN, rows + "\n")
    text = "\n".join([before, *map(text_of, results)] if before else map(text_of, results))
    write_whole(folder / "summary.txt", text + "\n")


def read_own(folder):
    """Those of a recipe; none if it has none or has not run."""
    path = Path(folder) / OWN
    if not path.exists():
        return []
    return [OwnResult(**row) for row in json.loads(path.read_text(encoding="utf-8"))]
