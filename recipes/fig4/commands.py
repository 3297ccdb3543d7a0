"""Figure 4: events I and II with a wider phi, the strength of blocks, and a map of front types."""

from functools import cache
from types import SimpleNamespace

import numpy as np
from rupture.once import each, keep, run
from rupture.reports import LOADING_ZONE, values

import frozen
import maps
from claims.samples import Samples, every
from events import EVENTS, NO_SLOW_SLIP, all_continued, shown_event, samples_of_branches
from events import samples_of_events, widened
from fig4 import strength
from maps import grid_of, order, spaced  # noqa: F401  (order: of claim 4D)
from measure.ways import WAYS, PRIMARY
from measure.front_map import types_of
from measure.pairs import share_of_lower

REGION = 0.25  # from here on phi is changed [L]
SHOWN = ("event II", "event I")  # the paper shows the first
SHAPES = ("uniform", "bell")
# Of edges; their step is that of the map.
SIGMA_BARS = frozen.sigma_bars("fig4", (0, 0.05, 0.1, 0.16, 0.2, 0.25, 0.285), 0.015)


# --- A-B: a wider phi --------------------------------------------------------------------------


@cache
def wider(name):
    """Event I or II as it is, and with the wider phi; both from its checkpoint on."""
    of = shown_event(EVENTS[name])
    found = widened(of.start, 0.01)
    keep(found.start, found.record)
    return SimpleNamespace(
        **vars(of),
        block=None,
        wider_start=found.start,
        wider_record=found.record,
        wider={PRIMARY: run(f"analyze front {found.record} --event 0")},
        phi_wider=run(f"analyze phi {found.start}"),
    )


def branches():
    """Events I and II; those of the ensemble begin when the front is at the branch."""
    return Samples({name: wider(name) for name in SHOWN}, samples_of_branches())


def change_of_means(of):
    """The largest relative change of a block's mean."""
    before, after = np.array(of.phi.mean), np.array(of.phi_wider.mean)
    return np.max(np.abs(after - before) / np.abs(before))


def types(of, way):
    """4AB: events that are not slow have nothing to compare."""
    if of.fronts[way].type != "slow" or of.wider[way].type is None:
        return None
    return {
        "front with the wider phi": of.wider[way].type,
        "unmodified": of.fronts[way].type,
        "largest relative change of a block's mean": change_of_means(of),
    }


def stress(of, way):
    """4C-stress: blocks beyond the loading zone. Events without a slow one have nothing to
    compare."""
    front = of.fronts[way]
    x, v_c, tau = values(front.x), values(front.v_c), values(of.strength.tau_bar_0)
    counts = (x > LOADING_ZONE) & (v_c > 0)
    is_slow = v_c < front.c_s * front.criteria.slow_below
    slow, fast = tau[counts & is_slow], tau[counts & ~is_slow]
    if not len(slow):
        return None
    medians = np.median(slow), np.median(fast) if len(fast) else np.nan
    return {
        "median tau_bar_0, slow": medians[0],
        "median tau_bar_0, fast": medians[1],
        "slow minus fast": medians[0] - medians[1],
    }


def each_event():
    return Samples({name: wider(name) for name in SHOWN}, samples_of_events())


# --- C: the strength of blocks -----------------------------------------------------------------


def curve_at(shape, sigma_bar):
    return run(f"analyze strength --shape {shape} --sigma-bar {sigma_bar}").mu_bar_eff


@cache
def curves():
    """{shape: (sigma_bar, mu_bar_eff)}"""
    sigma_bars = spaced(0, 0.55, 0.025)
    found = every(curve_at, [(shape, s) for shape in SHAPES for s in sigma_bars], "curves")
    return {shape: (sigma_bars, [found[shape, s] for s in sigma_bars]) for shape in SHAPES}


def prepared_block(shape, tau_bar, sigma_bar):
    """How strong a block of a prepared interface is, and which front it lets pass."""
    prestress = f"--shape {shape} --tau-bar {tau_bar} --sigma-bar {sigma_bar}"
    interface = f"{prestress} --set numerics.seed={maps.FIRST}"
    report = run(f"analyze strength {maps.start_of(interface)}")
    front = run(f"analyze front {maps.record_of(interface)}")
    return strength.prepared_block(report, front, tau_bar, shape)


@cache
def prepared():
    """The blocks of interfaces, without those that cannot be prepared."""
    places = grid_of("fig4", (0.1, 0.18, 0.04), (0, 0.35, 0.05))
    points = [(shape, *place) for shape in SHAPES for place in places]
    return [block for _, block in each(prepared_block, points, "prepared interfaces")]


def shown_blocks(name):
    of = wider(name)
    return strength.blocks_of(of.front, of.strength)


def gathered(seed):
    """A sample of 4C; events are the same for each seed."""
    of_events = [strength.blocks_of(of.fronts[PRIMARY], of.strength) for of in all_continued()]
    shown = [block for name in SHOWN[::-1] for block in shown_blocks(name)]
    types = types_of(map_of_types().of_seed(seed))
    return SimpleNamespace(
        deviation=strength.largest_deviation(prepared(), curves()),
        near=strength.share_near(shown, curves()),
        on_map=share_of_lower(strength.map_strata(types)),
        over_events=strength.over_events(of_events),
    )


def gathering():
    taken = maps.samples_of_seeds(gathered, "seeds")
    return Samples({"": taken[0].found} if taken else {}, {PRIMARY: taken})


def friction(of, way):
    """4C"""
    events, share = of.over_events[way]
    return {
        "largest deviation of prepared points from the curves": of.deviation,
        "share of blocks of events I and II near a curve": of.near,
        "share of pairs on the map": of.on_map,
        "share of pairs in the median event": share,
        "events with slow and fast blocks": events,
    }


# --- D: a map of types, and its edges ----------------------------------------------------------


@cache
def map_of_types():
    """Over prestress and width of phi."""
    return maps.map_of(grid_of("fig4", (0.03, 0.41, 0.02), (0, 0.285, 0.015)))


def each_seed():
    return map_of_types().samples()


@cache
def edges_with_and_without():
    """{sigma_bar: (edges with slow slip, edges without)}"""
    points = [(sigma, options) for sigma in SIGMA_BARS for options in ("", NO_SLOW_SLIP)]
    found = every(maps.edges, points, "edges")
    return {sigma: (found[sigma, ""], found[sigma, NO_SLOW_SLIP]) for sigma in SIGMA_BARS}


def all_edges():
    return Samples({"": [*edges_with_and_without().values()]})


def apart(pairs, way, kind):
    """The largest distance of the edge of fast fronts from that of `kind` without slow slip."""
    return max(abs(on[way]["fast"] - off[way][kind]) for on, off in pairs)


def edge(pairs, way):
    """4D-edge"""
    change = max(apart(pairs, any_way, "fast") for any_way in WAYS)
    return {
        "largest difference of the edges": apart(pairs, way, "slow"),
        "largest change of the edge of fast fronts by slow slip": change,
    }
