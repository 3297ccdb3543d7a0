"""Tables of Figure 1."""

import numpy as np
import rupture

from events import shown_events
from fig1 import junction
from fig1.commands import MIDDLE, event, loading, pulled, steady
from measure.ways import PRIMARY
from measure.tables import write_table


def write_tables(results, loading, events, record, front):
    load = np.array(loading["F_T"]) / loading["F_N"]
    write_table(results / "loading.csv", ["time [s]", "F_T/F_N"], zip(loading["time"], load))
    names = ["t_start [s]", "t_end [s]", "x_first [m]", "x_last [m]", "spanning", "type"]
    names += ["F_T_before [N]", "F_T_after [N]"]
    rows = ([event[name.split()[0]] for name in names] for event in events)
    write_table(results / "events.csv", names, rows)
    time, p, tau = record.time, record["p"][:, MIDDLE], record["tau"][:, MIDDLE]
    names = ["time [s]", "time since the rupture [s]", "p [N]", "tau [N]", "tau/p"]
    columns = [time, time - front["t_rupture"][MIDDLE], p, tau, tau / p]
    write_table(results / "block.csv", names, zip(*columns))


def write_steady(path, steady, limits):
    names = ["v [m/s]", "tau/p", "standard error", "renewal theory"]
    columns = (steady[name] + limits[name] for name in ("v", "mu", "mu_error", "mu_theory"))
    write_table(path, names, sorted(zip(*columns)))


def make(results):
    events, record = shown_events("reference")[PRIMARY], rupture.open(event().record)
    write_tables(results, loading(), events, record, event().fronts[PRIMARY])
    names = ["time [s]", "displacement [m]", "f_T/f_N", "pinned"]
    write_table(results / "junction.csv", names, junction.rows(junction.Pulled(*pulled())))
    write_steady(results / "steady-state.csv", steady().range, steady().limits)
