"""map: a picture of a record in space and time."""

import itertools

import numpy as np

from rupture import plotting
from rupture.programs import analyze
from rupture.tables import imported
from rupture.tools.command_line import Parser
from rupture.tools.output import check_output, complete, progress, say_written
from rupture.tools.window import add_window, open_record, window_of

SLOWEST = 1e-4  # the speed at which the colours begin [m/s]
NAMED = 8  # the most events that get a colour of their own
LINE = 0.026  # height of an event's number, of that of the panel
LEGEND = "White line: 30 % of the junctions are pinned. Marks at the right: an event begins."


def parse_options():
    made = Parser(
        "map RECORD -o FILE [options]",
        "Draws a record, or an unfinished one, in space and time: the fraction of pinned"
        " junctions, the slip speed and tau/p, and the speeds of its fronts.",
        "record",
    )
    made.add_argument("record", metavar="RECORD")
    made.add_output("picture to write: .png, .pdf or .svg")
    add_window(made)
    return made.parse_args()


def slip_speed(record, rows):
    """Mean speed of each block around each of these samples [m/s]."""
    return np.abs(np.gradient(record["u_x"][rows], record.time[rows], axis=0))


def draw_slip_speed(figure, axes, record, rows, t_zero):
    colors = imported("matplotlib.colors")
    speed = np.maximum(slip_speed(record, rows), SLOWEST)
    scale = colors.LogNorm(SLOWEST, max(speed.max(), 10 * SLOWEST))
    image = plotting.draw_image(axes, record, speed, rows, t_zero, norm=scale, cmap="magma")
    figure.colorbar(image, ax=axes, label="slip speed [m/s]", location="top", extend="min")


def draw_tau_over_p(figure, axes, record, rows, t_zero):
    p = record["p"][rows]
    ratio = np.divide(record["tau"][rows], p, out=np.full(p.shape, np.nan), where=p > 0)
    lowest, highest = np.nanquantile(ratio, (0.005, 0.995)) if (p > 0).any() else (0, 1)
    look = {"cmap": "RdYlBu_r", "vmin": lowest, "vmax": highest}
    image = plotting.draw_image(axes, record, ratio, rows, t_zero, **look)
    figure.colorbar(image, ax=axes, label=r"$\tau/p$", location="top", extend="both")


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
    """Marks at the right where each event begins, and writes its number."""
    low, high = axes.get_ylim()
    starts = [(event["t_start"] - t_zero) * plotting.MILLISECONDS for event in events]
    size = min(6.5, 6.5 / LINE / max(1, len(events)))
    for event, start, height in zip(events, starts, spread(starts, low, high)):
        axes.plot([1, 1.03], [start, start], color=plotting.BLACK, lw=0.8, clip_on=False)
        if numbered:
            axes.plot([1.03, 1.08], [start, height], color=plotting.BLACK, lw=0.4, clip_on=False)
            place = {"fontsize": size, "va": "center", "annotation_clip": False}
            axes.annotate(f"{event['number']}", (1.09, height), **place)


def draw_speeds(axes, path, events):
    """The front speeds of the events that span the interface; of all events if none does."""
    chosen = [event for event in events if event["spanning"]] or events
    names = {event["number"]: f"event {event['number']}" for event in chosen[:NAMED]}
    speeds = (analyze("front", path, event=number) for number in names)
    fronts = dict(zip(names, progress(speeds, len(names), "front")))
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


def figure_of(record, path, events, window):
    pyplot = plotting.pyplot_without_window()
    figure, axes = pyplot.subplots(1, 4, figsize=(10, 4.2))
    axes[1].sharey(axes[0])
    axes[2].sharey(axes[0])
    single = len(events) == 1
    t_zero = events[0]["t_start"] if single else 0.0
    shown = [(t - t_zero) * plotting.MILLISECONDS for t in window]
    rows = plotting.rows_in(record, t_zero, shown)
    image = plotting.draw_pinned(axes[0], record, t_zero, shown)
    plotting.draw_pinned_scale(figure, image, axes[0], location="top")
    draw_slip_speed(figure, axes[1], record, rows, t_zero)
    draw_tau_over_p(figure, axes[2], record, rows, t_zero)
    for panel in axes[:3]:
        panel.set(ylim=shown)
        mark_events(panel, events, t_zero, numbered=panel is axes[2])
        panel.label_outer()
    axes[2].set_title("event", loc="right", x=1.2, fontsize=6.5, y=1.0)
    begin, end, start = (f"{t * plotting.MILLISECONDS:.6g} ms" for t in (*window, t_zero))
    title = f"{plotting.plain_text(record.path.name)}, {begin} to {end}"
    title += f"; event {events[0]['number']} begins at {start}" if single else ""
    axes[0].set_ylabel("time since the event began [ms]" if single else "time [ms]")
    draw_speeds(axes[3], path, events)
    figure.suptitle(title)
    figure.supxlabel(LEGEND, fontsize=7)
    return figure


def run():
    options = parse_options()
    check_output(options.output, options.force, (".png", ".pdf", ".svg"), [options.record])
    record = open_record(options.record)
    events = analyze("events", options.record)["events"]
    begin, end = window_of(options, record, events)
    shown = [one for one in events if one["t_end"] >= begin and one["t_start"] <= end]
    figure = figure_of(record, options.record, shown, (begin, end))
    with complete(options.output, options.force) as path:
        figure.savefig(path, dpi=200)
    say_written(options.output)
