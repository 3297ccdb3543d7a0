"""Figure 5 B, its data and its claim."""

import numpy as np
import rupture
from matplotlib.colors import LinearSegmentedColormap
from quasistatic_stretch import MIDDLE, advances, read_ruptures

from claims.judge import judged
from claims.spread import spread
from data.records import report
from data.tables import write_table
from events.conventions import PRIMARY
from pictures.panels import draw_image
from pictures.plotting import AS_IT_IS, CHANGED, DOUBLE, MAP, figure, letter, save

GREYS = LinearSegmentedColormap.from_list("greys", ["0.5", "1"])  # black lines can be seen on it
STILL = 0.95  # from this pinned fraction on the undriven interface is not coloured
HARDLY = 2  # blocks
SHOWN_BEFORE, SHOWN_AFTER = 10e-3, 5e-3  # the dynamic events on either side [s]


def loading(path, t_zero=0.0):
    """Time [ms after t_zero] and F_T / F_N."""
    record = rupture.open(path)
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


def draw(data, stretch, L, stem):
    load = data / "quasistatic-load-record.h5"
    stopped = data / f"quasistatic-stopped-{MIDDLE}-record.h5"
    first, second = stretch["dynamic_events"][:2]
    window = (first - SHOWN_BEFORE) * 1e3, (second + SHOWN_AFTER) * 1e3
    fig, axes = figure(DOUBLE, 0.42 * DOUBLE, ncols=2, width_ratios=[1, 1.5])
    draw_loading(axes[0], load, stopped, window)
    draw_pinned(fig, axes[1], rupture.open(load), rupture.open(stopped))
    t_branch = float(stretch["branches"][MIDDLE]) * 1e3
    axes[1].axhline(t_branch, color=CHANGED, linestyle=":", label="driving stops")
    time, tip = np.array(stretch["tip"]).T
    axes[1].step(tip / L, time * 1e3, where="pre", color=AS_IT_IS, linewidth=1, label="tip, driven")
    axes[1].set(ylim=window)
    axes[1].legend(loc="lower right", bbox_to_anchor=(1, 0.1))
    letter(axes[0], "B")
    save(fig, stem)


def case_5B(c_s, speed, branch):
    return {"c_s/speed": c_s / speed, "blocks in 20 ms, V = 0": branch["stopped"]}


def units_5B(paths):
    """By quasistatic_seed.py. A front that hardly moves with the drive either says
    nothing about what happens without it."""
    found = {path.stem: report(path) for path in paths}
    return {
        name: {PRIMARY: [case_5B(load["c_s"], load["speed"], load["branch"])]}
        for name, load in found.items()
        if load["branch"]["driven"] > HARDLY
    }


def claim_5B(stretch, c_s, branches, others):
    speed, middle = stretch["speed"], branches[MIDDLE]
    case = case_5B(c_s, speed, middle)
    return judged(
        "5B",
        shown=case,
        units=units_5B(others),
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


def make(all_data, results):
    data, ensemble = all_data / "fig5", all_data / "ensemble"
    stretch = report(data / "quasistatic-stretch.json")
    record = data / "quasistatic-load-record.h5"
    load = read_ruptures(record)
    stopped = (data / f"quasistatic-stopped-{n}-record.h5" for n in range(len(stretch["branches"])))
    branches = [
        advances(load, read_ruptures(path), stretch["interval_from"], float(t_branch))
        for path, t_branch in zip(stopped, stretch["branches"])
    ]
    draw(data, stretch, load[2][-1], results / "fig5B")
    write_table(results / "quasistatic-tip.csv", ["time [s]", "tip [m]"], stretch["tip"])
    names = ["V = 0 from [s]", "tip [block]", "advance driven [blocks]"]
    names += ["advance with V = 0 [blocks]"]
    branch_rows = [branch.values() for branch in branches]
    write_table(results / "quasistatic-branches.csv", names, branch_rows)
    c_s = rupture.open(record).c_s
    others = sorted(ensemble.glob("h0-[0-9][0-9][0-9].json"))
    of = "{} runs at h = 0"
    ratios = [case["c_s/speed"] for unit in units_5B(others).values() for case in unit[PRIMARY]]
    number = spread("c_s/speed at h = 0", None, ratios, of, shown=c_s / stretch["speed"])
    return [claim_5B(stretch, c_s, branches, others), number]
