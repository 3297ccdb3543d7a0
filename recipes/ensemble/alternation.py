"""Do events that are fast-slow-fast alternate with others? A result of our own.

From 0.64 s on, the load that the figures show alternates. An event is slow if it is fast-slow-fast
in words; a load alternates if, from FROM on, each spanning event is of another kind than the one
before it. The kind changes with the age of the interface, too. So chance is what remains if the
n-th events of all loads are shuffled among the loads. This was found on the loads with seeds 2 to
20 and fixed before those that it is now applied to were run.
"""

import numpy as np
from rupture import figures
from rupture.figures import BLACK, DOUBLE, figure, save

from claims.own_result import OwnResult
from ensemble.commands import FAST, OTHER, SLOW

KINDS = {  # of events that span: colour, marker
    SLOW: (figures.SLOW, "s"),
    FAST: (figures.FAST, "^"),
    OTHER: (BLACK, "o"),
}
FROM = 0.6  # [s]
SHUFFLES, SEED = 10_000, 1


def changes(kinds):
    """How often an event is of another kind than the one before it."""
    return int(np.sum(kinds[1:] != kinds[:-1]))


def alternates(kinds):
    return len(kinds) > 1 and changes(kinds) == len(kinds) - 1


def shuffled(loads, random):
    """The kinds of the n-th events of all loads, shuffled among the loads that have so many."""
    found = [kinds.copy() for kinds in loads]
    for n in range(max(map(len, loads))):
        having = [load for load, kinds in enumerate(loads) if len(kinds) > n]
        for load, kind in zip(having, random.permutation([loads[load][n] for load in having])):
            found[load][n] = kind
    return found


def share_of(kinds):
    return float(np.mean(kinds)) if len(kinds) else None


def share_after(loads, kind):
    """Share of slow events among those that follow an event of a kind."""
    following = [b for kinds in loads for a, b in zip(kinds[:-1], kinds[1:]) if a == kind]
    return share_of(following)


def own_result(loads):
    """`loads`: {name: [(kind, event), ...]} of the spanning events of the reference slider."""
    kinds = [
        np.array([kind == SLOW for kind, event in pairs if event["t_start"] >= FROM])
        for pairs in loads.values()
    ]
    pairs, changed = sum(max(0, len(k) - 1) for k in kinds), sum(map(changes, kinds))
    random = np.random.default_rng(SEED)
    shuffles = (shuffled(kinds, random) for _ in range(SHUFFLES))
    by_chance = np.array([(sum(map(changes, s)), sum(map(alternates, s))) for s in shuffles])
    chance, alternating = by_chance.T
    return OwnResult(
        id="alternation",
        question="do fast-slow-fast events alternate with others in independent runs?",
        measured={
            "loads": len(kinds),
            "loads that alternate": sum(map(alternates, kinds)),
            "loads that alternate by chance": float(np.mean(alternating)),
            "pairs of successive spanning events": pairs,
            "of different kind": changed,
            "of different kind by chance": float(np.mean(chance)),
            "p of so many, or more, by chance": (1 + np.sum(chance >= changed)) / (1 + SHUFFLES),
            "share of fast-slow-fast events": share_of(np.concatenate(kinds)),
            "share after a fast-slow-fast event": share_after(kinds, True),
            "share after another event": share_after(kinds, False),
        },
    )


def draw(loads, stem):
    """One row per load, its spanning events in time."""
    fig, axes = figure(DOUBLE, 0.4 * DOUBLE)
    for row, pairs in enumerate(loads.values()):
        for of_kind, (colour, marker) in KINDS.items():
            times = [event["t_start"] for kind, event in pairs if kind == of_kind]
            axes.plot(times, [row] * len(times), marker, color=colour, markersize=4)
    for kind, (colour, marker) in KINDS.items():
        axes.plot([], [], marker, color=colour, label=kind)
    axes.set_yticks(range(len(loads)), [load.removeprefix("load-") for load in loads], fontsize=6)
    axes.set(xlabel="first rupture of the event [s]", ylabel="seed of the load")
    axes.invert_yaxis()
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncols=3)
    save(fig, stem)
