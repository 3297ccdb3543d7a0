"""The speed of slow slip behind fronts on prepared interfaces beside that of Eq. S1, as the script
of a chain:

    slope      = script slow_slip.py slope {all slow_slip where numerics.seed == seed}
    neighbours = script slow_slip.py neighbours {all slow_slip where numerics.seed == seed}
    of_event   = script slow_slip.py event {all slow_slip_event}

`slope`: of a line through the origin, in each way to measure ("under"); `event`: of event II with
other slipping times. `neighbours`: the largest ratio of the speeds of two neighbouring blocks
behind the front with the reference parameters, and behind the fronts of all variants.
"""

import slow_fronts as slow
from chains.results import read_points
from measure.conventions import PRIMARY
from measure.tables import numbers, rows_of

MM = 1e3  # [mm/m]
WIDTH = 0.14 / 56  # of a block [m]
K_I = {  # the variant in which k_i varies, by convention; primary: as the SI says
    PRIMARY: "k_i",
    "trigger's prestress unchanged": "k_i alone",
    "K scaled with E": "k_i and K",
}


def varied(rows, k_i=K_I[PRIMARY]):
    """What the claim is about, k_i varied in one way; the quantity that varies is `varies`."""
    names = {name: name for name in ("reference", "t_R", "tau_slip")} | {k_i: "k_i"}
    return [row | {"varies": names[row["variant"]]} for row in rows if row["variant"] in names]


def estimate_and_measured(rows):
    return numbers(rows, "estimate [m/s]") * MM, numbers(rows, "slow slip [m/s]") * MM


def fit(rows):
    return slow.fit_through_origin(*estimate_and_measured(rows))


def fit_of(rows):
    """Where each quantity could be varied: at two values or more, beside the reference."""
    counts = [sum(row["varies"] == name for row in rows) for name in ("t_R", "tau_slip", "k_i")]
    found = fit(rows) if min(counts) >= 2 else None
    return slow.measured(found, "slope", "r_squared", "exponent", "largest")


def largest_ratio(row):
    """The faster over the slower of two neighbours behind a front; None if there are none, or one
    does not slip forwards."""
    blocks = [round(x / WIDTH) for x in row["per_block"]["x"]]
    speed = row["per_block"]["speed"]
    pairs = zip(blocks, blocks[1:], speed, speed[1:])
    if min(speed) <= 0:
        return None
    ratios = (max(v, w) / min(v, w) for one, next_one, v, w in pairs if next_one == one + 1)
    return max(ratios, default=None)


def of_event(points):
    """Event II with other slipping times. Its front's speed is that of the slow stretch."""
    rows = [
        slow.in_window(row, result, PRIMARY)
        | {"front speed [m/s]": (result["slow_slip"]["slow"] or {}).get("speed")}
        for row, result in rows_of(points)
    ]
    return slow.usable(rows)


def slopes(points):
    rows, primary = slow.fronts(points), K_I[PRIMARY]
    found = {name: fit_of(varied(rows, k_i)) for name, k_i in K_I.items()}
    for window in slow.OTHER_WINDOWS:
        found[window] = fit_of(varied(slow.fronts(points, window), primary))
    of_SI = varied(rows, primary)
    found[slow.WITHOUT_NEAR_ARREST] = fit_of(slow.without_near_arrest(of_SI))
    speeds = slow.speeds(of_SI)
    fronts = {"fronts": len(of_SI), "speeds": [speeds.min(), speeds.max()] if of_SI else None}
    return found.pop(PRIMARY) | fronts | {"under": found}


def neighbours(points):
    rows = slow.fronts(points)
    ratios = [largest_ratio(row) for row in rows]
    ours = [ratio for row, ratio in zip(rows, ratios) if row["variant"] == "reference"]
    return {"largest": ours[0] if ours else None, "of_all": ratios}


def slope_of_event(points):
    rows = of_event(points)
    return {"slope": fit(rows).slope if rows else None}


def main(which, points):
    measured = {"slope": slopes, "neighbours": neighbours, "event": slope_of_event}[which]
    return measured(read_points(points))
