"""The claims about single fronts: 2A-2C, and those of the other laws that ask for the same.

case_of_event() and words_case() measure what the conditions in claims/claims.toml ask for, of the
event that the figures show and of each event of the ensemble alike.
"""

import numpy as np

from claims import paper
from claims.judge import judged, units_with, unmet, yes
from data.records import values
from events.fronts import LOADING_ZONE, front_spans

IN_ORDER = "fast, slow and fast in order of time"


def ratio(a, b):
    return None if a is None or b is None else a / b


def case_of_event(front):
    """Of claims 2A, 2B, 2C, S6A and Exp: `analyze front`, or an event of `analyze events`."""
    slow = front["slow"] or {}
    c_s, L = front["c_s"], front["L"]
    speed, slowest, mean = (slow.get(name) for name in ("speed", "slowest", "mean"))
    before, after = slow.get("fast_before"), slow.get("fast_after")
    duration, first, last = (slow.get(name) for name in ("duration", "x_from", "x_to"))
    length = None if first is None or last is None else last - first
    return {
        "type": front["type"],
        "spans": yes(front_spans(front)),
        "slow speed/c_s": ratio(speed, c_s),
        "duration [ms]": duration and duration * 1e3,
        "from [L]": ratio(first, L),
        "to [L]": ratio(last, L),
        "fast/slow before": ratio(before, speed),
        "fast/slow after": ratio(after, speed),
        "fast before/c_s": ratio(before, c_s),
        "slowest/c_s": ratio(slowest, c_s),
        "mean slow speed/c_s": ratio(mean, c_s),
        "fast/slowest": ratio(before, slowest),
        "length/duration/c_s": ratio(length, duration * c_s if duration else None),
    }


def is_fast_slow_fast(front):
    """Claim 2A."""
    return not unmet("2A", case_of_event(front))


def words_case(front):
    """Claims 2Aw, S6Aw and Expw; the front is measured with conventions.IN_WORDS."""
    return case_of_event(front) | {"fast-slow-fast in words": yes(front["fast_slow_fast"])}


def in_order_of_time(front):
    """Whether it is fast, slow and fast one after the other: most blocks before the slow stretch
    rupture before it does, and most of those behind it afterwards. It is not if the front begins
    within the slow stretch."""
    if not front["fast_slow_fast"]:
        return False
    slow, time = front["slow"], values(front["t_rupture"])
    x = np.linspace(0, front["L"], len(time))
    before, behind = time[(x > LOADING_ZONE) & (x < slow["x_from"])], time[x > slow["x_to"]]
    return bool(np.nanmedian(before) < slow["t_from"] and np.nanmedian(behind) > slow["t_to"])


def words_and_order_case(front):
    return words_case(front) | {IN_ORDER: yes(in_order_of_time(front))}


def judged_in_words(claim_id, front, units):
    """Claims 2Aw, S6Aw and Expe. That the order holds in time, too, is no condition."""
    case = words_and_order_case(front)
    measured = words_shown(front) | {
        IN_ORDER: case[IN_ORDER],
        "loads with such an event": units_with(lambda of: of[IN_ORDER] == "yes", units),
    }
    return judged(claim_id, measured, case, units)


def words_shown(front):
    """The quantities of words_case(), for readers."""
    slow = front["slow"] or {}
    return {
        "fast-slow-fast in words": words_case(front)["fast-slow-fast in words"],
        "below c_s/10 from [L]": ratio(slow.get("x_from"), front["L"]),
        "to [L]": ratio(slow.get("x_to"), front["L"]),
        "fast before [m/s]": slow.get("fast_before"),
        "fast after [m/s]": slow.get("fast_after"),
    }


def claims_of_fronts(slow_front, in_words, with_ends, fast_front, units, units_in_words):
    """Claims 2A, 2Aw, 2B, 2C for the events of Figure 2; `in_words`, `with_ends`: the first one
    again, in words and with the stencils at the ends of its slow stretch."""
    slow, case = slow_front["slow"], case_of_event(slow_front)
    speeds = {
        **slow_speeds(slow),
        "c_s/slow speed": slow_front["c_s"] / slow["speed"],
        "duration [ms]": slow["duration"] * 1e3,
        "between the crossings of c_s/20 [ms]": with_ends["slow"]["duration"] * 1e3,
        "from [L]": case["from [L]"],
        "to [L]": case["to [L]"],
        "fast before [m/s]": slow["fast_before"],
        "fast after [m/s]": slow["fast_after"],
        "fast/slow before": case["fast/slow before"],
        "fast/slow after": case["fast/slow after"],
    }
    slowest_of_fast = slowest(fast_front)
    fast = {
        "slowest stencil [m/s]": slowest_of_fast,
        "c_s/slowest": fast_front["c_s"] / slowest_of_fast,
    }
    return [
        judged("2A", speeds, case, units),
        judged_in_words("2Aw", in_words, units_in_words),
        judged("2B", fast, case_of_event(fast_front), units),
        judged("2Cw", words_compared(slow_front, case, units), case, units),
        judged("2C", speeds_compared(slow_front, case), case, units),
    ]


def slow_speeds(slow):
    """The speed in a slow stretch, in three ways [m/s]."""
    return {
        "median slow speed [m/s]": slow["speed"],
        "mean slow speed [m/s]": slow["mean"],
        "slowest stencil [m/s]": slow["slowest"],
    }


IN_PLACE = "loads with an event also within 0.1 L of 0.4 L and 0.6 L, and a factor of 2 of 1 ms"


def is_in_place(case):
    """2Cw, and the slow stretch begins and ends within 0.1 L of the paper's, and lasts as long
    within a factor of 2; no condition of a claim."""
    if unmet("2Cw", case):
        return False
    apart = (case[end] - x for end, x in zip(("from [L]", "to [L]"), paper.TRANSITIONS))
    factor = case["duration [ms]"] / (paper.SLOW_FOR * 1e3)
    return all(abs(distance) <= 0.1 for distance in apart) and 0.5 <= factor <= 2


def words_compared(front, case, units):
    """Measured speeds over the paper's, the last one that of 0.2 L in 1 ms."""
    length = paper.TRANSITIONS[1] - paper.TRANSITIONS[0]
    of_paper = length * front["L"] / paper.SLOW_FOR / front["c_s"]
    return {
        "fast before over the paper's c_s/3": ratio(case["fast before/c_s"], paper.FAST),
        "slowest over the paper's c_s/100": ratio(case["slowest/c_s"], paper.SLOW),
        "length/duration over the paper's 0.2 L in 1 ms": ratio(
            case["length/duration/c_s"], of_paper
        ),
        IN_PLACE: units_with(is_in_place, units),
    }


def speeds_compared(front, case):
    """Measured speeds over the paper's: c_s/3, c_s/100 and their ratio."""
    return {
        "fast before [m/s]": front["slow"]["fast_before"],
        "over the paper's c_s/3": ratio(case["fast before/c_s"], paper.FAST),
        **slow_speeds(front["slow"]),
        "slowest over the paper's c_s/100": ratio(case["slowest/c_s"], paper.SLOW),
        "fast/slowest": case["fast/slowest"],
        "over the paper's 33": ratio(case["fast/slowest"], paper.FAST / paper.SLOW),
    }


def slowest(front):
    """Slowest stencil beyond the loading zone where the front runs forwards [m/s]."""
    v_c = values(front["v_c"])
    return v_c[(np.array(front["x"]) > LOADING_ZONE) & (v_c > 0)].min()
