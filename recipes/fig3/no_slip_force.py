"""Fronts where junctions that slip carry no force: data and claim no-slip-force."""

from claims.judge import judged
from measure.tables import rows_of, write_table
from measure.conventions import MEASURES, PRIMARY
from measure.bands import bands_of, width
from measure.front_map import TYPES, beyond_trigger, front_type, read_map, seeds_of
from slow_fronts import of_seed


def types_of(front):
    """{convention: type}; impossible where no interface can be prepared."""
    return {name: front_type(front, name) for name in MEASURES}


def slowest(front):
    """Lowest v_c [m/s] of a front that spans, at stencils beyond the trigger region; else None."""
    if front is None or front["t_rupture"][-1] is None:
        return None
    return min((v for v in beyond_trigger(front) if v > 0), default=None)


def case_under(convention, fronts, bands):
    of_width = [width(ours, convention) / width(ref, convention) for ours, ref in bands.values()]
    kinds = [front_type(front, convention) for front in fronts]
    counts = {f"{kind} fronts": kinds.count(kind) for kind in TYPES}
    return counts | {"slow band/the reference's": max(of_width)}


def units_of(seeds, bands):
    """Of {seed: fronts}."""
    return {
        f"seed {seed}": {name: [case_under(name, fronts, bands[seed])] for name in MEASURES}
        for seed, fronts in seeds.items()
    }


def claim(seeds, bands):
    """`seeds`: {seed: fronts}, the shown one first; `bands`: bands_of() each."""
    first, shown = next(iter(seeds.items()))
    case = case_under(PRIMARY, shown, bands[first])
    return judged(
        "no-slip-force",
        shown=case,
        units=units_of(seeds, bands),
        measured={"interfaces": len(shown)} | case,
        note="mu_d = 0, so that tau_bar_0 = tau_0/(mu_s p); sigma_bar = 0 and 0.1, the same"
        " tau_bar_0 at each. A front is slow if one stencil beyond the trigger region is."
        " Seeds only affect the slipping times.",
    )


def make(chains, results):
    fronts = read_map(rows_of(chains["no_slip_force"]))
    of_seeds = {s: [front[s] for front in fronts.values()] for s in seeds_of(fronts)}
    rows = (
        [seed, *place, slowest(front), *types_of(front).values()]
        for seed, of_places in of_seeds.items()
        for place, front in zip(fronts, of_places)
    )
    names = ["seed", "tau-bar", "sigma-bar", "lowest v_c [m/s]", *MEASURES]
    write_table(results / "no-slip-force.csv", names, rows)
    edges = chains["edges"]
    reference = [point for point in edges if point["variant"] == "reference"]
    changed = [point for point in edges if point not in reference]
    bands = {seed: bands_of(of_seed(changed, seed), reference) for seed in of_seeds}
    return [claim(of_seeds, bands)]
