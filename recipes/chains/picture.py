"""The default picture of a user's sweep: every measured quantity against the one or two values that
vary, each a Column (table.py). Seeds are repetitions: single ones and their median are shown."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.ticker import NullLocator

from measure.map_panels import COLOURS
from report.symbols import GREEK
from rupture.units import in_si
from rupture.figures import BLACK, DOUBLE, LINES, MM, SINGLE, VERMILION, figure, save
from rupture.plotting import MAP

SEEDS = ("seed", "numerics.seed")
PANEL = 62 * MM  # height [inch]
OPTIONS = {"tau-bar": "tau_bar_0", "sigma-bar": "sigma_bar"}  # symbols of options
SYMBOL = re.compile(rf"(delta )?({'|'.join(GREEK)}|[A-Za-z])(_bar)?(?:_(\w+))?")
DELTA = r"\delta "
FEW = 8  # places of a logarithmic axis that have their numbers
QUARTILES = (0.25, 0.5, 0.75)
HATCHED = {"cmap": ListedColormap(["0.85"]), "hatch": "////", "edgecolor": "0.6", "linewidth": 0}


def plain(text):
    """The text for Matplotlib, which takes what is between two $ for a formula."""
    return text.replace("$", r"\$")


def symbol_of(name, sweep):
    """A symbol of docs/model.md for Matplotlib; empty for what has none."""
    found = SYMBOL.fullmatch(OPTIONS.get(name) or sweep.symbols.get(name, ""))
    if not found:
        return ""
    change, letter, bar, index = found.groups(default="")
    letter = rf"\{letter}" if letter in GREEK else letter
    letter = rf"\bar{{{letter}}}" if bar else letter
    index = f"{{{index}}}" if len(index) < 3 else rf"\mathrm{{{index}}}"
    return f"${DELTA * bool(change)}{letter}{'_' + index if found[4] else ''}$"


def as_typed(column, sweep):
    """The column with its symbol, and numbers in the unit in which all of them were typed."""
    column = replace(column, symbol=symbol_of(column.name, sweep), axis=sweep.axis or column.scale)
    if not (unit := sweep.typed.get(column.name)) or not column.unit:
        return column
    factor = in_si(f"1{unit}")[0]
    cells = [cell and float(f"{float(cell) / factor:.12g}") for cell in column.cells]
    return replace(column, unit=unit, cells=cells)


def label_of(column):
    return replace(column, name=column.symbol or plain(column.name)).heading


def set_axis(axes, which, axis):
    axes.set(**{f"{which}label": label_of(axis), f"{which}scale": axis.scale})
    if axis.categories:
        axes.set(**{f"{which}ticks": range(len(axis.categories))})
        axes.set(**{f"{which}ticklabels": axis.categories})
        axes.set(**{f"{which}lim": (-0.5, len(axis.categories) - 0.5)})
    elif axis.axis == "log" and len(places := np.unique(axis.positions)) <= FEW:  # it varies
        getattr(axes, f"{which}axis").set_minor_locator(NullLocator())
        axes.set(**{f"{which}ticks": places, f"{which}ticklabels": [f"{p:g}" for p in places]})
    elif axis.scale == "linear":
        axes.ticklabel_format(axis=which, style="sci", scilimits=(-3, 5), useMathText=True)


def middle(column, here):
    """The median of these points; of texts the most frequent one; NaN where there is none."""
    found = column.positions[here & np.isfinite(column.positions)]
    if not len(found):
        return np.nan
    return np.bincount(found.astype(int)).argmax() if column.categories else np.median(found)


# --- one value varies ----------------------------------------------------------------------


def draw_line(axes, x, y, done):
    """Single points and the line of their medians, or dots for texts, whose area is the number of
    points. At the bottom, below all dots, are points that are not done, or have no value."""
    if y.categories:
        places, counts = np.unique([x.positions, y.positions], axis=1, return_counts=True)
        axes.scatter(*places, s=12 * counts, color=LINES[0], linewidth=0)
    else:
        known = np.isfinite(x.positions) & np.isfinite(y.positions)
        places = np.unique(x.positions[known])
        at = [y.positions[known & (x.positions == place)] for place in places]
        low, medians, high = ([np.quantile(each, q) for each in at] for q in QUARTILES)
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


def cells(x, y, value_at):
    """The values of a map: value_at(which points) for each pair of places that has points."""
    (x_places, columns), (y_places, rows) = (
        np.unique(axis.positions, return_inverse=True) for axis in (x, y)
    )
    grid = np.full((len(y_places), len(x_places)), np.nan)
    for row, column in {*zip(rows, columns)}:
        grid[row, column] = value_at((rows == row) & (columns == column))
    return np.ma.masked_invalid(grid)


def draw_values(fig, axes, borders, z, grid):
    look = {"cmap": MAP, "norm": z.scale}
    if z.categories:
        colours = [COLOURS.get(text, LINES[n % len(LINES)]) for n, text in enumerate(z.categories)]
        look = {"cmap": ListedColormap(colours), "vmin": -0.5, "vmax": len(colours) - 0.5}
    scale = fig.colorbar(axes.pcolormesh(*borders, grid, **look), ax=axes)
    if z.categories:
        scale.ax.minorticks_off()
        scale.set_ticks(range(len(z.categories)), labels=z.categories)


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
    if all(name not in by_name for name in sweep.columns):
        return "No picture: all quantities are lists."
    done = np.array([status == "done" for status in by_name["status"].cells])
    measured = [by_name[name] for name in sweep.columns if name in by_name]
    beside = min(2, len(measured))
    below = -(-len(measured) // beside)
    size = (SINGLE if beside == 1 else DOUBLE, PANEL * below)
    fig, grid = figure(*size, nrows=below, ncols=beside, squeeze=False)
    for axes in grid.flat[len(measured) :]:
        axes.remove()
    for axes, quantity in zip(grid.flat, measured):
        if len(varied) == 1:
            draw_line(axes, varied[0], quantity, done)
        else:
            draw_map(fig, axes, varied[0], varied[1], quantity, done)
    line, crosses = ("line", "crosses") if len(varied) == 1 else ("colour", "hatched")
    seeds = max(len({*by_name[name].texts}) if name in by_name else 1 for name in SEEDS)
    notes = {
        f"{line}: median of {seeds} seeds{', band: quartiles' * (line == 'line')}": seeds > 1,
        f"{crosses}: not done": not done.all(),
        "dashes: no value": any(np.isnan(q.positions[done]).any() for q in measured),
    }
    note = "; ".join(text for text, applies in notes.items() if applies)
    fig.suptitle(plain(sweep.title) + (f" ({note})" if note else ""), fontsize=8)
    save(fig, stem)
    return ""


def remove(stem):
    for suffix in (".png", ".pdf"):
        Path(f"{stem}{suffix}").unlink(missing_ok=True)


def draw(stem, sweep, columns):
    """Replaces the former picture, or returns why there is none. The table is there already, so
    whatever Matplotlib raises is a reason, too."""
    remove(stem)
    try:
        return draw_columns(stem, sweep, columns)
    except Exception as error:
        remove(stem)
        return f"No picture: {(str(error) or type(error).__name__).splitlines()[0]}"
