"""Figure 5: A and its data here, B in quasistatic.py."""

import numpy as np
import rupture
from rupture.figures import AS_IT_IS, CHANGED, DOUBLE, figure, letter, save, window_of
from rupture.reports import values

from fig5 import quasistatic
from fig5.commands import event
from measure.tables import write_table
from measure.ways import PRIMARY

STOP = {"color": CHANGED, "linestyle": ":", "label": "driving stops"}


def draw_loading(axes, records, t_zero, t_stop):
    driven, undriven = (quasistatic.loading(record, t_zero) for record in records)
    axes.plot(*driven, color=AS_IT_IS, linewidth=2, label="driven")
    axes.plot(*undriven, "--", color=CHANGED, label="stopped")
    axes.axvline((t_stop - t_zero) * 1e3, **STOP)
    axes.set(xlabel="time [ms]", ylabel="$F_T/F_N$")
    axes.legend(loc="upper right")


def draw_lines(axes, fronts, t_zero, t_stop):
    """When the blocks rupture; those that had ruptured when the driving stopped only once."""
    driven, undriven = (values(front["t_rupture"]) for front in fronts)
    x = np.array(fronts[0]["x"]) / fronts[0]["L"]
    axes.plot(x, (driven - t_zero) * 1e3, color=AS_IT_IS, linewidth=2, label="rupture, driven")
    later = np.where(driven > t_stop, undriven, np.nan)
    axes.plot(x, (later - t_zero) * 1e3, "--", color=CHANGED, label="rupture, stopped")
    axes.axhline((t_stop - t_zero) * 1e3, **STOP)
    axes.legend(loc="lower right")


def draw(records, fronts, t_stop, stem):
    t_zero, window = window_of(fronts[0])
    fig, axes = figure(DOUBLE, 0.36 * DOUBLE, ncols=2, width_ratios=[1, 1.5])
    draw_loading(axes[0], records, t_zero, t_stop)
    quasistatic.draw_pinned(fig, axes[1], records[0], records[1], t_zero)
    draw_lines(axes[1], fronts, t_zero, t_stop)
    axes[1].set(ylim=window)
    letter(axes[0], "A")
    save(fig, stem)


def make(results):
    of = event()
    fronts = of.front, of.undriven[PRIMARY]
    records = [rupture.open(record) for record in (of.record, of.undriven_record)]
    draw(records, fronts, of.stop, results / "fig5A")
    names = ["x [m]", "t_rupture driven [s]", "t_rupture driving stopped [s]"]
    lines = zip(of.front.x, *(front.t_rupture for front in fronts))
    write_table(results / "rupture-lines.csv", names, lines)
    return quasistatic.make(results)
