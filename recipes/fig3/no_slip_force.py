"""Fronts where junctions that slip carry no force (f_slip = 0), so that nothing can slip slowly.
Pressure and mu_s are as ever, tau-bar is now tau_0/(mu_s p)."""

from functools import cache
from types import SimpleNamespace

import frozen
from claims.samples import every, sampled
from maps import FIRST, SEEDS, edges, fronts_at, over_seeds, places_of, spaced, width
from measure.ways import WAYS
from measure.front_map import TYPES, beyond_trigger, front_type
from measure.tables import write_table

TAU_BARS = frozen.tau_bars("fig3", spaced(0.02, 0.4, 0.02), 0.02)
SIGMA_BARS = frozen.sigma_bars("fig3", (0, 0.1), 0.1)
NO_FORCE = "--set junctions.mu_d=0"


@cache
def fronts(seed):
    """{place: front}"""
    found = fronts_at(places_of(TAU_BARS, SIGMA_BARS), [seed], NO_FORCE, f"f_slip = 0, seed {seed}")
    return {place: of[seed] for place, of in found.items()}


def bands(sigma_bar, seed):
    """Edges where slipping junctions carry no force, and of the reference."""
    return edges(sigma_bar, NO_FORCE, seed), edges(sigma_bar)


def of_seed(seed):
    found = every(bands, [(sigma, seed) for sigma in SIGMA_BARS], f"edges, seed {seed}")
    return SimpleNamespace(fronts=[*fronts(seed).values()], bands=[*found.values()])


def each_seed():
    return over_seeds(of_seed, "f_slip = 0")


def types(of, way):
    """no-slip-force"""
    kinds = [front_type(front, way) for front in of.fronts]
    counts = {f"{kind} fronts": kinds.count(kind) for kind in TYPES}
    widest = max(width(ours, way) / width(reference, way) for ours, reference in of.bands)
    return {"interfaces": len(kinds)} | counts | {"slow band/the reference's": widest}


# --- the table ---------------------------------------------------------------------------------


def slowest(front):
    """Lowest v_c [m/s] of a front that spans, at stencils beyond the trigger region; else None."""
    if front is None or front["t_rupture"][-1] is None:
        return None
    return min((v for v in beyond_trigger(front) if v > 0), default=None)


def make(results):
    known = sampled(fronts, [(seed,) for seed in SEEDS], "f_slip = 0")
    rows = (
        [seed, *place, slowest(front), *(front_type(front, name) for name in WAYS)]
        for (seed,), found in (known or [((FIRST,), fronts(FIRST))])
        for place, front in found.items()
    )
    names = ["seed", "tau-bar", "sigma-bar", "lowest v_c [m/s]", *WAYS]
    write_table(results / "no-slip-force.csv", names, rows)
