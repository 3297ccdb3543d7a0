"""Leading rows of claims about events: cases, and which events are units; fronts are made up."""

from pytest import mark

import curves
from claims.judge import holds
from conftest import approx
from events.continuations import BRANCHES, OWN_BLOCK
from events.conventions import IN_WORDS, PRIMARY
from events.event_claims import case_3Bw, case_5Aw, case_of_event, ratios_3Cr
from events.units import OF_EVENT

L, C_S = 0.14, 968.0
SLOW = {
    "x_from": 0.07,
    "x_to": 0.098,
    "t_from": 1e-3,
    "t_to": 2e-3,
    "duration": 1e-3,
    "speed": 25.0,
}
SLOW |= {"slowest": 10.0, "mean": 28.0, "fast_before": C_S / 3, "fast_after": 400.0}


def front(kind="slow", arrest=None, in_words=True):
    return {
        "type": kind,
        "c_s": C_S,
        "L": L,
        "x_arrest": arrest,
        "fast_slow_fast": in_words,
        "slow": SLOW if kind == "slow" else None,
        "t_rupture": [0.0, 1e-3, 2e-3, 3e-3],
    }


def loaded(*events):
    """Events of a load: whether each spans, its drop of F_T, whether the leading edge ruptures."""
    names = ("spanning", "F_T_before", "F_T_after", "t_rupture")
    values = ((spans, drop, 0.0, [0, 1 if edge else None]) for spans, drop, edge in events)
    return [dict(zip(names, of_event)) for of_event in values]


class TestLoads:
    @mark.parametrize(
        "events, expected",
        [
            ([(False, 1, False), *[(True, 10, True)] * 5], True),
            ([(False, 1, True), *[(True, 10, True)] * 5], False),  # an early one reaches the edge
            ([*[(True, 10, True)] * 5, (False, 1, True)], True),  # a later one may
            ([*[(True, 10, True)] * 5, (False, 5, False)], False),  # half the largest is large
            ([*[(True, 10, True)] * 4, (True, 4, True)], False),  # four large drops
        ],
    )
    def test_1Dw(self, events, expected):
        assert holds("1Dw", [curves.case_1Dw(loaded(*events))]) == expected

    def test_2Cw_compares_length_over_duration_with_28_m_per_s(self):
        case = case_of_event(front())
        assert case["length/duration/c_s"] == approx(28 / C_S)
        assert holds("2Cw", [case])
        assert not holds("2Cw", [case | {"length/duration/c_s": 1 / 71}])
        assert case_of_event(front("fast"))["length/duration/c_s"] is None


class TestContinuations:
    @mark.parametrize(
        "arrest, expected", [(0.084, True), (0.0565, True), (0.0855, False), (None, False)]
    )
    def test_3Bw(self, arrest, expected):
        assert holds("3Bw", [case_3Bw(front(), front("arrested", arrest))]) == expected

    def test_5Aw_goes_by_the_time_below_c_s_over_10(self):
        later = front() | {"t_rupture": [0.0, 9.0, 2e-3, 3.04e-3]}  # the 9 s come before the stop
        in_words = front() | {"slow": SLOW | {"duration": 0.8e-3}}
        assert case_5Aw(in_words, front(), later, 1.5e-3) == {
            "difference/time below c_s/10": approx(0.05)
        }
        later["t_rupture"][3] = None
        assert case_5Aw(in_words, front(), later) == {"difference/time below c_s/10": None}

    def test_3Cr_takes_the_peak_of_every_step(self):
        slip = {"slow_speed": 2e-3, "fast_slip": 6e-6, "slow_slip": 3e-6, "peak_speed": 1.0}
        assert list(ratios_3Cr({"stopped": slip}, 0.07).values()) == approx([70, 35, 2])


class TestUnits:
    @staticmethod
    def event(unmodified="slow"):
        fronts = {"unmodified": front(unmodified), "stopped": front(), "wider": front("fast")}
        slips = {run: {"fast_slip": 1.0, "slow_r_squared": 0.96} for run in ("t_R-half", "stopped")}
        slips["t_R-double"] = {"fast_slip": 1.05, "slow_r_squared": 0.96}
        of_branch = fronts | {
            "no-slow-slip": front("arrested", 0.07),
            IN_WORDS: {"stopped": front(in_words=False)},
            "slip": {OWN_BLOCK: slips},
        }
        return {
            "unmodified": front(unmodified),
            IN_WORDS: front(),
            "branches": dict.fromkeys(BRANCHES, of_branch) | {"0.25": None},
            "conventions": {
                "stencil 3": fronts | {"unmodified": front("fast")},
                "stencil 7": fronts,
            },
            "undriven": front(),
            "undriven_from": 1.5e-3,
        }

    def test_an_event_is_a_unit_where_its_front_is_slow(self):
        assert set(OF_EVENT["3A"](self.event())) == {
            *(PRIMARY, "stencil 7", "branch at 0.2 L", "branch at 0.25 L")
        }
        assert OF_EVENT["3A"](self.event("fast")) == {}
        assert OF_EVENT["5A"](self.event("fast")) == {}
        assert list(OF_EVENT["5Aw"](self.event("fast"))) == [PRIMARY]

    def test_a_branch_without_a_front_counts_against_the_claim(self):
        for claim, held in (("3Aw", False), ("3Bw", True), ("3Cw", True)):
            units = OF_EVENT[claim](self.event())
            assert {name: holds(claim, cases) for name, cases in units.items()} == {
                **{PRIMARY: held, "branch at 0.2 L": held},
                "branch at 0.25 L": False,
            }
