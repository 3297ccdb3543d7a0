"""Fronts with smaller time steps and on finer lattices. A case is a front at three levels, from the
reference one to the finest: a list of fronts, each with its values by the headings of COLUMNS."""

import numpy as np

from claims.own_result import OwnResult, write_own
from data.records import report, values
from data.tables import read_rows, write_table
from events.event_claims import yes
from maps.front_map import IMPOSSIBLE, TYPES, place_of, steps_back, type_on_map
from maps.map_panels import COLOURS
from pictures.plotting import BLACK, DOUBLE, LINES, figure, letter, save

EVENTS = {"I": "fast-slow-fast", "II": "second-slow", "III": "fast-only"}
STEPS = ["2e-7", "1e-7", "5e-8"]  # [s]
LATTICES = ["57 x 31", "113 x 61", "225 x 121"]  # blocks
TIME_STEP = "time step"
VARIANTS = {  # of the sweeps: series
    "damping ratio kept": "lattice",
    "viscosity kept": "lattice, viscosity kept",
}
LEVELS = {TIME_STEP: STEPS, **dict.fromkeys(VARIANTS.values(), LATTICES)}
SIGMAS = (0.0, 0.285)  # of the prepared interfaces
SPEED, DURATION = "slow speed [m/s]", "duration [s]"
SLOW = {SPEED: "speed", DURATION: "duration", "slow from [m]": "x_from", "slow to [m]": "x_to"}
IN_SWEEPS = {"slow from [m]": "slow stretch from [m]", "slow to [m]": "slow stretch to [m]"}
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
    cells = {name: row[IN_SWEEPS.get(name, name)] for name in COLUMNS[1:]}
    kind = type_on_map(row["type"]) if row["status"] == "done" else IMPOSSIBLE
    return {"type": kind} | {name: float(text) if text else None for name, text in cells.items()}


def read_places(data):
    """{series: {(tau_bar_0, sigma_bar): fronts per level}}, of places that all levels have."""

    def fronts(table, column, value):
        rows = read_rows(data / f"convergence/{table}.csv")
        return {place_of(row): row_front(row) for row in rows if row[column] == value}

    steps = [fronts("time-step", "numerics.dt", dt) for dt in STEPS]
    series: dict[str, list] = {TIME_STEP: steps}
    for variant, name in VARIANTS.items():
        finer = (fronts(f"lattice-{n}", "variant", variant) for n in ("113", "225"))
        series[name] = [steps[0], *finer]
    return {
        name: {
            place: [level[place] for level in levels]
            for place in sorted(levels[0], key=lambda place: place[::-1])
            if all(place in level for level in levels)
        }
        for name, levels in series.items()
    }


# --- what they say -------------------------------------------------------------------------


def cases_of(events, places):
    """{(series, name): case}, the events first"""
    shown = {
        (TIME_STEP, f"event {number}"): [event_front(front) for front in fronts]
        for number, fronts in events.items()
    }
    return shown | {
        (series, "tau_bar_0 {:g}, sigma_bar {:g}".format(*place)): case
        for series, of_series in places.items()
        for place, case in of_series.items()
    }


def column(case, name):
    """One element per level; None without a slow stretch."""
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


def series_measured(series, cases):
    """`cases`: {name: case}. A slow stretch may be too short for a speed."""
    types = {name: column(case, "type") for name, case in cases.items()}
    changed = [name for name, case in cases.items() if changes_type(case)]
    slow = [case for name, case in cases.items() if types[name][-2:] == ["slow", "slow"]]
    pairs = [column(case, SPEED)[-2:] for case in slow]
    changes = [abs(b / a - 1) for a, b in pairs if a and b]
    listed = "; ".join(f"{name} ({', '.join(types[name])})" for name in changed)
    return {
        f"{series}: cases": len(cases),
        f"{series}: type changes between the two finest": len(changed),
        f"{series}: these are": listed or "none",
        f"{series}: type is not the same at all levels": sum(
            len(set(kinds)) > 1 for kinds in types.values()
        ),
        f"{series}: slow at the two finest levels": len(slow),
        f"{series}: of these with a slow speed at both": len(changes),
        f"{series}: slow speed changes by at most [%]": max(changes) * 100 if changes else None,
    }


