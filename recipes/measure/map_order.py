"""Whether the types of fronts on a map are in order, as the script of a chain, for one seed:

    order = script ../measure/map_order.py one {seed} {all map} {all map_between} {all map_boundary}
    order = script ../measure/map_order.py variants {seed} {all geometry} {all geometry_seeds}

`one` map, or the maps of `variants`: the fewest types that are present on a map, and how many
sigma_bar are out of order on all of them; the range of tau_bar_0 with slow fronts on the map that
has the narrowest; in each way to measure ("under"). The map of a seed has
its own fronts at the boundary, and those of seed 1 elsewhere. The first file has the regular grid.
"""

from chains.results import read_points
from measure import front_map
from measure.conventions import CONVENTIONS, PRIMARY
from measure.tables import rows_of


def order_of(types):
    """Returns the order of fronts in maps, {name of a map: {place: type}}."""
    orders = [front_map.order_in_words(of_map) for of_map in types.values()]
    return {
        "slow_range": min(map(front_map.slow_range, types.values())),
        "types": min(present for present, _ in orders),
        "out_of_order": sum(out_of_order for _, out_of_order in orders),
    }


def in_each_way(maps):
    """order_of() maps, {name: map}, in the primary way, and in the others."""
    found = {
        way: order_of({name: front_map.types_of(fronts, way) for name, fronts in maps.items()})
        for way in CONVENTIONS
    }
    primary = found.pop(PRIMARY)
    return primary | {"under": found}


def main(which, seed, *files):
    grid, *others = map(read_points, files)
    if which == "one":
        fronts, places = front_map.load_map(grid, *others)
        maps = {"": {place: fronts[place] for place in places}}
    else:
        rows = rows_of(sum(others, grid))
        maps = front_map.read_variants(rows, dict.fromkeys(row["variant"] for row, _ in rows))
    return in_each_way(
        {name: front_map.map_of_seed(fronts, int(seed)) for name, fronts in maps.items()}
    )
