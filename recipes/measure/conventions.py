"""Ways to measure a front that the paper leaves open: options of `analyze events`, `front` and
`classify`. The first is the primary convention; each other differs from it in one way."""

from rupture.once import run

from measure.fronts import PRIMARY, SLOW_BELOW

C_S, C_S_OF_LATTICE = 968, 993  # [m/s]

CONVENTIONS = {  # name: options
    PRIMARY: "",
    "stencil 3": "--stencil 3",
    "stencil 7": "--stencil 7",
    "20 % pinned": "--ruptured-below 0.2",
    "50 % pinned": "--ruptured-below 0.5",
    "slow below c_s/10": f"--slow-below {1 / 10}",
    "slow below c_s/30": f"--slow-below {1 / 30}",
    "lattice's c_s": f"--slow-below {SLOW_BELOW * C_S_OF_LATTICE / C_S}",
    "raw line": "--line raw",
}
WAYS = CONVENTIONS | {  # of types on a map: other limits of slow fronts, too
    f"slow below c_s/{ratio}": f"--slow-below {1 / ratio}" for ratio in (8, 40, 60)
}
SETS = {  # what is measured beside the primary convention
    name: {way: options for way, options in ways.items() if way != PRIMARY}
    for name, ways in {
        "conventions": CONVENTIONS,
        "map": WAYS,
        "raw": {"raw line": CONVENTIONS["raw line"]},
    }.items()
}


def by_way(line, ways):
    """{way: report} of a command of `analyze`, the primary one first. The file is read once."""
    reports = run(f"{line} --also '{'; '.join(ways.values())}'")
    return dict(zip([PRIMARY, *ways], reports, strict=True))
