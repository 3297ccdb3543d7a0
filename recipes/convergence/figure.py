"""Fronts with smaller time steps; continuum.py has finer lattices. A case is a front with all
steps, the reference one first: a list, each front with its values by the headings of COLUMNS."""

import numpy as np

import continuum
from claims.own_result import OwnResult, write_own
from data.records import report, values
from data.tables import read_rows, write_table
from events.event_claims import yes
from maps.front_map import IMPOSSIBLE, TYPES, band, place_of, steps_back, type_on_map
from maps.map_panels import COLOURS
from pictures.plotting import BLACK, DOUBLE, LINES, figure, letter, save

EVENTS = {"I": "fast-slow-fast", "II": "second-slow", "III": "fast-only"}
STEPS = ["2e-7", "1e-7", "5e-8"]  # [s]
SIGMAS = (0.0, 0.285)  # of the prepared interfaces
SPEED, DURATION = "slow speed [m/s]", "duration [s]"
SLOW = {SPEED: "speed", DURATION: "duration", "slow from [m]": "x_from", "slow to [m]": "x_to"}
COLUMNS = ["type", *SLOW, "arrested at [m]", "speed with ends [m/s]", "duration with ends [s]"]


# --- reading -------------------------------------------------------------------------------


def event_front(front):
    """As `analyze front` reports it."""
    slow = front["slow"] or {}
    kept = {"type": front["type"], "arrested at [m]": front["x_arrest"]}
    return kept | {name: slow.get(key) for name, key in SLOW.items()}


def read_events(data):
    """{event's number: its fronts, as `analyze front` reports them, per time step}"""
    return {
        number: [
            report(data / f"{event}-front.json"),
            *(report(data / f"convergence/{event}-{dt}-front.json") for dt in STEPS[1:]),
        ]
        for number, event in EVENTS.items()
    }


def row_front(row):
    cells = {name: row[name] for name in COLUMNS[1:]}
    kind = type_on_map(row["type"]) if row["status"] == "done" else IMPOSSIBLE
    return {"type": kind} | {name: float(text) if text else None for name, text in cells.items()}


def read_places(data):
    """{(tau_bar_0, sigma_bar): case}"""
    rows = read_rows(data / "convergence/time-step.csv")
    levels = [
        {place_of(row): row_front(row) for row in rows if row["numerics.dt"] == dt} for dt in STEPS
    ]
    return {
        place: [level[place] for level in levels]
        for place in sorted(levels[0], key=lambda place: place[::-1])
    }


# --- what they say -------------------------------------------------------------------------


def cases_of(events, places):
    """{name: case}, the events first"""
    shown = {
        f"event {number}": [event_front(front) for front in fronts]
        for number, fronts in events.items()
    }
    return shown | {
        "tau_bar_0 {:g}, sigma_bar {:g}".format(*place): case for place, case in places.items()
    }


def column(case, name):
    """One element per step; None without a slow stretch."""
    return [front.get(name) for front in case]


def changes_type(case):
    """Between the two finest levels."""
    return case[-2]["type"] != case[-1]["type"]


def event_measured(name, case):
    types = column(case, "type")
    same = len(set(types)) == 1
    return {
        f"{name}: types": f"{types[0]} with each step" if same else ", ".join(types),
        f"{name}: {SPEED}": column(case, SPEED),
        f"{name}: duration [ms]": [time and time * 1e3 for time in column(case, DURATION)],
        f"{name}: slow from [m]": column(case, "slow from [m]"),
        f"{name}: slow to [m]": column(case, "slow to [m]"),
    }


def steps_measured(cases):
    """A slow stretch may be too short for a speed."""
    types = {name: column(case, "type") for name, case in cases.items()}
    changed = [name for name, case in cases.items() if changes_type(case)]
    slow = [case for name, case in cases.items() if types[name][-2:] == ["slow", "slow"]]
    pairs = [column(case, SPEED)[-2:] for case in slow]
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


def places_measured(types, dt):
    """Slow fronts, and what claim 4D asks of the order of types; `types`: {place: type}."""
    bands = {f"slow tau_bar_0 at sigma_bar {sigma:g}": band(types, sigma) for sigma in SIGMAS}
    measured = bands | {"types that step back along tau_bar_0": len(steps_back(types, 0))}
    return {f"time step {dt}: {name}": value for name, value in measured.items()}


