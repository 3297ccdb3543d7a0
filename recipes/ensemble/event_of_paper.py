"""What is like the paper's event, when, and why the others are not: the fast-slow-fast events of
the reference runs, the first of each run apart from the later ones."""

import numpy as np
from rupture.figures import BLACK, DOUBLE, OF_PAPER, ORANGE, PURPLE, lettered, save
from rupture.errors import Failure
from rupture.reports import value

import paper
from claims.samples import Sample
from ensemble.precursors import place_of, stretches
from events import samples_of_branches
from fig3.commands import arrest
from measure.ways import PRIMARY
from measure.tables import write_table

ORDERS = {"first of its run": (PURPLE, "o"), "later": (ORANGE, ".")}
FIRST, LATER = ORDERS
TIMES = {"half": 0.5, "stopped": 1, "double": 2}  # slipping times of branches [<t_R>]
COLUMNS = ("order", "t_start [s]", "begin [L]", "end [L]", "x_p [L]")


def ordered(runs):
    """[(order, x_p or None, event)] of the fast-slow-fast events. `runs`: lists of all events."""
    found = []
    for of_run in runs:
        order, x_p = FIRST, None
        for event in of_run:
            if event["fast_slow_fast"]:
                found.append((order, x_p, event))
                order = LATER
            x_p = place_of(event)
    return found


def by_order(samples: list[Sample]):
    """[(order, what was found)]: events of a run are in order of time."""
    known = [(run, of) for run, of in samples if not isinstance(of, Failure)]
    runs = [run for run, _ in known]
    return [(LATER if run in runs[:n] else FIRST, of) for n, (run, of) in enumerate(known)]


def draw_places(axes, events):
    """Where each is slow, by the time at which it starts."""
    axes.axvspan(*paper.TRANSITIONS, color="0.9", linewidth=0, label="paper")
    for order, _, event in events:
        _, begin, end = stretches([(0, event)])[:, 0]
        colour, _ = ORDERS[order]
        axes.plot([begin, end], [event["t_start"]] * 2, color=colour, linewidth=1)
    axes.set(xlabel="below $c_s/10$ [$L$]", ylabel="event starts at [s]", xlim=(0, 1))


def draw_precursors(axes, events):
    axes.axhspan(*paper.TRANSITIONS, color="0.9", linewidth=0)
    for order, (colour, marker) in ORDERS.items():
        pairs = [(x_p, event) for of, x_p, event in events if of == order and x_p is not None]
        x_p, _, end = stretches(pairs)
        axes.plot(x_p, end, marker, color=colour, markersize=4, label=order)
    axes.plot([0.2, 0.9], [0.2, 0.9], color=BLACK, linewidth=0.8)
    axes.set(xlabel="precursor arrested at $x_p$ [$L$]", ylabel="slow until [$L$]")


def slowest(of):
    """The slowest speed [c_s] with each slipping time."""
    fronts = (getattr(of, name)[PRIMARY] for name in TIMES)
    return [value(front, "in_words.slowest") / front["c_s"] for front in fronts]


def draw_dose(axes, branches):
    """How slow an event becomes with other slipping times from its branch on."""
    for order, of in branches:
        colour, marker = ORDERS[order]
        axes.loglog(TIMES.values(), slowest(of), f"{marker}-", color=colour, linewidth=0.4)
    axes.axhline(paper.SLOW, **OF_PAPER)
    axes.set_xticks([*TIMES.values()], ["1/2", "1", "2"])
    axes.minorticks_off()
    axes.set_yticks([0.005, 0.01, 0.02], ["1/200", "1/100", "1/50"])
    axes.set(xlabel=r"slipping time [$\langle t_R \rangle$]", ylabel="slowest speed [$c_s$]")


def draw_arrests(axes, branches):
    """Where an event stops without slow slip."""
    for order, of in branches:
        colour, marker = ORDERS[order]
        begin = value(of.fronts[PRIMARY], "in_words.x_from") / of.fronts[PRIMARY]["L"]
        stop = (arrest(of, PRIMARY) or {}).get("arrest [L]", np.nan)
        axes.plot(begin, stop, marker, color=colour, markersize=4)
    axes.plot([0, 1], [0, 1], color=BLACK, linewidth=0.8)
    axes.set(xlabel="slow from [$L$]", ylabel="without slow slip, arrests at [$L$]")
    axes.set(xlim=(0.2, 0.9), ylim=(0, 1))


def rows(events):
    for order, x_p, event in events:
        _, begin, end = stretches([(0, event)])[:, 0]
        yield [order, event["t_start"], begin, end, x_p]


def make(results, runs):
    """`runs`: lists of all events."""
    events, branches = ordered(runs), by_order(samples_of_branches()[PRIMARY])
    fig, panels = lettered("AB;CD", DOUBLE, 0.62 * DOUBLE)
    draw_places(panels["A"], events)
    draw_precursors(panels["B"], events)
    draw_dose(panels["C"], branches)
    draw_arrests(panels["D"], branches)
    panels["A"].legend(loc="upper left")
    panels["B"].legend(loc="lower right")
    save(fig, results / "event-of-paper")
    write_table(results / "event-of-paper.csv", COLUMNS, rows(events))
