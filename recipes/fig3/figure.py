#!/usr/bin/env python3
"""Figure 3 A-C, its data and its claims: figure.py results/data results/fig3 CLAIMS.json"""

import sys
from pathlib import Path

import numpy as np

from claims.claim import write_claims
from data.records import Pinned, report
from data.tables import write_table
from events.event_claims import claim_3A, claim_3B, claim_3C
from pictures.panels import draw_pinned, draw_pinned_scale
from pictures.plotting import BLACK, BLUE, DOUBLE, GREEN, VERMILION, figure, letter, save

EVENT = "fast-slow-fast"
SLIPS = {  # run: label, colour, line style
    "t_R-half": (r"$\langle t_R\rangle/2$", VERMILION, "--"),
    "stopped": (r"$\langle t_R\rangle$ (as in A)", BLUE, "-"),
    "t_R-double": (r"$2\,\langle t_R\rangle$", GREEN, "-."),
}


def draw_maps(fig, axes, data, t_zero, window):
    for axis, run, title in zip(axes, ("stopped", "no-slow-slip"), ("$V = 0$", "no slow slip")):
        image = draw_pinned(axis, Pinned(data / f"{run}-record.h5"), t_zero, window)
        axis.set_title(title)
    draw_pinned_scale(fig, image, axes)


def draw_slip(axes, slips, t_zero):
    for run, (label, colour, style) in SLIPS.items():
        slip = slips[run]
        time = (np.array(slip["time"]) - t_zero) * 1e3
        axes.plot(time, np.array(slip["slip"]) * 1e6, style, color=colour, label=label)
        fitted = np.array([slip["slow_from"], slip["slow_to"]])
        start = np.interp(slip["slow_from"], slip["time"], slip["slip"])
        line = start + slip["slow_speed"] * (fitted - fitted[0])
        axes.plot((fitted - t_zero) * 1e3, line * 1e6 + 0.15, color=BLACK, linewidth=0.7)
    axes.set(xlabel="time [ms]", ylabel=r"slip at $x = 0.34\,L$ [µm]")
    axes.legend(loc="lower right")


def draw(data, fronts, slips, stem):
    t_zero = slips["stopped"]["time"][0]
    last = (np.nanmax(np.array(fronts["stopped"]["t_rupture"], dtype=float)) - t_zero) * 1e3
    fig, axes = figure(DOUBLE, 0.36 * DOUBLE, ncols=3)
    draw_maps(fig, axes[:2], data, t_zero, (0, last + 0.5))
    draw_slip(axes[2], slips, t_zero)
    for axis, text in zip(axes, "ABC"):
        letter(axis, text)
    save(fig, stem)


def write_slips(path, slips):
    rows = ([run, *row] for run, slip in slips.items() for row in zip(slip["time"], slip["slip"]))
    write_table(path, ["run", "time [s]", "slip [m]"], rows)


def main(data, results, claims):
    data, results = Path(data), Path(results)
    unmodified = report(data / f"{EVENT}-front.json")
    data = data / EVENT
    fronts = {run: report(data / f"{run}-front.json") for run in ("stopped", "no-slow-slip")}
    slips = {run: report(data / f"{run}-slip.json") for run in SLIPS}
    draw(data, fronts, slips, results / "fig3")
    write_slips(results / "slip.csv", slips)
    write_claims(
        claims,
        [
            claim_3A(unmodified, fronts["stopped"]),
            claim_3B(unmodified, fronts["no-slow-slip"]),
            claim_3C(slips),
        ],
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
