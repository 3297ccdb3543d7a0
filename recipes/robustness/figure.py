"""Exponential slipping times: events, map of front types and claims; other geometries and the
distance law are in the modules beside this one."""

import distance
import geometry
import numpy as np

from claims.judge import judged
from measure.records import values
from measure.tables import rows_of, write_events
from measure.front_claims import judged_in_words
from measure.fronts import first_in_words, is_fast_only
from measure.cases import events_of, in_words
from measure.front_map import TYPES, read_map, types_of, write_types
from measure.map_claims import out_of_order
from measure.map_panels import draw_regions, name_regions
from report.plotting import DOUBLE, FAST, SINGLE, SLOW, figure, save


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


def case_of_map(fronts):
    """4D's order of regions, on the map of prepared interfaces with exponential times."""
    kinds = list(types_of(fronts).values())
    return {
        **{f"{kind} grid points of the map": kinds.count(kind) for kind in TYPES},
        "places out of order on the map": len(out_of_order(fronts)),
    }


def make(chains, results):
    [shown] = chains["ensemble/shown_events"]
    events = shown["measured"]["events"]
    spanning = [event for event in events if event["spanning"]]
    draw(spanning, results / "exponential")
    write_events(
        results / "exponential-events.csv", spanning, {"type": lambda event: event["type"]}
    )
    fronts = read_map(rows_of(chains["exponential_map"]))
    fig, axes = figure(SINGLE, 0.85 * SINGLE)
    draw_regions(axes, types := types_of(fronts), types)
    name_regions(axes, types)
    save(fig, results / "exponential-map")
    write_types(results / "exponential-map.csv", fronts)
    distance.make(chains, results)
    units, of_map = in_words(events_of(chains["ensemble/events"])), case_of_map(fronts)
    return [
        judged_in_words("exponential-event", first_in_words(events), units),
        judged("exponential-map", of_map, of_map),
        *geometry.make(chains, results),
    ]
