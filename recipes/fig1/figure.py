"""Figure 1 D-G and its data: tables, each {heading: column}."""

import numpy as np
import rupture
from rupture.figures import ARRESTED, BLACK, BLUE, DOUBLE, FAST, SLOW, lettered, save

from events import shown_events
from fig1 import junction
from fig1.commands import MIDDLE, event, loading, pulled, steady
from measure.ways import PRIMARY
from measure.tables import write_table
from paper import MU_D, MU_S

SHOWN = (0.1, 1500)  # speeds drawn in G [mm/s]
OF_EVENT = {  # heading: name in a report
    "t_start [s]": "t_start",
    "t_end [s]": "t_end",
    "x_first [m]": "x_first",
    "x_last [m]": "x_last",
    "spanning": "spanning",
    "type": "type",
    "F_T_before [N]": "F_T_before",
    "F_T_after [N]": "F_T_after",
}


# --- data --------------------------------------------------------------------------------------


def driving_force():
    report = loading()
    force = np.array(report.F_T) / report.F_N
    return {"time [s]": np.array(report.time), "F_T/F_N": force}


def events_of_load():
    events = shown_events("reference")[PRIMARY]
    return {head: np.array([one[name] for one in events]) for head, name in OF_EVENT.items()}


def block_in_the_middle():
    record, front = rupture.open(event().record), event().fronts[PRIMARY]
    p, tau = record["p"][:, MIDDLE], record["tau"][:, MIDDLE]
    since = record.time - front.t_rupture[MIDDLE]
    head = {"time [s]": record.time, "time since the rupture [s]": since}
    return head | {"p [N]": p, "tau [N]": tau, "tau/p": tau / p}


def one_junction():
    names = ["time [s]", "displacement [m]", "f_T/f_N", "pinned"]
    columns = zip(*junction.rows(junction.Pulled(*pulled())))
    return dict(zip(names, map(np.array, columns)))


def steady_friction():
    """All speeds, and the limits of low and high ones."""
    both, order = steady(), np.argsort(steady().range.v + steady().limits.v)
    names = {"v [m/s]": "v", "tau/p": "mu", "standard error": "mu_error"}
    names["renewal theory"] = "mu_theory"
    columns = {head: both.range[name] + both.limits[name] for head, name in names.items()}
    return {head: np.array(column)[order] for head, column in columns.items()}


# --- picture -----------------------------------------------------------------------------------


def draw_loading(axes, loading, events):
    axes.plot(loading["time [s]"], loading["F_T/F_N"], color=BLACK, linewidth=0.8)
    peak = np.interp(events["t_start [s]"], loading["time [s]"], loading["F_T/F_N"])
    for kind, colour, marker, label in (
        ("arrested", ARRESTED, "o", "arrested event"),
        ("slow", SLOW, "v", "spans, with a slow stretch"),
        ("fast", FAST, "^", "spans, fast everywhere"),
    ):
        chosen = events["type"] == kind
        x, y = events["t_start [s]"][chosen], peak[chosen] + 0.012
        axes.plot(x, y, marker, color=colour, markersize=3, label=label)
    axes.set(xlabel="$t$ [s]", ylabel="$F_T/F_N$", xlim=(0, 1.2), ylim=(0, 0.25))
    axes.legend(loc="lower right")


def draw_block(axes, block):
    time = block["time since the rupture [s]"] * 1e3
    axes.plot(time, block["tau/p"], color=BLUE)
    axes.axvline(0, color=BLACK, linestyle=":", linewidth=0.8)
    axes.annotate("rupture", (0, 0.27), xytext=(4, 0), textcoords="offset points")
    axes.set(xlabel="time after the block's rupture [ms]", ylabel=r"$\tau/p$ at $x = 0.5\,L$")
    axes.set(xlim=(time[0], time[-1]), ylim=(0.1, 0.285))


def draw_junction(axes, junction):
    u = junction["displacement [m]"] * 1e6
    axes.plot(u, junction["f_T/f_N"], color=BLUE)
    for level, name in ((MU_S, r"$\mu_s$"), (MU_D, r"$\mu_d$")):
        axes.axhline(level, color=BLACK, linestyle=":", linewidth=0.8)
        axes.annotate(name, (u[-1], level), xytext=(3, -3), textcoords="offset points")
    axes.set(xlabel="displacement of the block [µm]", ylabel="$f_T/f_N$")
    axes.set(xlim=(0, u[-1]), ylim=(-0.02, 0.45))


def draw_speeds(axes, steady):
    v = steady["v [m/s]"] * 1e3
    shown = (v > 0.9 * SHOWN[0]) & (v < SHOWN[1])
    axes.plot(v[shown], steady["renewal theory"][shown], color=BLACK, linewidth=0.8, label="theory")
    axes.plot(v[shown], steady["tau/p"][shown], "o", color=BLUE, label="measured")
    for level, name in ((MU_S / 2, r"$\mu_s/2$"), (MU_D, r"$\mu_d$")):
        axes.axhline(level, color=BLACK, linestyle=":", linewidth=0.8)
        axes.annotate(name, (400, level), xytext=(0, -9), textcoords="offset points")
    axes.set(xscale="log", xlabel="sliding speed [mm/s]", ylabel=r"$\tau/p$", ylim=(0.163, 0.203))
    axes.legend(loc="center right")


def draw(tables, stem):
    fig, panels = lettered("DE;FG", DOUBLE, 0.62 * DOUBLE)
    draw_loading(panels["D"], tables["loading"], tables["events"])
    draw_block(panels["E"], tables["block"])
    draw_junction(panels["F"], tables["junction"])
    draw_speeds(panels["G"], tables["steady-state"])
    save(fig, stem)


def make(results):
    tables = {
        "loading": driving_force(),
        "events": events_of_load(),
        "block": block_in_the_middle(),
        "junction": one_junction(),
        "steady-state": steady_friction(),
    }
    for name, columns in tables.items():
        write_table(results / f"{name}.csv", columns, zip(*columns.values()))
    draw(tables, results / "fig1")
