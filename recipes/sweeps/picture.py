"""The picture of a sweep: every quantity against the one or two values that vary, each a Column.
Seeds are repetitions: single ones and their median are shown."""

from dataclasses import replace

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.ticker import NullLocator

from measure.map_panels import COLOURS
from rupture.figures import BLACK, DOUBLE, LINES, MM, SINGLE, VERMILION, figure, save
from rupture.plotting import MAP, draw_profile
from rupture.units import in_si

SEEDS = ("seed", "numerics.seed")
PANEL, STRIP = 62 * MM, 9 * MM  # heights [inch]
QUARTILES = (0.25, 0.5, 0.75)
HATCHED = {"cmap": ListedColormap(["0.85"]), "hatch": "////", "edgecolor": "0.6", "linewidth": 0}
FEW = 20  # places of a logarithmic axis that have their numbers, and panels
APART = 2  # at least between two labels of ticks [pixels]


def plain(text):
    """The text for Matplotlib, which takes what is between two $ for a formula."""
    return text.replace("$", r"\$")


def as_typed(column, sweep):
    """The column with numbers in the unit in which all of them were typed."""
    column = replace(column, axis=sweep.axis or column.scale)
    if not (unit := sweep.typed.get(column.name)) or not column.unit:
        return column
    factor = in_si(f"1{unit}")[0]
    cells = [cell and float(f"{float(cell) / factor:.12g}") for cell in column.cells]
    return replace(column, unit=unit, cells=cells)


# --- axes ----------------------------------------------------------------------------------


def set_axis(axes, which, column):
    axes.set(**{f"{which}label": plain(column.heading), f"{which}scale": column.scale})
    axis = getattr(axes, f"{which}axis")
    if column.categories:
        axis.set_ticks(range(len(column.categories)), [*map(plain, column.categories)])
        axes.set(**{f"{which}lim": (-0.5, len(column.categories) - 0.5)})
    elif column.axis == "log" and len(places := np.unique(column.positions)) <= FEW:  # it varies
        axis.set_minor_locator(NullLocator())
        axis.set_ticks(places, [f"{place:g}" for place in places])
    elif column.scale == "linear":
        axes.ticklabel_format(axis=which, style="sci", scilimits=(-3, 5), useMathText=True)


def space_labels(fig):
    """Labels of ticks that would overlap: names along x are turned, of others some are left out."""
    fig.draw_without_rendering()
    for axis in (axis for axes in fig.axes for axis in (axes.xaxis, axes.yaxis)):
        labels, which = axis.get_ticklabels(), 0 if axis.axis_name == "x" else 1
        texts = [label.get_text() for label in labels]
        shown = without_overlap(labels, which)
        if len(shown) == sum(map(bool, texts)):
            continue
        if which == 0 and not texts[0][:1].isdigit():
            axis.set_tick_params(rotation=90)
        else:
            axis.set_ticks(
                axis.get_ticklocs(), [text * (n in shown) for n, text in enumerate(texts)]
            )


def without_overlap(labels, which):
    """The numbers of those with a text that stay."""
    ends = {n: label.get_window_extent() for n, label in enumerate(labels) if label.get_text()}
    shown, last = [], -np.inf
    for number in sorted(ends, key=lambda n: ends[n].min[which] + ends[n].max[which]):
        if ends[number].min[which] > last + APART:
            shown.append(number)
            last = ends[number].max[which]
    return shown


# --- one value varies ----------------------------------------------------------------------


def groups(*axes):
    """{place on these axes: numbers of the points there}, in order."""
    found: dict[tuple, list] = {}
    for number, place in enumerate(zip(*(axis.positions for axis in axes))):
        found.setdefault(place, []).append(number)
    return dict(sorted(found.items()))


def values_at(column, here):
    return column.positions[here][np.isfinite(column.positions[here])]


def quartiles(column, here):
    found = values_at(column, here)
    return np.quantile(found, QUARTILES) if len(found) else [np.nan] * 3


def draw_line(axes, x, y, done):
    """Single points and the line of their medians, which breaks where there is no value; or dots
    for texts, whose area is the number of points. At the bottom, below all dots, are points that
    are not done, or have no value."""
    if y.categories:
        places, counts = np.unique([x.positions, y.positions], axis=1, return_counts=True)
        axes.scatter(*places, s=12 * counts, color=LINES[0], linewidth=0)
    else:
        places = [place for place, in groups(x)]
        low, medians, high = zip(*(quartiles(y, here) for here in groups(x).values()))
        axes.plot(x.positions, y.positions, "o", color=LINES[0], alpha=0.5, markeredgewidth=0)
        axes.fill_between(places, low, high, color=LINES[0], alpha=0.2, linewidth=0)
        axes.plot(places, medians, color=LINES[0])
    set_axis(axes, "x", x)
    set_axis(axes, "y", y)
    without_value = done & np.isnan(y.positions)
    for marked, marker, colour in ((~done, "x", VERMILION), (without_value, "_", BLACK)):
        if marked.any():
            axes.margins(y=0.12)
            look = {"color": colour, "transform": axes.get_xaxis_transform()}
            places = np.unique(x.positions[marked])
            axes.plot(places, np.full(len(places), 0.04), marker, **look)


# --- two values vary -----------------------------------------------------------------------


