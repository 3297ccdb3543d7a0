"""How far prepared interfaces are from what was prescribed, as the script of a chain:

    deviation = script prestress.py {all profiles}

Reports the largest relative deviations: before depinning, 100 steps later without depinning, just
depinned, and of p from F_N/N_x; and how much friction depinning takes from the trigger region.
Prescribed is tau_0/p = mu_d + tau_bar_0 (mu_s - mu_d).
"""

import numpy as np

from chains.results import read_points
from claims.paper import MU_D, MU_S

X_TRIGGER, TAU_BAR_TRIGGER = 0.0225, 0.3  # [m], [1]


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
        "before": deviation(ratios["before"], wanted),
        "later": deviation(ratios["later"], wanted),
        "depinned": deviation(ratios["depinned"], depinned),
        "p": deviation(np.array(stress["p"]), stress["F_N"] / len(stress["p"])),
    }


def force_drop(point):
    """The friction that depinning takes from the trigger region [N]."""
    inside = np.array(point["before"]["x"]) < X_TRIGGER - 1e-9
    before, after = (np.array(point[when]["tau"])[inside].sum() for when in ("before", "depinned"))
    return float(before - after)


def main(points):
    points = read_points(points)
    each = [deviations(point["tau-bar"], point) for point in points]
    drops = [force_drop(point) for point in points]
    return {name: max(of[name] for of in each) for name in each[0]} | {
        "interfaces": len(each),
        "force_drop": drops[0],
        "force_drops_differ": max(drops) / min(drops) - 1,
    }
