"""The claims about single fronts and about an event with its continuations: 2A-2C, 3A-3C, 4AB, 5A.

case_*() measure what the conditions in claims/claims.toml ask for, of the event that the figures
show and of each event of the ensemble alike. `data` is the folder results/data, `event` the name
of the event there.
"""

import numpy as np

from claims.judge import judged, unmet
from data.records import report, values
from events.fronts import LOADING_ZONE, middle_of_slow_stretch

SLIPS = {"t_R-half": "<t_R>/2", "stopped": "<t_R>", "t_R-double": "2<t_R>"}  # run: slipping time
IN_WORDS = 1 / 10  # of c_s: "at least 1 order of magnitude slower than the wave speeds"
STENCILS = 3  # that a slow stretch has at least, in words
HALF_STENCIL = 2  # blocks on either side of a stencil's middle


def ratio(a, b):
    return None if a is None or b is None else a / b


def yes(holds):
    return "yes" if holds else "no"


# --- one front -----------------------------------------------------------------------------


def case_of_event(front):
    """Of claims 2A, 2B, 2C, S6A and Exp: `analyze front`, or an event of `analyze events`."""
    slow = front["slow"] or {}
    c_s, L = front["c_s"], front["L"]
    speed, slowest, mean = (slow.get(name) for name in ("speed", "slowest", "mean"))
    before, after = slow.get("fast_before"), slow.get("fast_after")
    duration = slow.get("duration")
    return {
        "type": front["type"],
        "spans": yes(front["type"] in ("slow", "fast")),
        "slow speed/c_s": ratio(speed, c_s),
        "duration [ms]": duration and duration * 1e3,
        "from [L]": ratio(slow.get("x_from"), L),
        "to [L]": ratio(slow.get("x_to"), L),
        "fast/slow before": ratio(before, speed),
        "fast/slow after": ratio(after, speed),
        "fast before/c_s": ratio(before, c_s),
        "slowest/c_s": ratio(slowest, c_s),
        "mean slow speed/c_s": ratio(mean, c_s),
        "fast/slowest": ratio(before, slowest),
    }


def is_fast_slow_fast(front):
    """Claim 2A."""
    return not unmet("2A", case_of_event(front))


def front_speeds(front):
    """Position [m] and v_c [m/s] at each block, with stencils of five blocks; NaN where there is
    none. Of an event of `analyze events`, which has no v_c."""
    t = values(front["t_rupture"])
    x = np.linspace(0, front["L"], len(t))
    v = np.full(len(t), np.nan)
    h = HALF_STENCIL
    with np.errstate(divide="ignore", invalid="ignore"):
        v[h:-h] = (x[2 * h :] - x[: -2 * h]) / (t[2 * h :] - t[: -2 * h])
    v[np.isnan(t) | np.isinf(v)] = np.nan
    return x, v


def stretches(is_slow):
    """Runs of consecutive slow stencils: [(first, last)]."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], is_slow.astype(int), [0]))))
    return [(first, after - 1) for first, after in edges.reshape(-1, 2)]


def words_case(front):
    """Claims 2Aw, S6Aw and Expw: the longest stretch of stencils with v_c < c_s/10, and whether it
    makes the event fast-slow-fast in words."""
    x, v = front_speeds(front)
    limit = IN_WORDS * front["c_s"]
    beyond = x > LOADING_ZONE
    found = [
        (last - first + 1, first, last)
        for first, last in stretches(beyond & (v > 0) & (v < limit))
        if last - first + 1 >= STENCILS
    ]
    length, first, last = max(found, default=(0, None, None))
    case = {"slow stencils": length, "fast before [m/s]": None, "fast after [m/s]": None}
    if length:
        before, after = v[:first][beyond[:first]], v[last + 1 :]
        for side, speeds in (("before", before), ("after", after)):
            if np.isfinite(speeds).any():
                case[f"fast {side} [m/s]"] = float(np.nanmedian(speeds))
    fast = (case["fast before [m/s]"], case["fast after [m/s]"])
    spans = front["type"] in ("slow", "fast")
    holds = spans and None not in fast and min(fast) >= limit
    return case | {"fast-slow-fast in words": yes(holds)}


def claims_of_fronts(data, slow_front, fast_front):
    """Claims 2A, 2Aw, 2B, 2C for the events that Figure 2 shows."""
    slow, case = slow_front["slow"], case_of_event(slow_front)
    speeds = {
        "slow speed [m/s]": slow["speed"],
        "c_s/slow speed": slow_front["c_s"] / slow["speed"],
        "duration [ms]": slow["duration"] * 1e3,
        "from [L]": case["from [L]"],
        "to [L]": case["to [L]"],
        "fast before [m/s]": slow["fast_before"],
        "fast after [m/s]": slow["fast_after"],
        "fast/slow before": case["fast/slow before"],
        "fast/slow after": case["fast/slow after"],
    }
    slowest_of_fast = slowest(fast_front)
    return [
        judged("2A", speeds, case),
        judged("2Aw", words_case(slow_front), words_case(slow_front)),
        judged(
            "2B",
            {
                "slowest stencil [m/s]": slowest_of_fast,
                "c_s/slowest": fast_front["c_s"] / slowest_of_fast,
            },
            case_of_event(fast_front),
        ),
        judged("2C", speeds_compared(slow_front, case), case),
    ]


def speeds_compared(front, case):
    """Measured speeds over the paper's: c_s/3, c_s/100 and their ratio."""
    return {
        "fast before [m/s]": front["slow"]["fast_before"],
        "over the paper's c_s/3": ratio(case["fast before/c_s"], 1 / 3),
        "slowest stencil [m/s]": front["slow"].get("slowest"),
        "over the paper's c_s/100": ratio(case["slowest/c_s"], 1 / 100),
        "mean over the slow stretch [m/s]": front["slow"].get("mean"),
        "fast/slowest": case["fast/slowest"],
        "over the paper's 33": ratio(case["fast/slowest"], 100 / 3),
    }


