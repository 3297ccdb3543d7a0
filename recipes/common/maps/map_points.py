"""Places that a map of front types needs more points at, as the table of another sweep:

map_points.py between MAP.csv OUTPUT                  halfway between two, of which one is fast
map_points.py boundary MAP.csv [BETWEEN.csv] OUTPUT   next to another type, given the former, too
map_points.py variants MAPS.csv OUTPUT                next to another type on one of several maps

`between` has seed 1, the others seeds 1 to 5.
"""

from data.tables import read_rows, write_table
from maps.front_map import IMPOSSIBLE, boundary, place_of, to_refine, type_on_map


def types_in(rows):
    """{place: type}; points that failed have none."""
    return {place_of(row): type_on_map(row["type"]) or IMPOSSIBLE for row in rows}


def boundary_of_variants(rows):
    variants = {row["variant"] for row in rows}
    maps = [types_in([row for row in rows if row["variant"] == name]) for name in variants]
    return sorted({place for types in maps for place in boundary(types, {})})


def main(which, grid, *rest):
    *between, output = rest
    grid_rows = read_rows(grid)
    between_types = types_in(read_rows(between[0])) if between else {}
    seeds = [1] if which == "between" else [1, 2, 3, 4, 5]
    places = {
        "between": lambda: to_refine(types_in(grid_rows)),
        "boundary": lambda: boundary(types_in(grid_rows), between_types),
        "variants": lambda: boundary_of_variants(grid_rows),
    }[which]()
    rows = ((seed, *(f"{number:.12g}" for number in place)) for place in places for seed in seeds)
    write_table(output, ["numerics.seed", "tau-bar", "sigma-bar"], rows)
