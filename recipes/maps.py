"""Prepared interfaces: the front that is triggered on one, maps of types over prestress and width
of phi (Figure 4 D), and edges, where the type changes with prestress."""

from dataclasses import dataclass
from functools import cache

from rupture.errors import Failure
from rupture.once import each, run

import frozen
from claims.samples import Sample, Samples, sampled
from measure import front_map
from measure.ways import ON_MAP, PRIMARY, WAYS, by_way
from measure.fronts import TYPES, type_on_map
from measure.tables import rounded

SEEDS = frozen.SEEDS_OF_PREPARED
FIRST = SEEDS[0]  # of each place on a map
COARSE = "--record record.h5 --record-every 1e-3"
CLASSIFIED = f"--arrived-below 0.2 {COARSE} --crossings 0.2,0.5"
STEP = 2.5e-4  # of tau_bar_0, between the two fronts beside an edge
LOWEST, HIGHEST = 0, 1200  # in steps: arrested at sigma_bar up to 0.285, and most often fast
NEAR = 4  # steps, to either side of a guess


def spaced(first, last, step):
    """Numbers so far apart."""
    count = round((last - first) / step)
    return [rounded(first + n * step) for n in range(count + 1)]


# --- samples -----------------------------------------------------------------------------------


def samples_of_seeds(function, title):
    """What is found for each seed is a sample of its own."""
    return [Sample(None, of) for _, of in sampled(function, [(seed,) for seed in SEEDS], title)]


def over_seeds(function, title):
    """The samples of a function of the seed; the picture shows the first."""
    return Samples({"": function(FIRST)}, {PRIMARY: samples_of_seeds(function, title)})


# --- fronts ------------------------------------------------------------------------------------


def start_of(interface):
    """An interface with these options of `prepare`."""
    return run(f"prepare {interface} -o start.h5")["start.h5"]


def record_of(interface, recorded=COARSE, kept=()):
    """The record of the front that is triggered there."""
    line = f"restart {start_of(interface)} -o end.h5 --until-quiet {recorded}"
    return run(line, kept)["record.h5"]


def at(tau_bar, sigma_bar, seed, options):
    """The options of `prepare` for a place on a map."""
    place = f"--tau-bar {tau_bar:.12g} --sigma-bar {sigma_bar:.12g}"
    return f"{place} {options} --set numerics.seed={seed}"


def front_at(*place):
    """A front with its type in all ways to measure that make a difference on a map."""
    record = record_of(at(*place), CLASSIFIED, ["record.h5"])
    types = by_way(f"analyze classify {record}", ON_MAP)
    front = run(f"analyze front {record}")
    return front | {"types": {way: report.type for way, report in types.items()}}


def plain_front_at(*place):
    """A front with its type as `analyze front` tells it."""
    front = run(f"analyze front {record_of(at(*place), kept=['record.h5'])}")
    return front | {"types": {PRIMARY: front.type}}


def fronts_at(places, seeds, options="", title="map", front=front_at):
    """{(tau_bar_0, sigma_bar): {seed: front}}, with None where no interface can be prepared. One
    that was prepared and could not be run is an error, not an impossible place."""
    points = [(*place, seed, options) for place in places for seed in seeds]
    worked = each(front, points, title)
    for _, sentence in worked.refused:
        if not sentence.startswith("prepare: "):
            raise Failure(f"a prepared interface was not run: {sentence}")
    found, fronts = dict(worked), dict[tuple, dict]()
    for point in points:
        tau_bar, sigma_bar, seed, _ = point
        fronts.setdefault((tau_bar, sigma_bar), {})[seed] = found.get(point)
    return fronts


# --- maps --------------------------------------------------------------------------------------


def places_of(tau_bars, sigma_bars):
    return [(tau, sigma) for tau in tau_bars for sigma in sigma_bars]


def grid_of(recipe, tau_bars, sigma_bars):
    """The places of a recipe's grid, shifted as frozen; both as (first, last, step)."""
    return places_of(
        frozen.tau_bars(recipe, spaced(*tau_bars), tau_bars[-1]),
        frozen.sigma_bars(recipe, spaced(*sigma_bars), sigma_bars[-1]),
    )


@dataclass(frozen=True)
class Map:
    """`fronts`: {place: {seed: front}} of a regular grid and of what is beside and between."""

    grid: list
    fronts: dict

    def on_grid(self):
        return {place: {FIRST: self.fronts[place][FIRST]} for place in self.grid}

    def of_seed(self, seed):
        """On the grid; the map of a seed has its own fronts where the type changes, and those of
        the first seed elsewhere."""
        return front_map.map_of_seed({place: self.fronts[place] for place in self.grid}, seed)

    def samples(self):
        seeds = [Sample(None, self.of_seed(seed)) for seed in SEEDS]
        return Samples({"": self.of_seed(FIRST)}, {PRIMARY: seeds})


def merged(*maps):
    found: dict[tuple, dict] = {}
    for place, seeds in (pair for fronts in maps for pair in fronts.items()):
        found.setdefault(place, {}).update(seeds)
    return found


def nowhere(_):
    return []


def map_of(grid, options="", between=front_map.to_refine):
    """A grid with one seed, places between those where the type changes, and several seeds next to
    another type."""
    fronts = fronts_at(grid, [FIRST], options)
    types = front_map.types_of(fronts)
    halfway = fronts_at(between(types), [FIRST], options, "map, halfway")
    places = front_map.boundary(types, front_map.types_of(halfway))
    beside = fronts_at(places, SEEDS, options, "map, where the type changes")
    return Map(grid, merged(fronts, halfway, beside))


def order(fronts, way):
    """4D: of the types on a map; medians of tau_bar_0 increase: arrested, slow, fast."""
    present, out_of_order = front_map.order_in_words(front_map.types_of(fronts, way))
    return {"types present": present, "sigma_bar out of order": out_of_order}


# --- edges -------------------------------------------------------------------------------------


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
    """Prepared interfaces with these options of `prepare`; `ways` to measure their fronts."""

    def __init__(self, options, step=STEP, ways=WAYS):
        self.options, self.step, self.ways = options, step, ways
        self.kinds = cache(self.kinds_at)

    def kinds_at(self, steps):
        """{way: type}"""
        record = record_of(f"--tau-bar {steps * self.step:g} {self.options}", CLASSIFIED)
        found = by_way(f"analyze classify {record}", self.ways)
        return {way: type_on_map(report.type) for way, report in found.items()}

    def edge(self, kind, way=PRIMARY, guess=None):
        """tau_bar_0 halfway to the first front of this type, or of one that comes after it. With a
        guess, it is sought from there."""

        def is_so(steps):
            return TYPES.index(self.kinds(steps)[way]) >= TYPES.index(kind)

        if guess is None and is_so(HIGHEST):
            ends = [LOWEST, HIGHEST]
        else:
            ends = around(is_so, HIGHEST if guess is None else round(guess / self.step))
        return round((first(is_so, *ends) - 0.5) * self.step, 6)


@cache
def edges(sigma_bar, options="", seed=FIRST):
    """{way: {"slow": lowest tau_bar_0 of a front that is not arrested, "fast": of a fast one}}"""
    interfaces = Interfaces(f"--sigma-bar {sigma_bar:.12g} --set numerics.seed={seed} {options}")
    return {way: {kind: interfaces.edge(kind, way) for kind in TYPES[1:]} for way in WAYS}


def width(edges, way=PRIMARY):
    """The width of a band of slow fronts, in tau_bar_0."""
    return edges[way]["fast"] - edges[way]["slow"]
