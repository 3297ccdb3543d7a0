"""map: a picture of one or several records in space and time."""

import itertools
import json
from collections import namedtuple

import numpy as np

from rupture import plotting
from rupture.errors import Failure, UsageError
from rupture.programs import analyze, output_of
from rupture.tables import imported
from rupture.tools.command_line import Parser
from rupture.tools.output import check_output, complete, origin_of, progress, say_written
from rupture.tools.window import add_window, last_rupture, open_record, window_of

SLOWEST = 1e-4  # the speed at which the colours begin [m/s]
NAMED = 8  # the most events that get a colour of their own
LINE = 0.026  # height of an event's number, of that of the panel
STRIP, APART = 0.07, 0.16  # height of the strip of a parameter, and from one to the next
Shown = namedtuple("Shown", "path record events window")  # a record, and what is drawn of it
LEGEND = "Marks at the right: an event begins."
LINE_LEGEND, SPEEDS_LEGEND = "White line: blocks rupture.", "Grey speeds exceed $c_s$."
PATCH_LEGEND = "Dashed lines: changes of {} along x."


def parse_options():
    made = Parser(
        "map RECORD... -o FILE [options]",
        "Draws a record, or an unfinished one, in space and time: the fraction of pinned"
        " junctions, the slip speed and tau/p, and the speeds of its fronts. Of several records:"
        " a row for each, with the same colours and its own time axis, and the lines of all"
        " fronts in one panel.",
        "record",
    )
    made.add_argument("records", metavar="RECORD", nargs="+", help="records, or their .part")
    made.add_output("picture to write: .png, .pdf or .svg")
    add_window(made)
    return made.parse_args()


def shown_of(options, path):
    record = open_record(path)
    events = analyze("events", path)["events"]
    try:
        begin, end = window_of(options, record, events)
    except (Failure, UsageError) as error:
        if len(options.records) == 1:
            raise
        raise type(error)(f"{path}: {error}") from None
    inside = [one for one in events if last_rupture(one) >= begin and one["t_start"] <= end]
    return Shown(path, record, inside, (begin, end))


def ruptured_before(one):
    """Which blocks had ruptured in the only event of a window before that begins."""
    event, begin = one.events[0], one.window[0]
    times = zip(event["t_before"], event["t_rupture"])
    return [before is not None or t is not None and t < begin for before, t in times]


def refuse_other_lengths(shown):
    """Refuses interfaces on which the same x/L is another place."""
    first, length = shown[0], shown[0].record.parameters["slider.L"]
    for other in shown[1:]:
        if (found := other.record.parameters["slider.L"]) != length:
            lengths = f"{first.path} has an interface of {length:g} m, {other.path} of {found:g} m"
            raise UsageError(f"{lengths}: give records of the same length")


def slip_speed(record, rows):
    """Mean speed of each block around each of these samples [m/s]."""
    return np.abs(np.gradient(record["u_x"][rows], record.time[rows], axis=0))


def tau_over_p(record, rows):
    p = record["p"][rows]
    return np.divide(record["tau"][rows], p, out=np.full(p.shape, np.nan), where=p > 0)


def draw_slip_speeds(figure, column, images):
    """`column` are the panels of these (record, rows, t_zero)."""
    colors = imported("matplotlib.colors")
    speeds = [np.maximum(slip_speed(record, rows), SLOWEST) for record, rows, _ in images]
    norm = colors.LogNorm(SLOWEST, max(10 * SLOWEST, *(speed.max() for speed in speeds)))
    for axes, speed, (record, rows, t_zero) in zip(column, speeds, images):
        image = plotting.draw_image(axes, record, speed, rows, t_zero, norm=norm, cmap="magma")
    figure.colorbar(image, ax=column, label="slip speed [m/s]", location="top", extend="min")


def draw_tau_over_p(figure, column, images):
    ratios = [tau_over_p(record, rows) for record, rows, _ in images]
    known = np.concatenate([ratio[np.isfinite(ratio)] for ratio in ratios])
    lowest, highest = np.quantile(known, (0.005, 0.995)) if len(known) else (0, 1)
    look = {"cmap": "RdYlBu_r", "vmin": lowest, "vmax": highest}
    for axes, ratio, (record, rows, t_zero) in zip(column, ratios, images):
        image = plotting.draw_image(axes, record, ratio, rows, t_zero, **look)
    figure.colorbar(image, ax=column, label=r"$\tau/p$", location="top", extend="both")


def spread(places, low, high):
    """Heights of the numbers at these places, in order: near them, but not overlapping."""
    apart = (high - low) * min(LINE, 1 / max(1, len(places)))
    heights, free = [], low
    for place in places:
        heights.append(max(place, free))
        free = heights[-1] + apart
    for number in reversed(range(len(heights))):
        heights[number] = min(heights[number], high - apart * (len(heights) - 1 - number))
    return heights


