"""Figure S3, its data and its claims."""

import numpy as np

from claims.judge import judged
from claims.paper import MU_D, MU_S
from measure.tables import write_table
from measure.front_map import beyond_trigger, type_on_map
from report.plotting import BLACK, BLUE, ORANGE, SINGLE, figure, save

X_TRIGGER, TAU_BAR_TRIGGER = 0.0225, 0.3  # [m], [1]
SHOWN_SIGMA_BAR = 0.0
COLOURS = {0.2: BLACK, 0.3: BLUE}


def prescribed(x, tau_bar):
    """tau_0/p of each block."""
    in_trigger_region = np.array(x) < X_TRIGGER - 1e-9
    return MU_D + np.where(in_trigger_region, TAU_BAR_TRIGGER, tau_bar) * (MU_S - MU_D)


def ratio(stress):
    return np.array(stress["tau"]) / np.array(stress["p"])


def deviation(found, wanted):
    return float(np.abs(found / wanted - 1).max())


def deviations(tau_bar, point):
    """Largest relative deviations of one prepared interface from what was prescribed."""
    stress = point["before"]
    wanted = prescribed(stress["x"], tau_bar)
    beyond = np.array(stress["x"]) > X_TRIGGER - 1e-9
    depinned = np.where(beyond, wanted, MU_D)  # slipping junctions carry f_slip
    ratios = {name: ratio(point[name]) for name in ("before", "later", "depinned")}
    return {
        "before depinning": deviation(ratios["before"], wanted),
        "100 steps later, not depinned": deviation(ratios["later"], wanted),
        "just depinned, from mu_d in the trigger region": deviation(ratios["depinned"], depinned),
        "p from F_N/N_x": deviation(np.array(stress["p"]), stress["F_N"] / len(stress["p"])),
    }


def median_speed(front):
    """Of the stencils beyond the trigger region [m/s]; None if there are none."""
    v_c = beyond_trigger(front)
    return float(np.nanmedian(v_c)) if np.any(np.isfinite(v_c)) else None


def draw(points, stem):
    fig, axes = figure(SINGLE, 0.65 * SINGLE)
    for (tau_bar, sigma_bar), point in points.items():
        if sigma_bar == SHOWN_SIGMA_BAR:
            stress, colour = point["before"], COLOURS[tau_bar]
            x = np.array(stress["x"]) * 1e3
            look = {"markersize": 2.5, "label": rf"$\bar\tau_0 = {tau_bar:g}$"}
            axes.plot(x, ratio(stress), "o", color=colour, **look)
            axes.plot(x, prescribed(stress["x"], tau_bar), color=colour, linewidth=0.6)
    axes.plot([], [], color=BLACK, linewidth=0.6, label="prescribed")
    axes.axhline(MU_D, color=BLACK, linewidth=0.6, linestyle=":")
    place = {"xycoords": ("axes fraction", "data"), "textcoords": "offset points", "ha": "right"}
    axes.annotate(r"$\mu_d$", (1, MU_D), xytext=(-3, 2), **place)
    axes.axvspan(-2, X_TRIGGER * 1e3 - 1.25, color=ORANGE, alpha=0.2, linewidth=0)
    axes.annotate("trigger\nregion", (9, 0.185), ha="center")
    axes.set(xlabel="$x$ [mm]", ylabel=r"$\tau_0/p$", xlim=(-2, 142), ylim=(0.15, 0.26))
    axes.legend(loc="center right", bbox_to_anchor=(1, 0.4))
    save(fig, stem)


def rows(points):
    for (tau_bar, sigma_bar), point in points.items():
        x = point["before"]["x"]
        for row in zip(x, prescribed(x, tau_bar), ratio(point["before"])):
            yield [tau_bar, sigma_bar, *row]


def claim_S3(points):
    each = [deviations(tau_bar, point) for (tau_bar, _), point in points.items()]
    worst = {f"largest relative deviation, {name}": max(d[name] for d in each) for name in each[0]}
    return judged(
        "S3",
        shown={"largest relative deviation": max(worst.values())},
        measured={"prepared interfaces": len(points)} | worst,
        note="For sigma_bar = 0 and 0.2. Prescribed is tau_0/p = mu_d + tau_bar_0 (mu_s - mu_d).",
    )


def claim_types(points):
    """The type of the front over each state, and its speed."""
    measured = {}
    for (tau_bar, sigma_bar), point in points.items():
        where = f"tau_bar_0 {tau_bar:g}, sigma_bar {sigma_bar:g}"
        measured[f"type at {where}"] = type_on_map(point["front"]["type"])
        measured[f"speed at {where} [m/s]"] = median_speed(point["front"])
    return judged(
        "S3-types",
        shown=None,
        measured=measured,
        note="Types as in Figure 4 D; speeds are medians beyond the trigger region. One seed.",
    )


def make(chains, results):
    points = {(point["tau-bar"], point["sigma-bar"]): point for point in chains["profiles"]}
    draw(points, results / "figS3")
    names = ["tau_bar_0", "sigma_bar", "x [m]", "prescribed tau_0/p", "tau_0/p"]
    write_table(results / "profiles.csv", names, rows(points))
    return [claim_S3(points), claim_types(points)]
