"""map: a picture of a record in space and time."""

import itertools

import numpy as np

from rupture import plotting
from rupture.programs import analyze
from rupture.tables import imported
from rupture.tools.command_line import Parser
from rupture.tools.output import check_output, complete
from rupture.tools.window import add_window, events_in, open_record, window_of

SLOWEST = 1e-4  # the speed at which the colours begin [m/s]
NAMED = 8  # the most events that get a colour of their own


def parser():
    made = Parser(
        "map",
        "RECORD -o FILE",
        "Draws a record, or an unfinished one, in space and time: the fraction of pinned"
        " junctions, the slip speed and tau/p, and the speeds of its fronts.",
        "picture of a record in space and time",
        "record",
    )
    made.add_argument("record", metavar="RECORD", help="record, or the .part of one")
    made.add_output("picture to write: .png, .pdf or .svg")
    add_window(made)
    made.add_common()
    return made


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
    image = plotting.draw_image(axes, record, ratio, rows, t_zero, cmap="cividis")
    figure.colorbar(image, ax=axes, label=r"$\tau/p$", location="top")


def mark_events(axes, events, t_zero):
    """A number at the right where each event begins, unless it would lie on another."""
    low, high = axes.get_ylim()
    free = low
    for event in events:
        start = (event["t_start"] - t_zero) * plotting.MILLISECONDS
        axes.plot([1, 1.02], [start, start], color=plotting.BLACK, lw=0.8, clip_on=False)
        if start >= free:
            text = f"{event['number']}"
            axes.annotate(text, (1.03, start), fontsize=6.5, va="center", annotation_clip=False)
            free = start + 0.022 * (high - low)


def draw_speeds(axes, path, events):
    """Those of the events that span the interface; of all if none does."""
    chosen = [event for event in events if event["spanning"]] or events
    names = {event["number"]: f"event {event['number']}" for event in chosen[:NAMED]}
    fronts = {number: analyze("front", path, event=number) for number in names}
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
    legend = axes.legend(fontsize=6.5, ncols=3, loc="lower center", bbox_to_anchor=(0.5, 1))
    legend.set_in_layout(False)  # there is room where the other panels have their colours


def figure_of(record, path, events, window):
    pyplot = plotting.pyplot_without_window()
    pyplot.rcParams.update(plotting.STYLE)
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
        mark_events(panel, events, t_zero)
        panel.label_outer()
    axes[2].set_title("event", loc="right", x=1.13, fontsize=6.5, y=0.98)
    axes[0].set_ylabel(f"time [ms] after {t_zero:.6g} s" if single else "time [ms]")
    draw_speeds(axes[3], path, events)
    name = plotting.plain_text(record.path.name)
    figure.suptitle(f"{name}, {window[0]:.6g} s to {window[1]:.6g} s")
    return figure


def run():
    made = parser()
    options = made.parse_args()
    check_output(options.output, options.force, (".png", ".pdf", ".svg"), [options.record])
    record = open_record(options.record)
    events = analyze("events", options.record)["events"]
    begin, end = window_of(options, record, events)
    shown = events_in(events, begin, end)
    figure = figure_of(record, options.record, shown, (begin, end))
    with complete(options.output, options.force) as path:
        figure.savefig(path, dpi=200)
