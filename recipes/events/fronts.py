"""Kinds of fronts.

`front` is what `analyze front --json` prints, or one entry of `analyze events --json`.
"""

DURATION = (0.5e-3, 3e-3)  # [s]
SLOW_BELOW = 1 / 20  # of c_s (claim 2B); the default of `analyze front`
LOADING_ZONE = 0.02  # [m]; speeds within it do not count


def within(value, bounds):
    return bounds[0] <= value <= bounds[1]


def middle_of_slow_stretch(front):
    """[s]; the driving stops there for claim 5A."""
    return (front["slow"]["t_from"] + front["slow"]["t_to"]) / 2


def slows_down(front):
    """Of the kind of claim 2A: fast, slow for as long as it says, and fast again, at whatever
    positions and however much faster."""
    slow = front["slow"]
    if front["type"] != "slow" or slow["fast_before"] is None or slow["fast_after"] is None:
        return False
    fast = SLOW_BELOW * front["c_s"]
    return (
        within(slow["duration"], DURATION)
        and slow["fast_before"] >= fast
        and slow["fast_after"] >= fast
    )


def has_slow_stretch(front):
    """Spans the interface, with a slow stretch beyond the loading zone."""
    return front["type"] == "slow"


def is_fast_only(front):
    """Claim 2B: no stencil beyond the loading zone is slow."""
    return front["type"] == "fast"


def counted(events):
    """The spanning events of a seed that count: the second and the third (runs/ensemble.smk)."""
    return [event for event in events if event["spanning"]][1:3]
