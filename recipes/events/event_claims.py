"""The claims about one fast-slow-fast event and its continuations: 2A, 3A, 3B, 3C, 4AB and 5A.

The same functions judge the event that the figures show and each event of the ensemble. `data` is
the folder results/data, `event` the name of the event there.
"""

import numpy as np

from claims.claim import Claim, verdict
from data.records import report, values
from events.fronts import LOADING_ZONE, is_fast_slow_fast, middle_of_slow_stretch

SLIPS = {"t_R-half": "<t_R>/2", "stopped": "<t_R>", "t_R-double": "2<t_R>"}  # run: slipping time
ROUNDING = 1e-12


def ratio_with_straddling_stencils(front):
    """Fast over slow speed before the slow stretch if the stencils that straddle the transition
    count, too (docs/decisions/0001-fast-speed.md)."""
    slow, x, v_c = front["slow"], np.array(front["x"]), values(front["v_c"])
    before = (x > LOADING_ZONE) & (x < slow["x_from"]) & ~np.isnan(v_c)
    return np.median(v_c[before]) / slow["speed"]


def claim_2A(front):
    slow = front["slow"]
    return Claim(
        id="2A",
        paper="fast (c_s/3), slow (c_s/100) for 1 ms from 0.4 L to 0.6 L, fast again",
        measured={
            "slow speed [m/s]": slow["speed"],
            "c_s/slow speed": front["c_s"] / slow["speed"],
            "duration [ms]": slow["duration"] * 1e3,
            "from [L]": slow["x_from"] / front["L"],
            "to [L]": slow["x_to"] / front["L"],
            "fast before [m/s]": slow["fast_before"],
            "fast after [m/s]": slow["fast_after"],
            "fast/slow before": slow["fast_before"] / slow["speed"],
            "the same with stencils across the transition": ratio_with_straddling_stencils(front),
        },
        acceptance="slow in [c_s/200, c_s/30] for 0.5-3 ms, transitions in [0.25, 0.55] L and"
        " [0.5, 0.85] L, fast >= 10 x slow on both sides",
        verdict=verdict(is_fast_slow_fast(front)),
    )


def claim_3A(unmodified, stopped):
    spans = stopped["type"] in ("slow", "fast")
    slow, reference = stopped["slow"], unmodified["slow"]
    ratio = slow and slow["speed"] / reference["speed"]
    return Claim(
        id="3A",
        paper="with V = 0 the front still slows down and spans the interface",
        measured={
            "front": stopped["type"],
            "slow speed [m/s]": slow and slow["speed"],
            "unmodified [m/s]": reference["speed"],
            "slow speed/unmodified": ratio,
        },
        acceptance="spans; slow speed within 25 % of the unmodified event's",
        verdict=verdict(spans and ratio is not None and abs(ratio - 1) <= 0.25),
    )


def claim_3B(unmodified, no_slow_slip):
    L = no_slow_slip["L"]
    arrest, transition = no_slow_slip["x_arrest"], unmodified["slow"]["x_from"]
    distance = None if arrest is None else (arrest - transition) / L
    return Claim(
        id="3B",
        paper="without slow slip the front arrests where it used to become slow",
        measured={
            "front": no_slow_slip["type"],
            "arrest [L]": arrest and arrest / L,
            "transition of the unmodified event [L]": transition / L,
            "arrest - transition [L]": distance,
        },
        acceptance="arrest within 0.1 L of the unmodified event's fast-to-slow transition",
        verdict=verdict(distance is not None and abs(distance) <= 0.1),
    )


