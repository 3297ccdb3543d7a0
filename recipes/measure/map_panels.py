"""How maps of front types are drawn (Figures 4 D and S6 B, claim geometry)."""

from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch
from matplotlib.patheffects import withStroke
import numpy as np
from rupture.figures import BLACK, BLUE, DOUBLE, GREEN, PURPLE, figure, letter, save
from scipy.interpolate import NearestNDInterpolator

from measure import front_map
from measure.front_map import TYPES, axes_of, below, types_of, types_of_seeds
from measure.tables import write_table

# Lighter than ARRESTED, SLOW and FAST, and apart in grey, too.
COLOURS = {"arrested": "#E9E3BC", "slow": "#8CC0E3", "fast": "#E07F4A"}
FINE = 12  # pixels per spacing of the grid
LINES = (BLACK, GREEN, BLUE, "#5A2A00", PURPLE)  # seen on all regions
LINESTYLES = ("-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)))


def regions(types, taus, sigmas):
    """The type of the nearest place, on the given axes; NaN where nothing can be prepared."""
    spacing = (
        taus[-1] - taus[-2],
        sigmas[-1] - sigmas[-2],
    )  # the first may be another: 0 is not shifted
    places = np.array(list(types)) / spacing
    kinds = [TYPES.index(kind) if kind in TYPES else np.nan for kind in types.values()]
    nearest = NearestNDInterpolator(places, kinds)
    edges = [
        np.linspace(axis[0] - step / 2, axis[-1] + step / 2, FINE * len(axis) + 1)
        for axis, step in zip((taus, sigmas), spacing)
    ]
    tau, sigma = (0.5 * (edge[1:] + edge[:-1]) for edge in edges)
    grid = np.stack(np.meshgrid(tau / spacing[0], sigma / spacing[1], indexing="ij"), axis=-1)
    return edges, nearest(grid)


def draw_regions(axes, types, grid_types):
    """Regions coloured by type, a dot per place. `grid_types` are those of the regular grid."""
    (tau, sigma), kinds = regions(types, *axes_of(grid_types))
    colours = ListedColormap([COLOURS[kind] for kind in TYPES])
    look = {"cmap": colours, "vmin": -0.5, "vmax": len(TYPES) - 0.5, "rasterized": True}
    axes.pcolormesh(sigma, tau, kinds, **look)
    taus, sigmas = zip(*(place for place, kind in types.items() if kind in TYPES))
    axes.plot(sigmas, taus, ".", color=BLACK, markersize=2, markeredgewidth=0, label="run")
    axes.set(xlabel=r"$\bar\sigma$", ylabel=r"$\bar\tau_0$")
    axes.set(xlim=(sigma[0], sigma[-1]), ylim=(tau[0], tau[-1]))


def draw_several_types(axes, seed_types):
    """Rings round the places whose type depends on the seed."""
    mixed = [place for place, seeds in seed_types.items() if len(set(seeds.values())) > 1]
    if mixed:
        taus, sigmas = zip(*mixed)
        look = {"markerfacecolor": "none", "markersize": 4, "markeredgewidth": 0.6}
        axes.plot(sigmas, taus, "o", color=BLACK, label="type depends\non the seed", **look)


def name_regions(axes, types):
    """The name of each region at its place next to the region's middle."""
    scale = np.ptp(np.array(list(types)), axis=0)
    for kind in TYPES:
        inside = np.array([place for place, k in types.items() if k == kind])
        if not len(inside):
            continue
        away = np.linalg.norm((inside - np.median(inside, axis=0)) / scale, axis=1)
        tau, sigma = inside[np.argmin(away)]
        halo = withStroke(linewidth=2.5, foreground=COLOURS[kind])
        axes.annotate(kind, (sigma, tau), ha="center", va="center", path_effects=[halo])


def draw_maps(panels, maps, titles):
    """Small maps side by side, with the names of their regions right of the last one."""
    for axes, (name, fronts) in zip(panels, maps.items()):
        types = types_of(fronts)
        draw_regions(axes, types, types)
        axes.set(title=titles[name], **({} if axes is panels[0] else {"ylabel": ""}))
    patches = [Patch(facecolor=COLOURS[kind], label=kind) for kind in reversed(TYPES)]
    handles = [*patches, *axes.get_legend_handles_labels()[0]]
    axes.legend(handles=handles, loc="center left", bbox_to_anchor=(1, 0.5), handlelength=1)


def draw_thresholds(axes, grid, slow_below):
    """The lines above which fronts are fast, for several thresholds c_s/ratio."""
    taus, sigmas = axes_of(grid)
    for ratio, colour, style in zip(slow_below, LINES, LINESTYLES):
        types = types_of(grid, below(ratio))
        fast = np.array([[types[tau, sigma] == "fast" for sigma in sigmas] for tau in taus], float)
        if 0 < fast.mean() < 1:
            line = {"colors": [colour], "linestyles": [style], "linewidths": 1}
            axes.contour(sigmas, taus, fast, levels=[0.5], **line)
        label = f"slow below $c_s/{ratio}$"
        axes.plot([], [], color=colour, linestyle=style, linewidth=1, label=label)
    draw_regions(axes, types_of(grid), types_of(grid))


def draw_map(fronts, grid, slow_below, text, stem):
    """The map with all its places, and beside it what the threshold for slow fronts does."""
    fig, (left, right) = figure(DOUBLE, 0.45 * DOUBLE, ncols=2, sharey=True)
    types = types_of(fronts)
    draw_regions(left, types, types_of(grid))
    draw_several_types(left, types_of_seeds(fronts))
    name_regions(left, types)
    letter(left, text)
    draw_thresholds(right, grid, slow_below)
    right.set(ylabel="")
    handles = [*right.get_legend_handles_labels()[0][:-1], *left.get_legend_handles_labels()[0]]
    right.legend(handles=handles, loc="center left", bbox_to_anchor=(1, 0.5), handlelength=1.5)
    save(fig, stem)


def thresholds_compared(fronts, grid, slow_below):
    """The effect of another threshold for slow fronts: numbers of grid points of each type, of
    those whose type is not that at the first threshold, and of violations over all seeds."""
    reference = types_of(grid, below(slow_below[0]))
    for ratio in slow_below:
        types = types_of(grid, below(ratio))
        seeds = types_of_seeds(fronts, below(ratio))
        yield {
            "c_s/threshold": ratio,
            "slow": sum(kind == "slow" for kind in types.values()),
            "fast": sum(kind == "fast" for kind in types.values()),
            "changed": sum(types[place] != reference[place] for place in types),
            "fast below-left of arrested": len(front_map.fast_below_left_of_arrested(seeds)),
        }


def write_map(fronts, grid, results, *, panel, slow_below):
    """Everything that a figure writes about its map, and the regular grid of it. Slow is below c_s
    over one of `slow_below`, of which the first is the default."""
    thresholds = list(thresholds_compared(fronts, grid, slow_below))
    draw_map(fronts, grid, slow_below, panel, results / f"{results.name}{panel}")
    front_map.write_types(results / "front-types.csv", fronts)
    write_table(results / "thresholds.csv", list(thresholds[0]), map(dict.values, thresholds))
