"""Fronts where junctions that slip carry no force: their table, and as the script of a chain

    no_slow = script no_slip_force.py FRONTS BANDS REFERENCE

how many are of which type, and the widest band of slow ones over the reference's (points of
edges.ini), over all sigma_bar; in each way to measure ("under").
"""

from chains.results import read_points
from measure.tables import rows_of, write_table
from measure.conventions import CONVENTIONS, PRIMARY
from measure.bands import bands_of, width
from measure.front_map import TYPES, beyond_trigger, front_type, read_map


def types_of(front):
    """{convention: type}; impossible where no interface can be prepared."""
    return {name: front_type(front, name) for name in CONVENTIONS}


def slowest(front):
    """Lowest v_c [m/s] of a front that spans, at stencils beyond the trigger region; else None."""
    if front is None or front["t_rupture"][-1] is None:
        return None
    return min((v for v in beyond_trigger(front) if v > 0), default=None)


def found_in(way, fronts, bands):
    kinds = [front_type(front, way) for front in fronts]
    of_width = [width(ours, way) / width(reference, way) for ours, reference in bands.values()]
    return {kind: kinds.count(kind) for kind in TYPES} | {"widest": max(of_width)}


def main(*files):
    fronts, changed, reference = map(read_points, files)
    of_places = [front for of in read_map(rows_of(fronts)).values() for front in of.values()]
    bands = bands_of(changed, reference)
    found = {way: found_in(way, of_places, bands) for way in CONVENTIONS}
    return found.pop(PRIMARY) | {"fronts": len(of_places), "under": found}


def make(chains, results):
    fronts = read_map(rows_of(chains["no_slip_force"]))
    rows = (
        [seed, *place, slowest(of[seed]), *types_of(of[seed]).values()]
        for seed in sorted({seed for of in fronts.values() for seed in of})
        for place, of in fronts.items()
    )
    names = ["seed", "tau-bar", "sigma-bar", "lowest v_c [m/s]", *CONVENTIONS]
    write_table(results / "no-slip-force.csv", names, rows)
