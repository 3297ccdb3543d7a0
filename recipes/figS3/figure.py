"""Figure S3 and its data."""

import numpy as np
from rupture.figures import BLACK, BLUE, ORANGE, SINGLE, figure, save

from figS3.commands import X_TRIGGER, interfaces, prescribed, ratio
from measure.tables import write_table
from paper import MU_D

SHOWN_SIGMA_BAR = 0
COLOURS = {0.2: BLACK, 0.3: BLUE}


def draw(found, stem):
    fig, axes = figure(SINGLE, 0.65 * SINGLE)
    for tau_bar, colour in COLOURS.items():
        stress = found[tau_bar, SHOWN_SIGMA_BAR].before
        x = np.array(stress.x) * 1e3
        look = {"markersize": 2.5, "label": rf"$\bar\tau_0 = {tau_bar:g}$"}
        axes.plot(x, ratio(stress), "o", color=colour, **look)
        axes.plot(x, prescribed(stress.x, tau_bar), color=colour, linewidth=0.6)
    axes.plot([], [], color=BLACK, linewidth=0.6, label="prescribed")
    axes.axhline(MU_D, color=BLACK, linewidth=0.6, linestyle=":")
    place = {"xycoords": ("axes fraction", "data"), "textcoords": "offset points", "ha": "right"}
    axes.annotate(r"$\mu_d$", (1, MU_D), xytext=(-3, 2), **place)
    axes.axvspan(-2, X_TRIGGER * 1e3 - 1.25, color=ORANGE, alpha=0.2, linewidth=0)
    axes.annotate("trigger\nregion", (9, 0.185), ha="center")
    axes.set(xlabel="$x$ [mm]", ylabel=r"$\tau_0/p$", xlim=(-2, 142), ylim=(0.15, 0.26))
    axes.legend(loc="center right", bbox_to_anchor=(1, 0.4))
    save(fig, stem)


def rows(found):
    for (tau_bar, sigma_bar), of in found.items():
        for row in zip(of.before.x, prescribed(of.before.x, tau_bar), ratio(of.before)):
            yield [tau_bar, sigma_bar, *row]


def make(results):
    draw(interfaces(), results / "figS3")
    names = ["tau_bar_0", "sigma_bar", "x [m]", "prescribed tau_0/p", "tau_0/p"]
    write_table(results / "profiles.csv", names, rows(interfaces()))
