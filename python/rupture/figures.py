"""The look of the recipes' figures: that of the package, at the sizes of a printed page; and panels
that several figures draw in the same way."""

from collections.abc import Iterable

import numpy as np

from rupture import plotting
from rupture.plotting import BLACK, BLUE, GREEN, LINES, ORANGE, PURPLE, SKY, VERMILION
from rupture.plotting import pyplot_without_window
from rupture.plotting import save as write
from rupture.replacing import replacing
from rupture.reports import LOADING_ZONE, values

plt = pyplot_without_window()
plt.rcParams["axes.prop_cycle"] = plt.cycler(color=LINES)

MM = 1 / 25.4  # [inch]
SINGLE = 89 * MM  # width of one column [inch]
DOUBLE = 183 * MM  # width of the page [inch]
MARGIN = 0.5  # shown before the first and after the last rupture [ms]

# The command that draws pictures now, and the files behind them, for their metadata.
made_by: Iterable[str] = ["./reproduce.sh report"]

# The same thing has the same colour in all figures.
FAST, SLOW, ARRESTED = VERMILION, BLUE, "#9A8F3C"  # fronts
EVENT = {"I": GREEN, "II": PURPLE, "III": SKY}
AS_IT_IS, CHANGED = BLACK, ORANGE  # a run, and one in which something was changed
OF_PAPER = {"color": BLACK, "linestyle": ":", "linewidth": 0.8}  # lines of the paper's numbers


def figure(width=SINGLE, height=None, **subplots):
    """plt.subplots() in the style of the project; lengths in inches."""
    return plt.subplots(figsize=(width, height or 0.75 * width), **subplots)


def lettered(layout, width, height, **subplots):
    """Figure and {letter: panel}, with the letters drawn; `layout` as "AB;CC"."""
    fig, panels = plt.subplot_mosaic(layout, figsize=(width, height), **subplots)
    for text, axes in panels.items():
        letter(axes, text)
    return fig, panels


def letter(axes, text):
    """The letter of a panel, left of its title."""
    place = {"xytext": (-10, 6), "textcoords": "offset points", "annotation_clip": False}
    axes.annotate(text, (0, 1), xycoords="axes fraction", weight="bold", size=9, **place)


def save(fig, stem):
    """Writes stem.png and stem.pdf; equal plots of equal points are equal bytes."""
    for ending in (".png", ".pdf"):
        with replacing(f"{stem}{ending}") as temporary:
            write(fig, temporary, "\n".join(made_by))
    plt.close(fig)


# --- panels ------------------------------------------------------------------------------------


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
    """Draws front speeds as the package does. Grey: the loading zone, where they do not count."""
    plotting.draw_front_speeds(axes, fronts, looks)
    L = next(iter(fronts.values()))["L"]
    axes.plot([], [], "o", color=plotting.ABOVE, label="above $c_s$")
    axes.axvspan(0, LOADING_ZONE / L, color="0.9", linewidth=0, label="loading zone")
