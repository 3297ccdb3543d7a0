"""Results of our own, which no claim of the paper speaks of: measured, without verdict."""

import json
from dataclasses import asdict, dataclass
from pathlib import Path

from claims.claim import measured_parts, plain
from rupture.replacing import write_whole

OWN = "own.json"  # beside a recipe's claims.json


@dataclass(frozen=True)
class OwnResult:
    """`measured` as in Claim: numbers by name and unit, or texts. `expected` is what was written
    down before, and `met` whether it came out so."""

    id: str
    question: str
    measured: dict
    expected: str = ""
    met: bool | None = None

    @property
    def standing(self):
        outcome = {True: ": met", False: ": not met", None: ""}[self.met]
        return f"expected {self.expected}{outcome}" if self.expected else "without verdict"


def text_of(result):
    lines = [f"{result.id} (ours, {result.standing}): {result.question}"]
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
