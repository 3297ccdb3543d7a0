#!/usr/bin/env python3
"""Figure S6 B, its data and claim S6B: map.py results/data results/figS6"""

import sys
from pathlib import Path

from common.claims import write_claims
from common.front_map import load_map, write_types
from common.map_claims import map_claim, thresholds_compared
from common.map_panels import draw_map
from common.tables import write_table

SLOW_BELOW = (20, 8, 10, 30, 40)  # slow is below c_s over this; the first is the default

PAPER = "decaying law: arrested, slow and fast regions as in Fig. 4D"
NOTE = (
    "As 4D, slow below c_s/20 as there; c_s/8 is what the acceptance of S6A allows a slow stretch."
    " tau_bar_0 counts from mu_d, the friction just after breaking; it falls to mu_new < mu_d while"
    " junctions slip, so fronts cross at negative tau_bar_0, too."
)


def main(data, results):
    data, results = Path(data), Path(results)
    fronts, grid, boundary = load_map(data, "figS6", ["map-boundary"])
    thresholds = list(thresholds_compared(fronts, grid, SLOW_BELOW))
    draw_map(fronts, grid, SLOW_BELOW, "B", results / "figS6B")
    write_types(results / "front-types.csv", fronts)
    write_table(results / "thresholds.csv", list(thresholds[0]), map(dict.values, thresholds))
    claim = map_claim("S6B", PAPER, fronts, grid, boundary, thresholds, NOTE)
    write_claims(data / "figS6/claims-map.json", [claim])


if __name__ == "__main__":
    main(*sys.argv[1:])
