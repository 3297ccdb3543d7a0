#!/usr/bin/env python3
"""Figure 3 C, inset, its data and its claim: slow_slip.py PREPARED.csv EVENT.csv FOLDER CLAIMS.json

The measured slow slip of each run: the mean over its blocks and their extremes (analyze slow-slip).
A run counts if its front spans and slows down, and at least BLOCKS blocks could be measured.
"""

import csv
import sys
from pathlib import Path

import numpy as np

from claims.claim import write_claims
from claims.judge import judged
from data.fits import fit_through_origin
from data.tables import numbers, read_rows
from pictures.plotting import BLACK, BLUE, GREEN, SINGLE, figure, save

BLOCKS = 5
MM = 1e3  # [mm/m]
MARKERS = {"reference": "o", "t_R": "^", "tau_slip": "s", "k_i": "<"}
LABELS = {
    "reference": "reference",
    "t_R": r"$\langle t_R\rangle$ varied",
    "tau_slip": r"$\tau_\mathrm{slip}$ varied",
    "k_i": "$k_i$ varied",
}
WHERE = (
    "Blocks: prepared, those of the slow stretch but for two at its ends; event, x = 0.2-0.5 L."
    " Time: from H/c_s after the block's rupture (or after the front became slow) for <t_R>, or"
    " until the front leaves its slow stretch if that is earlier (at least <t_R>/2); speed between"
    " 20 % and 80 % of the slip in this time. R^2 against the mean of the measured values."
)


def usable(rows):
    return [row for row in rows if row["type"] == "slow" and int(row["blocks"] or 0) >= BLOCKS]


def estimate_and_measured(rows):
    return numbers(rows, "estimate [m/s]") * MM, numbers(rows, "slow slip [m/s]") * MM


def fit(rows):
    return fit_through_origin(*estimate_and_measured(rows))


def fit_followed_for_longer(rows):
    """The same where the slip is followed for up to 2 <t_R>, and for <t_R> at least."""
    y = numbers(rows, "longer, slow slip [m/s]") * MM
    known = ~np.isnan(y)
    return fit_through_origin(estimate_and_measured(rows)[0][known], y[known])


def draw_rows(axes, rows, marker, colour, label):
    x, y = estimate_and_measured(rows)
    low = y - numbers(rows, "slowest [m/s]") * MM
    high = numbers(rows, "fastest [m/s]") * MM - y
    axes.errorbar(
        x,
        y,
        yerr=[low, high],
        fmt=marker,
        color=colour,
        markersize=4,
        elinewidth=0.6,
        capsize=1.5,
        label=label,
    )


def draw(prepared, event, prepared_fit, stem):
    fig, axes = figure(SINGLE, SINGLE)
    for variant, label in LABELS.items():
        rows = [row for row in prepared if row["variant"] == variant]
        draw_rows(axes, rows, MARKERS[variant], GREEN, f"prepared, {label}")
    draw_rows(axes, event, MARKERS["t_R"], BLUE, r"event, $\langle t_R\rangle$ varied")
    end = 1.08 * max(estimate_and_measured(prepared + event)[0])
    axes.plot([0, end], [0, prepared_fit.slope * end], color=GREEN, linewidth=0.8)
    axes.plot([0, end], [0, end], color=BLACK, linestyle=":", linewidth=0.8, label="Eq. S1")
    axes.set(
        xlabel=r"estimate $4.2\,\tau_\mathrm{slip}/(k_i\langle t_R\rangle)$ [mm/s]",
        ylabel=r"measured $v_\mathrm{slow\,slip}$ [mm/s]",
        xlim=(0, end),
        ylim=(0, None),
    )
    axes.legend(loc="upper left")
    save(fig, stem)


def write_table(path, runs):
    """The measured columns of both sweeps, with what was varied."""
    names = ["interface", "variant", "blocks", "front speed [m/s]", "estimate [m/s]"]
    names += ["slow slip [m/s]", "slowest [m/s]", "fastest [m/s]", "type", "point"]
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, names, restval="", extrasaction="ignore")
        table.writeheader()
        for interface, rows in runs.items():
            table.writerows({"interface": interface} | row for row in rows)


def beside_text(rows, variant):
    """Measured over estimate in a variant that is reported beside the claim, by front speed."""
    rows = [row for row in rows if row["variant"] == variant]
    x, y = estimate_and_measured(rows)
    speeds = numbers(rows, "front speed [m/s]")
    return ", ".join(f"{r:.2f} at {v:.1f} m/s" for v, r in sorted(zip(speeds, y / x)))


def claim(prepared, event, beside):
    fitted, longer = fit(prepared), fit_followed_for_longer(prepared)
    speeds = numbers(prepared, "front speed [m/s]")
    x, y = estimate_and_measured(event)
    case = {"slope": fitted.slope, "R^2": fitted.r_squared}
    return judged(
        "3Ci",
        shown=case,
        measured={
            **case,
            "prepared interfaces": fitted.points,
            "slowest and fastest front [m/s]": [speeds.min(), speeds.max()],
            "slope if followed for up to 2 <t_R>": longer.slope,
            "event, slope": fit(event).slope if event else None,
            "event, measured/estimate": [np.min(y / x), np.max(y / x)] if event else None,
        },
        note=f"{WHERE} A change of tau_slip alone is nearly a change of units (p and k_i do not"
        " depend on it). Where k_i varies, the trigger region's prestress makes up for the driving"
        " spring, as in the paper. Measured/estimate without that:"
        f" {beside_text(beside, 'k_i alone')}; with a driving spring as much stiffer as the slider"
        f" instead: {beside_text(beside, 'k_i and K')}. At other prestresses:"
        f" {beside_text(beside, 'prestress')}.",
    )


def main(prepared_path, event_path, folder, claims_path):
    folder = Path(folder)
    prepared = usable(read_rows(prepared_path))
    event = usable(read_rows(event_path))
    varied = [row for row in prepared if row["variant"] in MARKERS]
    beside = [row for row in prepared if row["variant"] not in MARKERS]
    draw(varied, event, fit(varied), folder / "fig3C-inset")
    write_table(folder / "slow-slip-speed.csv", {"prepared": prepared, "event": event})
    write_claims(claims_path, [claim(varied, event, beside)])


if __name__ == "__main__":
    main(*sys.argv[1:])
