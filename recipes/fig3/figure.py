#!/usr/bin/env python3
"""Figure 3 A-C, its data and its claims: figure.py results/data results/fig3"""

import csv
import sys
from pathlib import Path

import numpy as np

from common.claims import Claim, verdict, write_claims
from common.panels import draw_pinned, draw_pinned_scale
from common.plotting import BLACK, BLUE, DOUBLE, GREEN, VERMILION, figure, letter, save
from common.records import Pinned, report

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


def write_table(path, slips):
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["run", "time [s]", "slip [m]"])
        for run, slip in slips.items():
            for row in zip(slip["time"], slip["slip"]):
                table.writerow([run, *row])


def claim_3A(unmodified, front):
    spans = front["type"] != "arrested"
    slow, reference = front["slow"], unmodified["slow"]
    accepted = spans and slow is not None and abs(slow["speed"] / reference["speed"] - 1) <= 0.25
    return Claim(
        id="3A",
        paper="with V = 0 the front still slows down and spans the interface",
        measured={
            "front": front["type"],
            "slow speed [m/s]": slow and slow["speed"],
            "unmodified [m/s]": reference["speed"],
        },
        acceptance="spans; slow speed within 25 % of the unmodified event's",
        verdict=verdict(accepted),
    )


def claim_3B(unmodified, front):
    L = front["L"]
    arrest, transition = front["x_arrest"], unmodified["slow"]["x_from"]
    accepted = arrest is not None and abs(arrest - transition) <= 0.1 * L
    return Claim(
        id="3B",
        paper="without slow slip the front arrests where it used to become slow",
        measured={
            "front": front["type"],
            "arrest [L]": arrest and arrest / L,
            "transition of the unmodified event [L]": transition / L,
        },
        acceptance="arrest within 0.1 L of the unmodified event's fast-to-slow transition",
        verdict=verdict(accepted),
    )


def claim_3C(slips):
    fast = [slips[run]["fast_slip"] for run in SLIPS]
    r_squared = [slips[run]["slow_r_squared"] for run in SLIPS]
    accepted = None
    if None not in fast + r_squared:
        accepted = max(fast) / min(fast) <= 1.1 and min(r_squared) >= 0.95
    return Claim(
        id="3C",
        paper="fast slip independent of <t_R>, then arrest, then nearly linear slow slip",
        measured={
            "fast slip at <t_R>/2, <t_R>, 2<t_R> [um]": [f and f * 1e6 for f in fast],
            "slow slip speed [mm/s]": [s and s * 1e3 for s in (slips[r]["slow_speed"] for r in SLIPS)],
            "R^2": r_squared,
        },
        acceptance="fast slip equal within 10 % for <t_R> x {0.5, 1, 2}; slow part linear, R^2 >= 0.95",
        verdict=verdict(accepted),
    )


def main(data, results):
    data, results = Path(data), Path(results)
    unmodified = report(data / "fast-slow-fast-front.json")
    data = data / "fig3"
    fronts = {run: report(data / f"{run}-front.json") for run in ("stopped", "no-slow-slip")}
    slips = {run: report(data / f"{run}-slip.json") for run in SLIPS}
    draw(data, fronts, slips, results / "fig3")
    write_table(results / "slip.csv", slips)
    write_claims(
        results / "claims.json",
        [
            claim_3A(unmodified, fronts["stopped"]),
            claim_3B(unmodified, fronts["no-slow-slip"]),
            claim_3C(slips),
        ],
    )


if __name__ == "__main__":
    main(*sys.argv[1:])
