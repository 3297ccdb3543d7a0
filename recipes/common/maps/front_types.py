"""A map of front types, its data and its claim: Figures 4 D and S6 B."""

from dataclasses import dataclass

from data.tables import write_table
from maps.front_map import load_map, write_types
from maps.map_claims import map_claim, thresholds_compared
from maps.map_panels import draw_map


@dataclass(frozen=True)
class FrontTypes:
    recipe: str
    panel: str
    tables: list  # of sweeps, beside map.csv
    slow_below: tuple  # slow is below c_s over this; the first is the default
    claim: str
    note: str


def make_map(m, data, results):
    """Everything that the recipe writes about its map `m`. Returns the claim."""
    fronts, grid, boundary = load_map(data, m.recipe, m.tables)
    thresholds = list(thresholds_compared(fronts, grid, m.slow_below))
    draw_map(fronts, grid, m.slow_below, m.panel, results / f"{m.recipe}{m.panel}")
    write_types(results / "front-types.csv", fronts)
    write_table(results / "thresholds.csv", list(thresholds[0]), map(dict.values, thresholds))
    return map_claim(m.claim, fronts, grid, boundary, thresholds, m.note)
