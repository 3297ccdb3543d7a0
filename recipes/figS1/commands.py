"""Figure S1: normal and friction forces along the interface, unloaded and before event I."""

from functools import cache
from types import SimpleNamespace

import numpy as np
import rupture
from rupture.once import measured, run

from claims.samples import Samples
from events import shipped


class Stress:
    """The report of `analyze stress`: x [m], forces per block p and tau [N]."""

    def __init__(self, stress):
        self.x, self.p, self.tau = (np.array(stress[name]) for name in ("x", "p", "tau"))
        self.F_T, self.F_N, self.L = stress["F_T"], stress["F_N"], self.x[-1]

    def centroid(self):
        """The distance of the centroid of p from the middle of the interface, at the undeformed
        positions [m]."""
        return np.sum(self.p * (self.x - self.L / 2)) / np.sum(self.p)


def driven_at(checkpoint):
    """The height of the driven block [m]."""
    return float(rupture.open(checkpoint)["driving.h"])


@cache
def states():
    unloaded = run("load -o unloaded.h5 --until 0")["unloaded.h5"]
    event = shipped("fast-slow-fast")
    return SimpleNamespace(
        unloaded=run(f"analyze stress {unloaded}"),
        before=run(f"analyze stress {event}"),
        h=measured(driven_at, event),
    )


def both_states():
    return Samples({"": states()})


def symmetry(of, _):
    """S1: how far p is from symmetric and tau from antisymmetric where the slider rests; by how
    much the centroid of p moves until event I, over F_T h/F_N."""
    unloaded, before = Stress(of.unloaded), Stress(of.before)
    shift = before.centroid() - unloaded.centroid()
    asymmetry = np.abs(unloaded.p - unloaded.p[::-1]).max()
    symmetric = np.abs(unloaded.tau + unloaded.tau[::-1]).max()
    return {
        "asymmetry of p/mean p": asymmetry / unloaded.p.mean(),
        "symmetric part of tau/largest tau": symmetric / np.abs(unloaded.tau).max(),
        "|sum p/F_N - 1|": abs(unloaded.p.sum() / unloaded.F_N - 1),
        "their difference [%]": (shift / (before.F_T * of.h / before.F_N) - 1) * 100,
        "shift of the centroid of p [mm]": shift * 1e3,
    }
