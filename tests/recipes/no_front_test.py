"""Records in which nothing ruptured: `analyze front` reports the type none, which the recipes count
as they count fronts that arrest."""

import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "recipes/common"))
from events.event_claims import claim_3A  # noqa: E402
from maps.front_map import is_like_analyze, type_on_map  # noqa: E402
from maps.map_points import types_in  # noqa: E402

NOTHING = {"x": [0.0, 0.1], "t_rupture": [None, None], "v_c": [None, None], "c_s": 1000.0}
REFERENCE = {"slow": {"speed": 10.0}}


class NoFront(unittest.TestCase):
    def test_counts_as_arrested_on_maps(self):
        self.assertEqual(
            [type_on_map(kind) for kind in ("none", "arrested", "slow", "fast", "")],
            ["arrested", "arrested", "slow", "fast", ""],
        )
        self.assertTrue(is_like_analyze(NOTHING | {"type": "none"}))
        self.assertFalse(is_like_analyze(NOTHING | {"type": "fast"}))

    def test_counts_as_arrested_where_a_map_is_refined(self):
        places = (("0", "none"), ("0.1", "fast"), ("2", ""))
        rows = [{"tau-bar": tau, "sigma-bar": "0", "type": kind} for tau, kind in places]
        types = {(0.0, 0.0): "arrested", (0.1, 0.0): "fast", (2.0, 0.0): "impossible"}
        self.assertEqual(types_in(rows), types)

    def test_does_not_span(self):
        slow = {"speed": 10.0}
        for kind, accepted in (("slow", True), ("arrested", False), ("none", False)):
            fronts = REFERENCE, {"type": kind, "slow": slow}
            claim = claim_3A({"event": fronts}, {})
            self.assertEqual(claim.shown, accepted, kind)


if __name__ == "__main__":
    unittest.main()
