"""Panels that several figures draw in the same way."""

from common.plotting import MAP

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
