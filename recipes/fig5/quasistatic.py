"""Figure 5 B and its data."""

from matplotlib.colors import LinearSegmentedColormap
import numpy as np
import rupture
from rupture.errors import Failure
from rupture.figures import AS_IT_IS, CHANGED, DOUBLE, figure, letter, save
from rupture.plotting import MAP, draw_image

from claims.spread import spread
from fig5.commands import MOVES, branches, middle_branch, seeds, shown_load
from measure.tables import write_table

GREYS = LinearSegmentedColormap.from_list("greys", ["0.5", "1"])  # black lines can be seen on it
STILL = 0.95  # from this pinned fraction on the undriven interface is not coloured
SHOWN_BEFORE, SHOWN_AFTER = 10e-3, 5e-3  # the dynamic events on either side [s]


def loading(record, t_zero=0.0):
    """Time [ms after t_zero] and F_T / F_N."""
    return (record.time - t_zero) * 1e3, record["F_T"] / record["slider.F_N"]


def draw_loading(axes, load, stopped, window):
    axes.plot(*loading(load), color=AS_IT_IS, linewidth=0.8, label="driven at $h = 0$")
    axes.plot(*loading(stopped), color=CHANGED, label="driving stopped")
    axes.axvspan(*window, color="0.9", linewidth=0, label="shown on the right")
    axes.set(xlabel="time [ms]", ylabel="$F_T/F_N$", xlim=(0, None), ylim=(0, None))
    axes.legend(loc="lower right")


def draw_pinned(fig, axes, driven, stopped, t_zero=0.0):
    """The pinned fraction: grey as driven, in colour where blocks slip after the driving stops."""

    def draw_shown(record, shown, colours):
        fraction = np.where(shown, record.pinned_fraction, np.nan)
        return draw_image(axes, record, fraction, slice(None), t_zero, cmap=colours, vmin=0, vmax=1)

    grey = draw_shown(driven, True, GREYS)
    colour = draw_shown(stopped, stopped.pinned_fraction < STILL, MAP)
    for image, name in ((colour, "stopped"), (grey, "driven")):
        fig.colorbar(image, ax=axes, label=f"pinned fraction, {name}", aspect=30)


def draw(middle, load, stem):
    """`middle`: the branch in the middle of the stretch; `load`: the record before it."""
    stretch, stopped = middle.stretch, rupture.open(middle.record)
    first, second = stretch.dynamic_events[:2]
    window = (first - SHOWN_BEFORE) * 1e3, (second + SHOWN_AFTER) * 1e3
    fig, axes = figure(DOUBLE, 0.42 * DOUBLE, ncols=2, width_ratios=[1, 1.5])
    draw_loading(axes[0], load, stopped, window)
    draw_pinned(fig, axes[1], load, stopped)
    axes[1].axhline(middle.t * 1e3, color=CHANGED, linestyle=":", label="driving stops")
    time, tip = np.array(stretch.tip).T
    axes[1].step(
        tip / load.x[-1], time * 1e3, where="pre", color=AS_IT_IS, linewidth=1, label="tip, driven"
    )
    axes[1].set(ylim=window)
    axes[1].legend(loc="lower right", bbox_to_anchor=(1, 0.1))
    letter(axes[0], "B")
    save(fig, stem)


def ratio_of(branch):
    return branch.advance.c_s / branch.stretch.speed


def make(results):
    middle = middle_branch()
    draw(middle, rupture.open(shown_load()["record.h5"]), results / "fig5B")
    write_table(results / "quasistatic-tip.csv", ["time [s]", "tip [m]"], middle.stretch.tip)
    names = ["V = 0 from [s]", "tip [block]", "advance driven [blocks]"]
    names += ["advance with V = 0 [blocks]"]
    keys = ("t", "tip", "driven", "stopped")
    rows = ([branch.advance[key] for key in keys] for branch in branches())
    write_table(results / "quasistatic-branches.csv", names, rows)
    of_seeds = (branch for _, branch in seeds() if not isinstance(branch, Failure))
    ratios = [ratio_of(branch) for branch in of_seeds if branch.advance.driven > MOVES]
    of = "{} runs at h = 0"
    return [spread("c_s/speed at h = 0", None, ratios, of, shown=ratio_of(middle))]
