#!/usr/bin/env python3
"""Figure 3 D, its data and its claim: front_speed.py TABLE.csv PHI.csv FOLDER CLAIMS.json

Front speed and slow slip belong to the same blocks (analyze slow-slip). A run counts if its front
spans and slows down, and at least BLOCKS blocks could be measured; the same for both models.
"""

import csv
import sys
from pathlib import Path

import numpy as np

from claims.claim import write_claims
from claims.judge import judged
from data.fits import fit_through_origin
from data.tables import numbers, read_rows
from pictures.plotting import BLUE, SINGLE, VERMILION, figure, save

BLOCKS = 5
L_0 = 7e-3  # decay length of the shear force ahead of the front, the paper's value [m]
NX = 57
N_S = 100
MODELS = {"simplified": VERMILION, "full": BLUE}
MARKERS = {"v_slow and tau_0": "D", "t_R and tau_0": "o", "t_R": "^", "f_slip": "s", "k_i": "<"}
MARKERS |= {"F_N": "v"}
LABELS = {
    "v_slow and tau_0": r"$v_\mathrm{slow}$, $\tau_0$",
    "t_R and tau_0": r"$\langle t_R\rangle$, $\tau_0$",
    "t_R": r"$\langle t_R\rangle$",
    "f_slip": r"$f_\mathrm{slip}$",
    "k_i": "$k_i$",
    "F_N": "$F_N$",
}


def model_of(row):
    return row["variant"].split(", ")[0]


def varied_in(row):
    return row["variant"].split(", ")[1]


def usable(rows):
    return [row for row in rows if row["type"] == "slow" and int(row["blocks"] or 0) >= BLOCKS]


def scale(rows, strength=1.0):
    """k_i l_0 / (tau_max - tau_0), tau_max in the form of tau-bar: tau_thres is 1."""
    p = numbers(rows, "slider.F_N") / NX
    k_i = N_S * np.sqrt(numbers(rows, "junctions.kappa") * p / N_S)
    mu_s, mu_d = numbers(rows, "junctions.mu_s"), numbers(rows, "junctions.mu_d")
    return k_i * L_0 / ((strength - numbers(rows, "tau-bar")) * (mu_s - mu_d) * p)


def slip(rows):
    return numbers(rows, "slow slip [m/s]")


def front(rows):
    return numbers(rows, "front speed [m/s]")


def fit(rows):
    return fit_through_origin(scale(rows) * slip(rows), front(rows))


def fit_of_whole_t_R(rows):
    """The same from those blocks alone that could be followed for <t_R>."""
    rows = [row for row in rows if int(row["whole t_R, blocks"]) >= BLOCKS]
    x = scale(rows) * numbers(rows, "whole t_R, slow slip [m/s]")
    return fit_through_origin(x, numbers(rows, "whole t_R, front speed [m/s]"))


def chosen(rows, model, variants):
    return [row for row in rows if model_of(row) == model and varied_in(row) in variants]


def draw_points(axes, rows, x, label):
    for model, colour in MODELS.items():
        for variant, marker in MARKERS.items():
            points = chosen(rows, model, [variant])
            if points:
                text = f"{model}: {LABELS[variant]}" if label else None
                style = {"color": colour, "markerfacecolor": "none", "markeredgewidth": 0.7}
                axes.plot(x(points), front(points), marker, label=text, markersize=3.5, **style)


def draw(rows, fits, stem):
    fig, axes = figure(1.5 * SINGLE, 1.1 * SINGLE)
    draw_points(axes, rows, lambda points: scale(points) * slip(points), label=True)
    end = 1.08 * max(scale(rows) * slip(rows))
    for model, colour in MODELS.items():
        axes.plot([0, end], [0, fits[model].slope * end], color=colour, linewidth=0.8)
    axes.set(
        xlabel=r"$v_\mathrm{slow\,slip}\,k_i l_0/(\tau_\mathrm{thres}-\tau_0)$ [m/s]",
        ylabel=r"$v_{c,\mathrm{slow}}$ [m/s]",
        xlim=(0, end),
        ylim=(0, None),
    )
    axes.legend(loc="upper left", ncols=2, columnspacing=0.8, handletextpad=0.1)
    inset = axes.inset_axes([0.68, 0.13, 0.3, 0.3])
    draw_points(inset, rows, lambda points: slip(points) * 1e3, label=False)
    inset.set(xlim=(0, None), ylim=(0, None))
    inset.set_title("unscaled", fontsize=7, pad=2)
    inset.set_ylabel(r"$v_{c,\mathrm{slow}}$ [m/s]", fontsize=6.5, labelpad=1)
    inset.tick_params(labelsize=6)
    inset.set_xlabel(r"$v_\mathrm{slow\,slip}$ [mm/s]", fontsize=6.5, labelpad=1)
    save(fig, stem)


