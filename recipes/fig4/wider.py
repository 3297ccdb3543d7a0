#!/usr/bin/env python3
"""Figure 4 A-B and its claim: wider.py results/data results/fig4 CLAIMS.json"""

import sys
from pathlib import Path

import numpy as np

from claims.claim import write_claims
from data.records import Pinned, report, values
from events.event_claims import claim_4AB
from pictures.panels import draw_pinned, draw_pinned_scale
from pictures.plotting import DOUBLE, figure, letter, save

EVENT = "fast-slow-fast"
MARGIN = 0.5  # shown before the first and after the last rupture [ms]
REGION = 0.25  # from here on phi was changed [L]


def draw_events(axes, data, fronts):
    """The pinned fraction of both, with the same time axis. Returns the image."""
    t_zero = min(np.nanmin(values(front["t_rupture"])) for front in fronts)
    last = max(np.nanmax(values(front["t_rupture"])) for front in fronts)
    window = (-MARGIN, (last - t_zero) * 1e3 + MARGIN)
    for axis, run in zip(axes, (EVENT, f"{EVENT}/wider")):
        image = draw_pinned(axis, Pinned(data / f"{run}-record.h5"), t_zero, window)
    return image


def draw(data, fronts, stem):
    fig, axes = figure(0.7 * DOUBLE, 0.36 * DOUBLE, ncols=2, sharey=True)
    image = draw_events(axes, data, fronts)
    titles = ("as it is", r"wider $\varphi$ beyond $0.25\,L$")
    for axis, text, title in zip(axes, "AB", titles):
        axis.set_title(title)
        letter(axis, text)
    axes[1].set_ylabel("")
    arrow = {"arrowstyle": "->", "shrinkA": 0, "shrinkB": 0}
    axes[1].annotate("", (1, 0.03), (REGION, 0.03), "axes fraction", "axes fraction", arrow)
    draw_pinned_scale(fig, image, axes)
    save(fig, stem)


def main(data, results, claims):
    data, results = Path(data), Path(results)
    fronts = [report(data / f"{run}-front.json") for run in (EVENT, f"{EVENT}/wider")]
    phi = [report(data / f"{run}-phi.json") for run in (EVENT, f"{EVENT}/wider-start")]
    draw(data, fronts, results / "fig4AB")
    write_claims(claims, [claim_4AB(*fronts, *phi)])


if __name__ == "__main__":
    main(*sys.argv[1:])
