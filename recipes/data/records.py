# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Readers for the figures: reports of the tools, and time series of records."""

import json

import h5py
import numpy as np


def report(path):
    """A report of `analyze ... --json`."""
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def values(numbers):
    """A list from a report as an array, NaN where it says null."""
    return np.array([np.nan if number is None else number for number in numbers])


def shear_wave_speed(path):
    """c_s = sqrt(G / rho), with Poisson ratio 1/3."""
    with h5py.File(path) as file:
        p = {name: file[f"parameters/slider/{name}"][()] for name in "LHBME"}
    return np.sqrt(p["E"] / (2 * (1 + 1 / 3)) / (p["M"] / (p["L"] * p["H"] * p["B"])))


class Pinned:
    """Pinned fraction of each block against time: time [s], x / L, fraction [samples][blocks]."""

    def __init__(self, path):
        with h5py.File(path) as file:
            self.time = file["series/time"][()]
            simplified = file["parameters/junctions/law"][()] == b"simplified"
            springs = 1 if simplified else file["parameters/junctions/N_s"][()]
            self.fraction = file["series/pinned"][()] / springs
        self.x_over_L = np.linspace(0, 1, self.fraction.shape[1])
