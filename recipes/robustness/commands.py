"""What the paper calls robust: fronts with exponential slipping times, and on other sliders; and a
law by which junctions slip for a distance."""

from functools import cache

from rupture.once import run

import frozen
import maps
from claims.samples import Samples, every
from events import FINE, LAWS, samples_of_runs
from fig2.commands import fast_slow_fast, shown_of  # noqa: F401  (of claim exponential-event)
from fig3.commands import continued
from maps import fronts_at, grid_of, plain_front_at
from measure import front_map
from measure.ways import PRIMARY
from measure.front_map import types_of
from measure.fronts import TYPES

COARSE_MAP = grid_of("robustness", (0.02, 0.29, 0.03), (0, 0.24, 0.08))


# --- exponential slipping times ----------------------------------------------------------------


def each_run():
    return Samples({"": shown_of("exponential")}, samples_of_runs("exponential"))


@cache
def exponential_map():
    """A map with the steps of Figure 4 D, with one seed."""
    grid = grid_of("robustness", (0.03, 0.41, 0.02), (0, 0.285, 0.015))
    return fronts_at(grid, [maps.FIRST], LAWS["exponential"], "exponential map")


def exponential():
    return Samples({"": exponential_map()})


def order(fronts, way):
    """exponential-map"""
    kinds = list(types_of(fronts, way).values())
    counts = {f"{kind} grid points of the map": kinds.count(kind) for kind in TYPES}
    return counts | {"places out of order on the map": len(front_map.out_of_order(fronts, way))}


# --- other lengths, and other energies in the trigger region -----------------------------------


def longer(L, Nx):
    """The spacing of the blocks, their mass and the normal force on each are kept."""
    mass, load = 0.0756 * Nx / 57, 1920 * Nx / 57
    size = f"--set slider.L={L} --set slider.Nx={Nx}"
    return f"{size} --set slider.M={mass:.12g} --set slider.F_N={load:.12g}"


SLIDERS = {
    "L x 0.75": longer(0.105, 43),
    "L x 1.5": longer(0.21, 85),
    "trigger 0.2": "--tau-bar-trigger 0.2",
    "trigger 0.4": "--tau-bar-trigger 0.4",
}


@cache
def geometry():
    """{slider: map} with one seed."""
    return {name: fronts_at(COARSE_MAP, [maps.FIRST], of, name) for name, of in SLIDERS.items()}


def geometry_of_seed(seed):
    """The maps with fronts of this seed at places next to another type on one of these maps."""
    beside = {place for of in geometry().values() for place in front_map.boundary(types_of(of))}
    found = {}
    for name, options in SLIDERS.items():
        own = fronts_at(sorted(beside), [seed], options, f"{name}, seed {seed}")
        found[name] = front_map.map_of_seed(maps.merged(geometry()[name], own), seed)
    return found


def each_seed():
    taken = maps.samples_of_seeds(geometry_of_seed, "geometry")
    return Samples({"": geometry()}, {PRIMARY: taken})


def order_of_all(fronts, way):
    """geometry"""
    orders = [front_map.order_in_words(types_of(of, way)) for of in fronts.values()]
    return {
        "fewest types present on a map": min(present for present, _ in orders),
        "sigma_bar out of order on all maps": sum(out_of_order for _, out_of_order in orders),
    }


# --- the distance law --------------------------------------------------------------------------

DISTANCES = {f"d_R {d:g} um": d * 1e-6 for d in (0.3, 1, 3, 10)}  # [m]; delta_d_R in proportion
SIGMA_BARS = frozen.sigma_bars("robustness", (0, 0.1), 0.1)  # of edges


def by_distance(name):
    d_R = DISTANCES[name]
    lengths = f"--set junctions.d_R={d_R:.12g} --set junctions.delta_d_R={0.3 * d_R:.12g}"
    return f"--set junctions.law=distance {lengths}"


@cache
def distance_maps():
    """{distance: map}"""
    return {
        name: fronts_at(COARSE_MAP, [maps.FIRST], by_distance(name), name, plain_front_at)
        for name in DISTANCES
    }


@cache
def distance_bands():
    """{distance: {sigma_bar: (its edges, those of the reference)}}"""
    laws = {"": "", **{name: by_distance(name) for name in DISTANCES}}
    points = [(sigma, of) for of in laws.values() for sigma in SIGMA_BARS]
    found = every(maps.edges, points, "edges")
    return {
        name: {sigma: (found[sigma, laws[name]], found[sigma, ""]) for sigma in SIGMA_BARS}
        for name in DISTANCES
    }


def distance_event():
    """Event I from 0.14 L on: its front as it is, and with the distance law."""
    of = continued("event I")
    changed = "--set junctions.law=distance --for 0.04 --until-quiet"
    record = run(f"restart {of.start} -o distance.h5 {changed} {FINE}")["record.h5"]
    return of.fronts[PRIMARY], run(f"analyze front {record} --event 0")
