"""Fronts under the distance law, a result of our own."""

import numpy as np
from rupture.figures import AS_IT_IS, CHANGED, DOUBLE, lettered, save
from rupture.reports import values

from claims.own_result import OwnResult, write_own
from maps import width
from measure.front_map import TYPES, axes_of, band, types_of, write_variants
from measure.map_panels import draw_maps
from robustness.commands import distance_bands, distance_event, distance_maps

TITLES = {f"d_R {d} um": rf"$d_R = {d}\,\mu$m" for d in (0.3, 1, 3, 10)}


def measured_event(unmodified, continued):
    L = continued["L"]
    reaches = continued["x_arrest"] if continued["type"] == "arrested" else L
    return {
        "event under the reference law": unmodified["type"],
        "its slow stretch from [L]": unmodified["slow"]["x_from"] / unmodified["L"],
        "the same under the distance law": continued["type"],
        "which reaches [L]": reaches / L,
    }


def measured_map(name, fronts, edges):
    types = types_of(fronts)
    kinds = list(types.values())
    bands = {sigma: band(types, sigma) for sigma in axes_of(types)[1]}
    slow = [
        "{:g}: {:g} to {:g}".format(sigma, *limits) for sigma, limits in bands.items() if limits
    ]
    return {
        **{f"{name}: {kind}": kinds.count(kind) for kind in TYPES},
        f"{name}: slow tau_bar_0 by sigma_bar": "; ".join(slow) or "none",
        **{
            f"{name}: width of the slow band at sigma_bar = {sigma:g}, and of the reference's": [
                width(found) for found in pair
            ]
            for sigma, pair in edges.items()
        },
    }


def own_result(maps, edges, unmodified, continued):
    return OwnResult(
        id="distance",
        question="are there slow fronts if junctions slip for a distance instead of a time?",
        measured=measured_event(unmodified, continued)
        | {
            key: value
            for name, fronts in maps.items()
            for key, value in measured_map(name, fronts, edges[name]).items()
        },
    )


def draw_event(axes, fronts):
    start = min(np.nanmin(values(front["t_rupture"])) for front in fronts.values())
    for (label, front), colour in zip(fronts.items(), (AS_IT_IS, CHANGED)):
        time = (values(front["t_rupture"]) - start) * 1e3
        axes.plot(np.array(front["x"]) / front["L"], time, ".", color=colour, label=label)
    axes.set(title="event I", xlabel="$x/L$", xlim=(0, 1), xticks=(0, 0.5, 1))
    axes.set(ylabel="block ruptures after [ms]", ylim=(0, None))
    axes.legend(loc="lower right", handletextpad=0, borderpad=0)


def draw(maps, fronts, stem):
    fig, panels = lettered("ABCDE", DOUBLE, 0.3 * DOUBLE)
    draw_event(panels["A"], fronts)
    draw_maps([panels[text] for text in "BCDE"], maps, TITLES)
    save(fig, stem)


def make(results):
    maps, (as_it_is, changed) = distance_maps(), distance_event()
    draw(maps, {"by time": as_it_is, "by distance": changed}, results / "distance")
    write_variants(results / "distance.csv", maps)
    write_own(results, [own_result(maps, distance_bands(), as_it_is, changed)])
