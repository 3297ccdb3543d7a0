"""Panels that several figures draw in the same way; more are in the Python package."""

import numpy as np
from rupture import plotting
from rupture.plotting import along_interface, draw_image  # noqa: F401  (for the recipes)
from rupture.plotting import draw_pinned, draw_pinned_scale, name_line  # noqa: F401

from claims import paper
from measure.records import values
from measure.fronts import LOADING_ZONE

MARGIN = 0.5  # shown before the first and after the last rupture [ms]


def window_of(*fronts):
    """The first rupture of these fronts [s], and the times to show [ms after it]."""
    ruptures = [values(front["t_rupture"]) for front in fronts]
    t_zero, last = np.nanmin(ruptures), np.nanmax(ruptures)
    return t_zero, (-MARGIN, (last - t_zero) * 1e3 + MARGIN)


def ruptured_early(front):
    """Blocks that ruptured ahead of the front: so long before their neighbours that a front of
    c_s/100 would have passed from them to these."""
    t = values(front["t_rupture"])
    spacing = front["L"] / (len(t) - 1)
    beside = np.pad(t, 1, constant_values=np.inf)
    return np.minimum(beside[:-2], beside[2:]) - t > spacing / (paper.SLOW * front["c_s"])


def draw_front_speeds(axes, fronts, looks):
    """As in the package. Grey: the loading zone, in which speeds do not count."""
    plotting.draw_front_speeds(axes, fronts, looks)
    L = next(iter(fronts.values()))["L"]
    axes.axvspan(0, LOADING_ZONE / L, color="0.9", linewidth=0, label="loading zone")
