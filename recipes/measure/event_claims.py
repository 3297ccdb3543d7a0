"""The claims about an event and its continuations: 3A to 3C-ratios, 4AB, 5A, S2.

case_*() measure what the conditions in claims/claims.toml ask for, of the event that the figures
show and of each event of the ensemble alike.
"""

import numpy as np

from claims.judge import judged, units_with, yes
from measure.records import values
from measure.continuations import SLIPS
from measure.front_claims import ratio, words_case
from measure.fronts import is_fast_slow


def judged_event(claim_id, events, units):
    """`events`: {name: (front or slip, ...)}; the first one is the case, the others are reported
    beside it."""
    case, details, note = EVENT_CLAIMS[claim_id]
    measured = {
        f"{name}: {quantity}": value
        for name, of_event in events.items()
        for quantity, value in details(*of_event).items()
    }
    if claim_id in COUNTED:
        name, is_so = COUNTED[claim_id]
        measured[name] = units_with(is_so, units)
    shown = next(iter(events.values()))
    return judged(claim_id, measured, case(*shown), units, note)


def details_3A(stopped):
    stretch = stopped["in_words"] or {}
    return {
        "front": stopped["type"],
        "below c_s/10 from [L]": ratio(stretch.get("x_from"), stopped["L"]),
    }


def arrest_past(x, no_slow_slip):
    """How far beyond x the front without slow slip arrests [L]; None if x is, or if it does not."""
    arrest = no_slow_slip["x_arrest"]
    return ratio(None if arrest is None or x is None else arrest - x, no_slow_slip["L"])


PAST = "arrest - first stencil below c_s/10 [L]"


def case_3B(event, no_slow_slip):
    """From the first end of the first stencil in the stretch by which the unmodified event is
    fast-slow-fast."""
    return {PAST: arrest_past(event["in_words"]["x_from"], no_slow_slip)}


def details_3B(event, no_slow_slip):
    arrest = ratio(no_slow_slip["x_arrest"], no_slow_slip["L"])
    return {"arrest [L]": arrest} | case_3B(event, no_slow_slip)


COUNTED = {  # of claims: what is counted over units, without a verdict
    "3B": ("events that arrest without slow slip", lambda case: case[PAST] is not None),
}


def case_3C(slips):
    fast = [slips[run]["fast_slip"] for run in SLIPS]
    r_squared = [slips[run]["slow_r_squared"] for run in SLIPS]
    return {
        "largest/smallest fast slip": None if None in fast else max(fast) / min(fast),
        "smallest R^2": None if None in r_squared else min(r_squared),
    }


def slip_ratios(slips, peak):
    """What the paper compares with its ref. 20; `peak`: of the slip speed, at every step [m/s]."""
    slip = slips["stopped"]
    return {
        "peak/slow slip speed": ratio(peak, slip["slow_speed"]),
        "fast/slow slip distance": ratio(slip["fast_slip"], slip["slow_slip"]),
    }


def largest_change_of_mean(before, after):
    """The largest change of any block's mean force, relative to that mean."""
    old, new = np.array(before["mean"]), np.array(after["mean"])
    return np.max(np.abs(new - old) / np.abs(old))


def case_4AB(unmodified, wider, phi_before, phi_after):
    return {
        "front with the wider phi": wider["type"],
        "unmodified": unmodified["type"],
        "largest relative change of a block's mean": largest_change_of_mean(phi_before, phi_after),
    }


def details_4AB(*of_event):
    case = case_4AB(*of_event)
    del case["unmodified"]  # in the conditions
    return case


def case_S2(event, without):
    """An event with the simplified law, None if it was not found; its front without slow slip, None
    if nothing ruptures."""
    return {
        "transition with slow slip": yes(event is not None and is_fast_slow(event)),
        "transition without": yes(without is not None and without["slow"] is not None),
    }


def largest_difference(unmodified, undriven, stopped_at):
    """Of the rupture lines after the driving stops [s]; None where a block does not rupture."""
    original, other = values(unmodified["t_rupture"]), values(undriven["t_rupture"])
    difference = float(np.max(np.abs(other - original)[original > stopped_at]))
    return None if np.isnan(difference) else difference


def case_5A(event, unmodified, undriven, stopped_at):
    """`event`: in the run; `unmodified`: its front, continued alone; `stopped_at`: when the driving
    stops [s]."""
    difference = largest_difference(unmodified, undriven, stopped_at)
    return {"difference/time below c_s/10": ratio(difference, event["in_words"]["duration"])}


def details_5A(event, unmodified, undriven, stopped_at):
    passed = values(unmodified["t_rupture"]) <= stopped_at
    stopped = np.array(unmodified["x"])[passed].max() / unmodified["L"]
    return {"driving stopped at [L]": stopped} | case_5A(event, unmodified, undriven, stopped_at)


EVENT_CLAIMS: dict[str, tuple] = {  # what measures the case, what readers see of it, a note
    "3A": (words_case, details_3A, ""),
    "3B": (
        case_3B,
        details_3B,
        "From the first end of the first stencil below c_s/10 in the slow stretch of 2A.",
    ),
    "3C": (
        case_3C,
        case_3C,
        "The block of the paper's Figure 3 C lies 0.06 L before its transition.",
    ),
    "4AB": (
        case_4AB,
        details_4AB,
        "Both events start 0.5 ms before their first rupture, those of the ensemble when the front"
        " is at the branch. phi is widened in all blocks from x = 0.25 L on, including that block.",
    ),
    "5A": (
        case_5A,
        details_5A,
        "The driving stops in the middle of the slow stretch; the difference is the largest of all"
        " blocks that rupture later.",
    ),
}
