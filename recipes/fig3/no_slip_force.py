"""Fronts where junctions that slip carry no force: data and claim 0slip."""

from claims.judge import judged
from data.records import values
from data.tables import points_of, write_table
from events.conventions import PRIMARY
from maps.bands import bands_of, width
from maps.front_map import IMPOSSIBLE, SKIP_BELOW_X, TYPES, front_type, read_map
from maps.map_conventions import MEASURES
from slow_fronts import tables_of


def types_of(front):
    """{convention: type}; impossible where no interface can be prepared."""
    return {name: front_type(front, **how) for name, how in MEASURES.items()}


def slowest(front):
    """Lowest v_c [m/s] of a front that spans, at stencils beyond the trigger region; else None."""
    if front is None or front["t_rupture"][-1] is None:
        return None
    x_v_c = zip(front["x"], values(front["v_c"]))
    return min((v for x, v in x_v_c if x > SKIP_BELOW_X and v > 0), default=None)


def counts(kinds):
    return {f"{kind} fronts": kinds.count(kind) for kind in TYPES}


def case_under(convention, fronts, bands):
    of_width = [width(ours, convention) / width(ref, convention) for ours, ref in bands.values()]
    kinds = [front_type(front, **MEASURES[convention]) for front in fronts]
    return counts(kinds) | {"slow band/the reference's": max(of_width)}


def units_of(seeds, bands):
    """Of {seed: fronts}."""
    return {
        f"seed {seed}": {name: [case_under(name, fronts, bands[seed])] for name in MEASURES}
        for seed, fronts in seeds.items()
    }


def claim(seeds, bands):
    """`seeds`: {seed: fronts}, the shown one first; `bands`: bands_of() each."""
    first, shown = next(iter(seeds.items()))
    kinds = [types_of(front)[PRIMARY] for front in shown]
    speeds = [v for front in shown if (v := slowest(front)) is not None]
    slow_somehow = [front for front in shown if "slow" in types_of(front).values()]
    case = case_under(PRIMARY, shown, bands[first])
    widths = {
        f"slow band at sigma_bar = {sigma}, and of the reference": [width(edges) for edges in pair]
        for sigma, pair in bands[first].items()
    }
    return judged(
        "0slip",
        shown=case,
        units=units_of(seeds, bands),
        measured={
            "interfaces": len(shown),
            **case,
            **widths,
            "interfaces that cannot be prepared": kinds.count(IMPOSSIBLE),
            "fronts that are slow under any convention": len(slow_somehow),
            "lowest speed of fronts that span [m/s]": min(speeds, default=None),
        },
        note="mu_d = 0, so that tau_bar_0 = tau_0/(mu_s p); sigma_bar = 0 and 0.1, the same"
        " tau_bar_0 at each. A front is slow if one stencil beyond the trigger region is."
        " Seeds only affect the slipping times.",
    )


def make(data, results):
    maps = [read_map(points_of(table)) for table in tables_of(data, "no_slip_force")]
    fronts = [
        (seed, place, front)
        for of_table in maps
        for place, seeds in of_table.items()
        for seed, front in seeds.items()
    ]
    rows = (
        [seed, *place, slowest(front), *types_of(front).values()] for seed, place, front in fronts
    )
    names = ["seed", "tau-bar", "sigma-bar", "lowest v_c [m/s]", *MEASURES]
    write_table(results / "no-slip-force.csv", names, rows)
    of_seed: dict[int, list] = {}
    for seed, _, front in fronts:
        of_seed.setdefault(seed, []).append(front)
    bands = {seed: bands_of(data.parent, "no-slip-force", seed) for seed in of_seed}
    return [claim(of_seed, bands)]
