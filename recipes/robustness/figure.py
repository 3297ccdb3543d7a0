"""Exponential slipping times, and other geometries; the distance law is in distance.py."""

import numpy as np
from rupture.figures import DOUBLE, FAST, SINGLE, SLOW, figure, lettered, save
from rupture.reports import values

from events import shown_events
from measure.ways import PRIMARY
from measure.front_map import types_of, write_types, write_variants
from measure.fronts import is_fast_only
from measure.map_panels import draw_maps, draw_regions, name_regions
from measure.tables import write_events
from robustness import distance
from robustness.commands import exponential_map, geometry

TITLES = {
    "L x 0.75": r"$0.75\,L$",
    "L x 1.5": r"$1.5\,L$",
    "trigger 0.2": r"$\bar\tau_\mathrm{trigger} = 0.2$",
    "trigger 0.4": r"$\bar\tau_\mathrm{trigger} = 0.4$",
}


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


def make(results):
    spanning = [event for event in shown_events("exponential")[PRIMARY] if event["spanning"]]
    draw(spanning, results / "exponential")
    write_events(
        results / "exponential-events.csv", spanning, {"type": lambda event: event["type"]}
    )
    fronts = exponential_map()
    fig, axes = figure(SINGLE, 0.85 * SINGLE)
    draw_regions(axes, types := types_of(fronts), types)
    name_regions(axes, types)
    save(fig, results / "exponential-map")
    write_types(results / "exponential-map.csv", fronts)
    distance.make(results)
    fig, panels = lettered("ABCD", DOUBLE, 0.32 * DOUBLE, sharey=True)
    draw_maps([*panels.values()], geometry(), TITLES)
    save(fig, results / "geometry")
    write_variants(results / "geometry.csv", geometry())
