"""Figure S5 and its data."""

import numpy as np
from rupture.figures import BLACK, BLUE, DOUBLE, GREEN, PURPLE, VERMILION, lettered, save

from figS5.commands import strengths
from figS5.quadrature import SHAPES, mean_force, sigma_of_unit_width
from measure.tables import write_table
from paper import MU_D, MU_S

DRAWN = {0.06: BLUE, 0.12: GREEN, 0.2: VERMILION, 0.28: PURPLE}  # sigma-bar in A and B
MEAN = 0.0  # of the junction forces in A and B, as g: all carry f_slip on average
LINES = {"uniform": "-", "bell": "--"}
MARKERS = {"uniform": "o", "bell": "s"}  # of the largest values


def curve(shape, sigma_bar):
    """tau/p against the displacement of the block, in units of f_slip/k_ij."""
    a = sigma_bar / sigma_of_unit_width(shape)
    stretch = np.linspace(0, 1 + a, 400)  # of g; the last junction breaks at 1 + a
    ratio = [MU_D + (MU_S - MU_D) * mean_force(shape, a, MEAN, d) for d in stretch]
    return stretch * (MU_S - MU_D) / MU_D, np.array(ratio)


def draw_distributions(axes):
    for sigma_bar, colour in DRAWN.items():
        for shape, line in LINES.items():
            a = sigma_bar / sigma_of_unit_width(shape)
            xi = np.linspace(-1.01 * a, 1.01 * a, 801)
            f = MU_D + (MU_S - MU_D) * (MEAN + xi)
            axes.plot(f, SHAPES[shape](xi, a) / (MU_S - MU_D), line, color=colour)
        axes.plot([], [], color=colour, label=rf"$\bar\sigma = {sigma_bar:g}$")
    axes.set(xlabel="$f_T/f_N$", ylabel=r"$\varphi$", ylim=(0, None))
    axes.legend(loc="upper right", handlelength=1)


def draw_curves(axes, curves):
    for (shape, sigma_bar), (d, ratio) in curves.items():
        best = np.argmax(ratio)
        axes.plot(d, ratio, LINES[shape], color=DRAWN[sigma_bar])
        axes.plot(d[best], ratio[best], MARKERS[shape], color=DRAWN[sigma_bar])
    axes.set(xlabel=r"displacement $[f_\mathrm{slip}/k_{ij}]$", ylabel=r"$\tau/p$", xlim=(0, None))


def draw_strength(axes, strengths):
    for strength in strengths:
        line = LINES[strength.shape]
        axes.plot(strength.sigma_bar, strength.mu, line, color=BLACK)
        axes.plot([], [], line + MARKERS[strength.shape], color=BLACK, label=strength.shape)
        for sigma_bar, colour in DRAWN.items():
            n = np.argmin(np.abs(strength.sigma_bar - sigma_bar))
            axes.plot(sigma_bar, strength.mu[n], MARKERS[strength.shape], color=colour)
    axes.set(
        xlabel=r"$\bar\sigma$", ylabel=r"$\mu_s^\mathrm{eff}$", xlim=(0, 1.2), ylim=(MU_D, MU_S)
    )
    axes.legend(loc="upper right")


def draw(curves, strengths, stem):
    fig, panels = lettered("ABC", DOUBLE, 0.34 * DOUBLE)
    draw_distributions(panels["A"])
    draw_curves(panels["B"], curves)
    draw_strength(panels["C"], strengths)
    save(fig, stem)


def write_tables(results, curves, strengths):
    names = ["shape", "sigma-bar", "mu-bar", "mu_eff", "mu-bar by quadrature"]
    numbers = ((s, zip(s.sigma_bar, s.mu_bar, s.mu, s.quadrature)) for s in strengths)
    rows = ((strength.shape, *row) for strength, its_rows in numbers for row in its_rows)
    write_table(results / "strength.csv", names, rows)
    names = ["shape", "sigma-bar", "displacement [f_slip/k_ij]", "tau/p"]
    points = ((*name, *row) for name, curve in curves.items() for row in zip(*curve))
    write_table(results / "displacement.csv", names, points)


def make(results):
    curves = {(shape, sigma): curve(shape, sigma) for shape in LINES for sigma in DRAWN}
    draw(curves, strengths(), results / "figS5")
    write_tables(results, curves, strengths())
