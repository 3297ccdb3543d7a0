"""Criteria for kinds of fronts, as the acceptances of claims 2A and 2B state them.

`front` is what `analyze front --json` prints, or one entry of `analyze events --json`.
"""

SLOW_SPEED = (1 / 200, 1 / 30)  # of c_s
DURATION = (0.5e-3, 3e-3)  # [s]
TO_SLOW = (0.25, 0.55)  # of L
TO_FAST = (0.5, 0.85)  # of L
FAST_OVER_SLOW = 10
SLOW_BELOW = 1 / 20  # of c_s (claim 2B); the default of `analyze front`
LOADING_ZONE = 0.02  # [m]; speeds within it do not count


def within(value, bounds):
    return bounds[0] <= value <= bounds[1]


def criteria_2A(front, slow_speed=SLOW_SPEED):
    """Which of the criteria of claim 2A a front with a slow stretch meets, by name; S6A asks for
    the same with another slow speed."""
    slow = front["slow"]
    fast = {side: slow[side] for side in ("fast_before", "fast_after")}
    return {
        "spans": front["type"] == "slow",
        "slow speed": within(slow["speed"] / front["c_s"], slow_speed),
        "duration": within(slow["duration"], DURATION),
        "from": within(slow["x_from"] / front["L"], TO_SLOW),
        "to": within(slow["x_to"] / front["L"], TO_FAST),
        **{
            side.replace("_", " "): v is not None and v >= FAST_OVER_SLOW * slow["speed"]
            for side, v in fast.items()
        },
    }


def is_fast_slow_fast(front):
    """Claim 2A."""
    return front["slow"] is not None and all(criteria_2A(front).values())


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
