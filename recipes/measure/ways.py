"""Ways to measure a front that the paper leaves open: options of `analyze events`, `front` and
`classify`. The first is the primary one; each other differs from it in one option."""

from rupture.once import run

from measure.fronts import PRIMARY, RAW, SLOW_BELOW

C_S, C_S_OF_LATTICE = 968, 993  # [m/s]
LATTICE = "lattice's c_s"

WAYS = {  # name: options
    PRIMARY: "",
    "stencil 3": "--stencil 3",
    "stencil 7": "--stencil 7",
    "20 % pinned": "--ruptured-below 0.2",
    "50 % pinned": "--ruptured-below 0.5",
    "slow below c_s/10": f"--slow-below {1 / 10}",
    "slow below c_s/30": f"--slow-below {1 / 30}",
    LATTICE: f"--slow-below {SLOW_BELOW * C_S_OF_LATTICE / C_S}",
    RAW: "--line raw",
}
ON_MAP = WAYS | {  # of types on a map: other limits of slow fronts, too
    f"slow below c_s/{ratio}": f"--slow-below {1 / ratio}" for ratio in (8, 40, 60)
}


def others(ways):
    """Without the primary one."""
    return [way for way in ways if way != PRIMARY]


def by_way(line, ways=WAYS):
    """{way: report} of a command of `analyze`. The file is read once."""
    rest = others(ways)
    reports = run(f"{line} --also '{'; '.join(ways[way] for way in rest)}'")
    return dict(zip([PRIMARY, *rest], reports, strict=True))
