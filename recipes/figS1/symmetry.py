"""Symmetry of the forces along the interface, as the script of a chain:

    symmetry = script symmetry.py CHECKPOINT {all forces}

Reports how far p is from symmetric and tau from antisymmetric at F_T = 0, the sum of p over F_N
minus 1, and by how much the centroid of p moves until event I [m], over F_T h/F_N. The sum is
judged where the slider rests.
"""

import numpy as np
import rupture

from chains.results import read_points


class Stress:
    """The result of `analyze stress`: x [m], forces per block p and tau [N]."""

    def __init__(self, stress):
        self.x, self.p, self.tau = (np.array(stress[name]) for name in ("x", "p", "tau"))
        self.F_T, self.F_N, self.time = stress["F_T"], stress["F_N"], stress["time"]
        self.L = self.x[-1]

    def centroid(self):
        """From the middle of the interface, at the undeformed positions [m]."""
        return np.sum(self.p * (self.x - self.L / 2)) / np.sum(self.p)


def main(checkpoint, points):
    [point] = read_points(points)
    unloaded, before = Stress(point["unloaded"]), Stress(point["before"])
    shift = before.centroid() - unloaded.centroid()
    lever = before.F_T * rupture.open(checkpoint)["driving.h"] / before.F_N
    symmetry = np.abs(unloaded.p - unloaded.p[::-1]).max() / unloaded.p.mean()
    antisymmetry = np.abs(unloaded.tau + unloaded.tau[::-1]).max() / np.abs(unloaded.tau).max()
    return {
        "of_p": float(symmetry),
        "of_tau": float(antisymmetry),
        "sum_of_p": float(abs(unloaded.p.sum() / unloaded.F_N - 1)),
        "shift": float(shift),
        "over_lever": float(shift / lever),
    }