def write_table(path, rows):
    names = ["variant", "tau-bar", "sigma-bar", "junctions.t_R", "junctions.mu_d", "slider.E"]
    names += ["slider.F_N", "junctions.v_slow", "type", "blocks", "slow slip [m/s]"]
    names += ["scaled slow slip [m/s]", "front speed [m/s]", "point"]
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.DictWriter(file, names, extrasaction="ignore")
        table.writeheader()
        for row, scaled in zip(rows, scale(rows) * slip(rows)):
            table.writerow(row | {"scaled slow slip [m/s]": scaled})


def fit_with_other_widths(rows, phi):
    """The full model's fit if the points at other widths of phi count, too."""
    parts = [chosen(rows, "full", MARKERS), [row for row in phi if float(row["sigma-bar"]) != 0.1]]
    x = np.concatenate([scale(part) * slip(part) for part in parts])
    return fit_through_origin(x, np.concatenate([front(part) for part in parts]))


def threshold(rows):
    return np.ones(len(rows))


def strength_of_phi(rows):
    return numbers(rows, "strength")


def ratios(rows, strength):
    """Front speed over scaled slow slip at each width of phi, as text."""
    texts = []
    for width in sorted({row["sigma-bar"] for row in rows}):
        points = [row for row in rows if row["sigma-bar"] == width]
        ratio = np.mean(front(points) / (scale(points, strength(points)) * slip(points)))
        texts.append(f"{ratio:.2f} at sigma-bar {width}")
    return ", ".join(texts)


def claim(rows, fits, phi):
    full, simplified = fits["full"], fits["simplified"]
    difference = abs(full.slope / simplified.slope - 1)
    whole = {model: fit_of_whole_t_R(chosen(rows, model, MARKERS)) for model in MODELS}
    case = {
        "R^2, full": full.r_squared,
        "R^2, simplified": simplified.r_squared,
        "difference of the slopes": difference,
    }
    return judged(
        "3D",
        shown=case,
        measured={
            "slope, full": full.slope,
            "slope, simplified": simplified.slope,
            **case,
            "points": [full.points, simplified.points],
            "R^2, both on one line": fit(rows).r_squared,
            "R^2, both, unscaled": fit_through_origin(slip(rows), front(rows)).r_squared,
            "R^2, full, with other widths of phi too": fit_with_other_widths(rows, phi).r_squared,
            "slopes from blocks followed for <t_R>": [whole[m].slope for m in fits],
            "their R^2": [whole[m].r_squared for m in fits],
        },
        note=f"Fronts that span, with at least {BLOCKS} measured blocks; v_slow slip (mean) and v_c"
        " (median) belong to the same blocks and are measured as for 3Ci, in both models. R^2"
        " against the mean of v_c. l_0 = 7 mm; full model at sigma-bar = 0.1, for the scaling knows"
        f" no width of phi: v_c over the scaled slow slip is {ratios(phi, threshold)}. So the two"
        " models' factors would differ if both had sigma-bar = 0; with the strength that phi leaves"
        f" in place of tau_thres the full model's is {ratios(phi, strength_of_phi)}.",
    )


def main(table, phi_table, folder, claims_path):
    folder = Path(folder)
    rows, phi = usable(read_rows(table)), usable(read_rows(phi_table))
    fits = {model: fit(chosen(rows, model, MARKERS)) for model in ("full", "simplified")}
    draw(rows, fits, folder / "fig3D")
    write_table(folder / "front-speed.csv", rows)
    write_claims(claims_path, [claim(rows, fits, phi)])


if __name__ == "__main__":
    main(*sys.argv[1:])
