"""Fronts with smaller time steps; continuum.py has finer lattices. A case is a front with all
steps, the reference one first: a list, each front with its values by the headings of COLUMNS."""

import numpy as np

import continuum
from claims.own_result import OwnResult, write_own
from measure.tables import rows_of, values, write_table
from measure.front_map import IMPOSSIBLE, place_of, type_on_map
from rupture.figures import BLACK, DOUBLE, LINES, lettered, save

EVENTS = {"I": "fast-slow-fast", "II": "second-slow", "III": "fast-only"}
STEPS = ["2e-7", "1e-7", "5e-8"]  # [s]
SPEED = "slow speed [m/s]"
OF_FRONT = ("speed", "duration", "x_from", "x_to")
SLOW = dict(zip((SPEED, "duration [s]", "slow from [m]", "slow to [m]"), OF_FRONT))
COLUMNS = ["type", *SLOW, "arrested at [m]"]
LAMMPS = ("LAMMPS", "LAMMPS, edge springs half and damping along spring")  # lammps.ini
YES = {True: "yes", False: "no"}
IMPOSSIBLE_FRONT = {"type": IMPOSSIBLE, "x_arrest": None, "slow": None}


def event_front(front):
    """As `analyze front` reports it."""
    slow = front["slow"] or {}
    kept = {"type": front["type"], "arrested at [m]": front["x_arrest"]}
    return kept | {name: slow.get(key) for name, key in SLOW.items()}


def read_events(points):
    """{event's number: its fronts, as `analyze front` reports them, per time step}"""
    return {
        number: [point["front"] for point in points if point["name"] == event]
        for number, event in EVENTS.items()
    }


def read_places(points):
    """{name: case}. Of each place, the largest step comes first."""
    cases: dict[str, list] = {}
    for row, result in rows_of(points):
        front = result.get("front", IMPOSSIBLE_FRONT)
        case = event_front(front) | {"type": type_on_map(front["type"])}
        name = "tau_bar_0 {:g}, sigma_bar {:g}".format(*place_of(row))
        cases.setdefault(name, []).append(case)
    return cases


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


def lammps_measured(points):
    """The largest difference over the largest displacement, with our choices and with others."""
    measured: dict[str, object] = {}
    for name, point in zip(LAMMPS, points, strict=True):
        if not (found := point["lammps"]):
            return {name: "not installed (package lammps)"}
        part = found["largest difference [m]"] / found["largest displacement [m]"]
        measured |= {
            f"{name}, after {found['steps']} steps": part,
            f"{name}: within 1e-9": YES[part <= 1e-9],
        }
    return measured


def own_result(cases, edges, with_lammps):
    of_events = {
        f"{name}: {quantity}": [front[quantity] for front in case]
        for name, case in [*cases.items()][: len(EVENTS)]
        for quantity in ("type", *SLOW)
    }
    measured = of_events | steps_measured(cases) | continuum.measured(edges)
    return OwnResult(
        id="convergence",
        question="do fronts stay what they are with smaller time steps and on finer lattices, and"
        " does LAMMPS move the blocks in the same way?",
        measured=with_lammps | measured,
    )


def draw_event(axes, number, fronts):
    start = min(np.nanmin(values(front["t_rupture"])) for front in fronts)
    for front, dt, colour, style in zip(fronts, STEPS, (BLACK, *LINES), ("-", "--", ":")):
        time = (values(front["t_front"]) - start) * 1e3
        axes.plot(np.array(front["x"]) / front["L"], time, style, color=colour, label=f"{dt} s")
    axes.set(xlabel="$x/L$", xlim=(0, 1), ylim=(0, None))
    axes.set_title(f"event {number}")


def draw(events, edges, stem):
    fig, panels = lettered("ABC;DEF", DOUBLE, 0.66 * DOUBLE)
    for text, (number, fronts) in zip("ABC", events.items()):
        draw_event(panels[text], number, fronts)
    panels["A"].set_ylabel("front is there after [ms]")
    panels["C"].legend(loc="lower right", handlelength=1)
    continuum.draw([panels[text] for text in "DEF"], edges)
    save(fig, stem)


def rows(cases):
    for name, case in cases.items():
        for dt, front in zip(STEPS, case):
            yield [name, dt, *map(front.get, COLUMNS), YES[changes_type(case)]]


def make(chains, results):
    events = read_events([*chains["fig2/event"], *chains["events"]])
    edges = continuum.read_edges(chains["lattice"], chains["lattice_449"])
    cases = {f"event {number}": [*map(event_front, fronts)] for number, fronts in events.items()}
    cases |= read_places(chains["time_step"])
    draw(events, edges, results / "convergence")
    names = ["case", "time step [s]", *COLUMNS, "type changes between the two finest"]
    write_table(results / "convergence.csv", names, rows(cases))
    write_table(results / "edges.csv", continuum.COLUMNS, continuum.rows(edges))
    write_own(results, [own_result(cases, edges, lammps_measured(chains["lammps"]))])
    return []
