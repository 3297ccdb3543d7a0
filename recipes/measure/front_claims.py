"""The claims about single fronts: 2A to 2C, and those of the other laws that ask for the same.

case_of_event() and words_case() measure what the conditions in claims/claims.toml ask for, of the
event that the figures show and of each event of the ensemble alike.
"""

import numpy as np

from claims import paper
from claims.judge import judged, units_with, unmet, yes
from measure.records import values
from measure.fronts import LOADING_ZONE, front_spans

IN_ORDER = "fast, slow and fast in order of time"


def ratio(a, b):
    return None if a is None or b is None else a / b


def case_of_event(front):
    """Of claims 2B and 2C: `analyze front`, or an event of `analyze events`."""
    slow = front["slow"] or {}
    c_s, L = front["c_s"], front["L"]
    slowest, mean, before = (slow.get(name) for name in ("slowest", "mean", "fast_before"))
    duration, first, last = (slow.get(name) for name in ("duration", "x_from", "x_to"))
    length = None if first is None or last is None else last - first
    return {
        "type": front["type"],
        "spans": yes(front_spans(front)),
        "duration [ms]": duration and duration * 1e3,
        "from [L]": ratio(first, L),
        "to [L]": ratio(last, L),
        "fast before/c_s": ratio(before, c_s),
        "slowest/c_s": ratio(slowest, c_s),
        "mean slow speed/c_s": ratio(mean, c_s),
        "length/duration/c_s": ratio(length, duration * c_s if duration else None),
    }


def words_case(front):
    """Claims 2A, 3A, S6A and exponential-event."""
    return case_of_event(front) | {"fast-slow-fast in words": yes(front["fast_slow_fast"])}


def in_order_of_time(front):
    """Whether it is fast, slow and fast one after the other: most blocks before the slow stretch
    rupture before it does, and most of those behind it afterwards. It is not if the front begins
    within the slow stretch."""
    if not front["fast_slow_fast"]:
        return False
    slow, time = front["in_words"], values(front["t_rupture"])
    x = np.linspace(0, front["L"], len(time))
    before, behind = time[(x > LOADING_ZONE) & (x < slow["x_from"])], time[x > slow["x_to"]]
    return bool(np.nanmedian(before) < slow["t_from"] and np.nanmedian(behind) > slow["t_to"])


def words_and_order_case(front):
    return words_case(front) | {IN_ORDER: yes(in_order_of_time(front))}


def judged_in_words(claim_id, front, units):
    """Claims 2A, S6A and exponential-event. That the order holds in time, too, is no condition."""
    case, stretch = words_and_order_case(front), front["in_words"] or {}
    measured = {
        "below c_s/10 from [L]": ratio(stretch.get("x_from"), front["L"]),
        "to [L]": ratio(stretch.get("x_to"), front["L"]),
        "fast before [m/s]": stretch.get("fast_before"),
        IN_ORDER: case[IN_ORDER],
        "runs with such an event": units_with(lambda of: of[IN_ORDER] == "yes", units),
    }
    return judged(claim_id, measured, case, units)


def claims_of_fronts(slow_front, fast_front, units, units_in_words):
    """Claims 2A to 2C for the events of Figure 2."""
    case, slowest_of_fast = case_of_event(slow_front), slowest(fast_front)
    speeds = {
        name: case[name] for name in ("fast before/c_s", "slowest/c_s", "length/duration/c_s")
    }
    fast = {
        "slowest stencil [m/s]": slowest_of_fast,
        "c_s/slowest": fast_front["c_s"] / slowest_of_fast,
    }
    return [
        judged_in_words("2A", slow_front, units_in_words),
        judged("2B", fast, case_of_event(fast_front), units),
        judged("2C", speeds | {IN_PLACE: units_with(is_in_place, units)}, case, units),
    ]


IN_PLACE = "runs with an event also within 0.1 L of 0.4 L and 0.6 L, and a factor of 2 of 1 ms"


def is_in_place(case):
    """2C, and the slow stretch begins and ends within 0.1 L of the paper's, and lasts as long
    within a factor of 2; no condition of a claim."""
    if unmet("2C", case):
        return False
    apart = (case[end] - x for end, x in zip(("from [L]", "to [L]"), paper.TRANSITIONS))
    factor = case["duration [ms]"] / (paper.SLOW_FOR * 1e3)
    return all(abs(distance) <= 0.1 for distance in apart) and 0.5 <= factor <= 2


def slowest(front):
    """Slowest stencil beyond the loading zone where the front runs forwards [m/s]."""
    v_c = values(front["v_c"])
    return v_c[(np.array(front["x"]) > LOADING_ZONE) & (v_c > 0)].min()