# --- an event and its continuations --------------------------------------------------------


def case_3A(unmodified, stopped):
    slow, reference = stopped["slow"] or {}, unmodified["slow"] or {}
    return {
        "spans": yes(stopped["type"] in ("slow", "fast")),
        "slow speed/unmodified": ratio(slow.get("speed"), reference.get("speed")),
    }


def claim_3A(unmodified, stopped):
    slow, case = stopped["slow"], case_3A(unmodified, stopped)
    return judged(
        "3A",
        shown=case,
        measured={
            "front": stopped["type"],
            "slow speed [m/s]": slow and slow["speed"],
            "unmodified [m/s]": unmodified["slow"]["speed"],
            "slow speed/unmodified": case["slow speed/unmodified"],
        },
    )


def case_3B(unmodified, no_slow_slip):
    arrest, slow = no_slow_slip["x_arrest"], unmodified["slow"]
    apart = None if arrest is None or slow is None else arrest - slow["x_from"]
    return {"arrest - transition [L]": ratio(apart, no_slow_slip["L"])}


def claim_3B(unmodified, no_slow_slip):
    L = no_slow_slip["L"]
    case = case_3B(unmodified, no_slow_slip)
    return judged(
        "3B",
        shown=case,
        measured={
            "front": no_slow_slip["type"],
            "arrest [L]": ratio(no_slow_slip["x_arrest"], L),
            "transition of the unmodified event [L]": unmodified["slow"]["x_from"] / L,
            **case,
        },
    )


def case_3C(slips):
    fast = [slips[run]["fast_slip"] for run in SLIPS]
    r_squared = [slips[run]["slow_r_squared"] for run in SLIPS]
    return {
        "largest/smallest fast slip": None if None in fast else max(fast) / min(fast),
        "smallest R^2": None if None in r_squared else min(r_squared),
    }


def claim_3C(slips):
    measured = {}
    for run, t_R in SLIPS.items():
        fast_slip, slow_speed = slips[run]["fast_slip"], slips[run]["slow_speed"]
        measured[f"fast slip at {t_R} [um]"] = fast_slip and fast_slip * 1e6
        measured[f"slow slip speed at {t_R} [mm/s]"] = slow_speed and slow_speed * 1e3
        measured[f"R^2 at {t_R}"] = slips[run]["slow_r_squared"]
    case = case_3C(slips)
    return judged("3C", shown=case, measured=measured | case)


def largest_change_of_mean(before, after):
    """Of any block's mean force, relative to that mean."""
    old, new = np.array(before["mean"]), np.array(after["mean"])
    return np.max(np.abs(new - old) / np.abs(old))


def slowest(front):
    """Slowest stencil beyond the loading zone where the front runs forwards [m/s]."""
    v_c = values(front["v_c"])
    return v_c[(np.array(front["x"]) > LOADING_ZONE) & (v_c > 0)].min()


def case_4AB(unmodified, wider, phi_before, phi_after):
    return {
        "front with the wider phi": wider["type"],
        "unmodified": unmodified["type"],
        "largest relative change of a block's mean": largest_change_of_mean(phi_before, phi_after),
    }


def claim_4AB(unmodified, wider, phi_before, phi_after):
    case = case_4AB(unmodified, wider, phi_before, phi_after)
    return judged(
        "4AB",
        shown=case,
        measured=case
        | {
            "its slowest stencil [m/s]": slowest(wider),
            "slow stretch of the unmodified restart [ms]": unmodified["slow"]["duration"] * 1e3,
            "slow stretch with the wider phi [ms]": (wider["slow"] or {"duration": 0})["duration"]
            * 1e3,
        },
        note="Both start 0.5 ms before the first rupture. Widened: the blocks from 0.25 L on, which"
        " is itself the position of one.",
    )


def case_5A(unmodified, undriven):
    original, other = values(unmodified["t_rupture"]), values(undriven["t_rupture"])
    to_come = original > middle_of_slow_stretch(unmodified)
    difference = float(np.max(np.abs(other - original)[to_come]))
    share = None if np.isnan(difference) else difference / unmodified["slow"]["duration"]
    return {"difference/slow duration": share}


def claim_5A(unmodified, undriven):
    case = case_5A(unmodified, undriven)
    share, slow = case["difference/slow duration"], unmodified["slow"]
    passed = values(unmodified["t_rupture"]) <= middle_of_slow_stretch(unmodified)
    return judged(
        "5A",
        shown=case,
        measured={
            "driving stopped at [L]": np.array(unmodified["x"])[passed].max() / unmodified["L"],
            "largest difference of the rupture line [us]": share and share * slow["duration"] * 1e6,
            **case,
        },
        note="The driving stops in the middle of the slow stretch; the difference is the largest of"
        " all blocks that rupture later.",
    )


def all_claims(data, event):
    """Every claim of this file for one event."""

    def of(run, kind):
        return report(data / event / f"{run}-{kind}.json")

    unmodified = report(data / f"{event}-front.json")
    return [
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
