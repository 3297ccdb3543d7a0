"""The paper's numbers of events beside ours: of the event in the picture, of the one most like the
paper's, and of all events of independent runs."""

import numpy as np
from rupture.reports import values

import paper
from claims.spread import spread
from measure.fronts import is_fast_only


def ratio(a, b):
    return None if a is None or b is None else a / b


def numbers_of(front):
    """The numbers of `analyze front`, or of an event of `analyze events`, in the paper's units;
    None where there is no slow stretch."""
    slow = front["slow"] or {}
    c_s, L = front["c_s"], front["L"]
    return {
        "duration [ms]": slow.get("duration") and slow["duration"] * 1e3,
        "from [L]": ratio(slow.get("x_from"), L),
        "to [L]": ratio(slow.get("x_to"), L),
        "fast before/c_s": ratio(slow.get("fast_before"), c_s),
        "slowest/c_s": ratio(slow.get("slowest"), c_s),
        "mean slow speed/c_s": ratio(slow.get("mean_speed"), c_s),
    }


def at_transitions(front):
    """When this front is at 0.4 L and at 0.6 L, after its first rupture [ms]."""
    ruptured, t_front = values(front["t_rupture"]), values(front["t_front"])
    x, known = np.linspace(0, 1, len(t_front)), np.isfinite(t_front)
    after = (t_front[known] - np.nanmin(ruptured)) * 1e3
    return np.interp(paper.TRANSITIONS, x[known], after)


def crossing_time(front):
    """The time of a front from 0.4 L to 0.6 L [ms]."""
    start, end = at_transitions(front)
    return float(end - start)


def numbers_and_crossing(front):
    return numbers_of(front) | {"crossing [ms]": crossing_time(front)}


def mean_of_paper(front):
    """0.2 L in 1 ms [c_s]."""
    start, end = paper.TRANSITIONS
    return (end - start) * front["L"] / paper.SLOW_FOR / front["c_s"]


def numbers_of_events(shown, fast_only, most_like, events):
    """`shown`, `fast_only`, `most_like`: fronts, the last one None if it has not been chosen;
    `events`: of independent runs. The set is that of the events that are fast-slow-fast in words:
    an event that creeps and was never fast is none of them."""
    slow = [event for event in events if event["spanning"] and event["fast_slow_fast"]]
    cases, of_shown = [*map(numbers_and_crossing, slow)], numbers_and_crossing(shown)
    of_most_like = numbers_and_crossing(most_like) if most_like else {}
    of = f"{{}} of {len(slow)} fast-slow-fast events"
    rows = {
        "speed before the slow stretch [c_s]": ("fast before/c_s", paper.FAST),
        "slowest speed [c_s]": ("slowest/c_s", paper.SLOW),
        "mean speed of the slow stretch [c_s]": ("mean slow speed/c_s", mean_of_paper(shown)),
        "begin of the slow stretch [L]": ("from [L]", paper.TRANSITIONS[0]),
        "end of the slow stretch [L]": ("to [L]", paper.TRANSITIONS[1]),
        "duration of the slow stretch [ms]": ("duration [ms]", paper.SLOW_FOR * 1e3),
        "time from 0.4 L to 0.6 L [ms]": ("crossing [ms]", paper.SLOW_FOR * 1e3),
    }
    numbers = [
        spread(
            quantity,
            of_paper,
            [case[key] for case in cases],
            of,
            shown=of_shown[key],
            most_like=of_most_like.get(key),
        )
        for quantity, (key, of_paper) in rows.items()
    ]
    return [
        *numbers,
        spread(
            "speed of events that are fast everywhere [c_s]",
            None,
            [e["speed"] / e["c_s"] for e in events if e["spanning"] and is_fast_only(e)],
            "{} events",
            shown=fast_only["speed"] / fast_only["c_s"],
        ),
    ]
