"""Maps of front types (measure/front_map.py, maps.py, robustness), shares of pairs (pairs.py)."""

from pytest import mark, raises
from rupture.errors import Failure

import maps
from conftest import approx
from examples import front, map_of
from measure import front_map
from measure.ways import PRIMARY
from measure.front_map import out_of_order
from measure.pairs import share_of_lower
from robustness import commands as robustness

ARRESTED, SLOW, FAST = map(front, front_map.TYPES)


class TestFronts:
    """Of seeds 1 and 2 at (0.1, 0)."""

    def fronts(self, monkeypatch, sentence=""):
        class Found(list):
            refused = [((0.1, 0, 2, ""), sentence)] if sentence else []

        found = Found([((0.1, 0, 1, ""), FAST)])
        monkeypatch.setattr(maps, "each", lambda *_: found)
        return maps.fronts_at([(0.1, 0)], [1, 2])

    def test_an_interface_that_cannot_be_prepared_has_no_front(self, monkeypatch):
        found = self.fronts(monkeypatch, "prepare: no such phi")
        assert found == {(0.1, 0): {1: FAST, 2: None}}

    def test_one_that_could_be_prepared_and_not_run_is_an_error(self, monkeypatch):
        with raises(Failure, match="time step is too long"):
            self.fronts(monkeypatch, "restart: the time step is too long")

    def test_a_front_has_its_types_by_each_way(self, monkeypatch):
        class Type:
            def __init__(self, kind):
                self.type = kind

        types = {PRIMARY: Type("none"), "stencil 3": Type("slow")}
        monkeypatch.setattr(maps, "record_of", lambda *_: "record.h5")
        monkeypatch.setattr(maps, "by_way", lambda *_: types)
        monkeypatch.setattr(maps, "run", lambda _: {"type": "none"})
        found = maps.front_at(0.1, 0, 1, "")
        kinds = front_map.front_type(found), front_map.front_type(found, "stencil 3")
        assert kinds == ("arrested", "slow")


def test_a_map_has_what_is_halfway_and_seeds_where_the_type_changes(monkeypatch):
    """On a grid of two tau_bar_0 and two sigma_bar, fast from 0.15 on."""
    asked = []

    def fronts_at(places, seeds, *_):
        asked.append((places, [*seeds]))
        return {(t, s): dict.fromkeys(seeds, FAST if t > 0.14 else SLOW) for t, s in places}

    monkeypatch.setattr(maps, "fronts_at", fronts_at)
    grid = maps.places_of((0.1, 0.2), (0, 1))
    found = maps.map_of(grid)
    halfway = [(0.15, 0), (0.15, 1)]
    changes = [(0.1, 0), (0.1, 1), *halfway]
    first = maps.SEEDS[:1]
    assert asked == [(grid, first), (halfway, first), (changes, maps.SEEDS)]
    assert found.fronts.keys() == {*grid, *halfway}
    fourth = maps.SEEDS[3]
    assert [*found.of_seed(fourth)[0.1, 0]] == [fourth] and [*found.of_seed(fourth)[0.2, 0]] == [
        fourth
    ]
    assert found.on_grid()[0.1, 0] == {maps.FIRST: SLOW}
    assert maps.map_of(grid, "", maps.nowhere).fronts.keys() == {*grid}


# tau_bar_0 upwards, sigma_bar to the right:  slow     fast
#                                             arrested slow
GRID = {(0.1, 0.0): "arrested", (0.1, 0.2): "slow", (0.2, 0.0): "slow", (0.2, 0.2): "fast"}
SLOW_FROM = {(0.0, 0.0): "arrested", (0.1, 0.0): "slow"}
FAST_FROM = {(0.0, 0.0): "arrested", (0.1, 0.0): "fast"}
SLOW_BETWEEN = {(0.05, 0.0): "slow"}
BACK = {(0.0, 0.0): "arrested", (0.1, 0.0): "slow", (0.2, 0.0): "slow"}
BACK |= {(0.0, 0.1): "slow", (0.1, 0.1): "impossible", (0.2, 0.1): "arrested"}
SEEDS = {(0.0, 0.0): {1: SLOW}, (0.1, 0.0): {1: SLOW, 2: FAST}}
below_left = front_map.fast_below_left_of_arrested
MAPS = [  # a function, its arguments, and what it finds
    # The type `none` of analyze counts as arrested.
    *((front_map.type_on_map, [kind], kind) for kind in ("arrested", "slow", "fast", "")),
    (front_map.type_on_map, ["none"], "arrested"),
    # Only the edge of the fast region is refined, without rounding noise.
    (front_map.to_refine, [GRID], [(0.15, 0.2), (0.2, 0.1)]),
    # Nothing changes towards what cannot be prepared.
    (front_map.changes, [{(0.0, 0.0): "fast", (0.1, 0.0): "impossible"}], []),
    # The place halfway decides which neighbour is at the boundary; a third type makes two.
    (front_map.boundary, [SLOW_FROM], [(0.0, 0.0), (0.1, 0.0)]),
    (front_map.boundary, [SLOW_FROM, SLOW_BETWEEN], [(0.0, 0.0), (0.05, 0.0)]),
    (front_map.boundary, [FAST_FROM, SLOW_BETWEEN], [(0.0, 0.0), (0.05, 0.0), (0.1, 0.0)]),
    # A fast seed below left of an arrested one, also of the same place, is out of order.
    (below_left, [{(0, 1): {1: "slow", 2: "fast"}, (1, 1): {1: "arrested"}}], [((0, 1), (1, 1))]),
    (below_left, [{(0, 0): {1: "fast", 2: "arrested"}}], [((0, 0), (0, 0))]),
    (below_left, [{(0, 2): {1: "fast"}, (1, 1): {1: "arrested"}}], []),  # at wider phi
    (out_of_order, [{(0.0, 0.0): {1: FAST}, (0.1, 0.1): {1: ARRESTED}}], {(0.0, 0.0)}),
    # A step back is seen along tau_bar_0.
    (front_map.steps_back, [BACK], {(0.2, 0.1)}),
    (front_map.steps_back, [BACK | {(0.2, 0.0): "arrested"}], {(0.2, 0.0), (0.2, 0.1)}),
    # A map has its own fronts or those of the first seed.
    (front_map.map_of_seed, [SEEDS, 2], {(0.0, 0.0): {2: SLOW}, (0.1, 0.0): {2: FAST}}),
    # The share counts pairs of equal strata only.
    (share_of_lower, [[([1.0], [2.0]), ([5.0], [6.0])]], 1.0),
    (share_of_lower, [[([1.0, 2.0], [1.5, 2.0])]], 0.625),
    (share_of_lower, [[([1.0], [])]], None),
]


