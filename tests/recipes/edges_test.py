"""Edges between types of fronts by bisection (maps/edges.py), and claim edge; all made up."""

from pytest import fixture

import edge
from claims.judge import holds
from conftest import approx
from events.conventions import PRIMARY
from maps import edges


class TestBisection:
    def test_finds_the_first_of_all(self):
        asked = []

        def is_so(number):
            asked.append(number)
            return number >= 7

        assert edges.first(is_so, 0, 100) == 7
        assert len(asked) <= 7  # 2^7 > 100
        assert edges.first(lambda number: True, 0, 100) == 1

    @fixture(name="interfaces")
    def made_up_interfaces(self, monkeypatch):
        """Arrested below 0.05, slow below 0.1 and, at the other threshold, below 0.12."""

        def kind(steps, slow_below=0.05):
            tau = steps * edges.STEP
            bounds = (0.05, 0.1 if slow_below == 0.05 else 0.12)
            return edges.TYPES[sum(tau >= bound for bound in bounds)]

        monkeypatch.setattr(edges.Interfaces, "front", lambda self, steps: steps)
        monkeypatch.setattr(edges, "front_type", kind)
        return edges.Interfaces(".", None, [])

    def test_an_edge_is_halfway_to_the_first_front_of_a_type(self, interfaces):
        for kind, how, expected in (
            ("slow", {}, 0.05),
            ("fast", {}, 0.1),
            ("fast", {"slow_below": 0.1}, 0.12),
        ):
            assert interfaces.edge(kind, **how) == approx(expected - edges.STEP / 2)


class TestClaim:
    @staticmethod
    def of(fast, arrested):
        return {PRIMARY: {"slow": 0.04, "fast": fast}}, {PRIMARY: {"slow": arrested, "fast": 1.0}}

    def test_the_largest_difference_of_all_sigma_bar_counts(self):
        for last, expected in ((0.1005, 0.001), (0.0975, -0.002), (0.0985, 0.001)):
            pairs = [(0.1, *self.of(0.1, 0.101)), (0.2, *self.of(last, 0.0995))]
            case = edge.cases(pairs)[PRIMARY]
            assert case["largest difference of the edges"] == approx(abs(expected))
        assert holds("edge", [{"largest difference of the edges": 0.002}])
        assert not holds("edge", [{"largest difference of the edges": 0.0021}])