def mark_events(axes, events, t_zero, numbered):
    """Marks at the right where each event begins that does so in view, and writes its number."""
    low, high = axes.get_ylim()
    starts = {e["number"]: (e["t_start"] - t_zero) * plotting.MILLISECONDS for e in events}
    starts = {number: start for number, start in starts.items() if low <= start <= high}
    size = min(6.5, 6.5 / LINE / max(1, len(starts)))
    for (number, start), height in zip(starts.items(), spread([*starts.values()], low, high)):
        axes.plot([1, 1.03], [start, start], color=plotting.BLACK, lw=0.8, clip_on=False)
        if numbered:
            axes.plot([1.03, 1.08], [start, height], color=plotting.BLACK, lw=0.4, clip_on=False)
            place = {"fontsize": size, "va": "center", "annotation_clip": False}
            axes.annotate(f"{number}", (1.09, height), **place)


def fronts_of(shown):
    """The events that span the interface, of all events if none does; the fronts of the first of
    them by number."""
    chosen = [event for event in shown.events if event["spanning"]] or shown.events
    numbers = [event["number"] for event in chosen[:NAMED]]
    fronts = (analyze("front", shown.path, event=number) for number in numbers)
    return chosen, dict(zip(numbers, progress(fronts, len(numbers), "front")))


def patches_of(record):
    """The places where parameters change along x [x/L], by name: between two blocks, or at the ends
    of a slope."""
    between, found = (record.x[1:] + record.x[:-1]) / (2 * record.x[-1]), {}
    for name, values in record.parameters.items():
        if isinstance(values, list):
            change = np.pad(np.array(values[1:]) != values[:-1], 1)
            found[name] = between[change[1:-1] & ~(change[:-2] & change[2:])].tolist()
    return found


def mark_patches(axes, patches):
    for x in itertools.chain(*patches.values()):
        for colour, style in (("white", "-"), (plotting.BLACK, (0, (4, 4)))):  # seen on any colour
            axes.axvline(x, color=colour, linestyle=style, linewidth=0.7)


