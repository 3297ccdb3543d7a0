"""The claims about an event and its continuations: 3A-3Cv, 4AB, 5A, S2.

case_*() measure what the conditions in claims/claims.toml ask for, of the event that the figures
show and of each event of the ensemble alike.
"""

import numpy as np

from claims import paper
from claims.judge import holds, judged, units_with, yes
from data.records import values
from events.front_claims import ratio, slowest, words_case, words_shown
from events.fronts import LOADING_ZONE, front_spans, is_fast_slow, takes_time
from maps.front_map import STENCIL

SLIPS = {"t_R-half": "<t_R>/2", "stopped": "<t_R>", "t_R-double": "2<t_R>"}  # run: slipping time


def judged_event(claim_id, events, units):
    """`events`: {name: (front or slip, ...)}; the first one is judged as the one that is shown, the
    others are reported beside it."""
    case, details, note = EVENT_CLAIMS[claim_id]
    (name, first), *others = events.items()
    measured = {"event": name} | details(*first)
    for other, fronts in others:
        beside = details(*fronts) | {"holds": yes(holds(claim_id, [case(*fronts)]))}
        measured |= {f"{other}: {key}": value for key, value in beside.items()}
    counted = COUNTED.get(claim_id, {}).items()
    measured |= {name: units_with(is_so, units) for name, is_so in counted}
    return judged(claim_id, measured, case(*first), units, note)


def case_3A(unmodified, stopped):
    slow, reference = stopped["slow"] or {}, unmodified["slow"] or {}
    return {
        "spans": yes(front_spans(stopped)),
        "slow speed/unmodified": ratio(slow.get("speed"), reference.get("speed")),
    }


def details_3A(unmodified, stopped):
    slow = stopped["slow"]
    return {
        "front": stopped["type"],
        "slow speed [m/s]": slow and slow["speed"],
        "unmodified [m/s]": unmodified["slow"]["speed"],
        "slow speed/unmodified": case_3A(unmodified, stopped)["slow speed/unmodified"],
    }


def arrest_past(x, no_slow_slip):
    """How far beyond x the front without slow slip arrests [L]; None if x is, or if it does not."""
    arrest = no_slow_slip["x_arrest"]
    return ratio(None if arrest is None or x is None else arrest - x, no_slow_slip["L"])


def case_3B(unmodified, no_slow_slip):
    """The transition is where the unmodified front becomes slow."""
    transition = (unmodified["slow"] or {}).get("x_from")
    return {"arrest - transition [L]": arrest_past(transition, no_slow_slip)}


FIRST, CENTRE, ANYWHERE = (
    f"arrest - {place} [L]"
    for place in (
        "first stencil below c_s/10",
        "the centre of that stencil",
        "first stencil below c_s/10 anywhere",
    )
)


