"""Kinds of fronts.

`front` is what `analyze front --json` prints, or one entry of `analyze events --json`.
"""

PRIMARY = "primary"  # the way to measure if no other is named
RAW = "raw line"  # the front is at each block that ruptures, even if alone
SLOW_BELOW = 1 / 20  # of c_s; the default of the programs
STENCIL = 5  # blocks; the default of the programs
FAST_OVER_SLOW = 10  # of a front that becomes slow
SLOW_FOR = 0.5e-3  # [s], at least
TYPES = ("arrested", "slow", "fast")  # on prepared interfaces


def middle_of(stretch):
    """The time in the middle of a stretch [s]."""
    return (stretch["t_from"] + stretch["t_to"]) / 2


def front_spans(front):
    return front["type"] in ("slow", "fast")


def is_cut(front):
    """Whether the record ends amid the event, so that its type is not known."""
    return front["type"] is None


def last_block(front, block, way):
    """The number of the last block that a front reaches which was at `block` when the record began:
    it stops at one that does not rupture. The raw line goes on to those that rupture beyond."""
    if way == RAW:
        return max(n for n, t in enumerate(front["t_rupture"]) if t is not None or n == block)
    last = block
    for times in [*zip(front["t_rupture"], front["t_before"])][block + 1 :]:
        if times == (None, None):
            break
        last += 1
    return last


def is_fast_slow(front):
    """Crosses the interface, and becomes slow after it was fast."""
    slow = front["slow"]
    if front["type"] != "slow" or slow is None or slow["fast_before"] is None:
        return False
    return (
        slow["fast_before"] >= FAST_OVER_SLOW * slow["speed"]
        and (slow["duration"] or 0) >= SLOW_FOR
    )


def is_fast_only(front):
    """No stencil beyond the loading zone is slow."""
    return front["type"] == "fast"


def type_on_map(kind):
    """The type that `analyze front` names, on prepared interfaces: a front that never left the
    trigger region is arrested there."""
    return "arrested" if kind == "none" else kind
