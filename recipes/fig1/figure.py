"""Figure 1 D-G, drawn from its tables."""

import numpy as np
from rupture.figures import ARRESTED, BLACK, BLUE, DOUBLE, FAST, SLOW, lettered, save

from fig1 import curves
from measure.tables import read_table
from paper import MU_D, MU_S

SHOWN = (0.1, 1500)  # speeds drawn in G [mm/s]


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


def draw(results):
    table = {
        name: read_table(results / f"{name}.csv")
        for name in ("loading", "events", "block", "junction", "steady-state")
    }
    fig, panels = lettered("DE;FG", DOUBLE, 0.62 * DOUBLE)
    draw_loading(panels["D"], table["loading"], table["events"])
    draw_block(panels["E"], table["block"])
    draw_junction(panels["F"], table["junction"])
    draw_speeds(panels["G"], table["steady-state"])
    save(fig, results / "fig1")


def make(results):
    curves.make(results)
    draw(results)
