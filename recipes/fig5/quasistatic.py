"""Figure 5 B, its data and its claim."""

import numpy as np
import rupture
from matplotlib.colors import LinearSegmentedColormap
from quasistatic_stretch import advances, read_ruptures

from claims.judge import judged
from claims.spread import spread
from measure.tables import write_table
from measure.conventions import PRIMARY
from report.panels import draw_image
from report.plotting import AS_IT_IS, CHANGED, DOUBLE, MAP, figure, letter, save

GREYS = LinearSegmentedColormap.from_list("greys", ["0.5", "1"])  # black lines can be seen on it
STILL = 0.95  # from this pinned fraction on the undriven interface is not coloured
HARDLY = 2  # blocks
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
    stretch, stopped = middle["stretch"], rupture.open(middle.file("stopped-record.h5"))
    first, second = stretch["dynamic_events"][:2]
    window = (first - SHOWN_BEFORE) * 1e3, (second + SHOWN_AFTER) * 1e3
    fig, axes = figure(DOUBLE, 0.42 * DOUBLE, ncols=2, width_ratios=[1, 1.5])
    draw_loading(axes[0], load, stopped, window)
    draw_pinned(fig, axes[1], load, stopped)
    t_branch = float(middle["branch"]["t"]) * 1e3
    axes[1].axhline(t_branch, color=CHANGED, linestyle=":", label="driving stops")
    time, tip = np.array(stretch["tip"]).T
    axes[1].step(
        tip / load.x[-1], time * 1e3, where="pre", color=AS_IT_IS, linewidth=1, label="tip, driven"
    )
    axes[1].set(ylim=window)
    axes[1].legend(loc="lower right", bbox_to_anchor=(1, 0.1))
    letter(axes[0], "B")
    save(fig, stem)


def moved(branch):
    """What advances() says of a point of stopped.ini."""
    load, stopped = (
        read_ruptures(branch.file(name)) for name in ("record.h5", "stopped-record.h5")
    )
    return advances(load, stopped, branch["stretch"]["interval_from"], float(branch["branch"]["t"]))


def case_5B(branch, found):
    c_s = rupture.open(branch.file("record.h5")).c_s
    return {
        "c_s/speed": c_s / branch["stretch"]["speed"],
        "blocks in 20 ms, V = 0": found["stopped"],
    }


def units_5B(branches):
    """`branches`: one of each seed. A front that hardly moves with the drive either says nothing
    about what happens without it."""
    found = {branch: moved(branch) for branch in branches}
    return {
        f"seed {branch['numerics.seed']:g}": {PRIMARY: [case_5B(branch, of_seed)]}
        for branch, of_seed in found.items()
        if of_seed["driven"] > HARDLY
    }


def claim_5B(case, speed, branches, units):
    return judged(
        "5B",
        shown=case,
        units=units,
        measured={
            "mean speed [m/s]": speed,
            **case,
            "all branches, V = 0": [branch["stopped"] for branch in branches],
            "all branches, driven": [branch["driven"] for branch in branches],
        },
        note="The stretch lies between the first two dynamic events (more than half of the blocks"
        " rupture within 1 ms) and ends 10 ms before the second. The branch in the middle of its"
        " time decides the verdict. There is a branch at each tenth of it, on the 10 ms grid of the"
        " checkpoints; in the last one the second event has begun to nucleate. The front creeps in"
        " bursts of some ms; if a branch begins within one, the front continues for some blocks"
        " before it stops.",
    )


def make(branches, of_seeds, results):
    [middle] = (branch for branch in branches if branch["branch"]["middle"])
    stretch, found = middle["stretch"], {branch: moved(branch) for branch in branches}
    draw(middle, rupture.open(middle.file("record.h5")), results / "fig5B")
    write_table(results / "quasistatic-tip.csv", ["time [s]", "tip [m]"], stretch["tip"])
    names = ["V = 0 from [s]", "tip [block]", "advance driven [blocks]"]
    names += ["advance with V = 0 [blocks]"]
    rows = map(dict.values, found.values())
    write_table(results / "quasistatic-branches.csv", names, rows)
    case, units = case_5B(middle, found[middle]), units_5B(of_seeds)
    ratios = [of_seed["c_s/speed"] for unit in units.values() for of_seed in unit[PRIMARY]]
    of = "{} runs at h = 0"
    number = spread("c_s/speed at h = 0", None, ratios, of, shown=case["c_s/speed"])
    return [claim_5B(case, stretch["speed"], found.values(), units), number]
