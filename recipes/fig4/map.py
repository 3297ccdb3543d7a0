#!/usr/bin/env python3
"""Figure 4 D, its data and claim 4D: map.py results/data results/fig4"""

import sys

from maps.front_types import FrontTypes, make_map

MAP = FrontTypes(
    recipe="fig4",
    panel="D",
    tables=["map-between", "map-boundary"],
    slow_below=(20, 10, 30, 40, 60),
    claim="4D",
    claims_file="claims-4D.json",
    note=(
        "Below-left: neither tau_bar_0 nor sigma_bar larger, over all points and seeds. Boundary:"
        " grid points and points halfway between them that are next to another type. Seeds act"
        " through the slipping times only, so that fast fronts hardly depend on them."
    ),
)


if __name__ == "__main__":
    make_map(MAP, *sys.argv[1:])
