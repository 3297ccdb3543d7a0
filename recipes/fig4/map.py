#!/usr/bin/env python3
"""Figure 4 D, its data and claim 4D: map.py results/data results/fig4"""

import sys
from pathlib import Path

from common.claims import write_claims
from common.front_map import load_map, write_types
from common.map_claims import map_claim, thresholds_compared
from common.map_panels import draw_map
from common.tables import write_table

SLOW_BELOW = (20, 10, 30, 40, 60)  # slow is below c_s over this; the first is the default

PAPER = "arrest at low tau_bar_0 and sigma_bar, fast at high, a slow region between"
NOTE = (
    "Below-left: neither tau_bar_0 nor sigma_bar larger, over all points and seeds. Boundary: grid"
    " points and points halfway between them that are next to another type. Seeds act through the"
    " slipping times only, so that fast fronts hardly depend on them."
)


def main(data, results):
    data, results = Path(data), Path(results)
    fronts, grid, boundary = load_map(data, "fig4", ["map-between", "map-boundary"])
    thresholds = list(thresholds_compared(fronts, grid, SLOW_BELOW))
    draw_map(fronts, grid, SLOW_BELOW, "D", results / "fig4D")
    write_types(results / "front-types.csv", fronts)
    write_table(results / "thresholds.csv", list(thresholds[0]), map(dict.values, thresholds))
    claim = map_claim("4D", PAPER, fronts, grid, boundary, thresholds, NOTE)
    write_claims(data / "fig4/claims-4D.json", [claim])


if __name__ == "__main__":
    main(*sys.argv[1:])
