"""Panels that several figures draw in the same way; more are in the Python package."""

from rupture import plotting
from rupture.plotting import (  # noqa: F401  (for the recipes)
    draw_pinned,
    draw_pinned_scale,
    name_line,
)

from events.fronts import LOADING_ZONE


def draw_front_speeds(axes, fronts, looks):
    """As in the package. Grey: the loading zone, in which speeds do not count."""
    plotting.draw_front_speeds(axes, fronts, looks)
    L = next(iter(fronts.values()))["L"]
    axes.axvspan(0, LOADING_ZONE / L, color="0.9", linewidth=0)
