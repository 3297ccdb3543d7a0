"""The programs at work in a folder: runs of events, and what is measured of them."""

from contextlib import suppress

import h5py
import rupture
from rupture.errors import UsageError
from rupture.programs import output_of

from events.choose_events import start
from events.continuations import BRANCHES
from events.conventions import PRIMARY, each_way, words_of
from events.fronts import LOADING_ZONE
from events.slip import until

RECORD_EVERY = "1e-5"  # [s]
LONG = ("time", "slip", "histogram", "bins", "x")  # series that nobody needs for each run


def short(report):
    return report and {key: value for key, value in report.items() if key not in LONG}


def without_lines(front):
    return front and {key: value for key, value in front.items() if not isinstance(value, list)}


class Workshop:
    """Runs programs in a folder, with a load of which checkpoints are there."""

    def __init__(self, load, checkpoint_every, record_options, folder):
        self.load, self.checkpoint_every = load, float(checkpoint_every)
        self.record_options = record_options.split()
        self.folder = folder

    def path(self, name):
        return self.folder / f"{name}.h5"

    def run(self, tool, source, name, *options):
        output_of(tool, source, "-o", self.path(name), "--force", "--quiet", *options)

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
        with h5py.File(record, "r", locking=False) as file:
            if len(file["ruptures/time"]) == 0:
                return found
        _, x = BRANCHES.get(name.split("-")[0], (None, LOADING_ZONE))
        command, beyond = "front --event 0", ["--skip-below-x", x]
        with suppress(UsageError):
            return each_way(command, record, ways, *beyond)
        for way, options in ways.items():  # down to the pinned fraction of some, nothing ruptures
            with suppress(UsageError):
                found |= each_way(command, record, {way: {}}, *beyond, *words_of(options))
        return found

    def front(self, name):
        return self.fronts(name, {PRIMARY: {}})[PRIMARY]

    def slips(self, name, places):
        """{place: slip} at {place: x}, until the front leaves its slow stretch, or reaches the
        leading edge, or to the end."""
        front = self.front(name) or {"slow": None, "t_rupture": [None]}
        last = until(front)
        record = self.path(f"{name}-record")
        return {
            place: short(slip)
            for place, x in places.items()
            for slip in [rupture.analyze("slip", record, x=x, to=last)]
        }
