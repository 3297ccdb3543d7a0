"""Decay length of the shear force ahead of slow fronts: picture and data."""

import numpy as np
from rupture.figures import BLACK, BLUE, OF_PAPER, SINGLE, figure, save

import paper
from claims.spread import spread
from fig3.decay_length import FITTED, median
from fig3.lengths import fronts
from measure.ways import PRIMARY
from measure.tables import write_table

SHOWN = 1  # seed


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


def make(results):
    """decay_length.py says what is known of a front. Those without a slow stretch have no
    profiles."""
    measured = {tau_bar: of for tau_bar, of in fronts(SHOWN).items() if of.profiles}
    l_0 = median(of.l_0[PRIMARY] for of in fronts(SHOWN).values())
    draw([*measured.values()], l_0, results / "fig3-l0")
    names = ["tau_bar_0", "x - x_0 [m]", "excess over that at x_0"]
    profiles = {tau_bar: zip(f["x - x_0"], f["excess"]) for tau_bar, f in measured.items()}
    rows = ([tau_bar, *row] for tau_bar, profile in profiles.items() for row in profile)
    write_table(results / "decay-length.csv", names, rows)
    each = [f.l_0[PRIMARY] * 1e3 for f in measured.values() if f.l_0[PRIMARY] is not None]
    of, shown = "{} prepared fronts", l_0 * 1e3
    return [spread("decay length l_0 [mm]", paper.L_0 * 1e3, each, of, shown=shown)]
