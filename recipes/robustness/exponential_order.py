"""Whether a map has the order of regions of Figure 4 D, as the script of a chain:

    counts = script exponential_order.py {all exponential_map}

Reports how many of its places have a front of each type, and how many are out of order."""

from chains.results import read_points
from measure.front_map import TYPES, out_of_order, read_map, types_of
from measure.tables import rows_of


def main(points):
    fronts = read_map(rows_of(read_points(points)))
    kinds = list(types_of(fronts).values())
    return {kind: kinds.count(kind) for kind in TYPES} | {"out_of_order": len(out_of_order(fronts))}
