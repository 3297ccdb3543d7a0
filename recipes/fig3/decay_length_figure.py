"""Decay length of the shear force ahead of slow fronts: picture, data and claim 3D-length."""

import numpy as np
from decay_length import FITTED, METHODS

from claims import paper
from claims.judge import judged
from claims.spread import spread
from data.records import report
from data.tables import write_table
from events.conventions import PRIMARY
from pictures.plotting import BLACK, BLUE, OF_PAPER, SINGLE, figure, save


def case(l_0):
    """What the conditions ask for, of l_0 [m]."""
    return {"l_0 [mm]": l_0 and l_0 * 1e3}


def units_of(paths):
    """{seed: {convention: [case]}}; l0-seed-3.json is the report of seed 3."""
    return {
        path.stem.removeprefix("l0-").replace("-", " "): {
            name: [case(report(path)["l_0"][name])] for name in METHODS
        }
        for path in paths
    }


def measured_fronts(seed):
    """{tau_bar_0: front} of those with a slow stretch."""
    return {tau_bar: f for tau_bar, f in seed["fronts"].items() if f["profiles"]}


def exponential_through_middle(x, excess, l_0):
    """An exponential with this l_0 that has the fitted blocks in its middle."""
    fitted = slice(FITTED[0], FITTED[1] + 1)
    amplitude = np.mean(np.log(excess[fitted]) + x[fitted] / l_0)
    return np.exp(amplitude - x / l_0)


def draw(seed, stem):
    fronts = measured_fronts(seed)
    fig, axes = figure(SINGLE, 0.75 * SINGLE)
    first = next(iter(fronts.values()))
    x, excess = np.array(first["x - x_0"]), np.array([f["excess"] for f in fronts.values()])
    axes.plot(x * 1e3, excess.T, color="0.7", linewidth=0.6)
    axes.plot([], [], color="0.7", linewidth=0.6, label="one front")
    middle = np.median(excess, axis=0)
    axes.plot(x * 1e3, middle, "o", color=BLACK, markersize=3, label="median of the fronts")
    for l_0, text, look in (
        (seed["l_0"][PRIMARY], "fitted", {"color": BLUE, "linewidth": 1}),
        (paper.L_0, "paper", OF_PAPER),
    ):
        label = rf"{text}: $l_0 = {l_0 * 1e3:.1f}$ mm"
        line = exponential_through_middle(x, middle, l_0)
        axes.plot(x * 1e3, line, label=label, **look)
    fitted = x[list(FITTED)] * 1e3
    axes.axvspan(*fitted, color="0.93", linewidth=0, zorder=0, label="fitted blocks")
    axes.set(xlabel="$x - x_0$ [mm]", yscale="log", ylim=(0.06, 1.3))
    axes.set_ylabel(r"$(\tau - \tau_0)/(\tau - \tau_0)_{x_0}$")
    axes.legend(loc="upper right")
    save(fig, stem)


def lengths_of(seed):
    """l_0 of each front [mm]."""
    found = (front["l_0"][PRIMARY] for front in measured_fronts(seed).values())
    return [l_0 * 1e3 for l_0 in found if l_0 is not None]


def claim(paths):
    seed = report(paths[0])
    fronts, lengths = measured_fronts(seed).values(), lengths_of(seed)
    cases = {name: case(seed["l_0"][name]) for name in METHODS}
    shown = cases.pop(PRIMARY)
    others = [of for other in cases.values() if (of := other["l_0 [mm]"]) is not None]
    return judged(
        "3D-length",
        shown=shown,
        units=units_of(paths),
        measured={
            **shown,
            "slow fronts": len(fronts),
            "profiles": sum(front["profiles"] for front in fronts),
            "least and most of a front [mm]": [min(lengths), max(lengths)] if lengths else None,
            "least and most of the other conventions [mm]": [min(others), max(others)],
        },
        note="l_0 is fitted to the excess of the shear force over tau_0, when the block that"
        " ruptures next (x_0) carries its largest force: an exponential from x_0 to 3 blocks"
        " ahead, median over the blocks of the slow stretch, then over the fronts. Other"
        " conventions fit other blocks, or take the distance at which the excess has fallen to"
        " 1/e. The excess is not exponential: the farther a fit reaches, the longer l_0. The fit"
        " to 8 blocks ahead was added when the others were known, because it alone exceeds 25 %.",
    )


def make(data, results):
    """The first report is of the seed that is shown; decay_length.py says what is in it."""
    paths = sorted(data.glob("l0-seed-[0-9].json"))
    shown = report(paths[0])
    draw(shown, results / "fig3-l0")
    names = ["tau_bar_0", "x - x_0 [m]", "excess over that at x_0"]
    profiles = {t: zip(f["x - x_0"], f["excess"]) for t, f in measured_fronts(shown).items()}
    rows = ([tau_bar, *row] for tau_bar, profile in profiles.items() for row in profile)
    write_table(results / "decay-length.csv", names, rows)
    (l_0,) = case(shown["l_0"][PRIMARY]).values()
    of = "{} prepared fronts"
    return [
        claim(paths),
        spread("decay length l_0 [mm]", paper.L_0 * 1e3, lengths_of(shown), of, shown=l_0),
    ]
