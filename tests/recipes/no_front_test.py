"""Records in which nothing ruptured: `analyze front` reports the type none, which the recipes count
as they count fronts that arrest."""

from events.event_claims import judged_event
from maps.front_map import is_like_analyze, type_on_map
from maps.map_points import types_in

NOTHING = {"x": [0.0, 0.1], "t_rupture": [None, None], "v_c": [None, None], "c_s": 1000.0}
REFERENCE = {"slow": {"speed": 10.0}}


class TestNoFront:
    def test_counts_as_arrested_on_maps(self):
        for kind in ("arrested", "slow", "fast", ""):
            assert type_on_map(kind) == kind
        assert type_on_map("none") == "arrested"
        assert is_like_analyze(NOTHING | {"type": "none"})
        assert not is_like_analyze(NOTHING | {"type": "fast"})

    def test_counts_as_arrested_where_a_map_is_refined(self):
        places = (("0", "none"), ("0.1", "fast"), ("2", ""))
        rows = [{"tau-bar": tau, "sigma-bar": "0", "type": kind} for tau, kind in places]
        types = {(0.0, 0.0): "arrested", (0.1, 0.0): "fast", (2.0, 0.0): "impossible"}
        assert types_in(rows) == types

    def test_does_not_span(self):
        slow = {"speed": 10.0}
        for kind, accepted in (("slow", True), ("arrested", False), ("none", False)):
            fronts = REFERENCE, {"type": kind, "slow": slow}
            claim = judged_event("3A", {"event": fronts}, {})
            assert claim.shown == accepted, kind
