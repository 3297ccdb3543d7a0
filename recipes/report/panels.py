"""Panels that several figures draw in the same way; more are in the Python package."""

import numpy as np
from rupture import plotting
from rupture.plotting import along_interface, draw_image  # noqa: F401  (for the recipes)
from rupture.plotting import draw_pinned, draw_pinned_scale, name_line  # noqa: F401

from measure.tables import values
from measure.fronts import LOADING_ZONE

MARGIN = 0.5  # shown before the first and after the last rupture [ms]


def window_of(*fronts):
    """The first rupture of these fronts [s], and the times to show [ms after it]."""
    ruptures = [values(front["t_rupture"]) for front in fronts]
    t_zero, last = np.nanmin(ruptures), np.nanmax(ruptures)
    return t_zero, (-MARGIN, (last - t_zero) * 1e3 + MARGIN)


def draw_ahead(axes, front, t_zero, **look):
    """Blocks beyond the loading zone that ruptured ahead of the front; times in ms after t_zero."""
    x, ruptured, front_at = (values(front[name]) for name in ("x", "t_rupture", "t_front"))
    ahead = (ruptured < front_at) & (x > LOADING_ZONE)
    times = (ruptured[ahead] - t_zero) * 1e3
    axes.plot(x[ahead] / front["L"], times, ".", markersize=2, **look)


def draw_front_speeds(axes, fronts, looks):
    """As in the package. Grey: the loading zone, in which speeds do not count."""
    plotting.draw_front_speeds(axes, fronts, looks)
    L = next(iter(fronts.values()))["L"]
    axes.plot([], [], "o", color=plotting.ABOVE, label="above $c_s$")
    axes.axvspan(0, LOADING_ZONE / L, color="0.9", linewidth=0, label="loading zone")