def claim_3C(slips):
    fast = [slips[run]["fast_slip"] for run in SLIPS]
    r_squared = [slips[run]["slow_r_squared"] for run in SLIPS]
    measured = {}
    for run, t_R in SLIPS.items():
        fast_slip, slow_speed = slips[run]["fast_slip"], slips[run]["slow_speed"]
        measured[f"fast slip at {t_R} [um]"] = fast_slip and fast_slip * 1e6
        measured[f"slow slip speed at {t_R} [mm/s]"] = slow_speed and slow_speed * 1e3
        measured[f"R^2 at {t_R}"] = slips[run]["slow_r_squared"]
    spread = None if None in fast else max(fast) / min(fast)
    accepted = None
    if spread is not None and None not in r_squared:
        accepted = spread <= 1.1 and min(r_squared) >= 0.95
    return Claim(
        id="3C",
        paper="fast slip independent of <t_R>, then arrest, then nearly linear slow slip",
        measured=measured | {"largest/smallest fast slip": spread},
        acceptance="fast slip equal within 10 % for <t_R> x {0.5, 1, 2}; slow part linear,"
        " R^2 >= 0.95",
        verdict=verdict(accepted),
    )


def largest_change_of_mean(before, after):
    """Of any block's mean force, relative to that mean."""
    old, new = np.array(before["mean"]), np.array(after["mean"])
    return np.max(np.abs(new - old) / np.abs(old))


def slowest(front):
    """Slowest stencil beyond the loading zone where the front runs forwards [m/s]."""
    v_c = values(front["v_c"])
    return v_c[(np.array(front["x"]) > LOADING_ZONE) & (v_c > 0)].min()


def claim_4AB(unmodified, wider, phi_before, phi_after):
    change = largest_change_of_mean(phi_before, phi_after)
    accepted = wider["type"] == "fast" and unmodified["slow"] is not None and change <= ROUNDING
    return Claim(
        id="4AB",
        paper="with a wider phi beyond 0.25 L the fast-slow-fast event becomes fast-only",
        measured={
            "front with the wider phi": wider["type"],
            "its slowest stencil [m/s]": slowest(wider),
            "slow stretch of the unmodified restart [ms]": unmodified["slow"]["duration"] * 1e3,
            "slow stretch with the wider phi [ms]": (wider["slow"] or {"duration": 0})["duration"]
            * 1e3,
            "largest relative change of a block's mean": change,
        },
        acceptance="no slow stretch; the unmodified restart keeps it; block means unchanged"
        " to 1e-12",
        verdict=verdict(accepted),
        note="Both start 0.5 ms before the first rupture. Widened: the blocks from 0.25 L on, which"
        " is itself the position of one.",
    )


def claim_5A(unmodified, undriven):
    original, other = values(unmodified["t_rupture"]), values(undriven["t_rupture"])
    to_come = original > middle_of_slow_stretch(unmodified)
    difference = np.max(np.abs(other - original)[to_come])
    share = None if np.isnan(difference) else difference / unmodified["slow"]["duration"]
    return Claim(
        id="5A",
        paper="driving stopped during the slow front: it propagates exactly like the original",
        measured={
            "driving stopped at [L]": np.array(unmodified["x"])[~to_come].max() / unmodified["L"],
            "largest difference of the rupture line [us]": share and difference * 1e6,
            "difference/slow duration": share,
        },
        acceptance="rupture-line difference <= 5 % of the slow duration",
        verdict=verdict(share is not None and share <= 0.05),
        note="The driving stops in the middle of the slow stretch; the difference is the largest of"
        " all blocks that rupture later.",
    )


def all_claims(data, event):
    """Every claim of this file for one event."""

    def of(run, kind):
        return report(data / event / f"{run}-{kind}.json")

    unmodified = report(data / f"{event}-front.json")
    return [
        claim_2A(unmodified),
        claim_3A(unmodified, of("stopped", "front")),
        claim_3B(unmodified, of("no-slow-slip", "front")),
        claim_3C({run: of(run, "slip") for run in SLIPS}),
        claim_4AB(
            unmodified,
            of("wider", "front"),
            report(data / f"{event}-phi.json"),
            of("wider-start", "phi"),
        ),
        claim_5A(unmodified, of("undriven", "front")),
    ]
