"""A map of front types, its data and its claims: Figures 4 D and S6 B."""

from data.tables import write_table
from maps.front_map import load_map, write_types
from maps.map_claims import map_claims, thresholds_compared
from maps.map_panels import draw_map


def make_map(data, results, *, panel, tables, slow_below, claims, note):
    """Everything that the recipe writes about its map, of map.csv and these tables. Slow is below
    c_s over one of `slow_below`, of which the first is the default. Returns the claims: the
    leading one and the one that asks for more."""
    recipe = results.name
    fronts, grid, boundary = load_map(data, recipe, tables)
    thresholds = list(thresholds_compared(fronts, grid, slow_below))
    draw_map(fronts, grid, slow_below, panel, results / f"{recipe}{panel}")
    write_types(results / "front-types.csv", fronts)
    write_table(results / "thresholds.csv", list(thresholds[0]), map(dict.values, thresholds))
    leading, strict = claims
    return map_claims(leading, strict, fronts, grid, boundary, thresholds, note)
