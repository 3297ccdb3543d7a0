"""Tables of Figure 1."""

import junction
import numpy as np
import rupture

from measure.tables import write_table

MIDDLE = 0.5  # of L; the block of panel E


def middle(front):
    return int(np.argmin(np.abs(np.array(front["x"]) - MIDDLE * front["L"])))


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


def write_steady(path, steady, limits):
    names = ["v [m/s]", "tau/p", "standard error", "renewal theory"]
    columns = (steady[name] + limits[name] for name in ("v", "mu", "mu_error", "mu_theory"))
    write_table(path, names, sorted(zip(*columns)))


def make(chains, results):
    parts = ("loading", "ensemble/shown_events", "event", "junction", "steady")
    [loading], [shown], [event], [pulled], [steady] = (chains[name] for name in parts)
    record = rupture.open(event.file("record.h5"))
    write_tables(results, loading["loading"], shown["measured"]["events"], record, event["front"])
    names = ["time [s]", "displacement [m]", "f_T/f_N", "pinned"]
    write_table(results / "junction.csv", names, junction.rows(junction.pulled_of(pulled)))
    write_steady(results / "steady-state.csv", steady["range"], steady["limits"])
