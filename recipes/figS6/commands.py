"""Figure S6: the decaying law, which sustains slow fronts over a wide range of prestress."""

from functools import cache
from types import SimpleNamespace

from rupture.once import keep, run

import events
import maps
from claims.samples import Samples
from events import FINE, LAWS, shown_events, shown_load
from fig2.commands import fast_slow_fast, shown_of  # noqa: F401  (of claim S6A)
from fig4 import commands as fig4
from maps import grid_of, order  # noqa: F401  (of claim S6B)
from measure import front_map
from measure.ways import PRIMARY

LAW = "decaying"


@cache
def event():
    """The first that is fast-slow-fast in words: as it is, and with doubled slipping times."""
    first = next(one for one in shown_events(LAW)[PRIMARY] if one.fast_slow_fast)
    start = events.before(shown_load(LAW), first, [events.BRANCHED, *events.TIMES])
    doubled = events.slip_times(4e-3)
    record, double = (
        run(f"restart {start} -o end.h5 {change} --for 0.01 {FINE}")["record.h5"]
        for change in ("", doubled)
    )
    keep(record)
    return SimpleNamespace(
        record=record,
        front=run(f"analyze front {record} --event 0"),
        front_double=run(f"analyze front {double} --event 0"),
    )


@cache
def map_of_types():
    grid = grid_of("figS6", (-0.28, 0.48, 0.04), (0, 0.285, 0.015))
    return maps.map_of(grid, LAWS[LAW], maps.nowhere)


# --- what claims measure -----------------------------------------------------------------------


def each_run():
    return Samples({"": shown_of(LAW)}, events.samples_of_runs(LAW))


def each_seed():
    return map_of_types().samples()


def both_maps(seed):
    return map_of_types().of_seed(seed), fig4.map_of_types().of_seed(seed)


def beside_reference():
    """A sample is this map and that of Figure 4 D, of a seed."""
    taken = maps.samples_of_seeds(both_maps, "maps")
    return Samples({"": taken[0].found} if taken else {}, {PRIMARY: taken})


def slow_range(both, way):
    """S6B-range"""
    ours, reference = (front_map.slow_range(front_map.types_of(of, way)) for of in both)
    return {
        "range of tau_bar_0, decaying law": ours,
        "range of tau_bar_0, reference law": reference,
        "ratio of both": ours / reference,
    }
