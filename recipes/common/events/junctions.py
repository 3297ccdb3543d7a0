"""Forces in single junctions, from a checkpoint and what `analyze phi --json` says of it."""

import h5py
import numpy as np


class Junctions:
    """[blocks][junctions]: force [N], slipping; per block: f_thres [N], x / L."""

    def __init__(self, checkpoint, phi):
        self.f_thres = np.array(phi["f_thres"])
        with h5py.File(checkpoint) as file:
            parameters = file["parameters/junctions"]
            k_ij = np.sqrt(parameters["kappa"][()] * self.f_thres / parameters["mu_s"][()])
            stretch = file["state/u_x"][0][:, None] - file["state/junctions/attachment"][()]
            self.slipping = file["state/junctions/slipping"][()] == 1
            self.x_over_L = np.array(phi["x"]) / file["parameters/slider/L"][()]
        self.force = k_ij[:, None] * stretch
        np.testing.assert_allclose(self.force.mean(axis=1), phi["mean"], rtol=1e-9)

    def pinned(self, block):
        """Forces in the pinned junctions of one block, ascending [N]."""
        return np.sort(self.force[block][~self.slipping[block]])