def slow_measured(series, places):
    """The tau_bar_0 of slow fronts, for each level and sigma_bar."""
    return {
        f"{series} {level}: slow tau_bar_0 at sigma_bar {sigma:g}": ", ".join(
            f"{tau:g}"
            for (tau, s), fronts in places.items()
            if s == sigma and fronts[number]["type"] == "slow"
        )
        or "none"
        for number, level in enumerate(LEVELS[series])
        for sigma in SIGMAS
    }


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


def order_measured(series, places):
    """What claim 4D asks of the order of types, for each level."""
    return {
        f"{series} {level}: types that step back along tau_bar_0": len(
            steps_back({place: fronts[number]["type"] for place, fronts in places.items()}, 0)
        )
        for number, level in enumerate(LEVELS[series])
    }


def own_result(cases, places, lammps):
    measured = lammps_measured(lammps)
    for (_, name), case in [*cases.items()][: len(EVENTS)]:
        measured |= event_measured(name, case)
    for series in LEVELS:
        of_series = {name: case for (of, name), case in cases.items() if of == series}
        measured |= series_measured(series, of_series)
        measured |= slow_measured(series, places[series])
        measured |= order_measured(series, places[series])
    return OwnResult(
        id="convergence",
        question="do fronts stay what they are with smaller time steps and on finer lattices, and"
        " does LAMMPS move the blocks in the same way?",
        measured=measured,
    )


# --- picture and table ---------------------------------------------------------------------


def draw_event(axes, number, fronts):
    start = min(np.nanmin(values(front["t_rupture"])) for front in fronts)
    for front, dt, colour, style in zip(fronts, STEPS, (BLACK, *LINES), ("-", "--", ":")):
        time = (values(front["t_rupture"]) - start) * 1e3
        axes.plot(np.array(front["x"]) / front["L"], time, style, color=colour, label=f"{dt} s")
    axes.set(xlabel="$x/L$", xlim=(0, 1), ylim=(0, None))
    axes.set_title(f"event {number}")


def draw_places(axes, series, places):
    """A column per level, for either sigma_bar."""
    columns = [(sigma, level) for sigma in SIGMAS for level in range(len(LEVELS[series]))]
    for kind in TYPES:
        points = [
            (columns.index((sigma, level)), tau)
            for (tau, sigma), fronts in places.items()
            for level, front in enumerate(fronts)
            if front["type"] == kind
        ]
        look = {"color": COLOURS[kind], "markeredgecolor": BLACK, "markeredgewidth": 0.5}
        x_y = zip(*points, strict=True) if points else ([], [])
        axes.plot(*x_y, "s", label=kind, markersize=4, **look)
    axes.axvline(len(columns) / 2 - 0.5, ymax=0.58, color=BLACK, linewidth=0.6)
    labels = [LEVELS[series][level] for _, level in columns]
    axes.set_xticks(range(len(columns)), labels, rotation=90)
    for sigma, x in zip(SIGMAS, (1, 4)):
        axes.text(x, 0.44, rf"$\bar\sigma$ = {sigma:g}", ha="center")
    axes.set(ylabel=r"$\bar\tau_0$", xlim=(-0.5, len(columns) - 0.5), ylim=(-0.02, 0.8))
    axes.set_title(series)


def draw(events, places, stem):
    fig, (above, below) = figure(DOUBLE, 0.66 * DOUBLE, nrows=2, ncols=len(EVENTS))
    for axes, (number, fronts) in zip(above, events.items()):
        draw_event(axes, number, fronts)
    above[0].set_ylabel("block ruptures after [ms]")
    above[2].legend(loc="lower right", handlelength=1)
    for axes, (series, of_series) in zip(below, places.items()):
        draw_places(axes, series, of_series)
    below[-1].legend(loc="upper center")
    for axes, text in zip([*above, *below], "ABCDEF"):
        letter(axes, text)
    save(fig, stem)


def rows(cases):
    for (series, name), case in cases.items():
        mark = yes(changes_type(case))
        for level, front in zip(LEVELS[series], case):
            yield [series, name, level, *map(front.get, COLUMNS), mark]


def make(data, results):
    events, places = read_events(data), read_places(data)
    cases = cases_of(events, places)
    draw(events, places, results / "convergence")
    names = ["varied", "case", "level", *COLUMNS, "type changes between the two finest"]
    write_table(results / "convergence.csv", names, rows(cases))
    lammps = report(data / "convergence/lammps.json")
    write_own(results, [own_result(cases, places, lammps)])
    return []
