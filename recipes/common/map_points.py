#!/usr/bin/env python3
"""Places that a map of front types needs more points at, as the table of another sweep:

map_points.py between MAP.csv OUTPUT                  halfway between neighbours of which one is fast
map_points.py boundary MAP.csv [BETWEEN.csv] OUTPUT   next to another type, given the former, too
"""

import csv
import sys

from common.front_map import IMPOSSIBLE, boundary, place_of, rows_of, to_refine


def types_in(table):
    """{place: type}; points that failed have none."""
    return {place_of(row): row["type"] or IMPOSSIBLE for row in rows_of(table)}


def main(which, grid, *rest):
    *between, output = rest
    grid_types = types_in(grid)
    between_types = types_in(between[0]) if between else {}
    places = {
        "between": lambda: to_refine(grid_types),
        "boundary": lambda: boundary(grid_types, between_types),
    }[which]()
    with open(output, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["tau-bar", "sigma-bar"])
        writer.writerows([f"{number:.12g}" for number in place] for place in places)


if __name__ == "__main__":
    main(*sys.argv[1:])
