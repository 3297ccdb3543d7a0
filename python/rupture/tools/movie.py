"""movie: a record as a film."""

import shutil
import signal
import subprocess
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path

import numpy as np

from rupture import plotting
from rupture.errors import Failure
from rupture.programs import analyze
from rupture.tables import imported
from rupture.tools.command_line import DEFAULT, Parser, whole_number
from rupture.tools.output import check_output, complete, progress, say_written
from rupture.tools.window import add_window, open_record, window_of

ENDINGS = (".gif", ".mp4", ".webm")
CODECS = {".mp4": "libx264", ".webm": "libvpx-vp9"}
FRAMES = 150
PER_SECOND = 15
DPI = 120
SLOWEST = 0.1  # the speed at which axes and colours begin [mm/s]


def parse_options():
    made = Parser(
        "movie RECORD -o FILE [options]",
        "Films a record, or an unfinished one: the interface and, where the run had --fields, the"
        " slider above it, coloured by its speed.",
        "record",
    )
    made.add_argument("record", metavar="RECORD", help="record, or its .part")
    made.add_output("film to write: .gif, or .mp4 or .webm with ffmpeg")
    text = f"largest number of frames, {PER_SECOND} per second{DEFAULT}"
    number = partial(whole_number, least=1)
    made.add_argument("--frames", type=number, default=FRAMES, metavar="N", help=text)
    add_window(made)
    return made.parse_args()


def writer_of(path):
    animation = imported("matplotlib.animation")
    ending = Path(path).suffix.lower()
    if ending == ".gif":
        return animation.PillowWriter(fps=PER_SECOND)
    if not shutil.which("ffmpeg"):
        raise Failure(f"{ending} needs ffmpeg, which is not installed; install it, or write a .gif")
    even = ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"]
    terse = ["-loglevel", "error"]
    return animation.FFMpegWriter(fps=PER_SECOND, codec=CODECS[ending], extra_args=even + terse)


@contextmanager
def reasons_of_ffmpeg(output, path):
    """If ffmpeg stops early or writes nothing, the error gives a reason; the signal of the broken
    pipe would give none."""
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    reason = "it ended without a complete film"
    try:
        with suppress(BrokenPipeError):
            yield
            if path.stat().st_size:
                return
    except subprocess.CalledProcessError as error:
        reason = [f"exit code {error.returncode}", *error.stderr.strip().splitlines()][-1]
    raise Failure(f"cannot write {output}: ffmpeg: {reason}")


def chosen_samples(time, window, most):
    """Indices of at most so many samples in the window, evenly spaced."""
    shown = np.flatnonzero((time >= window[0]) & (time <= window[1]))
    if not len(shown):
        between = f"between {window[0]:g} s and {window[1]:g} s"
        raise Failure(f"the record has no fields {between}; choose a longer time")
    return shown[np.unique(np.linspace(0, len(shown) - 1, min(most, len(shown))).astype(int))]


class Interface:
    """Slip speed and pinned fraction of each block; `rows` are the samples of the frames."""

    def __init__(self, axes, record, rows):
        x, time = record.x / record.x[-1], record.time
        self.speed = np.abs(np.gradient(record["u_x"], time, axis=0))[rows] * 1e3  # [mm/s]
        self.pinned = record.pinned_fraction[rows]
        self.bars = axes.bar(x, self.pinned[0], x[1], color=plotting.SKY)
        axes.axhline(plotting.RUPTURED, color=plotting.BLACK, linestyle="--", linewidth=0.8)
        place = f"$x/L$ (dashed: a block ruptures at {plotting.RUPTURED})"
        axes.set(xlabel=place, ylabel="pinned fraction", xlim=(0, 1), ylim=(0, 1.02))
        right = axes.twinx()
        (self.line,) = right.plot(x, self.speed[0], color=plotting.VERMILION)
        right.set(yscale="log", ylim=(SLOWEST, max(1, 1.5 * self.speed.max())))
        right.set_ylabel("slip speed [mm/s]", color=plotting.VERMILION)
        (self.front,) = axes.plot([], [], "v", color=plotting.BLACK, markersize=6)
        axes.set_title("triangle: the front", loc="right", fontsize=7)

    def draw(self, frame, front):
        self.front.set_data([front], [0.98])
        for bar, height in zip(self.bars, self.pinned[frame]):
            bar.set_height(height)
        self.line.set_ydata(self.speed[frame])
        return f"fastest block {self.speed[frame].max():.3g} mm/s"


