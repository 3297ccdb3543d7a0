"""Fronts with other time steps; continuum.py has finer lattices. A case is a front with all steps,
the longest first: a list, each front with its values by the headings of COLUMNS."""

import numpy as np
from rupture.figures import BLACK, DOUBLE, LINES, lettered, save
from rupture.reports import values

from claims.own_result import OwnResult, write_own
from convergence import continuum, lattice
from convergence.commands import LAMMPS, STEPS, events, lammps, prepared
from measure.front_map import IMPOSSIBLE
from measure.fronts import type_on_map
from measure.tables import write_table

SPEED = "slow speed [m/s]"
OF_FRONT = ("speed", "duration", "x_from", "x_to")
SLOW = dict(zip((SPEED, "duration [s]", "slow from [m]", "slow to [m]"), OF_FRONT))
COLUMNS = ["type", *SLOW, "arrested at [m]"]
YES = {True: "yes", False: "no"}
IMPOSSIBLE_FRONT = {"type": IMPOSSIBLE, "x_arrest": None, "slow": None}


def event_front(front):
    """The row of a front that `analyze front` reports."""
    slow = front["slow"] or {}
    kept = {"type": front["type"], "arrested at [m]": front["x_arrest"]}
    return kept | {name: slow.get(key) for name, key in SLOW.items()}


def cases_of_places():
    """{name: case}"""
    return {
        f"tau_bar_0 {tau:g}, sigma_bar {sigma:g}": [
            event_front(front) | {"type": type_on_map(front["type"])}
            for front in (one or IMPOSSIBLE_FRONT for one in of)
        ]
        for (tau, sigma), of in prepared().items()
    }


def changes_type(case):
    """Between the two finest levels."""
    return case[-2]["type"] != case[-1]["type"]


def steps_measured(cases):
    """A slow stretch may be too short for a speed."""
    types = {name: [front["type"] for front in case] for name, case in cases.items()}
    changed = [name for name, case in cases.items() if changes_type(case)]
    slow = [case for name, case in cases.items() if types[name][-2:] == ["slow", "slow"]]
    pairs = ([front[SPEED] for front in case[-2:]] for case in slow)
    changes = [abs(b / a - 1) for a, b in pairs if a and b]
    listed = "; ".join(f"{name} ({', '.join(types[name])})" for name in changed)
    measured = {
        "cases": len(cases),
        "type changes between the two finest": len(changed),
        "these are": listed or "none",
        "type is not the same at all levels": sum(len(set(kinds)) > 1 for kinds in types.values()),
        "slow at the two finest levels": len(slow),
        "of these with a slow speed at both": len(changes),
        "slow speed changes by at most [%]": max(changes) * 100 if changes else None,
    }
    return {f"time step: {name}": value for name, value in measured.items()}


def lammps_measured():
    """The largest difference over the largest displacement, with our choices and with others."""
    measured: dict[str, object] = {}
    for name, found in lammps().items():
        part = found["largest difference [m]"] / found["largest displacement [m]"]
        measured |= {
            f"{name}, after {found['steps']} steps": part,
            f"{name}: within 1e-9": YES[part <= 1e-9],
        }
    return measured or {next(iter(LAMMPS)): "not installed (package lammps)"}


def own_result(cases, edges, with_lammps):
    of_events = {
        f"{name}: {quantity}": [front[quantity] for front in case]
        for name, case in [*cases.items()][: len(events())]
        for quantity in ("type", *SLOW)
    }
    measured = of_events | steps_measured(cases) | continuum.measured(edges)
    return OwnResult(
        id="convergence",
        question="do fronts stay what they are with smaller time steps and on finer lattices, and"
        " does LAMMPS move the blocks in the same way?",
        measured=with_lammps | measured,
    )


def draw_event(axes, name, fronts):
    start = min(np.nanmin(values(front["t_rupture"])) for front in fronts)
    styles = (":", "-.", "-", "--", ":")
    for front, dt, colour, style in zip(fronts, STEPS, (*LINES[2:4], BLACK, *LINES), styles):
        time = (values(front["t_front"]) - start) * 1e3
        axes.plot(np.array(front["x"]) / front["L"], time, style, color=colour, label=f"{dt} s")
    axes.set(xlabel="$x/L$", xlim=(0, 1), ylim=(0, None))
    axes.set_title(name)


def draw(edges, stem):
    fig, panels = lettered("ABC;DEF", DOUBLE, 0.66 * DOUBLE)
    for text, (name, fronts) in zip("ABC", events().items()):
        draw_event(panels[text], name, fronts)
    panels["A"].set_ylabel("front is there after [ms]")
    panels["C"].legend(loc="lower right", handlelength=1)
    continuum.draw([panels[text] for text in "DEF"], edges)
    save(fig, stem)


def rows(cases):
    for name, case in cases.items():
        for dt, front in zip(STEPS, case):
            yield [name, dt, *map(front.get, COLUMNS), YES[changes_type(case)]]


def make(results):
    edges = continuum.by_front(lattice.edges())
    cases = {name: [*map(event_front, fronts)] for name, fronts in events().items()}
    cases |= cases_of_places()
    draw(edges, results / "convergence")
    names = ["case", "time step [s]", *COLUMNS, "type changes between the two finest"]
    write_table(results / "convergence.csv", names, rows(cases))
    write_table(results / "edges.csv", continuum.COLUMNS, continuum.rows(edges))
    write_own(results, [own_result(cases, edges, lammps_measured())])
