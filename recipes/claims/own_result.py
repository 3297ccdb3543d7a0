"""Results of our own, on questions that the paper does not raise: measured, without verdict. For
some, an expectation in numbers was fixed beforehand."""

import json
from dataclasses import asdict, dataclass, field
from pathlib import Path

from rupture.commands.folder import in_lines, parsed, read_own
from rupture.errors import Failure
from rupture.replacing import write_whole

from claims.claim import form_of, is_value, number, plain, split_unit
from claims.conditions import met, wanted

OWN = "own.json"  # beside a recipe's claims.json


@dataclass(frozen=True)
class OwnResult:
    """`measured` as in Claim: numbers by name and unit, or texts. `expected`: conditions on some of
    them, as in claims.toml."""

    id: str
    question: str
    measured: dict
    expected: dict = field(default_factory=dict)
    met: bool | None = None  # whether all of them are

    def outcome(self):
        return {None: "without verdict", True: "as expected", False: "not as expected"}[self.met]

    def shown(self):
        """`measured` for readers: names say what was expected."""
        return {
            f"{name} (expected: {wanted(name, asked)})" if asked else name: value
            for name, value in self.measured.items()
            for asked in [self.expected.get(name)]
        }


def compared(name, measured, question, expected):
    """A result with an expectation."""
    held = all(met(condition, measured[of]) for of, condition in expected.items())
    return OwnResult(name, question, measured, expected, held)


def text_of(result):
    lines = [f"{result.id} (ours, {result.outcome()}): {result.question}"]
    for name, value in result.shown().items():
        quantity, unit = split_unit(name)
        lines.append(f"  {quantity} = {number(value)} {unit}".rstrip())
    return "\n".join(lines)


def write_own(folder, results):
    rows = json.dumps([asdict(result) for result in results], indent=2, default=plain)
    write_whole(Path(folder) / OWN, rows + "\n")


FORM = form_of(OwnResult, measured={"": is_value}, expected={"": object})


def results_in(folder):
    """The own results of a recipe; an empty list if it has none or has not run."""
    path = Path(folder) / OWN
    try:
        found = [OwnResult(**row) for row in parsed(read_own(path), [FORM], in_lines)]
        for result in found:
            result.shown()  # what was expected can be read
        return found
    except FileNotFoundError:
        return []
    except (OSError, ValueError, ArithmeticError) as error:
        raise Failure(f"{path} has no results ({error})") from error