class Slider:
    """The blocks, coloured by their speed; `rows` are samples of the fields."""

    def __init__(self, figure, axes, record, rows):
        colors = imported("matplotlib.colors")
        self.values = speeds_of(record, rows)
        top = max(np.quantile(self.values, 0.995), 10 * SLOWEST)
        p = record.parameters
        extent = (0, 1, 0, p["slider.H"] / p["slider.L"])
        look = {"norm": colors.LogNorm(SLOWEST, top), "cmap": "magma", "origin": "lower"}
        self.image = axes.imshow(self.values[0], extent=extent, aspect="auto", **look)
        axes.set(ylabel="$z/L$", xlim=(0, 1))
        place = {"location": "top", "aspect": 40, "extend": "both"}
        figure.colorbar(self.image, ax=axes, label="speed $|v_x|$ [mm/s]", **place)

    def draw(self, frame):
        self.image.set_data(self.values[frame])


class Loading:
    """The driving force against time, with a line at the time of the frame."""

    def __init__(self, axes, record, window):
        shown = (record.time >= window[0]) & (record.time <= window[1])
        axes.plot(record.time[shown] * 1e3, record["F_T"][shown], color=plotting.BLUE)
        self.line = axes.axvline(window[0] * 1e3, color=plotting.BLACK, linewidth=0.8)
        axes.set(xlabel="time [ms]", ylabel="$F_T$ [N]")

    def draw(self, time):
        self.line.set_xdata([time * 1e3] * 2)


def front_at(time, fronts):
    """The place of the front that began last, [x/L]; NaN before the first. `fronts` are reports of
    `analyze front` in the order of time."""
    place = np.nan
    for front in fronts:
        passed = np.array(front["t_front"], dtype=float) <= time
        place = np.array(front["x"])[passed].max() / front["L"] if passed.any() else place
    return place


def speeds_of(record, rows):
    """Of the blocks [frames][Nz][Nx], in [mm/s]."""
    u_x = record["fields/u_x"].astype(float)
    if len(u_x) < 2:
        raise Failure("a film needs fields at two times or more: run with a shorter --fields")
    speed = np.gradient(u_x, record["fields/time"], axis=0)[rows]
    return np.maximum(np.abs(speed) * 1e3, SLOWEST)


def draw_frames(pyplot, record, window, fronts, options, path):
    with_bulk = "fields/u_x" in record
    times = record["fields/time"] if with_bulk else record.time
    rows = chosen_samples(times, window, options.frames)
    heights = [2] * with_bulk + [2.5, 1]
    size = (6, sum(heights) + 0.5)
    figure, axes = pyplot.subplots(len(heights), 1, figsize=size, height_ratios=heights)
    near = np.clip(np.searchsorted(record.time, times[rows] - 1e-12), 0, len(record.time) - 1)
    interface, loading = Interface(axes[-2], record, near), Loading(axes[-1], record, window)
    slider = Slider(figure, axes[0], record, rows) if with_bulk else None
    figure.suptitle(" ")
    figure.canvas.draw()
    figure.set_layout_engine("none")  # the place of everything stays as it is: half the time
    for each in figure.axes:
        each.set_title("", y=1)  # with y, no place is searched for one: a fifth of the time
    with (writer := writer_of(path)).saving(figure, str(path), DPI):
        for frame, time in enumerate(progress(times[rows], len(rows), "frame")):
            said = interface.draw(frame, front_at(time, fronts))
            loading.draw(time)
            if slider:
                slider.draw(frame)
            figure.suptitle(f"t = {time * 1e3:.3f} ms, {said}")
            writer.grab_frame()


def run():
    options = parse_options()
    check_output(options.output, options.force, ENDINGS, [options.record])
    pyplot = plotting.pyplot_without_window()
    writer_of(options.output)
    record = open_record(options.record)
    events = analyze("events", options.record)["events"]
    window = window_of(options, record, events)
    shown = [n for n, one in enumerate(events) if window[0] <= one["t_start"] <= window[1]]
    numbers = progress(shown, len(shown), "front")
    fronts = [analyze("front", options.record, event=number) for number in numbers]
    with complete(options.output, options.force) as path, reasons_of_ffmpeg(options.output, path):
        draw_frames(pyplot, record, window, fronts, options, path)
    say_written(options.output)
