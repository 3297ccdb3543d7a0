"""Do events that are fast-slow-fast alternate with others? A result of our own.

From 0.64 s on, the load that the figures show alternates. What counts was written down before the
other loads were looked at: an event is slow if it is fast-slow-fast in words; a load alternates if,
from its third spanning event on, each one is of another kind than the one before it. Chance is what
shuffling the events within each load gives.
"""

import numpy as np

from claims.own_result import OwnResult
from pictures.plotting import BLUE, DOUBLE, VERMILION, figure, save

SLOW = "fast-slow-fast in words"
FROM = 2  # the third spanning event
SHUFFLES, SEED = 10_000, 1


def changes(kinds):
    """How often an event is of another kind than the one before it."""
    return int(np.sum(kinds[1:] != kinds[:-1]))


def alternates(kinds):
    later = kinds[FROM:]
    return len(later) > 1 and changes(later) == len(later) - 1


def p_of_changes(loads):
    """Share of shuffles with at least as many changes in all loads together."""
    random = np.random.default_rng(SEED)
    observed = sum(map(changes, loads))
    shuffled = (sum(changes(random.permutation(k)) for k in loads) for _ in range(SHUFFLES))
    return (1 + sum(count >= observed for count in shuffled)) / (1 + SHUFFLES)


def share_after(loads, kind):
    """Share of slow events among those that follow an event of a kind."""
    following = [b for kinds in loads for a, b in zip(kinds[:-1], kinds[1:]) if a == kind]
    return float(np.mean(following)) if following else None


def own_result(loads):
    """`loads`: {name: [(kind, event), ...]} of the spanning events of the reference slider."""
    kinds = [np.array([kind == SLOW for kind, _ in pairs]) for pairs in loads.values()]
    pairs = sum(len(k) - 1 for k in kinds)
    return OwnResult(
        id="alternation",
        question="do fast-slow-fast events alternate with others in independent loads?",
        measured={
            "loads": len(kinds),
            "loads that alternate": sum(map(alternates, kinds)),
            "pairs of successive spanning events": pairs,
            "of different kind": sum(map(changes, kinds)),
            "p of so many, or more, by chance": p_of_changes(kinds),
            "share of fast-slow-fast events": float(np.mean(np.concatenate(kinds))),
            "share after a fast-slow-fast event": share_after(kinds, True),
            "share after another event": share_after(kinds, False),
        },
    )


def draw(loads, stem):
    """One row per load, its spanning events in time."""
    fig, axes = figure(DOUBLE, 0.4 * DOUBLE)
    for row, pairs in enumerate(loads.values()):
        for is_slow, colour, marker in ((True, BLUE, "s"), (False, VERMILION, "o")):
            times = [event["t_start"] for kind, event in pairs if (kind == SLOW) == is_slow]
            axes.plot(times, [row] * len(times), marker, color=colour, markersize=4)
    for label, colour, marker in ((SLOW, BLUE, "s"), ("other", VERMILION, "o")):
        axes.plot([], [], marker, color=colour, label=label)
    axes.set_yticks(range(len(loads)), [load.removeprefix("load-") for load in loads], fontsize=6)
    axes.set(xlabel="first rupture of the event [s]", ylabel="seed of the load")
    axes.invert_yaxis()
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=2)
    save(fig, stem)
