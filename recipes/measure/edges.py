"""Where fronts on prepared interfaces change from arrested to slow and from slow to fast, as the
script of a chain:

    edges = script ../measure/edges.py {values}

bisects tau_bar_0 under these options of `prepare` (--sigma-bar 0.1 --set junctions.mu_d=0). It
reports, under each convention of a map,

    {"slow": lowest tau_bar_0 of a front that is not arrested, "fast": of one that is fast}

each halfway between two fronts STEP apart.
"""

from functools import cache

from rupture.programs import output_of

from measure.conventions import CONVENTIONS, PRIMARY, each_way
from measure.fronts import TYPES, type_on_map

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
    """Prepared interfaces with these options, run in the current folder; `ways` to measure their
    fronts."""

    def __init__(self, options, step=STEP, ways=CONVENTIONS):
        self.options = options
        self.step = step
        self.ways = ways

    @cache  # conventions share fronts
    def kinds(self, steps):
        """{way: type}"""
        silent = ["--quiet", "--force"]
        prestress = ["--tau-bar", f"{steps * self.step:g}"]
        output_of("prepare", *prestress, *self.options, "-o", "start.h5", *silent)
        recorded = ["--record", "record.h5", "--record-every", "1e-3", "--crossings", "0.2,0.5"]
        until = ["--until-quiet", "--arrived-below", 0.2, "--threads", 1]
        output_of("restart", "start.h5", "-o", "end.h5", *until, *recorded, *silent)
        found = each_way("classify", "record.h5", self.ways)
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


def main(*options):
    interfaces = Interfaces(options)
    return {
        way: {kind: interfaces.edge(kind, way=way) for kind in TYPES[1:]} for way in CONVENTIONS
    }
