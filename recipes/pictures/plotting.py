# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""The look of all figures: sizes of a printed page, and colours that everybody can tell apart."""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend has to be chosen first)

MM = 1 / 25.4  # [inch]
SINGLE = 89 * MM  # width of one column [inch]
DOUBLE = 183 * MM  # width of the page [inch]
MAP = "viridis"  # for images; "cividis" where a second one is needed

# Okabe and Ito's colours: distinct for all common kinds of colour vision.
BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"
YELLOW, BLUE, VERMILION, PURPLE = "#F0E442", "#0072B2", "#D55E00", "#CC79A7"
LINES = [BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK]

OF_PAPER = {"color": BLACK, "linestyle": ":", "linewidth": 0.8}  # lines of the paper's numbers

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
    "axes.prop_cycle": matplotlib.cycler(color=LINES),
    "image.cmap": MAP,
    "image.origin": "lower",
    "image.interpolation": "nearest",
    "figure.constrained_layout.use": True,
    "pdf.fonttype": 42,  # text stays text
    "savefig.dpi": 300,
}


def figure(width=SINGLE, height=None, **subplots):
    """plt.subplots() in the style of the project; lengths in inches."""
    plt.rcParams.update(STYLE)
    return plt.subplots(figsize=(width, height or 0.75 * width), **subplots)


def letter(axes, text):
    """The letter of a panel, above its upper left corner."""
    axes.set_title(text, loc="left", fontweight="bold", fontsize=9)


def save(fig, stem):
    """Writes stem.png and stem.pdf; equal plots are equal bytes."""
    Path(stem).parent.mkdir(parents=True, exist_ok=True)
    fig.savefig(f"{stem}.png", metadata={"Software": None})
    fig.savefig(f"{stem}.pdf", metadata={"CreationDate": None, "ModDate": None})
    plt.close(fig)
