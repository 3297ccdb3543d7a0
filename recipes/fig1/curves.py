"""Tables and claims of Figure 1 D and E."""

from itertools import takewhile

import numpy as np
import rupture

from claims.judge import judged
from data.records import report, values
from data.tables import write_table
from events.choose_events import read_events
from events.continuations import LEAD
from events.conventions import PRIMARY
from events.fronts import LOADING_ZONE
from events.units import name_of, of_ensemble

NEAR = 0.1e-3  # peak and rupture of a block [s]
MIDDLE = 0.5  # of L; the block of panel E


class Blocks:
    """Friction of the interface blocks against time in a record: [samples][blocks]."""

    def __init__(self, path):
        record = rupture.open(path)
        self.time, self.p, self.tau = (record[name] for name in ("time", "p", "tau"))  # [s, N, N]
        self.ratio = self.tau / self.p

    def peaks(self, until):
        """As the ensemble has them (ensemble/continue_events.py), up to a time [s]."""
        ratio = self.ratio[self.time <= until]
        return {
            "t_peak": self.time[np.argmax(ratio, axis=0)],
            "before": ratio[0],
            "at_peak": ratio.max(axis=0),
            "after": ratio[-1],
        }


def precursors(events):
    """All before the first one that spans."""
    return list(takewhile(lambda event: not event["spanning"], events))


def case_1D(events, first):
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
    }


def claim_1Dw(events, paths):
    units = {name_of(path): {PRIMARY: [case_1Dw(read_events(path))]} for path in paths}
    shown = case_1Dw(events)
    return judged("1Dw", shown, shown, units)


def units_1D(paths):
    return {
        name_of(path): {
            PRIMARY: [case_1D(read_events(path), None)],
            "the first five": [case_1D(read_events(path), 5)],
        }
        for path in paths
    }


def claim_1D(events, paths):
    early = precursors(events)
    drops = [e["F_T_before"] - e["F_T_after"] for e in events if e["spanning"]]
    others = [e["F_T_before"] - e["F_T_after"] for e in events if not e["spanning"]]
    return judged(
        "1D",
        shown=case_1D(events, None),
        units=units_1D(paths),
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


def case_1E(peaks, front, chosen):
    """Of some blocks: the difference farthest from zero, None if one of them does not rupture."""
    off = off_by(peaks, front)[chosen]
    farthest = off[np.argmax(np.abs(off))]  # a NaN is the largest of all
    before, at_peak, after = (values(peaks[n])[chosen] for n in ("before", "at_peak", "after"))
    return {
        "peak minus rupture [ms]": None if np.isnan(farthest) else farthest * 1e3,
        "rises and falls": "yes" if np.all((before < at_peak) & (after < at_peak)) else "no",
    }


def cases_1E(peaks, front):
    """By convention."""
    return {
        PRIMARY: [case_1E(peaks, front, beyond_loading_zone(front))],
        "the middle block": [case_1Ew(peaks, front)],
    }


def case_1Ew(peaks, front):
    return case_1E(peaks, front, [middle(front)])


def claim_1Ew(peaks, front, paths):
    shown = case_1Ew(peaks, front)
    units = of_continued(paths, lambda *of_event: {PRIMARY: [case_1Ew(*of_event)]})
    return judged("1Ew", shown, shown, units)


def of_continued(paths, cases):
    return {
        f"{name_of(path)}, event {number}": cases(event["peaks"], event["unmodified"])
        for path in paths
        for number, event in report(path).items()
    }


def claim_1E(blocks, peaks, front, paths):
    t_rupture = values(front["t_rupture"])
    off = np.abs(off_by(peaks, front))
    i = middle(front)
    ratio, t_peak = blocks.ratio[:, i], peaks["t_peak"]
    cases = cases_1E(peaks, front)
    return judged(
        "1E",
        shown=cases[PRIMARY][0],
        units=of_continued(paths, cases_1E),
        measured={
            "block at [L]": front["x"][i] / front["L"],
            "tau/p 0.5 ms before the event": ratio[0],
            "at its peak": ratio.max(),
            "lowest afterwards": ratio[blocks.time > t_peak[i]].min(),
            "peak minus rupture [ms]": (t_peak[i] - t_rupture[i]) * 1e3,
            "median distance over all blocks [ms]": np.median(off) * 1e3,
            "farthest of the blocks beyond 2 cm [ms]": cases[PRIMARY][0]["peak minus rupture [ms]"],
            "blocks within 0.1 ms": int((off <= NEAR).sum()),
            "the others are at [mm]": np.array(front["x"])[off > NEAR] * 1e3,
        },
        note="The case shown is event I, with all blocks beyond x = 2 cm; the"
        " curve is that of the block in the middle. A block ruptures when 70 % of its junctions"
        " have broken, and tau/p is largest just before. Blocks farther off may be in the"
        " loading zone, where later loading exceeds it or junctions break gradually before the"
        " front starts, and where the front is slow or has just been. Peaks count until 0.5 ms"
        " after the last rupture of the front.",
    )


def beyond_loading_zone(front):
    return np.array(front["x"]) > LOADING_ZONE


def middle(front):
    return int(np.argmin(np.abs(np.array(front["x"]) - MIDDLE * front["L"])))


def write_tables(results, loading, events, blocks, front):
    load = np.array(loading["F_T"]) / loading["F_N"]
    write_table(results / "loading.csv", ["time [s]", "F_T/F_N"], zip(loading["time"], load))
    names = ["t_start [s]", "t_end [s]", "x_first [m]", "x_last [m]", "spanning", "type"]
    names += ["F_T_before [N]", "F_T_after [N]"]
    rows = ([event[name.split()[0]] for name in names] for event in events)
    write_table(results / "events.csv", names, rows)
    i = middle(front)
    columns = blocks.time, blocks.time - front["t_rupture"][i]
    write_table(
        results / "block.csv",
        ["time [s]", "time since the rupture [s]", "p [N]", "tau [N]", "tau/p"],
        zip(*columns, *(column[:, i] for column in (blocks.p, blocks.tau, blocks.ratio))),
    )


def make(data, results):
    loading = report(data / "ensemble/load-01-loading.json")
    events = read_events(data / "ensemble/load-01-events.json")
    front = report(data / "fig1/event-front.json")
    blocks = Blocks(data / "fig1/event-record.h5")
    peaks = blocks.peaks(np.nanmax(values(front["t_rupture"])) + LEAD)
    write_tables(results, loading, events, blocks, front)
    loads, continued = (of_ensemble(data, "load", kind) for kind in ("events", "continued"))
    return [
        claim_1Dw(events, loads),
        claim_1D(events, loads),
        claim_1Ew(peaks, front, continued),
        claim_1E(blocks, peaks, front, continued),
    ]
