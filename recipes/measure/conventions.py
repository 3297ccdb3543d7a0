"""Ways to measure a front that the paper leaves open, as data: options of `analyze events` and
`analyze front`. The first is the primary convention; each other differs from it in one way."""

import json

from rupture.programs import output_of

from claims.claim import PRIMARY
from measure.fronts import SLOW_BELOW

C_S, C_S_OF_LATTICE = 968, 993  # [m/s]

CONVENTIONS: dict[str, dict] = {  # name: options
    PRIMARY: {},
    "stencil 3": {"--stencil": 3},
    "stencil 7": {"--stencil": 7},
    "20 % pinned": {"--ruptured-below": 0.2},
    "50 % pinned": {"--ruptured-below": 0.5},
    "slow below c_s/10": {"--slow-below": 1 / 10},
    "slow below c_s/30": {"--slow-below": 1 / 30},
    "lattice's c_s": {"--slow-below": SLOW_BELOW * C_S_OF_LATTICE / C_S},
    "raw line": {"--line": "raw"},
}
WAYS = CONVENTIONS | {  # of types on a map: other limits of slow fronts, too
    f"slow below c_s/{ratio}": {"--slow-below": 1 / ratio} for ratio in (8, 40, 60)
}
# What a chain measures with `analyze ... --also NAME`, beside the primary convention.
SETS = {
    name: {way: options for way, options in ways.items() if way != PRIMARY}
    for name, ways in {
        "conventions": CONVENTIONS,
        "map": WAYS,
        "raw": {"raw line": CONVENTIONS["raw line"]},
    }.items()
}


def words_of(options):
    return [str(word) for option in options.items() for word in option]


def each_way(command, path, ways, *options):
    """{name: report of `analyze COMMAND`} of the ways to measure {name: options}, the primary one
    first. The file is read once."""
    _, *others = (" ".join(words_of(way)) for way in ways.values())
    also = ["--also", "; ".join(others)] if others else []
    output = output_of("analyze", *command.split(), path, "--json", *options, *also)
    return dict(zip(ways, map(json.loads, output.splitlines()), strict=True))
