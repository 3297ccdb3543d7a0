"""Tables and claims of Figure 1 D and E."""

from itertools import takewhile

import numpy as np
import rupture

from claims.judge import judged, yes
from measure.records import values
from measure.tables import write_table
from measure.conventions import PRIMARY
from measure.slip import peaks_of
from measure.cases import events_of, name_of

MIDDLE = 0.5  # of L; the block of panel E


def precursors(events):
    """All before the first one that spans."""
    return list(takewhile(lambda event: not event["spanning"], events))


def case_1D(events):
    """Of one run."""
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


def claim_1D(events, loads):
    case = case_1D(events)
    units = {load: {PRIMARY: [case_1D(of[PRIMARY])]} for load, of in events_of(loads).items()}
    first = next(event for event in events if event["spanning"])
    return judged("1D", case | {"first spanning event at [s]": first["t_start"]}, case, units)


def middle(front):
    return int(np.argmin(np.abs(np.array(front["x"]) - MIDDLE * front["L"])))


def case_1E(peaks, front):
    """Of the block in the middle; None where it does not rupture."""
    i = middle(front)
    off = (values(peaks["t_peak"]) - values(front["t_rupture"]))[i]
    before, at_peak, after = (values(peaks[n])[i] for n in ("before", "at_peak", "after"))
    return {
        "peak minus rupture [ms]": None if np.isnan(off) else off * 1e3,
        "rises and falls": yes(before < at_peak and after < at_peak),
    }


def claim_1E(record, peaks, front, continued):
    i, case = middle(front), case_1E(peaks, front)
    ratio = record["tau"][:, i] / record["p"][:, i]
    measured = {
        "block at [L]": front["x"][i] / front["L"],
        "tau/p 0.5 ms before the event": ratio[0],
        "at its peak": ratio.max(),
    }
    note = (
        "A block ruptures when 70 % of its junctions have broken, and tau/p is largest just before."
        " Peaks count until 0.5 ms after the last rupture of the front."
    )
    units = {
        f"{name_of(p)}, event {p['event']['number']}": {PRIMARY: [case_1E(p["peaks"], p["front"])]}
        for p in continued
    }
    return judged("1E", measured | case, case, units, note)


def write_tables(results, loading, events, record, front):
    load = np.array(loading["F_T"]) / loading["F_N"]
    write_table(results / "loading.csv", ["time [s]", "F_T/F_N"], zip(loading["time"], load))
    names = ["t_start [s]", "t_end [s]", "x_first [m]", "x_last [m]", "spanning", "type"]
    names += ["F_T_before [N]", "F_T_after [N]"]
    rows = ([event[name.split()[0]] for name in names] for event in events)
    write_table(results / "events.csv", names, rows)
    i = middle(front)
    time, p, tau = record.time, record["p"][:, i], record["tau"][:, i]
    names = ["time [s]", "time since the rupture [s]", "p [N]", "tau [N]", "tau/p"]
    columns = [time, time - front["t_rupture"][i], p, tau, tau / p]
    write_table(results / "block.csv", names, zip(*columns))


def make(chains, results):
    [loading], [shown], [event] = (
        chains["loading"],
        chains["ensemble/shown_events"],
        chains["event"],
    )
    events, front = shown["measured"]["events"], event["front"]
    record = rupture.open(event.file("record.h5"))
    write_tables(results, loading["loading"], events, record, front)
    return [
        claim_1D(events, chains["ensemble/events"]),
        claim_1E(record, peaks_of(record), front, chains["ensemble/continued"]),
    ]
