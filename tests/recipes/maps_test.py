"""Maps of front types (measure/front_map.py, map_order.py) and shares of pairs (pairs.py)."""

from pytest import mark, raises

from conftest import approx
from measure.pairs import share_of_lower
from measure.conventions import CONVENTIONS, PRIMARY, SETS, WAYS
from measure import front_map, map_order
from measure.front_map import front_type, out_of_order
from measure.map_order import in_each_way
from measure.map_points import boundary_of_variants

ARRESTED, SLOW, FAST = (
    {"types": dict.fromkeys(WAYS, kind), "t_rupture": [1.0]} for kind in front_map.TYPES
)


class TestReadMap:
    ROW = {"point": "p", "tau-bar": "0.1", "sigma-bar": "0", "numerics.seed": "1"}

    def read(self, result):
        return front_map.read_map([(self.ROW, result)])

    def test_an_interface_that_cannot_be_prepared_has_no_front(self):
        refused = {"status": "failed", "sentence": "no such phi", "checksums": {}}
        assert self.read(refused) == {(0.1, 0.0): {1: None}}

    def test_one_that_could_be_prepared_and_not_run_is_an_error(self):
        failed = {"status": "failed", "sentence": "the time step is too long"}
        with raises(ValueError, match="time step is too long"):
            self.read(failed | {"checksums": {"start.h5": "00"}})

    def test_a_front_has_its_types_by_each_way_of_the_chain(self):
        under = dict.fromkeys(SETS["map"], {"type": "fast"}) | {"stencil 3": {"type": "slow"}}
        types = {"type": "none", "under": under}
        (seeds,) = self.read({"front": {"type": "none"}, "types": types}).values()
        assert (front_type(seeds[1]), front_type(seeds[1], "stencil 3")) == ("arrested", "slow")
        (seeds,) = self.read({"front": {"type": "slow"}}).values()
        assert front_type(seeds[1]) == "slow"


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
    def test_a_place_at_the_boundary_of_one_variant_is_enough(self):
        maps = [
            {(n / 10, 0.0): {1: front} for n, front in enumerate(fronts, 1)}
            for fronts in ([SLOW, FAST, FAST], [FAST, FAST, FAST])
        ]
        assert boundary_of_variants(maps) == [(0.1, 0.0), (0.2, 0.0)]

    def test_other_seeds_of_variants_are_on_their_maps(self, monkeypatch):
        def point(tau_bar, kind, seed):
            row = {"variant": "v", "tau-bar": tau_bar, "sigma-bar": "0", "numerics.seed": seed}
            return row, {"front": {"type": kind, "under": dict.fromkeys(WAYS, {"type": kind})}}

        grid = [point(str(n), kind, "1") for n, kind in enumerate(front_map.TYPES)]
        files = grid, [point("1", "fast", "2")]
        monkeypatch.setattr(map_order, "read_points", lambda file: files[file])
        monkeypatch.setattr(map_order, "rows_of", list)
        types = [map_order.main("variants", seed, 0, 1)["types"] for seed in "12"]
        assert types == [3, 2]

    def test_the_worst_of_several_maps_counts_in_each_way(self):
        mixed: dict = {"types": dict.fromkeys(WAYS, "slow") | {"stencil 3": "fast"}}
        rows: dict = {  # from low to high tau_bar_0
            "all": [ARRESTED, mixed, FAST],
            "two": [ARRESTED, FAST, FAST],
            "out of order": [SLOW, ARRESTED, FAST],
            "out of order too": [FAST, SLOW, ARRESTED],
        }
        maps = {n: {(t / 10, 0.0): {1: f} for t, f in enumerate(of)} for n, of in rows.items()}
        for names, primary, other in (
            (["all"], (3, 0), (2, 0)),
            (["all", "two"], (2, 0), (2, 0)),
            (["all", "out of order"], (3, 1), (2, 1)),
            (["out of order", "out of order too"], (3, 2), (3, 2)),
        ):
            found = in_each_way({name: maps[name] for name in names})
            assert (found["types"], found["out_of_order"]) == primary
            assert [*found["under"]] == [way for way in CONVENTIONS if way != PRIMARY]
            under = found["under"]["stencil 3"]
            assert (under["types"], under["out_of_order"]) == other


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
