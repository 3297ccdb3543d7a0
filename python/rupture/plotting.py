"""The look of all pictures, and the panels that several draw."""

import logging
import os
import re

import numpy as np

from rupture.tables import imported

MAP = "viridis"  # for images; "cividis" where a second one is needed

# Okabe and Ito's colours: distinct for all common kinds of colour vision.
BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
BLUE, VERMILION, PURPLE = "#0072B2", "#D55E00", "#CC79A7"
LINES = [BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK]

STYLE = {
    "font.family": "DejaVu Sans",  # comes with Matplotlib
    "font.size": 8,
    "axes.titlesize": 8,
    "axes.labelsize": 8,
    "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5,
    "legend.fontsize": 7.5,
    "legend.frameon": False,
    "axes.linewidth": 0.6,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.minor.width": 0.4,
    "ytick.minor.width": 0.4,
    "xtick.direction": "out",
    "ytick.direction": "out",
    "lines.linewidth": 1.2,
    "lines.markersize": 3,
    "image.cmap": MAP,
    "image.origin": "lower",
    "image.interpolation": "nearest",
    "figure.constrained_layout.use": True,
    "pdf.fonttype": 42,  # text stays text
    "savefig.dpi": 300,
}

RUPTURED = 0.3  # pinned fraction below which a block counts as ruptured
PINNED_AGAIN = 0.5  # pinned fraction above which a ruptured block no longer belongs to the front
ROWS = 1500  # of an image: more than can be told apart
ABOVE = "0.7"  # colour of front speeds above c_s
MILLISECONDS = 1e3
ROUNDING = 1e-6  # of times [ms]


def pyplot_without_window():
    """pyplot for programs that write files. No display, toolkit or matplotlibrc counts, and nothing
    is said if no home folder can keep Matplotlib's cache. Matplotlib may be missing."""
    os.environ.update(MATPLOTLIBRC=os.devnull, MPLBACKEND="agg")
    os.environ.setdefault("HOME", os.devnull)  # an unknown user has none
    logging.getLogger("matplotlib").setLevel(logging.CRITICAL)
    pyplot = imported("matplotlib.pyplot")
    pyplot.switch_backend("agg")  # it may be imported already
    pyplot.rcdefaults()
    pyplot.rcParams.update(STYLE)
    return pyplot


# What takes a text, and what would differ from one drawing to the next, by the ending of the file.
METADATA = {
    ".png": ("Description", {"Software": None}),
    ".pdf": ("Subject", {"CreationDate": None, "ModDate": None}),
    ".svg": ("Description", {"Date": None}),
}


def save(figure, path, made_by, **options):
    """Writes a picture, in whose metadata is where it comes from. Equal ones are equal bytes."""
    name, others = METADATA[path.suffix.lower()]
    figure.savefig(path, metadata={name: made_by, **others}, **options)


def plain_text(name):
    """The name of a file as text for matplotlib, without formulas and undecodable bytes."""
    return os.fsencode(name).decode(errors="replace").replace("$", r"\$")