@mark.parametrize("function, arguments, found", MAPS)
def test_what_is_found_on_maps_and_in_pairs(function, arguments, found):
    assert function(*arguments) == found


class TestSeveralMaps:
    def test_a_place_at_the_boundary_of_one_slider_is_enough(self, monkeypatch):
        """Also for the other sliders; each of their maps has own fronts of the seed there."""
        grids = {"one": map_of("slow", "fast", "fast"), "other": map_of("fast", "fast", "fast")}
        asked = []

        def fronts_at(places, seeds, options, title):
            asked.append((places, [*seeds], options))
            return {place: {seed: SLOW for seed in seeds} for place in places}

        monkeypatch.setattr(robustness, "SLIDERS", {"one": "--a", "other": "--b"})
        monkeypatch.setattr(robustness, "geometry", lambda: grids)
        monkeypatch.setattr(robustness, "fronts_at", fronts_at)
        found = robustness.geometry_of_seed(3)
        places = [(0.0, 0.0), (0.1, 0.0)]
        assert asked == [(places, [3], "--a"), (places, [3], "--b")]
        kinds = [front_map.front_type(of[3]) for of in found["other"].values()]
        assert kinds == ["slow", "slow", "fast"]

    def test_the_worst_of_several_maps_counts_in_each_way(self):
        mixed = front("slow", **{"stencil 3": "fast"})
        all_types = map_of("arrested", "slow", "fast") | {(0.1, 0.0): {1: mixed}}
        two = map_of("arrested", "fast", "fast")
        back, back_too = map_of("slow", "arrested", "fast"), map_of("fast", "slow", "arrested")
        for of, primary, other in (
            ([all_types], (3, 0), (2, 0)),
            ([all_types, two], (2, 0), (2, 0)),
            ([all_types, back], (3, 1), (2, 1)),
            ([back, back_too], (3, 2), (3, 2)),
        ):
            for way, expected in ((PRIMARY, primary), ("stencil 3", other)):
                found = robustness.order_of_all(dict(enumerate(of)), way)
                assert tuple(found.values()) == expected


class TestOrderInWords:
    def test_medians_ascend_from_arrested_over_slow_to_fast(self):
        types = dict.fromkeys(((0.1, 0), (0.3, 0), (0.9, 0)), "arrested")  # median 0.3
        types |= dict.fromkeys(((0.2, 0), (0.6, 0)), "slow")  # median 0.4
        assert front_map.medians_ascend(types, 0)
        assert not front_map.medians_ascend(types | {(0.35, 0): "fast"}, 0)
        assert not front_map.medians_ascend(types | {(0.4, 0): "fast"}, 0)  # equal is no ascent
        assert front_map.medians_ascend(types | {(0.5, 0): "fast"}, 0)
        assert front_map.order_in_words(types | {(0.1, 1): "slow", (0.2, 1): "arrested"}) == (2, 1)

    def test_the_range_of_slow_fronts_is_the_median_over_sigma_bar(self):
        slow = {(0.1, 0): 1, (0.3, 0): 1, (0.2, 1): 1, (0.1, 2): 0}
        places = [(tau, sigma) for tau in (0.1, 0.2, 0.3) for sigma in (0, 1, 2)]
        types = {place: "slow" if slow.get(place) else "fast" for place in places}
        assert front_map.slow_range(types) == approx(0.1)  # of 0.2, 0.1 and 0
