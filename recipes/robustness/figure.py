"""Exponential slipping times: events, map of front types and claims; other geometries and the
distance law are in the modules beside this one."""

import distance
import geometry
import numpy as np

from claims.judge import judged, unmet
from data.records import report, values
from data.tables import points_of, write_events
from events.choose_events import first_in_words, read_events
from events.front_claims import case_of_event, judged_in_words, words_case, words_shown
from events.fronts import has_slow_stretch, is_fast_only
from events.units import in_words as units_in_words
from events.units import of_ensemble, of_loads
from maps.front_map import TYPES, read_map, types_of, write_types
from maps.map_conventions import ALONG_TAU, out_of_order
from maps.map_panels import draw_regions, name_regions
from pictures.plotting import DOUBLE, FAST, SINGLE, SLOW, figure, save


def draw(events, stem):
    """When each block ruptures: one small panel per spanning event."""
    fig, axes = figure(DOUBLE, 0.25 * DOUBLE, ncols=len(events), sharex=True, sharey=True)
    for event, axis in zip(events, axes):
        time = (values(event["t_rupture"]) - event["t_start"]) * 1e3
        colour = FAST if is_fast_only(event) else SLOW
        axis.plot(np.linspace(0, 1, len(time)), time, ".", color=colour)
        axis.set(title=f"{event['t_start']:.3f} s", xlabel="$x/L$", xlim=(0, 1), ylim=(0, None))
        axis.set_xticks([0, 0.5, 1], ["0", "½", "1"])
    axes[0].set_ylabel("block ruptures after [ms]")
    for colour, label in ((SLOW, "with a slow\nstretch"), (FAST, "fast\neverywhere")):
        axes[-1].plot([], [], ".", color=colour, label=label)
    axes[-1].legend(loc="center left", bbox_to_anchor=(1, 0.5), handletextpad=0, borderpad=0)
    save(fig, stem)


def slow_stretch(front):
    """In one line; a front without one is what it is."""
    slow, L = front["slow"], front["L"]
    if slow is None:
        return f"none, the front is {front['type']}"
    where = f"{slow['x_from'] / L:.3g} L to {slow['x_to'] / L:.3g} L"
    return f"{slow['speed']:.3g} m/s for {slow['duration'] * 1e3:.3g} ms, {where}"


def case_of_map(fronts):
    """4D's order of regions, on the map of prepared interfaces with exponential times."""
    kinds = list(types_of(fronts).values())
    return {
        **{f"{kind} grid points of the map": kinds.count(kind) for kind in TYPES},
        "places out of order on the map": len(out_of_order(fronts, fronts, ALONG_TAU)),
    }


def claims_in_words(first, of_map, loads):
    """Of the events, of the map, and of both."""
    shown, case, units = words_shown(first), words_case(first), units_in_words(loads)
    with_map = {
        unit: {name: [case | of_map for case in cases] for name, cases in measured.items()}
        for unit, measured in units.items()
    }
    return [
        judged_in_words("Expe", first, units),
        judged(
            "Expw",
            shown | of_map,
            case | of_map,
            with_map,
            note="Each load is judged by its own events, and all of them by the one map of prepared"
            " interfaces.",
        ),
        judged("Expm", of_map, of_map),
    ]


def claim_strict(events, unmodified, continued, loads):
    shown = min(events, key=lambda event: len(unmet("Exp", case_of_event(event))))
    slow, case = shown["slow"] or {}, case_of_event(shown)
    lasts = slow.get("between_crossings")
    accepted = [event for event in events if not unmet("Exp", case_of_event(event))]
    return judged(
        "Exp",
        shown=case,
        units=of_loads(loads, case_of_event),
        measured={
            "spanning events": len(events),
            "with a slow stretch": sum(map(has_slow_stretch, events)),
            "meeting 2A": len(accepted),
            "first to meet most of 2A at [s]": shown["t_start"],
            "slow speed [m/s]": slow.get("speed"),
            **{name: case[name] for name in ("duration [ms]", "from [L]", "to [L]")},
            "between the crossings of c_s/20 [ms]": lasts and lasts * 1e3,
            "fast before [m/s]": slow.get("fast_before"),
            "fast after [m/s]": slow.get("fast_after"),
            "unmet criteria": ", ".join(unmet("Exp", case)) or "none",
            "slow stretch of the event of Figure 2": slow_stretch(unmodified),
            "the same, continued with exponential times": slow_stretch(continued),
        },
        note="The case shown is the (first) event that meets the most conditions. The event"
        " of Figure 2 is also continued with exponential times, from the moment when its front is"
        " at 0.14 L.",
    )


def make(data, results):
    loads = of_ensemble(data, "exponential", "events")
    events = data / "ensemble/exponential-01-events.json"
    spanning = [event for event in read_events(events) if event["spanning"]]
    draw(spanning, results / "exponential")
    columns = {
        "type": lambda event: event["type"],
        "criteria of 2A not met": lambda event: "; ".join(unmet("Exp", case_of_event(event))),
    }
    write_events(results / "exponential-events.csv", spanning, columns)
    fronts = read_map(points_of(data / "robustness/exponential-map.csv"))
    fig, axes = figure(SINGLE, 0.85 * SINGLE)
    draw_regions(axes, types := types_of(fronts), types)
    name_regions(axes, types)
    save(fig, results / "exponential-map")
    write_types(results / "exponential-map.csv", fronts)
    runs = ("fast-slow-fast", "fast-slow-fast/exponential")
    unmodified, continued = (report(data / f"{run}-front.json") for run in runs)
    strict = claim_strict(spanning, unmodified, continued, loads)
    words = claims_in_words(first_in_words(events), case_of_map(fronts), loads)
    distance.make(data, results)
    return [strict, *words, *geometry.make(data / "robustness", results)]
