#!/usr/bin/env python3
"""Figure S6 B, its data and claim S6B: map.py results/data results/figS6"""

import sys

from maps.front_types import FrontTypes, make_map

MAP = FrontTypes(
    recipe="figS6",
    panel="B",
    tables=["map-boundary"],
    slow_below=(20, 8, 10, 30, 40),
    claim="S6B",
    claims_file="claims-map.json",
    note=(
        "As 4D, slow below c_s/20 as there; c_s/8 is what the acceptance of S6A allows a slow"
        " stretch. tau_bar_0 counts from mu_d, the friction just after breaking; it falls to mu_new"
        " < mu_d while junctions slip, so fronts cross at negative tau_bar_0, too."
    ),
)


if __name__ == "__main__":
    make_map(MAP, *sys.argv[1:])