def rows_in(record, t_zero, window):
    """Indices of at most ROWS samples of a record in `window` [ms after t_zero], evenly spaced."""
    time = (record.time - t_zero) * MILLISECONDS
    shown = np.flatnonzero((time > window[0] - ROUNDING) & (time < window[1] + ROUNDING))
    return shown[:: max(1, -(-len(shown) // ROWS))]


def along_interface(axes):
    """The axis x/L, with ticks that do not run into those of the next panel."""
    axes.set(xlabel="$x/L$", xlim=(0, 1))
    axes.set_xticks([0, 0.2, 0.4, 0.6, 0.8, 1], ["0", "0.2", "0.4", "0.6", "0.8", "1"])


def draw_profile(axes, described, lines, **look):
    """Draws in a thin panel what a parameter is along x. `described` is its row of `rupture
    parameters --json`; `lines`: places and values of each line, in SI units; words are numbers."""
    symbol = re.sub(r"\b(mu|kappa|delta)(?![a-z])", r"\\\1", described["symbol"].strip("-"))
    symbol = re.sub(r"_(\w+)", r"_{\1}", symbol)
    for x, values in lines:
        axes.plot(x, values, **look)
    found = np.concatenate([values for _, values in lines])
    words, ends = described.get("words"), (found.min(), found.max())
    low, high = (words[int(end)] if words else f"{end:.4g}" for end in ends)
    unit = described["unit"].replace("1", "")
    name = f"${symbol}$, {described['name']}" if symbol else described["name"]
    axes.set_title(f"{name}: {low} to {high} {unit}".rstrip(), loc="left", fontsize=6.5, pad=2)
    axes.margins(y=0.2)
    axes.set(xticks=[], yticks=[])


def draw_image(axes, record, values, rows, t_zero, **look):
    """Image of `values` [rows][blocks], position along x, time upwards in ms after t_zero."""
    x, time = record.x / record.x[-1], (record.time[rows] - t_zero) * MILLISECONDS
    along_interface(axes)
    axes.set(ylabel="time [ms]")
    return axes.pcolormesh(x, time, values, shading="nearest", rasterized=True, **look)


def draw_pinned(axes, record, t_zero, window, line=True, ruptured=False):
    """Map of the pinned fraction, with the line along which blocks rupture first. (Where a block
    is pinned again and ruptures once more, that is no front, nor does the line go on beside it.)
    `window` is the time shown [ms after t_zero]; blocks that had `ruptured` before it have no line.
    Returns the image."""
    rows = rows_in(record, t_zero, window)
    fraction = record.pinned_fraction[rows]
    image = draw_image(axes, record, fraction, rows, t_zero, cmap=MAP, vmin=0, vmax=1)
    x, time = record.x / record.x[-1], (record.time[rows] - t_zero) * MILLISECONDS
    lowest = np.minimum.accumulate(fraction)
    if line and lowest.min() < RUPTURED < lowest.max():
        is_again = (lowest < RUPTURED) & (fraction > PINNED_AGAIN)
        lowest = np.ma.masked_where(is_again | np.asarray(ruptured), lowest)
        axes.contour(x, time, lowest, levels=[RUPTURED], colors="white", linewidths=0.8)
    axes.set(ylim=window)
    return image


def draw_pinned_scale(figure, image, axes, **place):
    scale = figure.colorbar(
        image, ax=axes, label=f"pinned fraction (white: {RUPTURED:g})", aspect=30, **place
    )
    across = scale.ax.axhline if scale.orientation == "vertical" else scale.ax.axvline
    across(RUPTURED, color="white", linewidth=0.8)


def name_line(axes, text, height):
    """Writes a name at the right end of a horizontal line, outside the panel."""
    place = {"xycoords": axes.get_yaxis_transform(), "textcoords": "offset points"}
    axes.annotate(text, (1, height), xytext=(3, 0), va="center", **place)


def draw_front_speeds(axes, fronts, looks):
    """Front speed against position. `fronts` holds reports of `analyze front` by name, `looks`
    label, colour and marker by the same names. Speeds above c_s are grey: there, blocks that were
    about to break do so nearly at once."""
    for name, (label, colour, marker) in looks.items():
        front = fronts[name]
        v_c = np.array(front["v_c"], dtype=float)  # None becomes NaN
        x = np.array(front["x"]) / front["L"]
        v_c[~(v_c > 0)] = np.nan  # backwards, or unknown: the line breaks
        if np.isfinite(v_c).any():  # not over fewer blocks than a stencil has
            axes.plot(x, v_c, color=colour, marker=marker, label=label)
            above = v_c > front["c_s"]
            axes.plot(x[above], v_c[above], marker, color=ABOVE, zorder=3)
    c_s = front["c_s"]
    axes.axhline(c_s, color=BLACK, linewidth=0.8)
    name_line(axes, "$c_s$", c_s)
    along_interface(axes)
    axes.set(ylabel="front speed $v_c$ [m/s]", yscale="log")
