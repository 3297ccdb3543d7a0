"""Does the place where the last precursor arrested decide where a front slows down? A result of our
own. x_p is the last block that ruptures in the event before one that spans, if that one did not.
What is expected was fixed on seeds 201 to 220, before the loads that it is now applied to were run.
"""

import numpy as np
from rupture.figures import BLACK, DOUBLE, FAST, SLOW, figure, save

from claims.own_result import compared

TURN = 0.715  # [L]: below, events are expected to be fast-slow-fast
OFFSET = -0.107  # of the begin from x_p [L]
EXPECTED = {
    "correlation of end and x_p": {"at_least": 0.9},
    "median of begin - x_p [L]": {"at_least": OFFSET - 0.03, "at_most": OFFSET + 0.03},
    f"share of fast-slow-fast events, x_p below {TURN} L": {"at_least": 0.8},
    f"share of fast-slow-fast events, x_p beyond {TURN} L": {"at_most": 0.2},
}


def place_of(event):
    """x_p [L] if the next event follows; None of one that spans, or may yet."""
    return event["x_last"] / event["L"] if event["spanning"] is False else None


def pairs_of(loads):
    """(x_p [L], event) of each event that spans and follows one that does not. `loads`: lists of
    all events, in time."""
    return [
        (place_of(before), event)
        for events in loads
        for before, event in zip(events, events[1:])
        if event["spanning"] and place_of(before) is not None
    ]


def stretches(pairs):
    """x_p, begin and end [L] of the fast-slow-fast events."""
    found = [
        (x_p, event["in_words"]["x_from"] / event["L"], event["in_words"]["x_to"] / event["L"])
        for x_p, event in pairs
        if event["fast_slow_fast"]
    ]
    return np.array(found).reshape(-1, 3).T


def share(events):
    """Fraction of the events that are fast-slow-fast; None without events."""
    return float(np.mean([event["fast_slow_fast"] for event in events])) if events else None


def own_result(loads):
    pairs = pairs_of(loads)
    x_p, begin, end = stretches(pairs)
    parts = ([e for x, e in pairs if x < TURN], [e for x, e in pairs if x >= TURN])
    enough = len(x_p) > 1
    numbers = (
        float(np.corrcoef(x_p, end)[0, 1]) if enough else None,
        float(np.median(begin - x_p)) if enough else None,
        *map(share, parts),
    )
    others = {
        "events that follow a precursor": len(pairs),
        "of them fast-slow-fast": len(x_p),
        "correlation of begin and x_p": float(np.corrcoef(x_p, begin)[0, 1]) if enough else None,
        "median of end - x_p [L]": float(np.median(end - x_p)) if enough else None,
    }
    question = "does a front slow down where the last precursor arrested?"
    return compared("precursors", dict(zip(EXPECTED, numbers)) | others, question, EXPECTED)


def draw(loads, stem):
    """On the left where the slow stretch begins and ends, on the right how many events have one."""
    pairs = pairs_of(loads)
    x_p, begin, end = stretches(pairs)
    fig, (left, right) = figure(DOUBLE, 0.42 * DOUBLE, ncols=2)
    left.plot(x_p, end, "^", color=FAST, markersize=4, label="end")
    left.plot(x_p, begin, "v", color=SLOW, markersize=4, label="begin")
    left.plot([0, 1], [0, 1], color=BLACK, linewidth=0.8, label="$x_p$")
    left.set(xlabel="$x_p/L$", ylabel="slow stretch [$L$]", xlim=(0.2, 0.9), ylim=(0.2, 0.9))
    left.legend()
    edges = np.arange(0.2, 0.95, 0.05)
    of_kind = [[x for x, e in pairs if e["fast_slow_fast"] is kind] for kind in (True, False)]
    names = ["fast-slow-fast", "others"]
    right.hist(of_kind, edges, stacked=True, color=[SLOW, FAST], label=names)
    right.axvline(TURN, color=BLACK, linewidth=0.8, linestyle=":", label="expected turn")
    right.set(xlabel="$x_p/L$", ylabel="events that span")
    right.legend()
    save(fig, stem)
