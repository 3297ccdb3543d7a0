"""Stresses in the slider, which files do not hold: they follow from the displacements."""

import numpy as np

POISSON = 1 / 3  # of the lattice
STRESSES = ("sigma_xx", "sigma_zz", "sigma_xz")


def stress_of(u_x, u_z, parameters):
    """Plane stress of an isotropic solid with this displacement, [...][Nz][Nx] [m]: sigma_xx,
    sigma_zz and sigma_xz [Pa]. Small strains from central differences, at the edges one-sided
    ones, so values at the edges and at the tip of a front are rough."""
    l = parameters["slider.L"] / (parameters["slider.Nx"] - 1)  # noqa: E741  the paper's symbol
    E = parameters["slider.E"]
    xx, zz = np.gradient(u_x, l, axis=-1), np.gradient(u_z, l, axis=-2)
    xz = (np.gradient(u_x, l, axis=-2) + np.gradient(u_z, l, axis=-1)) / 2
    plane = E / (1 - POISSON**2)
    return plane * (xx + POISSON * zz), plane * (zz + POISSON * xx), E / (1 + POISSON) * xz