def edges(axis):
    """Borders of the cells around its places, halfway between them as the axis shows it."""
    places = np.unique(axis.positions)
    shown = np.log(places) if axis.scale == "log" else places
    half = np.diff(shown) / 2
    borders = np.concatenate([shown[:1] - half[:1], shown[:-1] + half, shown[-1:] + half[-1:]])
    return np.exp(borders) if axis.scale == "log" else borders


def middle(column, here):
    """The median of these points; of texts the most frequent one; NaN where there is none."""
    found = values_at(column, here)
    if not len(found):
        return np.nan
    return np.bincount(found.astype(int)).argmax() if column.categories else np.median(found)


def cells(x, y, value_at):
    """The values of a map: value_at(which points) for each pair of places that has points."""
    rows, columns = ({p: n for n, p in enumerate(np.unique(axis.positions))} for axis in (y, x))
    grid = np.full((len(rows), len(columns)), np.nan)
    for (at_x, at_y), here in groups(x, y).items():
        grid[rows[at_y], columns[at_x]] = value_at(here)
    return np.ma.masked_invalid(grid)


def draw_values(fig, axes, borders, z, grid):
    look = {"cmap": MAP, "norm": z.scale}
    if z.categories:
        colours = [COLOURS.get(text, LINES[n % len(LINES)]) for n, text in enumerate(z.categories)]
        look = {"cmap": ListedColormap(colours), "vmin": -0.5, "vmax": len(colours) - 0.5}
    scale = fig.colorbar(axes.pcolormesh(*borders, grid, **look), ax=axes)
    if z.categories:
        scale.ax.minorticks_off()
        scale.set_ticks(range(len(z.categories)), labels=[*map(plain, z.categories)])


def draw_map(fig, axes, x, y, z, done):
    """Medians as colours; hatched where no point is done."""
    borders = edges(x), edges(y)
    medians = cells(x, y, lambda here: middle(z, here))
    not_done = cells(x, y, lambda here: np.nan if done[here].any() else 0.0)
    axes.set_title(plain(z.heading) + ("" if medians.count() else ": no value"))
    if medians.count():
        draw_values(fig, axes, borders, z, medians)
    if not_done.count():
        axes.pcolor(*borders, not_done, **HATCHED)
    empty = done & np.isnan(z.positions)
    axes.plot(x.positions[empty], y.positions[empty], "_", color=BLACK, markersize=6)
    set_axis(axes, "x", x)
    set_axis(axes, "y", y)


# --- the picture ---------------------------------------------------------------------------


def draw_strips(panels, varying):
    """Draws what each parameter is along x at the points; the other panels go."""
    for axes, (described, lines) in zip(panels, varying):
        draw_profile(axes, described, lines, color=LINES[0], alpha=0.7)
        axes.margins(x=0)
    for axes in panels[len(varying) :]:
        axes.remove()


def draw_columns(stem, sweep, columns):
    """Writes the picture, or says why there is none."""
    by_name = {column.name: column for column in columns}
    varied = [as_typed(by_name[name], sweep) for name in sweep.varied if name not in SEEDS]
    if len(varied) not in (1, 2):
        vary = f"{len(varied)} values vary (seeds do not count)"
        return f"No picture: {vary}; pictures are drawn of one or two."
    for axis in varied:
        if None in axis.cells:
            return f"No picture: some points have no {axis.name}."
    measured = [by_name[name] for name in sweep.columns]
    if len(measured) > FEW:
        return f"No picture: there are {len(measured)} quantities; up to {FEW} are drawn."
    done = np.array([status == "done" for status in by_name["status"].cells])
    beside = min(2, len(measured))
    below, above = (-(-len(ones) // beside) for ones in (measured, sweep.along_x))
    heights = above * [STRIP] + below * [PANEL]
    size = (SINGLE if beside == 1 else DOUBLE, sum(heights))
    rows = {"nrows": len(heights), "gridspec_kw": {"height_ratios": heights}}
    fig, grid = figure(*size, **rows, ncols=beside, squeeze=False)
    draw_strips(grid[:above].flat, sweep.along_x)
    panels = grid[above:].flat
    for axes in panels[len(measured) :]:
        axes.remove()
    for axes, quantity in zip(panels, measured):
        if len(varied) == 1:
            draw_line(axes, varied[0], quantity, done)
        else:
            draw_map(fig, axes, varied[0], varied[1], quantity, done)
    line, crosses = ("line", "crosses") if len(varied) == 1 else ("colour", "hatched")
    seeds = max(len({*by_name[name].texts}) if name in by_name else 1 for name in SEEDS)
    notes = {
        f"{line}: median of {seeds} seeds{', band: quartiles' * (line == 'line')}": seeds > 1,
        f"{crosses}: not done": not done.all(),
        "strips: along x": above > 0,
        "dashes: no value": any(np.isnan(q.positions[done]).any() for q in measured),
    }
    note = "; ".join(text for text, applies in notes.items() if applies)
    fig.suptitle(plain(sweep.title) + (f" ({note})" if note else ""), fontsize=8)
    space_labels(fig)
    save(fig, stem)
    return ""


def draw(stem, sweep, columns):
    """Whatever Matplotlib raises is a reason for no picture: the table is there already."""
    try:
        return draw_columns(stem, sweep, columns)
    except Exception as error:
        return f"No picture: {(str(error) or type(error).__name__).splitlines()[0]}"
