"""The default picture of a user's sweep: every measured quantity against the one or two values that
vary, each a Column (report.py). Seeds are repetitions: single ones and their median are shown."""

from collections import Counter
from pathlib import Path

import numpy as np
from matplotlib.colors import ListedColormap

from maps.map_panels import COLOURS
from pictures.plotting import BLACK, DOUBLE, LINES, MAP, MM, SINGLE, VERMILION, figure, save

SEEDS = ("seed", "numerics.seed")
PANEL = 62 * MM  # height [inch]
HATCHED = {"cmap": ListedColormap(["0.85"]), "hatch": "////", "edgecolor": "0.6", "linewidth": 0}


def plain(text):
    """For Matplotlib, which takes what is between two $ for a formula."""
    return text.replace("$", r"\$")


def set_axis(axes, which, axis):
    axes.set(**{f"{which}label": plain(axis.heading), f"{which}scale": axis.scale})
    if axis.categories:
        axes.set(**{f"{which}ticks": range(len(axis.categories))})
        axes.set(**{f"{which}ticklabels": axis.categories})
        axes.set(**{f"{which}lim": (-0.5, len(axis.categories) - 0.5)})
    elif axis.scale == "linear":
        axes.ticklabel_format(axis=which, style="sci", scilimits=(-3, 5), useMathText=True)


def middle(axis, numbers):
    """Their median; of texts the most frequent one; NaN where there is none."""
    numbers = numbers[np.isfinite(numbers)]
    if not len(numbers):
        return np.nan
    return Counter(sorted(numbers)).most_common(1)[0][0] if axis.categories else np.median(numbers)


# --- one value varies ----------------------------------------------------------------------


def draw_texts(axes, x, y):
    """The area of a dot is the number of points."""
    counts = Counter(zip(x.positions, y.positions))
    for (place, category), count in counts.items():
        axes.scatter(place, category, s=12 * count, color=LINES[0], linewidth=0)


def draw_numbers(axes, x, y):
    """Single points, and the line of medians."""
    places = np.unique(x.positions)
    medians = np.array([middle(y, y.positions[x.positions == place]) for place in places])
    known = np.isfinite(medians)
    axes.plot(x.positions, y.positions, "o", color=LINES[0], alpha=0.5, markeredgewidth=0)
    axes.plot(places[known], medians[known], color=LINES[0])


def mark(axes, places, marker, colour):
    """At the bottom, below all dots."""
    axes.margins(y=0.12)
    bottom = np.full(len(places), 0.04)
    axes.plot(places, bottom, marker, color=colour, transform=axes.get_xaxis_transform())


def draw_line(axes, x, y, done):
    if y.categories:
        draw_texts(axes, x, y)
    else:
        draw_numbers(axes, x, y)
    set_axis(axes, "x", x)
    set_axis(axes, "y", y)
    if not done.all():
        mark(axes, np.unique(x.positions[~done]), "x", VERMILION)
    if (empty := done & np.isnan(y.positions)).any():
        mark(axes, np.unique(x.positions[empty]), "_", BLACK)


# --- two values vary -----------------------------------------------------------------------


def edges(axis, places):
    """Borders of the cells around these places, halfway between them as the axis shows it."""
    if axis.categories:
        return np.arange(len(places) + 1) - 0.5
    shown = np.log(places) if axis.scale == "log" else places
    inner = (shown[1:] + shown[:-1]) / 2
    outer = np.concatenate([[2 * shown[0] - inner[0]], inner, [2 * shown[-1] - inner[-1]]])
    return np.exp(outer) if axis.scale == "log" else outer


def cells(x, y, value_at):
    """The values of a map: value_at(which points) for each pair of places that has points."""
    (x_places, columns), (y_places, rows) = (
        np.unique(axis.positions, return_inverse=True) for axis in (x, y)
    )
    grid = np.full((len(y_places), len(x_places)), np.nan)
    for row, column in {*zip(rows, columns)}:
        grid[row, column] = value_at((rows == row) & (columns == column))
    return edges(x, x_places), edges(y, y_places), grid


def draw_values(fig, axes, borders, z, grid):
    look = {"cmap": MAP, "norm": z.scale}
    if z.categories:
        colours = [COLOURS.get(text, LINES[n % len(LINES)]) for n, text in enumerate(z.categories)]
        look = {"cmap": ListedColormap(colours), "vmin": -0.5, "vmax": len(colours) - 0.5}
    image = axes.pcolormesh(*borders, np.ma.masked_invalid(grid), **look)
    scale = fig.colorbar(image, ax=axes)
    if z.categories:
        scale.ax.minorticks_off()
        scale.set_ticks(range(len(z.categories)), labels=z.categories)


def draw_map(fig, axes, x, y, z, done):
    """Medians as colours; hatched where no point is done."""
    *borders, medians = cells(x, y, lambda here: middle(z, z.positions[here]))
    not_done = cells(x, y, lambda here: np.nan if done[here].any() else 0.0)[2]
    measured = np.isfinite(medians).any()
    axes.set_title(plain(z.heading) + ("" if measured else ": no value"))
    if measured:
        draw_values(fig, axes, borders, z, medians)
    if np.isfinite(not_done).any():
        axes.pcolor(*borders, np.ma.masked_invalid(not_done), **HATCHED)
    empty = done & np.isnan(z.positions)
    axes.plot(x.positions[empty], y.positions[empty], "_", color=BLACK, markersize=6)
    set_axis(axes, "x", x)
    set_axis(axes, "y", y)


# --- the picture ---------------------------------------------------------------------------


def panels(number):
    """A figure with so many axes, two beside each other."""
    beside = min(2, number)
    below = -(-number // beside)
    size = (SINGLE if beside == 1 else DOUBLE, PANEL * below)
    fig, grid = figure(*size, nrows=below, ncols=beside, squeeze=False)
    for axes in grid.flat[number:]:
        axes.remove()
    return fig, grid.flat[:number]


def draw_columns(stem, sweep, columns):
    """Writes the picture, or says why there is none."""
    by_name = {column.name: column for column in columns}
    varied = [name for name in sweep.varied if name not in SEEDS]
    if len(varied) not in (1, 2):
        return f"No picture: {len(varied)} values vary; pictures are drawn of one or two."
    for name in varied:
        if None in by_name[name].cells:
            return f"No picture: some points have no {name}."
    done = np.array([status == "done" for status in by_name["status"].cells])
    over = [by_name[name] for name in varied]
    measured = [by_name[name] for name in sweep.columns]
    fig, all_axes = panels(len(measured))
    for axes, quantity in zip(all_axes, measured):
        if len(varied) == 1:
            draw_line(axes, over[0], quantity, done)
        else:
            draw_map(fig, axes, over[0], over[1], quantity, done)
    seeds = max(len({*by_name[name].texts}) if name in by_name else 1 for name in SEEDS)
    notes = {
        f"{'line' if len(varied) == 1 else 'colour'}: median of {seeds} seeds": seeds > 1,
        f"{'crosses' if len(varied) == 1 else 'hatched'}: not done": not done.all(),
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
    """The same in the place of a former picture. The table is there already, so that all that
    Matplotlib may raise is a reason, too."""
    remove(stem)
    try:
        return draw_columns(stem, sweep, columns)
    except Exception as error:
        remove(stem)
        return f"No picture: {(str(error) or type(error).__name__).splitlines()[0]}"
