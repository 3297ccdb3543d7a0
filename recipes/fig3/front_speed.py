"""Figure 3 D, its data and its claim.

The simplified law has one spring per block, hence no width of phi: where the convention is another
width, it is that of the full model alone.
"""

import numpy as np

from claims import paper
from claims.judge import judged
from claims.spread import spread
from measure.tables import numbers, write_columns
from measure.conventions import PRIMARY
from report.plotting import AS_IT_IS, CHANGED, SINGLE, lettered, save
import slow_fronts as slow

NX = 57
N_S = 100
MODELS = {  # label and colour
    "simplified": ("simplified", CHANGED),
    "full": ("reference", AS_IT_IS),
}
VARIED = {  # marker and label
    "v_slow and tau_0": ("D", r"$v_\mathrm{slow}$, $\tau_0$"),
    "t_R and tau_0": ("o", r"$\langle t_R\rangle$, $\tau_0$"),
    "t_R": ("^", r"$\langle t_R\rangle$"),
    "f_slip": ("s", r"$f_\mathrm{slip}$"),
    "k_i": ("<", "$k_i$"),
    "F_N": ("v", "$F_N$"),
}


def scaled_slip(rows):
    """Slow slip times k_i l_0 / (tau_thres - tau_0) [m/s]; of tau-bar, tau_thres is 1."""
    p = numbers(rows, "slider.F_N") / NX
    k_i = N_S * np.sqrt(numbers(rows, "junctions.kappa") * p / N_S)
    mu_s, mu_d = numbers(rows, "junctions.mu_s"), numbers(rows, "junctions.mu_d")
    scale = k_i * paper.L_0 / ((1 - numbers(rows, "tau-bar")) * (mu_s - mu_d) * p)
    return scale * slip(rows)


def slip(rows):
    return numbers(rows, "slow slip [m/s]")


def fit(rows):
    return slow.fit_through_origin(scaled_slip(rows), slow.speeds(rows))


def chosen(rows, model, variants=VARIED):
    """A row is of a variant such as "full, t_R and tau_0, wide": the model, and what varies."""
    variant_of = ((row, row["variant"].split(", ")) for row in rows)
    return [row for row, (of, name, *_) in variant_of if of == model and name in variants]


def draw_points(axes, rows, x, label):
    for model, (law, colour) in MODELS.items():
        for variant, (marker, name) in VARIED.items():
            points = chosen(rows, model, [variant])
            if points:
                text = f"{law}: {name}" if label else None
                style = {"color": colour, "markerfacecolor": "none", "markeredgewidth": 0.7}
                axes.plot(
                    x(points), slow.speeds(points), marker, label=text, markersize=3.5, **style
                )


def draw(rows, fits, stem):
    fig, panels = lettered("D", 1.5 * SINGLE, 1.1 * SINGLE)
    axes = panels["D"]
    draw_points(axes, rows, scaled_slip, label=True)
    end = 1.08 * max(scaled_slip(rows))
    for model, (law, colour) in MODELS.items():
        slope = fits[model].slope
        look = {"color": colour, "linewidth": 0.8, "label": f"{law}: slope {slope:.2f}"}
        axes.plot([0, end], [0, slope * end], **look)
    axes.set_xlabel(r"$v_\mathrm{slow\,slip}\,k_i l_0/(\tau_\mathrm{thres}-\tau_0)$ [m/s]")
    axes.set(ylabel=r"$v_{c,\mathrm{slow}}$ [m/s]", xlim=(0, end), ylim=(0, None))
    by_law = sorted(zip(*axes.get_legend_handles_labels()), key=lambda of: of[1][0], reverse=True)
    look = {"columnspacing": 0.8, "handletextpad": 0.4, "handlelength": 1.2}
    axes.legend(*zip(*by_law), loc="upper left", ncols=2, **look)
    inset = axes.inset_axes([0.68, 0.13, 0.3, 0.3])
    draw_points(inset, rows, lambda points: slip(points) * 1e3, label=False)
    inset.set(xlim=(0, None), ylim=(0, None))
    inset.set_title("unscaled", fontsize=7, pad=2)
    inset.set_ylabel(r"$v_{c,\mathrm{slow}}$ [m/s]", fontsize=6.5, labelpad=1)
    inset.tick_params(labelsize=6)
    inset.set_xlabel(r"$v_\mathrm{slow\,slip}$ [mm/s]", fontsize=6.5, labelpad=1)
    save(fig, stem)


def fits_of(rows):
    return {model: fit(chosen(rows, model)) for model in ("full", "simplified")}


def case_3D(rows):
    """Without values where a model could not be fitted."""
    full, simplified = fits_of(rows).values()
    both = full and simplified
    return {
        "R^2, full": full and full.r_squared,
        "R^2, simplified": simplified and simplified.r_squared,
        "difference of the slopes": abs(full.slope / simplified.slope - 1) if both else None,
    }


def with_width(rows, widths, sigma_bar):
    """The full model's fronts at this width of phi instead; the simplified one has none."""
    others = [row for row in widths if float(row["sigma-bar"]) == sigma_bar]
    return chosen(rows, "simplified") + others


def conventions(points, widths_points):
    rows, widths = slow.fronts(points), slow.fronts(widths_points)
    cases = {PRIMARY: case_3D(rows)}
    cases |= {window: case_3D(slow.fronts(points, window)) for window in slow.OTHER_WINDOWS}
    for sigma_bar in (0, 0.2):
        cases[f"sigma-bar {sigma_bar}"] = case_3D(with_width(rows, widths, sigma_bar))
    cases[slow.WITHOUT_NEAR_ARREST] = case_3D(slow.without_near_arrest(rows))
    return {name: [case] for name, case in cases.items()}


def claim(rows, units):
    fits = fits_of(rows)
    full, simplified = fits.values()
    return judged(
        "3D",
        shown=case_3D(rows),
        units=units,
        measured={
            "slope, full": full.slope,
            "slope, simplified": simplified.slope,
            **case_3D(rows),
        },
        note=f"Fronts that span, with at least {slow.BLOCKS} measured blocks; v_slow slip (mean)"
        f" and v_c (median) belong to the same blocks, in both models. {slow.WHERE} l_0 is the"
        " paper's 7 mm, a factor common to all points: the fitted l_0 gives the same R^2 and the"
        " same difference of the slopes, so it is not a separate convention. The full model is at"
        " sigma-bar = 0.1; the simplified one has one spring per block and thus no width of phi;"
        " at sigma-bar = 0 neither has one. The scaling does not include the width.",
    )


def make(chains, results):
    points = chains["front_speed"]
    rows = slow.fronts(slow.of_seed(points))
    draw(rows, fits_of(rows), results / "fig3D")
    scaled = [row | {"scaled slow slip [m/s]": x} for row, x in zip(rows, scaled_slip(rows))]
    names = ["variant", "tau-bar", "sigma-bar", "junctions.t_R", "junctions.mu_d", "slider.E"]
    names += ["slider.F_N", "junctions.v_slow", "type", "blocks", "slow slip [m/s]"]
    names += ["scaled slow slip [m/s]", "front speed [m/s]", "point"]
    write_columns(results / "front-speed.csv", names, scaled)
    units = slow.of_seeds(conventions, points, chains["front_speed_widths"])
    full = chosen(rows, "full")
    factor = spread(
        "factor of Figure 3 D",
        None,
        slow.speeds(full) / scaled_slip(full),
        "{} prepared fronts, reference law",
        shown=fit(full).slope,
    )
    return [claim(rows, units), factor]
