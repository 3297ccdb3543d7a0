"""Exponential slipping times: events and map of front types; other geometries and the distance law
are in the modules beside this one."""

import distance
import geometry
import numpy as np

from measure.tables import rows_of, values, write_events
from measure.fronts import is_fast_only
from measure.front_map import read_map, types_of, write_types
from measure.map_panels import draw_regions, name_regions
from rupture.figures import DOUBLE, FAST, SINGLE, SLOW, figure, save


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
    geometry.make(chains, results)