def draw_strips(row, record):
    """Draws above the maps of a row what varies along x. Returns the height of it all, of that of a
    map."""
    varying = {n: values for n, values in record.parameters.items() if isinstance(values, list)}
    known = json.loads(output_of("parameters", "--json"))["parameters"] if varying else ()
    for number, one in enumerate(one for one in known if one["name"] in varying):
        values, words = varying[one["name"]], one.get("words")
        line = record.x / record.x[-1], [*map(words.index, values)] if words else values
        height = 1.02 + APART * (number // len(row))
        strip = row[number % len(row)].inset_axes([0, height, 1, STRIP])
        plotting.draw_profile(strip, one, [line], color=plotting.BLACK, drawstyle="steps-mid")
        strip.set_xlim(0, 1)
    return APART * -(-len(varying) // len(row))


def gaps_of(record, times):
    """Behind which blocks the line of a front breaks off [indices], where it is at these times: of
    two neighbours, one was pinned again before the other ruptured."""
    pinned, gaps = record.pinned_fraction, []
    for block, pair in enumerate(zip(times[:-1], times[1:])):
        meanwhile = (record.time > min(pair)) & (record.time < max(pair))
        first = pinned[meanwhile, block + (pair[1] < pair[0])]
        if (first > plotting.PINNED_AGAIN).any():
            gaps.append(block + 1)
    return gaps


def draw_front_lines(axes, shown, t_zeros, windows):
    """Draws when the fronts of several records are where, within their windows [ms]."""
    colours = itertools.cycle(plotting.LINES)
    for one, t_zero, window, colour in zip(shown, t_zeros, windows, colours):
        label = plotting.plain_text(one.record.path.name)
        for front in fronts_of(one)[1].values():
            x, time = np.array(front["x"]), np.array(front["t_front"], dtype=float)
            shift = (time - t_zero) * plotting.MILLISECONDS
            shift[(shift < window[0]) | (shift > window[1])] = np.nan
            gaps = gaps_of(one.record, time)
            x, shift = np.insert(x / front["L"], gaps, np.nan), np.insert(shift, gaps, np.nan)
            axes.plot(x, shift, ".-", color=colour, lw=1, label=label)
            label = None
    plotting.along_interface(axes)
    legend = axes.legend(fontsize=6.5, title="fronts", loc="lower center", bbox_to_anchor=(0.5, 1))
    legend.set_in_layout(False)


def draw_speeds(axes, shown):
    """The front speeds of one record."""
    chosen, fronts = fronts_of(shown)
    names = {number: f"event {number}" for number in fronts}
    marks = itertools.cycle("o^sDv")
    colours = itertools.cycle(plotting.LINES)
    looks = {n: (name, next(colours), next(marks)) for n, name in names.items()}
    if not fronts:
        axes.text(0.5, 0.5, "no block ruptured", ha="center", transform=axes.transAxes)
        return axes.set(xlabel="$x/L$", xlim=(0, 1))
    plotting.draw_front_speeds(axes, fronts, looks)
    if not axes.get_legend_handles_labels()[0]:
        axes.text(0.5, 0.5, "fronts too short for a speed", ha="center", transform=axes.transAxes)
        return
    said = "spanning events" if chosen[0]["spanning"] else "events, of which none spans"
    if len(chosen) > NAMED:
        said = f"the first {NAMED} of {len(chosen)} {said}"
    place = {"loc": "lower center", "bbox_to_anchor": (0.5, 1)}
    legend = axes.legend(fontsize=6.5, ncols=3, title=said, title_fontsize=7, **place)
    legend.set_in_layout(False)  # there is room where the other panels have their colours


def title_of(one, t_zero):
    begin, end, start = (f"{t * plotting.MILLISECONDS:.6g} ms" for t in (*one.window, t_zero))
    title = f"{plotting.plain_text(one.record.path.name)}, {begin} to {end}"
    return title + (f"; event {one.events[0]['number']} begins at {start}" if t_zero else "")


def figure_of(shown, since_event):
    """`since_event`: whether the time of a picture of one event each begins with that."""
    single = since_event and all(len(one.events) == 1 for one in shown)
    t_zeros = [one.events[0]["t_start"] if single else 0.0 for one in shown]
    windows = [
        [(t - t_zero) * plotting.MILLISECONDS for t in one.window]
        for one, t_zero in zip(shown, t_zeros)
    ]
    images = [
        (one.record, plotting.rows_in(one.record, t_zero, window), t_zero)
        for one, t_zero, window in zip(shown, t_zeros, windows)
    ]
    figure = plotting.pyplot_without_window().figure(figsize=(10, 4.2 + 2.8 * (len(shown) - 1)))
    grid = figure.add_gridspec(len(shown), 4)
    maps = np.array(
        [[figure.add_subplot(grid[row, n]) for n in range(3)] for row in range(len(shown))]
    )
    last = figure.add_subplot(grid[:, 3])
    for axes, one, (record, _, t_zero), window in zip(maps[:, 0], shown, images, windows):
        before = ruptured_before(one) if single else False
        image = plotting.draw_pinned(axes, record, t_zero, window, line=single, ruptured=before)
    plotting.draw_pinned_scale(figure, image, maps[:, 0], location="top")
    draw_slip_speeds(figure, maps[:, 1], images)
    draw_tau_over_p(figure, maps[:, 2], images)
    patches = [patches_of(one.record) for one in shown]
    for row, one, t_zero, window, changes in zip(maps, shown, t_zeros, windows, patches):
        for panel in row:
            panel.set(ylim=window)
            mark_patches(panel, changes)
            mark_events(panel, one.events, t_zero, numbered=panel is row[2])
            panel.label_outer()
        above = draw_strips(row, one.record)
        row[0].set_ylabel("time since the event began [ms]" if single else "time [ms]")
        if len(shown) > 1:
            row[0].set_title(title_of(one, t_zero), loc="left", y=1 + above)
    maps[0, 2].set_title("event", loc="right", x=1.2, fontsize=6.5, y=1.0)
    if patches.count(patches[0]) == len(patches):
        mark_patches(last, patches[0])
    if len(shown) > 1:
        draw_front_lines(last, shown, t_zeros, windows)
        last.set_ylabel(maps[0, 0].get_ylabel())
    else:
        draw_speeds(last, shown[0])
        figure.suptitle(title_of(shown[0], t_zeros[0]))
    legends = [LINE_LEGEND] * single + [LEGEND] + [SPEEDS_LEGEND] * (len(shown) == 1)
    if varying := sorted({*itertools.chain(*patches)}):
        legends.append(PATCH_LEGEND.format(", ".join(varying)))
    figure.supxlabel(" ".join(legends), fontsize=7)
    return figure


def run():
    options = parse_options()
    check_output(options.output, options.force, (".png", ".pdf", ".svg"), options.records)
    shown = [shown_of(options, path) for path in options.records]
    refuse_other_lengths(shown)
    figure = figure_of(shown, since_event=len(shown) == 1 or options.event is not None)
    with complete(options.output, options.force) as path:
        plotting.save(figure, path, origin_of("map", [one.record for one in shown]), dpi=200)
    say_written(options.output)
