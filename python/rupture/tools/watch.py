"""watch: a run in progress, by the record that it writes."""

import fcntl
import os
import shutil
import struct
import sys
import time
from pathlib import Path

import numpy as np

from rupture import plotting
from rupture.errors import Failure
from rupture.files import Record, open_file
from rupture.tables import imported
from rupture.tools.command_line import CLEAR, DEFAULT, Parser, plural

LEVELS = " ▁▂▃▄▅▆▇█"
SAMPLES = 1000  # the last ones, shown in a window
MOMENT = 0.3  # [s]
WANTED = "give the unfinished record (RECORD.h5.part) of a run"
FLOCK = "hhqqi0q"  # struct flock: l_type, l_whence, l_start, l_len, l_pid


def parse_options():
    made = Parser(
        "watch RECORD.part [options]",
        "Shows the interface while a run is in progress, in a window or, without a display, as"
        " text: the fraction of pinned junctions along it. Ends when the record is finished.",
        "record",
    )
    made.add_argument("record", metavar="RECORD.part", help="record of a run in progress")
    made.add_time("--every", f"time between updates{DEFAULT}", least=0.01, most=86400, default=1.0)
    made.add_argument("--text", action="store_true", help="text, even if there is a display")
    return made.parse_args()


def current(path):
    """The record as it is now: the `.part`, or the finished record."""
    whole = Path(str(path).removesuffix(".part"))
    if not whole.name:
        raise Failure(f"'{path}' names no file; {WANTED}")
    part = whole.with_name(whole.name + ".part")
    for existing in (part, whole):
        try:
            record = open_file(existing)
        except Failure:
            if existing.exists():
                raise
            continue
        if isinstance(record, Record):
            return record
        raise Failure(f"{existing} is a checkpoint; {WANTED}")
    raise Failure(f"{part} does not exist; {WANTED}")


def is_being_written(path):
    """Whether a run holds its lock (docs/decisions/0008-records-in-pieces.md); True if the file
    system cannot tell."""
    try:
        with open(path, "rb") as file:
            asked = struct.pack(FLOCK, fcntl.F_WRLCK, 0, 0, 0, 0)
            answer = fcntl.fcntl(file, fcntl.F_OFD_GETLK, asked)
    except OSError:
        return True
    return struct.unpack(FLOCK, answer)[0] != fcntl.F_UNLCK


def latest(path):
    """The record as it is now. Raises Failure if its run was killed. It looks twice, because a run
    takes a moment to take its lock and to finish its record."""
    for pause in (MOMENT, 0.0):
        record = current(path)
        if record.finished or is_being_written(record.path):
            return record
        time.sleep(pause)
    hint = f"rupture finish {record.path} -o NEW.h5 makes a record of it"
    raise Failure(f"the run that wrote {record.path} was killed; {hint}")


def bar(fraction, width):
    """A character per block, or for every n-th where there are too many."""
    shown = fraction[:: max(1, -(-len(fraction) // width))]
    return "".join(LEVELS[round(f * (len(LEVELS) - 1))] for f in shown)


def text_of(record):
    if not len(record.time):
        return "no sample yet"
    width = shutil.get_terminal_size().columns - 50
    pinned = bar(record["pinned"][-1] / record.springs_per_block, max(width, 10))
    force, count = record["F_T"][-1], plural(len(record.ruptures.time), "rupture")
    return f"t = {record.time[-1]:.6f} s  F_T = {force:7.2f} N  {count:>14}  |{pinned}|"


class Text:
    """One line that is rewritten in a terminal; elsewhere, a new line each time."""

    def draw(self, record):
        start, end = (CLEAR, "") if sys.stdout.isatty() else ("", "\n")
        print(start + text_of(record), end=end, flush=True)

    pause = staticmethod(time.sleep)

    def finish(self):
        print("\nfinished" if sys.stdout.isatty() else "finished")


class Window:
    def __init__(self, pyplot):
        self.pyplot = pyplot
        pyplot.rcdefaults()
        pyplot.rcParams.update(plotting.STYLE)
        self.figure, self.axes = pyplot.subplots(figsize=(5, 5))
        pyplot.show(block=False)

    def draw(self, record):
        self.axes.clear()
        if len(record.time) > 1:
            shown = record.time[-SAMPLES:][[0, -1]] * plotting.MILLISECONDS
            plotting.draw_pinned(self.axes, record, 0.0, shown)
        self.axes.set_title(f"pinned fraction until t = {np.max(record.time, initial=0):.6f} s")

    def pause(self, seconds):
        self.pyplot.pause(seconds)
        if not self.pyplot.fignum_exists(self.figure.number):
            sys.exit()  # the window was closed

    def finish(self):
        self.pyplot.show()


def view(options):
    if options.text:
        return Text()
    pyplot = imported("matplotlib.pyplot")
    try:
        if not os.environ.get("MPLBACKEND"):  # nor may a matplotlibrc here name any module
            pyplot.switch_backend(dict.get(pyplot.rcParamsDefault, "backend"))
        pyplot.figure()  # only now are the display and its toolkit looked for
    except ImportError:
        return Text()
    pyplot.close()
    interactive = pyplot.get_backend() in imported("matplotlib.rcsetup").interactive_bk
    return Window(pyplot) if interactive else Text()


def run():
    options = parse_options()
    record, shown = latest(options.record), view(options)
    while True:
        shown.draw(record)
        if record.finished:
            return shown.finish()
        shown.pause(options.every)
        record = latest(options.record)
