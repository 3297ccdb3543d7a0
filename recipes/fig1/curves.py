"""Tables and claims of Figure 1 D and E."""

from functools import partial
from itertools import takewhile

import numpy as np
import rupture

from claims.judge import judged, units_with, yes
from data.records import report, values
from data.tables import write_table
from events.choose_events import read_events
from events.conventions import PRIMARY
from events.fronts import LOADING_ZONE
from events.slip import peaks_of
from events.units import name_of, of_ensemble

NEAR = 0.1e-3  # peak and rupture of a block [s]
MIDDLE = 0.5  # of L; the block of panel E


def precursors(events):
    """All before the first one that spans."""
    return list(takewhile(lambda event: not event["spanning"], events))


def case_1D(events, first=None):
    """Of one load. `first`: how many events count as the first ones; None: all before one spans."""
    counted = precursors(events)[:first]
    return {
        "furthest arrest of the first events [L]": max(
            (event["x_last"] / event["L"] for event in counted), default=None
        ),
        "spanning events": sum(event["spanning"] for event in events),
    }


def case_1Dw(events):
    """Of one load."""
    drops = np.array([event["F_T_before"] - event["F_T_after"] for event in events])
    spanning = np.array([event["spanning"] for event in events])
    large = drops >= drops.max() / 2
    return {
        "early events that reach the leading edge": sum(
            event["t_rupture"][-1] is not None for event in precursors(events)
        ),
        "large drops by other events": int(np.sum(large & ~spanning)),
        "large drops by spanning events": int(np.sum(large & spanning)),
        "largest drop by another event/largest drop": float(
            drops[~spanning].max(initial=0) / drops.max()
        ),
        "drops of at least 0.4 of the largest": int(np.sum(drops >= 0.4 * drops.max())),
    }


def units_1D(paths, cases):
    """`cases`: of a load, by convention."""
    return {
        name_of(path): {name: [case(read_events(path))] for name, case in cases.items()}
        for path in paths
    }


def claim_1Dw(events, paths):
    case, units = case_1Dw(events), units_1D(paths, {PRIMARY: case_1Dw})
    smaller = "drops of at least 0.4 of the largest"
    measured = case | {
        f"loads with five or more {smaller}": units_with(lambda of: of[smaller] >= 5, units),
        "loads where no other event has a tenth of the largest": units_with(
            lambda of: of["largest drop by another event/largest drop"] < 0.1, units
        ),
    }
    return judged("1Dw", measured, case, units)


def claim_1D(events, paths):
    early = precursors(events)
    drops = [e["F_T_before"] - e["F_T_after"] for e in events if e["spanning"]]
    others = [e["F_T_before"] - e["F_T_after"] for e in events if not e["spanning"]]
    return judged(
        "1D",
        shown=case_1D(events),
        units=units_1D(paths, {PRIMARY: case_1D, "the first five": partial(case_1D, first=5)}),
        measured={
            "arrest of the events before the first spanning one [mm]": [
                event["x_last"] * 1e3 for event in early
            ],
            "0.5 L [mm]": 0.5 * events[0]["L"] * 1e3,
            "first spanning event at [s]": events[len(early)]["t_start"],
            "spanning events until 1.2 s": len(drops),
            "drops of F_T in them [N]": drops,
            "largest drop in any other event [N]": max(others),
        },
        note="'First events' are all before the first one that spans the interface. Later,"
        " arrested events occur between the spanning ones.",
    )


def off_by(peaks, front):
    """Peak minus rupture of each block [s]; NaN where it does not rupture."""
    return values(peaks["t_peak"]) - values(front["t_rupture"])


def beyond_loading_zone(front):
    return np.flatnonzero(np.array(front["x"]) > LOADING_ZONE)


def middle(front):
    return [int(np.argmin(np.abs(np.array(front["x"]) - MIDDLE * front["L"])))]


BLOCKS_1E = {PRIMARY: beyond_loading_zone, "the middle block": middle}


