"""The forces in junctions before and after phi is widened. The slipping ones keep their force."""

import numpy as np
import rupture
from scipy import stats

REGION = 0.25  # phi was changed from here on, this block included [L]


class Junctions:
    """The junctions of a checkpoint, and what `analyze phi --json` reports. [blocks][junctions]:
    force [N], slipping; per block: f_thres [N], x / L."""

    def __init__(self, checkpoint, phi):
        self.f_thres = np.array(phi["f_thres"])
        state = rupture.open(checkpoint)
        k_ij = np.sqrt(state["junctions.kappa"] * self.f_thres / state["junctions.mu_s"])
        stretch = state["u_x"][0][:, None] - state["junctions/attachment"]
        self.slipping = state["junctions/slipping"] == 1
        self.x_over_L = np.array(phi["x"]) / state["slider.L"]
        self.force = k_ij[:, None] * stretch
        np.testing.assert_allclose(self.force.mean(axis=1), phi["mean"], rtol=1e-9)

    def pinned(self, block):
        """Forces in the pinned junctions of one block, ascending [N]."""
        return np.sort(self.force[block][~self.slipping[block]])


def beside_widest_uniform(junctions, block):
    """The forces in a block's pinned junctions and the widest uniform phi with their mean: p of the
    Kolmogorov-Smirnov test, and the largest distance of a force from its exact quantile
    (j + 1/2)/n, over f_thres."""
    forces, f_thres = junctions.pinned(block), junctions.f_thres[block]
    mean = forces.mean()
    half_width = f_thres - abs(mean)
    uniform = stats.uniform(mean - half_width, 2 * half_width)
    quantiles = (2 * np.arange(len(forces)) + 1) / len(forces) - 1
    distance = np.max(np.abs(forces - mean - half_width * quantiles)) / f_thres
    return stats.kstest(forces, uniform.cdf).pvalue, distance


def beside_uniform(checkpoint):
    """The smallest p of Kolmogorov-Smirnov tests that the forces in the pinned junctions of a
    changed block are uniform, and their largest distance from exact quantiles, over f_thres."""
    junctions = Junctions(checkpoint, rupture.analyze("phi", checkpoint))
    changed = np.flatnonzero(junctions.x_over_L > REGION - 1e-9)
    p, distances = zip(*(beside_widest_uniform(junctions, block) for block in changed))
    return {"p": float(min(p)), "distance": float(max(distances)), "blocks": len(changed)}
