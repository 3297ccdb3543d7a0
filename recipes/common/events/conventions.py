"""Ways to measure a front that the paper leaves open, as data: options of `analyze events` and
`analyze front`. The first is the primary convention; each other differs from it in one way."""

import json
import subprocess
from pathlib import Path

from claims.claim import PRIMARY
from events.fronts import SLOW_BELOW

C_S, C_S_OF_LATTICE = 968, 993  # [m/s]
IN_WORDS = "in words"  # "at least 1 order of magnitude slower than the material's wave speeds"
DECAYING = "slow below c_s/8"  # claim S6A allows a slow speed up to this

CONVENTIONS: dict[str, dict] = {  # name: options
    PRIMARY: {},
    "stencil 3": {"--stencil": 3},
    "stencil 7": {"--stencil": 7},
    "20 % pinned": {"--ruptured-below": 0.2},
    "50 % pinned": {"--ruptured-below": 0.5},
    "slow below c_s/10": {"--slow-below": 1 / 10},
    "slow below c_s/30": {"--slow-below": 1 / 30},
    "lattice's c_s": {"--slow-below": SLOW_BELOW * C_S_OF_LATTICE / C_S},
    "ends to the slow": {"--stencils-at-ends": "slow"},
    "ends to the fast": {"--stencils-at-ends": "fast"},
}
# Not conventions, but the ways to measure of single claims.
OWN_WAYS: dict[str, dict] = {
    IN_WORDS: {"--slow-below": 1 / 10, "--stencils-at-ends": "slow"},
    DECAYING: {"--slow-below": 1 / 8},
}
WAYS = CONVENTIONS | OWN_WAYS


def words_of(options):
    return [str(word) for option in options.items() for word in option]


class Analysis:
    """`analyze` of a folder of programs."""

    def __init__(self, programs):
        self.program = Path(programs).resolve() / "analyze"

    def __call__(self, command, path, options=()):
        """The report of `analyze COMMAND FILE --json OPTION...`. Raises CalledProcessError."""
        return self.each(command, path, {PRIMARY: {}}, options)[PRIMARY]

    def each(self, command, path, ways, options=()):
        """{name: report} of the ways to measure {name: options}, the primary one first. The file
        is read once."""
        words = [str(self.program), *command.split(), str(path), "--json", *map(str, options)]
        _, *others = (" ".join(words_of(way)) for way in ways.values())
        words += ["--also", "; ".join(others)] if others else []
        output = subprocess.run(words, stdout=subprocess.PIPE, check=True).stdout
        return dict(zip(ways, map(json.loads, output.splitlines()), strict=True))
