"""Figure S1, its data and its claim."""

import numpy as np
import rupture

from claims.judge import judged
from measure.tables import write_table
from report.plotting import BLACK, BLUE, DOUBLE, VERMILION, lettered, save


class Stress:
    """The result of `analyze stress`: x [m], forces per block p and tau [N]."""

    def __init__(self, stress):
        self.x, self.p, self.tau = (np.array(stress[name]) for name in ("x", "p", "tau"))
        self.F_T, self.F_N, self.time = stress["F_T"], stress["F_N"], stress["time"]
        self.L = self.x[-1]

    def centroid(self):
        """From the middle of the interface, at the undeformed positions [m]."""
        return np.sum(self.p * (self.x - self.L / 2)) / np.sum(self.p)


def claim_S1(unloaded, before, state):
    symmetry = np.abs(unloaded.p - unloaded.p[::-1]).max() / unloaded.p.mean()
    antisymmetry = np.abs(unloaded.tau + unloaded.tau[::-1]).max() / np.abs(unloaded.tau).max()
    total = abs(unloaded.p.sum() / unloaded.F_N - 1)
    shift = before.centroid() - unloaded.centroid()
    lever = before.F_T * state["driving.h"] / before.F_N
    case = {
        "asymmetry of p/mean p": symmetry,
        "symmetric part of tau/largest tau": antisymmetry,
        "|sum p/F_N - 1|": total,
        "their difference [%]": (shift / lever - 1) * 100,
    }
    return judged(
        "S1",
        shown=case,
        measured={
            **case,
            "shift of the centroid of p [mm]": shift * 1e3,
        },
        note="Symmetry and the sum of p are judged at F_T = 0, where the slider rests. Event I is"
        " the fast-slow-fast event of Figure 2, 0.5 ms before its first rupture: h is the height"
        " of the driven block. The slider still oscillates a little from earlier events.",
    )


def draw_stress(axes, stress):
    x = stress.x / stress.L
    axes.plot(x, stress.p, color=BLUE, marker="o", label="$p$")
    axes.plot(x, stress.tau, color=VERMILION, marker="^", label=r"$\tau$")
    axes.axhline(0, color=BLACK, linewidth=0.6)
    axes.set(xlabel="$x/L$", xlim=(-0.01, 1.01))


def draw(unloaded, before, stem):
    fig, panels = lettered("AB", DOUBLE, 0.38 * DOUBLE, sharey=True)
    draw_stress(panels["A"], unloaded)
    draw_stress(panels["B"], before)
    panels["A"].set(title="$F_T = 0$", ylabel="force on a block [N]")
    panels["B"].set_title(f"0.5 ms before event I, $F_T$ = {before.F_T:.0f} N")
    panels["A"].legend(loc="center")
    save(fig, stem)


def make(chains, results):
    (point,) = chains["forces"]
    unloaded, before = Stress(point["unloaded"]), Stress(point["before"])
    draw(unloaded, before, results / "figS1")
    names = ["p [N]", "tau [N]"]
    write_table(
        results / "stress.csv",
        ["x [m]", *(f"{state} {n}" for state in ("unloaded", "before event") for n in names)],
        zip(unloaded.x, unloaded.p, unloaded.tau, before.p, before.tau),
    )
    return [claim_S1(unloaded, before, rupture.open(point.base))]
