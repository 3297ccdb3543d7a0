#!/usr/bin/env python3
"""Figure 2, its data and its claims: figure.py results/data results/fig2 load-01-events.json ..."""

import sys
from pathlib import Path

import numpy as np

from claims.claim import write_claims
from data.records import Pinned, report, values
from data.tables import write_fronts
from events.event_claims import case_of_event, claims_of_fronts
from events.units import in_words, of_loads
from pictures.panels import draw_front_speeds, draw_pinned, draw_pinned_scale
from pictures.plotting import BLACK, BLUE, DOUBLE, VERMILION, figure, letter, save

EVENTS = {  # label, colour, marker
    "fast-slow-fast": ("event I", BLUE, "o"),
    "fast-only": ("event III", VERMILION, "^"),
}
PAPER_SPEEDS = {3: "$c_s/3$", 100: "$c_s/100$"}  # c_s over the speed
PAPER_TRANSITIONS = (0.4, 0.6)  # [L]
MARGIN = 0.5  # shown before the first and after the last rupture [ms]


def first_rupture(front):
    return np.nanmin(values(front["t_rupture"]))


def draw_map(axes, front, pinned):
    t_zero = first_rupture(front)
    last = (np.nanmax(values(front["t_rupture"])) - t_zero) * 1e3
    return draw_pinned(axes, pinned, t_zero, (-MARGIN, last + MARGIN))


def draw_speeds(axes, fronts):
    draw_front_speeds(axes, fronts, EVENTS)
    c_s = fronts["fast-slow-fast"]["c_s"]
    for part, text in PAPER_SPEEDS.items():
        axes.axhline(c_s / part, color=BLACK, linestyle=":", linewidth=0.8)
        axes.annotate(text, (0.01, c_s / part), xytext=(0, 2), textcoords="offset points")
    for x in PAPER_TRANSITIONS:
        axes.axvline(x, color=BLACK, linestyle=":", linewidth=0.8)
    axes.set(ylim=(1, None))
    axes.legend(loc="lower left", bbox_to_anchor=(0.12, 0))


def draw(data, fronts, stem):
    fig, axes = figure(DOUBLE, 0.36 * DOUBLE, ncols=3)
    for axis, name, text in zip(axes, EVENTS, "AB"):
        image = draw_map(axis, fronts[name], Pinned(data / f"{name}-record.h5"))
        axis.set_title(EVENTS[name][0])
        letter(axis, text)
    draw_pinned_scale(fig, image, axes[:2])
    draw_speeds(axes[2], fronts)
    letter(axes[2], "C")
    save(fig, stem)


def main(data, results, *loads):
    data, results = Path(data), Path(results)
    fronts = {name: report(data / f"{name}-front.json") for name in EVENTS}
    draw(data, fronts, results / "fig2")
    write_fronts(results / "front-speed.csv", fronts)
    slow, fast = fronts.values()
    again = report(data / "fast-slow-fast-front-in-words.json")
    units = of_loads(loads, case_of_event), in_words(loads)
    write_claims(results / "claims.json", claims_of_fronts(slow, again, fast, *units))


if __name__ == "__main__":
    main(*sys.argv[1:])
