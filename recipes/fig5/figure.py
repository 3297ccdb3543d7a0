"""Figure 5: A, its data and its claim here, B in quasistatic.py."""

import numpy as np
import quasistatic
import rupture

from data.records import report, values
from data.tables import write_table
from events.event_claims import judged_event
from events.fronts import middle_of_slow_stretch
from events.units import of_ensemble, of_events
from pictures.panels import draw_image, draw_pinned_scale, window_of
from pictures.plotting import BLACK, BLUE, DOUBLE, MAP, VERMILION, figure, save

EVENT = "fast-slow-fast"
STILL = 0.95  # from this pinned fraction on the undriven interface is not coloured


def draw_loading(axes, data, t_zero, t_stop):
    time, load = quasistatic.loading(data / f"{EVENT}-record.h5")
    axes.plot((time - t_zero) * 1e3, load, color="0.6", linewidth=2.5, label="driven")
    time, load = quasistatic.loading(data / f"{EVENT}/undriven-record.h5")
    axes.plot((time - t_zero) * 1e3, load, color=BLUE, label="driving stopped")
    axes.axvline((t_stop - t_zero) * 1e3, color=VERMILION, linestyle=":", linewidth=0.9)
    axes.set(xlabel="time [ms]", ylabel="$F_T/F_N$")
    axes.legend(loc="upper right")


def draw_map(axes, pinned, t_zero, colours, shown):
    fraction = np.where(shown, pinned.pinned_fraction, np.nan)
    return draw_image(axes, pinned, fraction, slice(None), t_zero, cmap=colours, vmin=0, vmax=1)


def draw_lines(axes, fronts, t_zero, t_stop):
    """When the blocks rupture; those that had ruptured when the driving stopped only once."""
    driven, undriven = (values(front["t_rupture"]) for front in fronts)
    x = np.array(fronts[0]["x"]) / fronts[0]["L"]
    axes.plot(x, (driven - t_zero) * 1e3, color=BLACK, linewidth=2, label="driven")
    later = np.where(driven > t_stop, undriven, np.nan)
    axes.plot(x, (later - t_zero) * 1e3, "--", color=VERMILION, label="driving stopped")
    axes.legend(loc="lower right")


def draw(data, fronts, t_stop, stem):
    t_zero, window = window_of(fronts[0])
    fig, axes = figure(0.8 * DOUBLE, 0.36 * DOUBLE, ncols=2)
    draw_loading(axes[0], data, t_zero, t_stop)
    driven, undriven = (
        rupture.open(data / f"{run}-record.h5") for run in (EVENT, f"{EVENT}/undriven")
    )
    draw_map(axes[1], driven, t_zero, "gray", True)
    image = draw_map(axes[1], undriven, t_zero, MAP, undriven.pinned_fraction < STILL)
    draw_lines(axes[1], fronts, t_zero, t_stop)
    axes[1].axhline((t_stop - t_zero) * 1e3, color=VERMILION, linestyle=":", linewidth=0.9)
    axes[1].set(xlim=(0, 1), ylim=window)
    draw_pinned_scale(fig, image, axes[1])
    save(fig, stem)


def write_ruptures(path, fronts):
    names = ["x [m]", "t_rupture driven [s]", "t_rupture driving stopped [s]"]
    write_table(path, names, zip(fronts[0]["x"], *(front["t_rupture"] for front in fronts)))


def make(data, results):
    fronts = [report(data / f"{run}-front.json") for run in (EVENT, f"{EVENT}/undriven")]
    t_stop = middle_of_slow_stretch(fronts[0])
    draw(data, fronts, t_stop, results / "fig5A")
    write_ruptures(results / "rupture-lines.csv", fronts)
    continued = of_ensemble(data, "load", "continued")
    in_words = report(data / f"{EVENT}-front-in-words.json")
    measured = {"5Aw": (in_words, *fronts), "5A": fronts}
    claims = [judged_event(c, {"event I": m}, of_events(continued, c)) for c, m in measured.items()]
    return [*claims, *quasistatic.make(data, results)]