def lammps_measured(compared):
    """What lammps.py printed."""
    if not compared:
        return {"LAMMPS: largest difference/displacement": "not installed (package lammps)"}
    difference = compared["largest difference [m]"]
    displacement = compared["largest displacement [m]"]
    return {
        "LAMMPS: steps": compared["steps"],
        "LAMMPS: largest difference/displacement": difference / displacement,
        "LAMMPS: within 1e-9": yes(difference <= 1e-9 * displacement),
    }


def own_result(cases, places, edges, lammps):
    measured = lammps_measured(lammps)
    for name, case in [*cases.items()][: len(EVENTS)]:
        measured |= event_measured(name, case)
    measured |= steps_measured(cases)
    for number, dt in enumerate(STEPS):
        types = {place: fronts[number]["type"] for place, fronts in places.items()}
        measured |= places_measured(types, dt)
    return OwnResult(
        id="convergence",
        question="do fronts stay what they are with smaller time steps and on finer lattices, and"
        " does LAMMPS move the blocks in the same way?",
        measured=measured | continuum.measured(edges),
    )


# --- picture and table ---------------------------------------------------------------------


def draw_event(axes, number, fronts):
    start = min(np.nanmin(values(front["t_rupture"])) for front in fronts)
    for front, dt, colour, style in zip(fronts, STEPS, (BLACK, *LINES), ("-", "--", ":")):
        time = (values(front["t_rupture"]) - start) * 1e3
        axes.plot(np.array(front["x"]) / front["L"], time, style, color=colour, label=f"{dt} s")
    axes.set(xlabel="$x/L$", xlim=(0, 1), ylim=(0, None))
    axes.set_title(f"event {number}")


def draw_places(axes, places):
    """A column per step, for either sigma_bar."""
    points = [
        (len(STEPS) * SIGMAS.index(sigma) + number, tau, front["type"])
        for (tau, sigma), fronts in places.items()
        for number, front in enumerate(fronts)
    ]
    for kind in TYPES:
        x_y = np.array([point[:2] for point in points if point[2] == kind]).reshape(-1, 2).T
        look = {"color": COLOURS[kind], "markeredgecolor": BLACK, "markeredgewidth": 0.5}
        axes.plot(*x_y, "s", label=kind, markersize=4, **look)
    axes.axvline(2.5, ymax=0.58, color=BLACK, linewidth=0.6)
    axes.set_xticks(range(6), STEPS * 2, rotation=90)
    for sigma, x in zip(SIGMAS, (1, 4)):
        axes.text(x, 0.44, rf"$\bar\sigma$ = {sigma:g}", ha="center")
    axes.set(ylabel=r"$\bar\tau_0$", xlim=(-0.5, 5.5), ylim=(-0.02, 0.8), title="time step")
    axes.legend(loc="upper center")


def draw(events, places, edges, stem):
    fig, (above, below) = figure(DOUBLE, 0.66 * DOUBLE, nrows=2, ncols=len(EVENTS))
    for axes, (number, fronts) in zip(above, events.items()):
        draw_event(axes, number, fronts)
    above[0].set_ylabel("block ruptures after [ms]")
    above[2].legend(loc="lower right", handlelength=1)
    draw_places(below[0], places)
    continuum.draw(below[1:], edges)
    for axes, text in zip([*above, *below], "ABCDEF"):
        letter(axes, text)
    save(fig, stem)


def rows(cases):
    for name, case in cases.items():
        for dt, front in zip(STEPS, case):
            yield [name, dt, *map(front.get, COLUMNS), yes(changes_type(case))]


def make(data, results):
    events, places = read_events(data), read_places(data)
    cases, edges = cases_of(events, places), continuum.read_edges(data)
    draw(events, places, edges, results / "convergence")
    names = ["case", "time step [s]", *COLUMNS, "type changes between the two finest"]
    write_table(results / "convergence.csv", names, rows(cases))
    write_table(results / "edges.csv", continuum.COLUMNS, continuum.rows(edges))
    lammps = report(data / "convergence/lammps.json")
    write_own(results, [own_result(cases, places, edges, lammps)])
    return []