def case_1E(peaks, front, blocks=beyond_loading_zone):
    """Of some blocks: the difference farthest from zero, None if one of them does not rupture."""
    chosen = blocks(front)
    off = off_by(peaks, front)[chosen]
    farthest = off[np.argmax(np.abs(off))]  # a NaN is the largest of all
    before, at_peak, after = (values(peaks[n])[chosen] for n in ("before", "at_peak", "after"))
    return {
        "peak minus rupture [ms]": None if np.isnan(farthest) else farthest * 1e3,
        "rises and falls": yes(np.all((before < at_peak) & (after < at_peak))),
    }


def units_1E(paths, blocks):
    """`blocks`: of a front, by convention."""
    return {
        f"{name_of(path)}, event {number}": {
            name: [case_1E(event["peaks"], event["unmodified"], of)] for name, of in blocks.items()
        }
        for path in paths
        for number, event in report(path).items()
    }


def claim_1E(record, peaks, front, paths):
    off, [i] = off_by(peaks, front), middle(front)
    ratio = record["tau"][:, i] / record["p"][:, i]
    case, distance = case_1E(peaks, front), np.abs(off)
    return judged(
        "1E",
        shown=case,
        units=units_1E(paths, BLOCKS_1E),
        measured={
            "block at [L]": front["x"][i] / front["L"],
            "tau/p 0.5 ms before the event": ratio[0],
            "at its peak": ratio.max(),
            "lowest afterwards": ratio[record.time > peaks["t_peak"][i]].min(),
            "peak minus rupture [ms]": off[i] * 1e3,
            "median distance over all blocks [ms]": np.median(distance) * 1e3,
            "farthest of the blocks beyond 2 cm [ms]": case["peak minus rupture [ms]"],
            "blocks within 0.1 ms": int((distance <= NEAR).sum()),
            "the others are at [mm]": np.array(front["x"])[distance > NEAR] * 1e3,
        },
        note="The case shown is event I, with all blocks beyond x = 2 cm; the curve is that of"
        " the block in the middle. A block ruptures when 70 % of its junctions have broken, and"
        " tau/p is largest just before. Blocks with larger differences may lie in the loading"
        " zone, where later loading exceeds this maximum or junctions break gradually before the"
        " front starts, or where the front is slow or was slow just before. Peaks count until 0.5"
        " ms after the last rupture of the front.",
    )


def write_tables(results, loading, events, record, front):
    load = np.array(loading["F_T"]) / loading["F_N"]
    write_table(results / "loading.csv", ["time [s]", "F_T/F_N"], zip(loading["time"], load))
    names = ["t_start [s]", "t_end [s]", "x_first [m]", "x_last [m]", "spanning", "type"]
    names += ["F_T_before [N]", "F_T_after [N]"]
    rows = ([event[name.split()[0]] for name in names] for event in events)
    write_table(results / "events.csv", names, rows)
    [i] = middle(front)
    time, p, tau = record.time, record["p"][:, i], record["tau"][:, i]
    names = ["time [s]", "time since the rupture [s]", "p [N]", "tau [N]", "tau/p"]
    columns = [time, time - front["t_rupture"][i], p, tau, tau / p]
    write_table(results / "block.csv", names, zip(*columns))


def make(data, results):
    loading = report(data / "ensemble/load-01-loading.json")
    events = read_events(data / "ensemble/load-01-events.json")
    front = report(data / "fig1/event-front.json")
    record = rupture.open(data / "fig1/event-record.h5")
    peaks = peaks_of(record)
    write_tables(results, loading, events, record, front)
    loads, continued = (of_ensemble(data, "load", kind) for kind in ("events", "continued"))
    shown_1Ew = case_1E(peaks, front, middle)
    return [
        claim_1Dw(events, loads),
        claim_1D(events, loads),
        judged("1Ew", shown_1Ew, shown_1Ew, units_1E(continued, {PRIMARY: middle})),
        claim_1E(record, peaks, front, continued),
    ]
