"""Places that a map of front types needs more points at, as the script of a chain:

    between  = script ../measure/map_points.py between {all map}
    boundary = script ../measure/map_points.py boundary {all map} {all map_between}
    boundary = script ../measure/map_points.py variants {all maps}

`between`: halfway between two places of which one is fast; `boundary`: next to another type, given
those halfway, too; `variants`: next to another type on one of the maps of several variants."""

from chains.results import read_points
from measure.tables import rows_of
from measure.front_map import boundary, read_map, read_variants, to_refine, types_of


def boundary_of_variants(maps):
    return sorted({place for fronts in maps for place in boundary(types_of(fronts))})


def main(which, *files):
    rows = [rows_of(read_points(file)) for file in files]
    variants = {row.get("variant") for row, _ in rows[0]}
    types = [types_of(read_map(of_file)) for of_file in rows]
    places = {
        "between": lambda: to_refine(*types),
        "boundary": lambda: boundary(*types),
        "variants": lambda: boundary_of_variants(read_variants(rows[0], variants).values()),
    }[which]()
    return {"places": [dict(zip(("tau_bar", "sigma_bar"), place)) for place in places]}
