"""Where fronts on prepared interfaces change from arrested to slow and from slow to fast:

    edges.py FOLDER SIGMA_BAR [OPTION ...]

bisects tau_bar_0 at one sigma_bar, with options of `prepare` (--set junctions.mu_d=0). Works in
FOLDER, which is deleted at the end. Prints, under each convention of a map,

    {"slow": lowest tau_bar_0 of a front that is not arrested, "fast": of one that is fast}

each halfway between two fronts STEP apart.
"""

from functools import cache
from pathlib import Path

from rupture.programs import output_of

from data.scratch import scratch
from events.conventions import PRIMARY, each_way
from maps.front_map import MEASURES, TYPES, type_on_map

STEP = 2.5e-4  # of tau_bar_0
LOWEST, HIGHEST = 0, 1200  # in steps: arrested at sigma_bar up to 0.285, and most often fast
NEAR = 4  # steps, to either side of a guess


def first(is_so, low, high):
    """The lowest number for which it is so; is_so(low) is not, is_so(high) is."""
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if is_so(middle) else (middle, high)
    return high


def around(is_so, guess):
    """A bracket for first() that begins at a guess, and doubles until it holds the change."""
    so, near = is_so(guess), guess
    width = -NEAR if so else NEAR
    while is_so(near + width) == so:
        near, width = near + width, 2 * width
    return sorted((near, near + width))


class Interfaces:
    """Prepared interfaces of one sigma_bar, run in a folder; `ways` to measure
    their fronts."""

    def __init__(self, folder, options, step=STEP, ways=MEASURES):
        self.folder = folder
        self.options = options
        self.step = step
        self.ways = ways

    @cache  # conventions share fronts
    def kinds(self, steps):
        """{way: type}"""
        start, end, record = (self.folder / f"{name}.h5" for name in ("start", "end", "record"))
        silent = ["--quiet", "--force"]
        prestress = ["--tau-bar", f"{steps * self.step:g}"]
        output_of("prepare", *prestress, *self.options, "-o", start, *silent)
        recorded = ["--record", record, "--record-every", "1e-3", "--crossings", "0.2,0.5"]
        until = ["--until-quiet", "--arrived-below", 0.2, "--threads", 1]
        output_of("restart", start, "-o", end, *until, *recorded, *silent)
        found = each_way("classify", record, self.ways)
        return {way: type_on_map(report["type"]) for way, report in found.items()}

    def edge(self, kind, guess=None, way=PRIMARY):
        """Halfway to the first front of this type, or of one that comes after it. With a guess, it
        is sought from there."""

        def is_so(steps):
            return TYPES.index(self.kinds(steps)[way]) >= TYPES.index(kind)

        if guess is None and is_so(HIGHEST):
            ends = [LOWEST, HIGHEST]
        else:
            ends = around(is_so, HIGHEST if guess is None else round(guess / self.step))
        return round((first(is_so, *ends) - 0.5) * self.step, 6)


def main(folder, sigma_bar, *options):
    with scratch(Path(folder)) as folder:
        interfaces = Interfaces(folder, ["--sigma-bar", sigma_bar, *options])
        return {
            way: {kind: interfaces.edge(kind, way=way) for kind in TYPES[1:]} for way in MEASURES
        }
