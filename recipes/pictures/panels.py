# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Panels that several figures draw in the same way."""

import numpy as np

from data.records import values
from events.fronts import LOADING_ZONE
from pictures.plotting import BLACK, MAP

RUPTURED = 0.3  # pinned fraction below which a block counts as ruptured


def draw_pinned(axes, pinned, t_zero, window):
    """Map of the pinned fraction, position along x, time upwards in ms after t_zero, with the line
    along which blocks rupture. `window` is the time shown [ms]. Returns the image."""
    time = (pinned.time - t_zero) * 1e3
    shown = (time >= window[0]) & (time <= window[1])
    image = axes.pcolormesh(
        pinned.x_over_L,
        time[shown],
        pinned.fraction[shown],
        cmap=MAP,
        vmin=0,
        vmax=1,
        shading="nearest",
        rasterized=True,
    )
    axes.contour(
        pinned.x_over_L,
        time[shown],
        pinned.fraction[shown],
        levels=[RUPTURED],
        colors="white",
        linewidths=0.8,
    )
    axes.set(xlabel="$x/L$", ylabel="time [ms]", xlim=(0, 1), ylim=window)
    return image


def draw_pinned_scale(figure, image, axes):
    scale = figure.colorbar(image, ax=axes, label="fraction of pinned junctions", aspect=30)
    scale.ax.axhline(RUPTURED, color="white", linestyle="--", linewidth=0.8)


def draw_front_speeds(axes, fronts, looks):
    """Front speed against position. `fronts` holds reports of `analyze front` by name, `looks`
    label, colour and marker by the same names. Grey: the loading zone, in which speeds do not
    count."""
    for name, (label, colour, marker) in looks.items():
        front = fronts[name]
        v_c = values(front["v_c"])
        x = np.array(front["x"]) / front["L"]
        forwards = v_c > 0
        axes.plot(x[forwards], v_c[forwards], color=colour, marker=marker, label=label)
    c_s = front["c_s"]
    axes.axhline(c_s, color=BLACK, linewidth=0.8)
    axes.annotate("$c_s$", (0.9, c_s), xytext=(0, 2), textcoords="offset points")
    axes.axvspan(0, LOADING_ZONE / front["L"], color="0.9", linewidth=0)
    axes.set(xlabel="$x/L$", ylabel="front speed $v_c$ [m/s]", yscale="log", xlim=(0, 1))
