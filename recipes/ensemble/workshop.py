"""The programs at work in a folder: runs of events, and what is measured of them."""

import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import h5py

from events.choose_events import start
from events.continuations import BRANCHES
from events.conventions import PRIMARY, Analysis, words_of
from events.fronts import LOADING_ZONE
from events.slip import until, with_peak_speed

RECORD_EVERY = "1e-5"  # [s]
NO_EVENT = 2  # exit code of `analyze front` where nothing ruptured
LONG = ("time", "slip", "histogram", "bins", "x")  # series that nobody needs for each run


def short(report):
    return report and {key: value for key, value in report.items() if key not in LONG}


def without_lines(front):
    return front and {key: value for key, value in front.items() if not isinstance(value, list)}


@contextmanager
def without_event():
    """Goes on behind the block where `analyze front` finds no event."""
    try:
        yield
    except subprocess.CalledProcessError as error:
        if error.returncode != NO_EVENT:
            raise


class Workshop:
    """Runs programs in a folder, with a load of which checkpoints are there."""

    def __init__(self, programs, load, checkpoint_every, record_options, folder):
        self.programs = Path(programs).resolve()
        self.analyze = Analysis(programs)
        self.load, self.checkpoint_every = load, float(checkpoint_every)
        self.record_options = record_options.split()
        self.folder = folder

    def path(self, name):
        return self.folder / f"{name}.h5"

    def run(self, tool, source, name, *options):
        words = [self.programs / tool, source, "-o", self.path(name), "--force", "--quiet"]
        subprocess.run([*words, *map(str, options)], stdout=sys.stderr, check=True)

    def start(self, event):
        """Makes the state shortly before an event of the load."""
        before = start(event, self.checkpoint_every)
        self.run(
            "restart", f"{self.load}-t{before['from']}.h5", "start", "--until", before["until"]
        )

    def recorded(self, source, name, *options):
        record = ["--record", self.path(f"{name}-record"), "--record-every", RECORD_EVERY]
        self.run("restart", source, name, *options, *record, *self.record_options)

    def fronts(self, name, ways):
        """{way: front of the first event of a run}; None where nothing ruptures. Speeds of a run
        that branches off count beyond the branch: the blocks before it may rupture once more."""
        record = self.path(f"{name}-record")
        found = dict.fromkeys(ways)
        with h5py.File(record) as file:
            if len(file["ruptures/time"]) == 0:
                return found
        _, x = BRANCHES.get(name.split("-")[0], (None, LOADING_ZONE))
        command, beyond = "front --event 0", ["--skip-below-x", x]
        with without_event():
            return self.analyze.each(command, record, ways, beyond)
        for way, options in ways.items():  # down to the pinned fraction of some, nothing ruptures
            with without_event():
                found[way] = self.analyze(command, record, [*beyond, *words_of(options)])
        return found

    def front(self, name):
        return self.fronts(name, {PRIMARY: {}})[PRIMARY]

    def slips(self, name, places):
        """{place: slip} at {place: x}, as rule event_slip measures it: until the front leaves its
        slow stretch, or reaches the leading edge, or to the end. With the peak of the speed."""
        front = self.front(name) or {"slow": None, "t_rupture": [None]}
        last = until(front)
        end = [] if last is None else ["--to", last]
        record = self.path(f"{name}-record")
        return {
            place: short(with_peak_speed(slip))
            for place, x in places.items()
            for slip in [self.analyze("slip", record, ["--x", x, *end])]
        }
