"""Does the place where a precursor arrests decide where the next front speeds up again? A result of
ours. What is expected was fixed before any of these continuations was run."""

from itertools import pairwise

import numpy as np
from rupture.figures import BLACK, DOUBLE, FAST, SLOW, figure, save

from claims.own_result import compared, write_own
from measure.tables import write_table
from places.commands import places

SLOPE, CORRELATION = "slope of end on x_p, within states", "correlation, within states"
EXPECTED = {SLOPE: {"at_least": 0.8, "at_most": 1.2}, CORRELATION: {"at_least": 0.8}}
COLUMNS = ("x_p", "fast-slow-fast", "begin", "end")
PARTS = 5  # of the range of x_p


def deviations(found):
    """x_p and end of the fast-slow-fast events, less the means of their state [L]."""
    parts = [np.empty((0, 2))]
    for of_state in found.values():
        pairs = np.array([(one["x_p"], one["end"]) for one in of_state if one["fast-slow-fast"]])
        parts += [pairs - pairs.mean(axis=0)] if len(pairs) > 1 else []
    return np.concatenate(parts).T


def line_of(x, y):
    """Slope and correlation; None of both where x or y does not vary."""
    if not (x.any() and y.any()):
        return None, None
    return float(x @ y / (x @ x)), float(x @ y / np.sqrt((x @ x) * (y @ y)))


def spreads(found):
    """Standard deviations of x_p and of ends, within states and between their means [L]; nothing
    without two fast-slow-fast events of a state."""
    within = deviations(found)
    if not within.size:
        return {}
    slow = [[one for one in of if one["fast-slow-fast"]] for of in found.values()]
    means = [[np.mean([one[name] for one in of]) for of in slow if of] for name in ("x_p", "end")]
    return {
        f"standard deviation of {name}, {where} states [L]": float(np.sqrt(np.mean(square)))
        for where, both in (("within", within), ("between", np.array(means)))
        for name, square in zip(("x_p", "end"), (both - both.mean(axis=1, keepdims=True)) ** 2)
    }


def shares(every):
    """{range of x_p: "so many of so many are fast-slow-fast"}, in parts of equal size."""
    ordered, found = sorted(every, key=lambda one: one["x_p"]), {}
    ends = [n * len(ordered) // PARTS for n in range(PARTS + 1)]
    for part in (ordered[first:last] for first, last in pairwise(ends)):
        if part:
            between = f"from {part[0]['x_p']:.2f} to {part[-1]['x_p']:.2f} L"
            such = sum(one["fast-slow-fast"] for one in part)
            found[f"fast-slow-fast, x_p {between}"] = f"{such} of {len(part)}"
    return found


def own_result(found):
    every = [one for of in found.values() for one in of]
    x, y = deviations(found)
    numbers = dict(zip((SLOPE, CORRELATION), line_of(x, y)))
    others = {
        "states": len(found),
        "continuations": len(every),
        "fast-slow-fast within states": len(x),
    }
    question = "does a front speed up again where the precursor before it arrested, all else equal?"
    found_too = others | spreads(found) | shares(every)
    return compared("places", numbers | found_too, question, EXPECTED)


def draw(found, stem):
    """Left: end and x_p; right: both less the means of their state."""
    fig, (left, right) = figure(DOUBLE, 0.45 * DOUBLE, ncols=2)
    slow = [one for of in found.values() for one in of if one["fast-slow-fast"]]
    x_p = [one["x_p"] for one in slow]
    for name, marker, colour in (("end", "^", FAST), ("begin", "v", SLOW)):
        left.plot(x_p, [one[name] for one in slow], marker, color=colour, label=name)
    left.plot([0.2, 0.9], [0.2, 0.9], color=BLACK, linewidth=0.8, label="$x_p$")
    left.set(xlabel="$x_p/L$", ylabel="slow stretch [$L$]")
    left.legend()
    right.plot(*deviations(found), "^", color=FAST)
    right.plot([-0.2, 0.2], [-0.2, 0.2], color=BLACK, linewidth=0.8)
    right.set(xlabel="$x_p$ less its mean [$L$]", ylabel="end less its mean [$L$]")
    save(fig, stem)


def make(results):
    found = places()
    draw(found, results / "places")
    rows = [[seed, *(one[name] for name in COLUMNS)] for seed, of in found.items() for one in of]
    write_table(results / "places.csv", ["seed", *COLUMNS], rows)
    write_own(results, [own_result(found)])
