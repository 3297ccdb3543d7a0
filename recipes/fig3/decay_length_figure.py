"""Decay length of the shear force ahead of slow fronts: picture, data and claim 3D-length."""

import numpy as np
from decay_length import FITTED, METHODS, median

from claims import paper
from claims.judge import judged
from claims.spread import spread
from measure.tables import write_table
from measure.conventions import PRIMARY
from report.plotting import BLACK, BLUE, OF_PAPER, SINGLE, figure, save
import slow_fronts as slow


def case(l_0):
    """What the conditions ask for, of l_0 [m]."""
    return {"l_0 [mm]": l_0 and l_0 * 1e3}


def lengths(fronts):
    """{method: l_0 [m]}: the median of the fronts, all of the same weight."""
    return {name: median(front["l_0"][name] for front in fronts) for name in METHODS}


def conventions(points):
    """The case of one seed by each method."""
    found = lengths([point["l_0"] for point in points])
    return {name: [case(l_0)] for name, l_0 in found.items()}


def exponential_through_middle(x, excess, l_0):
    """An exponential with this l_0 that has the fitted blocks in its middle."""
    fitted = slice(FITTED[0], FITTED[1] + 1)
    amplitude = np.mean(np.log(excess[fitted]) + x[fitted] / l_0)
    return np.exp(amplitude - x / l_0)


def draw(fronts, l_0, stem):
    fig, axes = figure(SINGLE, 0.75 * SINGLE)
    x, excess = np.array(fronts[0]["x - x_0"]), np.array([front["excess"] for front in fronts])
    axes.plot(x * 1e3, excess.T, color="0.7", linewidth=0.6)
    axes.plot([], [], color="0.7", linewidth=0.6, label="one front")
    middle = np.median(excess, axis=0)
    axes.plot(x * 1e3, middle, "o", color=BLACK, markersize=3, label="median of the fronts")
    for length, text, look in (
        (l_0, "fitted", {"color": BLUE, "linewidth": 1}),
        (paper.L_0, "paper", OF_PAPER),
    ):
        label = rf"{text}: $l_0 = {length * 1e3:.1f}$ mm"
        line = exponential_through_middle(x, middle, length)
        axes.plot(x * 1e3, line, label=label, **look)
    fitted = x[list(FITTED)] * 1e3
    axes.axvspan(*fitted, color="0.93", linewidth=0, zorder=0, label="fitted blocks")
    axes.set(xlabel="$x - x_0$ [mm]", yscale="log", ylim=(0.06, 1.3))
    axes.set_ylabel(r"$(\tau - \tau_0)/(\tau - \tau_0)_{x_0}$")
    axes.legend(loc="upper right")
    save(fig, stem)


def claim(fronts, l_0, each, points):
    """`fronts`: the shown ones; `each`: l_0 of each [mm]."""
    cases = {name: case(length) for name, length in l_0.items()}
    shown = cases.pop(PRIMARY)
    others = [of for other in cases.values() if (of := other["l_0 [mm]"]) is not None]
    return judged(
        "3D-length",
        shown=shown,
        units=slow.of_seeds(conventions, points),
        measured={
            **shown,
            "slow fronts": len(fronts),
            "profiles": sum(front["profiles"] for front in fronts),
            "least and most of a front [mm]": [min(each), max(each)] if each else None,
            "least and most of the other conventions [mm]": [min(others), max(others)],
        },
        note="l_0 is fitted to the excess of the shear force over tau_0, when the block that"
        " ruptures next (x_0) carries its largest force: an exponential from x_0 to 3 blocks"
        " ahead, median over the blocks of the slow stretch, then over the fronts. Other"
        " conventions fit other blocks, or take the distance at which the excess has fallen to"
        " 1/e. The excess is not exponential: the farther a fit reaches, the longer l_0. The fit"
        " to 8 blocks ahead was added when the others were known, because it alone exceeds 25 %.",
    )


def make(chains, results):
    """decay_length.py says what is known of a front. Those without a slow stretch have no
    profiles."""
    shown = slow.of_seed(points := chains["l_0"])
    measured = {point["tau-bar"]: point["l_0"] for point in shown if point["l_0"]["profiles"]}
    fronts, l_0 = [*measured.values()], lengths([point["l_0"] for point in shown])
    draw(fronts, l_0[PRIMARY], results / "fig3-l0")
    names = ["tau_bar_0", "x - x_0 [m]", "excess over that at x_0"]
    profiles = {tau_bar: zip(f["x - x_0"], f["excess"]) for tau_bar, f in measured.items()}
    rows = ([tau_bar, *row] for tau_bar, profile in profiles.items() for row in profile)
    write_table(results / "decay-length.csv", names, rows)
    each = [f["l_0"][PRIMARY] * 1e3 for f in fronts if f["l_0"][PRIMARY] is not None]
    of, (shown_l_0,) = "{} prepared fronts", case(l_0[PRIMARY]).values()
    return [
        claim(fronts, l_0, each, points),
        spread("decay length l_0 [mm]", paper.L_0 * 1e3, each, of, shown=shown_l_0),
    ]
