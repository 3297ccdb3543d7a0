#!/usr/bin/env python3
"""Places that a map of front types needs more points at, as the table of another sweep:

map_points.py between MAP.csv OUTPUT                  halfway between two, of which one is fast
map_points.py boundary MAP.csv [BETWEEN.csv] OUTPUT   next to another type, given the former, too
"""

import sys

from data.tables import read_rows, write_table
from maps.front_map import IMPOSSIBLE, boundary, place_of, to_refine, type_on_map


def types_in(table):
    """{place: type}; points that failed have none."""
    return {place_of(row): type_on_map(row["type"]) or IMPOSSIBLE for row in read_rows(table)}


def main(which, grid, *rest):
    *between, output = rest
    grid_types = types_in(grid)
    between_types = types_in(between[0]) if between else {}
    places = {
        "between": lambda: to_refine(grid_types),
        "boundary": lambda: boundary(grid_types, between_types),
    }[which]()
    rows = ([f"{number:.12g}" for number in place] for place in places)
    write_table(output, ["tau-bar", "sigma-bar"], rows)


if __name__ == "__main__":
    main(*sys.argv[1:])
