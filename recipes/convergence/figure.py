"""Fronts with smaller time steps and on finer lattices. A case is a front at three levels, from the
reference one to the finest."""

from dataclasses import dataclass

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
COLUMNS = (
    *("type", "speed", "duration", "x_from", "x_to", "arrest"),
    *("whole speed", "whole duration"),  # not of events
)


@dataclass(frozen=True)
class Case:
    """Lists have one element per level. Speeds [m/s], times [s] and places [m] are None without a
    slow stretch."""

    series: str  # one of LEVELS
    name: str
    types: list
    speeds: list
    durations: list
    starts: list  # of the slow stretch
    ends: list
    arrests: list  # where the front stopped [m]
    whole_speeds: list  # with the stencils at the ends of the slow stretch
    whole_durations: list

    def changes_type(self):
        """Between the two finest levels."""
        return self.types[-2] != self.types[-1]


def case_of(series, name, fronts):
    """`fronts`: for each level its values by name, as in COLUMNS."""
    return Case(series, name, *([front.get(column) for front in fronts] for column in COLUMNS))


# --- events --------------------------------------------------------------------------------


def event_front(front):
    slow = front["slow"] or dict.fromkeys(("x_from", "x_to", "speed", "duration"))
    kept = {key: slow[key] for key in ("x_from", "x_to", "speed", "duration")}
    return kept | {"type": front["type"], "arrest": front["x_arrest"]}


def read_events(data):
    """{event's number: its fronts, as `analyze front` reports them, per time step}"""
    return {
        number: [
            report(data / f"{event}-front.json"),
            *(report(data / f"convergence/{event}-{dt}-front.json") for dt in STEPS[1:]),
        ]
        for number, event in EVENTS.items()
    }


# --- prepared interfaces -------------------------------------------------------------------


def number_of(text):
    return float(text) if text else None


def row_front(row):
    return {
        "type": type_on_map(row["type"]) if row["status"] == "done" else IMPOSSIBLE,
        "arrest": number_of(row["arrested at [m]"]),
        "x_from": number_of(row["slow stretch from [m]"]),
        "x_to": number_of(row["slow stretch to [m]"]),
        "speed": number_of(row["slow speed [m/s]"]),
        "duration": number_of(row["duration [s]"]),
        "whole speed": number_of(row["speed with ends [m/s]"]),
        "whole duration": number_of(row["duration with ends [s]"]),
    }


def read_places(data):
    """{series: {(tau_bar_0, sigma_bar): fronts per level}}, of places that all levels have."""
    rows = read_rows(data / "convergence/time-step.csv")
    steps = [[row for row in rows if row["numerics.dt"] == dt] for dt in STEPS]
    finer = [read_rows(data / f"convergence/lattice-{n}.csv") for n in ("113", "225")]
    series_of_levels: dict = {TIME_STEP: steps}
    for variant, series in VARIANTS.items():
        of_variant = [[row for row in rows if row["variant"] == variant] for rows in finer]
        series_of_levels[series] = [steps[0], *of_variant]
    found: dict = {}
    for series, levels in series_of_levels.items():
        fronts = [{place_of(row): row_front(row) for row in level} for level in levels]
        shared = [place for place in fronts[0] if all(place in level for level in fronts)]
        places = sorted(shared, key=lambda place: place[::-1])
        found[series] = {place: [of_level[place] for of_level in fronts] for place in places}
    return found


# --- what they say -------------------------------------------------------------------------


def name_of(place):
    return "tau_bar_0 {:g}, sigma_bar {:g}".format(*place)


def cases_of(events, places):
    shown = [
        case_of(TIME_STEP, f"event {number}", [event_front(front) for front in fronts])
        for number, fronts in events.items()
    ]
    prepared = [
        case_of(series, name_of(place), fronts)
        for series, of_series in places.items()
        for place, fronts in of_series.items()
    ]
    return shown + prepared


def in_milliseconds(times):
    return [time and time * 1e3 for time in times]


def types_text(types):
    return f"{types[0]} with each step" if len(set(types)) == 1 else ", ".join(types)


def event_measured(case):
    return {
        f"{case.name}: types": types_text(case.types),
        f"{case.name}: slow speed [m/s]": case.speeds,
        f"{case.name}: duration [ms]": in_milliseconds(case.durations),
        f"{case.name}: slow from [m]": case.starts,
        f"{case.name}: slow to [m]": case.ends,
    }


def is_slow(case):
    """At the two finest levels."""
    return case.types[-2:] == ["slow", "slow"]


def relative_changes(cases):
    """Of the slow speed, between the two finest levels. A slow stretch may be too short for one."""
    pairs = [case.speeds[-2:] for case in cases if is_slow(case)]
    return [abs(b / a - 1) for a, b in pairs if a and b]


def type_changes(case):
    return f"{case.name} ({', '.join(case.types)})"


def series_measured(series, cases):
    changed = [case for case in cases if case.changes_type()]
    changes = relative_changes(cases)
    return {
        f"{series}: cases": len(cases),
        f"{series}: type changes between the two finest": len(changed),
        f"{series}: these are": "; ".join(map(type_changes, changed)) or "none",
        f"{series}: type is not the same at all levels": sum(
            len(set(case.types)) > 1 for case in cases
        ),
        f"{series}: slow at the two finest levels": sum(map(is_slow, cases)),
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
    for case in cases[: len(EVENTS)]:
        measured |= event_measured(case)
    for series in LEVELS:
        measured |= series_measured(series, [case for case in cases if case.series == series])
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
        style = {
            "color": COLOURS[kind],
            "markersize": 4,
            "markeredgewidth": 0.5,
            "markeredgecolor": BLACK,
        }
        axes.plot(*zip(*points, strict=True) if points else ([], []), "s", label=kind, **style)
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
    for case in cases:
        columns = [
            *(case.types, case.speeds, case.durations, case.starts, case.ends, case.arrests),
            *(case.whole_speeds, case.whole_durations),
        ]
        mark = "yes" if case.changes_type() else "no"
        for level, *cells in zip(LEVELS[case.series], *columns):
            yield [case.series, case.name, level, *cells, mark]


NAMES = [
    *("varied", "case", "level", "type", "slow speed [m/s]", "duration [s]", "slow from [m]"),
    *("slow to [m]", "arrested at [m]", "speed with ends [m/s]", "duration with ends [s]"),
    "type changes between the two finest",
]


def make(data, results):
    events, places = read_events(data), read_places(data)
    cases = cases_of(events, places)
    draw(events, places, results / "convergence")
    write_table(results / "convergence.csv", NAMES, rows(cases))
    lammps = report(data / "convergence/lammps.json")
    write_own(results, [own_result(cases, places, lammps)])
    return []
