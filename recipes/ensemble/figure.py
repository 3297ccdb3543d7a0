"""The events of independent runs, picture and table."""

from itertools import chain
from operator import itemgetter

import numpy as np
from rupture.figures import DOUBLE, lettered, save
from rupture.plotting import along_interface
from rupture.reports import values
from rupture.tools.command_line import plural

from claims.own_result import OwnResult, write_own
from ensemble import alternation, event_of_paper, precursors
from ensemble.commands import compute, runs, spanning
from measure.tables import write_events

NAMES = {  # of runs: title
    "load": "reference",
    "simplified": "simplified law",
    "decaying": "decaying law",
    "exponential": "exponential $t_R$",
}
SHOWN = (-1, 5)  # after the first block that is shown [ms]
FROM = 0.2  # of L; before, fronts begin in many ways


def draw_fronts(axes, events, colour):
    """Draws when each front is where, from the block at FROM on."""
    for event in events:
        t_front = values(event["t_front"])
        x = np.linspace(0, 1, len(t_front))
        beyond = (x >= FROM) & np.isfinite(t_front)
        time = (t_front[beyond] - t_front[beyond][0]) * 1e3
        axes.plot(x[beyond], time, color=colour, linewidth=0.5)
    axes.set_title(plural(len(events), "event"))


def draw(loads, stem):
    """A row per kind of event, a column per kind of load."""
    fig, panels = lettered("ABCD;EFGH;IJKL", DOUBLE, 0.8 * DOUBLE, sharex=True, sharey=True)
    of_row = iter(panels.values())
    for kind, (colour, _) in alternation.KINDS.items():
        for setting in NAMES:
            axes = next(of_row)
            pairs = chain(*loads[setting].values())
            draw_fronts(axes, [event for of, event in pairs if of == kind], colour)
    for text, title in zip("ABCD", NAMES.values()):
        panels[text].set_title(f"{title}: {panels[text].get_title()}")
    for text, kind in zip("AEI", alternation.KINDS):
        panels[text].set_ylabel(f"{kind}\nfront is there after [ms]")
    for text in "IJKL":
        along_interface(panels[text])
    panels["A"].set(xlim=(FROM, 1), ylim=SHOWN)
    save(fig, stem)


def kinds_counted(loads):
    pairs = {setting: [*chain(*of_setting.values())] for setting, of_setting in loads.items()}
    measured = {
        f"{setting}: {kind}": sum(of == kind for of, _ in found)
        for setting, found in pairs.items()
        for kind in alternation.KINDS
    }
    return OwnResult("kinds", "of which kinds are the events that span?", measured)


def make(results):
    compute()
    loads = {name: spanning(name) for name in NAMES}
    reference = [*runs("load").values()]
    draw(loads, results / "ensemble")
    alternation.draw(loads["load"], results / "alternation")
    precursors.draw(reference, results / "precursors")
    event_of_paper.make(results, reference)
    events = (
        event | {"load": load, "kind": kind}
        for load, pairs in chain(*(of.items() for of in loads.values()))
        for kind, event in pairs
    )
    columns = {name: itemgetter(name) for name in ("load", "type", "kind")}
    write_events(results / "events.csv", events, columns)
    own = [alternation.own_result(loads["load"]), precursors.own_result(reference)]
    write_own(results, [kinds_counted(loads), *own])