def case_3Bw(unmodified, in_words, no_slow_slip):
    """From the first end of the first stencil in the slow stretch of `in_words`, the unmodified
    front measured so; and from two other places that readers may mean."""
    x, v_c = values(unmodified["x"]), values(unmodified["v_c"])
    start = in_words["slow"] and in_words["slow"]["x_from"]
    centre = start and round(start + STENCIL // 2 * (x[1] - x[0]), 9)
    slow = x[(x > LOADING_ZONE) & (v_c > 0) & (v_c < unmodified["c_s"] / 10)]
    places = {FIRST: start, CENTRE: centre, ANYWHERE: slow[0] if len(slow) else None}
    return {name: arrest_past(place, no_slow_slip) for name, place in places.items()}


def is_near(name):
    """Whether 3Bw would hold from another place."""
    return lambda case: holds("3Bw", [{FIRST: case[name]}])


COUNTED = {  # of claims: what is counted over units, without a verdict
    "3Bw": {
        "events that arrest without slow slip": lambda case: case[FIRST] is not None,
        "within 0.1 L of the centre of that stencil": is_near(CENTRE),
        "within 0.1 L of the first stencil below c_s/10 anywhere": is_near(ANYWHERE),
    }
}


def details_3B(unmodified, no_slow_slip):
    L = no_slow_slip["L"]
    return {
        "front": no_slow_slip["type"],
        "arrest [L]": ratio(no_slow_slip["x_arrest"], L),
        "transition of the unmodified event [L]": unmodified["slow"]["x_from"] / L,
        **case_3B(unmodified, no_slow_slip),
    }


def case_3C(slips):
    fast = [slips[run]["fast_slip"] for run in SLIPS]
    r_squared = [slips[run]["slow_r_squared"] for run in SLIPS]
    return {
        "largest/smallest fast slip": None if None in fast else max(fast) / min(fast),
        "smallest R^2": None if None in r_squared else min(r_squared),
    }


def details_3C(slips):
    measured = {}
    for run, t_R in SLIPS.items():
        fast_slip, slow_speed = slips[run]["fast_slip"], slips[run]["slow_speed"]
        measured[f"fast slip at {t_R} [um]"] = fast_slip and fast_slip * 1e6
        measured[f"slow slip speed at {t_R} [mm/s]"] = slow_speed and slow_speed * 1e3
        measured[f"R^2 at {t_R}"] = slips[run]["slow_r_squared"]
    return measured | case_3C(slips)


def case_3Cv(slips):
    peak = slips["stopped"]["peak_speed"]
    return {"peak slip speed [mm/s]": peak and peak * 1e3}


def details_3Cv(slips):
    slip = slips["stopped"]
    fast, slow, slow_speed = (slip[name] for name in ("fast_slip", "slow_slip", "slow_speed"))
    return {
        **case_3Cv(slips),
        "slow slip speed [mm/s]": slow_speed and slow_speed * 1e3,
        "peak/slow speed": ratio(slip["peak_speed"], slow_speed),
        "fast slip [um]": fast and fast * 1e6,
        "slow slip [um]": slow and slow * 1e6,
        "fast/slow slip distance": ratio(fast, slow),
        "peak speed over the paper's": ratio(slip["peak_speed"], paper.FAST_SLIP_SPEED),
    }


def ratios_3Cr(slips, peak):
    """What the paper compares with its ref. 20; `peak`: of the slip speed, at every step [m/s]."""
    slip = slips["stopped"]
    return {
        "peak slip speed at every step [mm/s]": peak * 1e3,
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


def details_4AB(unmodified, wider, phi_before, phi_after):
    return case_4AB(unmodified, wider, phi_before, phi_after) | {
        "its slowest stencil [m/s]": slowest(wider),
    }


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


def case_5A(unmodified, undriven, stopped_at):
    """`stopped_at`: when the driving stops [s]."""
    if not takes_time(unmodified):
        return {"difference/slow duration": None}
    difference = largest_difference(unmodified, undriven, stopped_at)
    return {"difference/slow duration": ratio(difference, unmodified["slow"]["duration"])}


def case_5Aw(in_words, unmodified, undriven, stopped_at):
    """As 5A; `in_words`: the unmodified front, measured so."""
    difference = largest_difference(unmodified, undriven, stopped_at)
    slow_for = in_words["slow"] and in_words["slow"]["duration"]
    return {"difference/time below c_s/10": ratio(difference, slow_for)}


def details_5A(unmodified, undriven, stopped_at):
    case, slow = case_5A(unmodified, undriven, stopped_at), unmodified["slow"]
    share = case["difference/slow duration"]
    passed = values(unmodified["t_rupture"]) <= stopped_at
    return {
        "driving stopped at [L]": np.array(unmodified["x"])[passed].max() / unmodified["L"],
        "largest difference of the rupture line [us]": share and share * slow["duration"] * 1e6,
        **case,
    }


EVENT_CLAIMS: dict[str, tuple] = {  # what measures the case, what readers see of it, a note
    "3Aw": (words_case, words_shown, ""),
    "3Bw": (
        case_3Bw,
        case_3Bw,
        "From the first end of the first stencil below c_s/10 in the stretch of 2Aw.",
    ),
    "3Cw": (
        case_3C,
        details_3C,
        "The block of the paper's Figure 3 C lies 0.06 L before its transition.",
    ),
    "5Aw": (case_5Aw, case_5Aw, ""),
    "3A": (case_3A, details_3A, ""),
    "3B": (case_3B, details_3B, ""),
    "3C": (case_3C, details_3C, ""),
    "3Cv": (case_3Cv, details_3Cv, ""),
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
