"""Claims about events and about single blocks: cases, and which events are units; all made up."""

import runpy

import numpy as np
from pytest import mark

import curves
from claims.judge import holds
from conftest import ROOT, approx
from measure.continuations import BRANCHES, LEAD, OWN_BLOCK
from measure.conventions import PRIMARY
from measure.event_claims import case_3B, case_5A, slip_ratios
from measure.front_claims import IN_ORDER, case_of_event, words_and_order_case
from measure.slip import peaks_of
from measure.cases import of_event
from rupture.files import Ruptures

L, C_S = 0.14, 968.0
FURTHER = [f"branch at {place} L" for place in ("0.2", "0.25")]
SLOW = dict(x_from=0.07, x_to=0.098, t_from=1e-3, t_to=2e-3, duration=1e-3, speed=25.0)
SLOW |= dict(slowest=10.0, mean=28.0, fast_before=C_S / 3, fast_after=400.0)


def front(kind="slow", arrest=None, in_words=True):
    return {
        "type": kind,
        "c_s": C_S,
        "L": L,
        "x_arrest": arrest,
        "fast_slow_fast": in_words,
        "slow": SLOW if kind == "slow" else None,
        "in_words": SLOW if in_words else None,
        "t_rupture": [0.0, 1e-3, 2e-3, 3e-3],
        "x": [0.01, 0.05, 0.07, 0.09],
        "v_c": [9.0, -9.0, C_S / 11, 9.0],  # in the loading zone, backwards, slow
    }


class TestLoads:
    """An event of a load: whether it spans, its drop of F_T, whether the leading edge ruptures."""

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
    def test_1D(self, events, expected):
        names = ("spanning", "F_T_before", "F_T_after", "t_rupture")
        values = ((spans, drop, 0.0, [0, 1 if edge else None]) for spans, drop, edge in events)
        case = curves.case_1D([dict(zip(names, each)) for each in values])
        assert holds("1D", [case]) == expected

    def test_2C_compares_length_over_duration_with_28_m_per_s(self):
        case = case_of_event(front())
        assert case["length/duration/c_s"] == approx(28 / C_S)
        assert holds("2C", [case])
        assert not holds("2C", [case | {"length/duration/c_s": 1 / 71}])
        assert case_of_event(front("fast"))["length/duration/c_s"] is None

    @mark.parametrize(
        "t_rupture, expected",
        [
            ([0.0, 0.1, 0.2, 1.0, 2.0, 2.1, 2.2], "yes"),
            ([0.0, 2.1, 2.0, 1.0, 1.9, 2.1, 2.2], "no"),  # what is before the stretch comes after
            ([0.0, 0.1, 0.2, 1.0, 2.0, 0.4, 0.3], "no"),  # what is behind it comes before
        ],
    )
    def test_an_event_is_fast_slow_fast_in_order_of_time(self, t_rupture, expected):
        slow = SLOW | {"x_from": 0.5 * L, "x_to": 0.67 * L, "t_from": 1.0, "t_to": 2.0}
        case = words_and_order_case(front() | {"in_words": slow, "t_rupture": t_rupture})
        assert case[IN_ORDER] == expected


class TestContinuations:
    @mark.parametrize(
        "arrest, expected", [(0.084, True), (0.0565, True), (0.0855, False), (None, False)]
    )
    def test_3B(self, arrest, expected):
        case = case_3B(front(), front("arrested", arrest))
        assert holds("3B", [case]) == expected

    @mark.parametrize("last, expected", [(3.04e-3, approx(0.05)), (None, None)])
    def test_5A_goes_by_the_time_below_c_s_over_10(self, last, expected):
        later = front() | {"t_rupture": [0.0, 9.0, 2e-3, last]}  # the 9 s come before the stop
        event = front() | {"in_words": SLOW | {"duration": 0.8e-3}}
        case = case_5A(event, front(), later, 1.5e-3)
        assert case == {"difference/time below c_s/10": expected}

    def test_3C_ratios_take_the_peak_of_every_step(self):
        slip = {"slow_speed": 2e-3, "fast_slip": 6e-6, "slow_slip": 3e-6}
        assert list(slip_ratios({"stopped": slip}, 0.07).values()) == approx([35, 2])


class TestUnits:
    @staticmethod
    def event(unmodified="slow"):
        original = front(unmodified)
        fronts = {"unmodified": original, "stopped": front(in_words=False), "wider": front("fast")}
        slips = {run: {"fast_slip": 1.0, "slow_r_squared": 0.96} for run in ("t_R-half", "stopped")}
        slips["t_R-double"] = {"fast_slip": 1.05, "slow_r_squared": 0.96}
        of_branch = fronts | {
            "no-slow-slip": front("arrested", 0.07),
            "slip": {OWN_BLOCK: slips},
            "phi": dict.fromkeys(("before", "after"), {"mean": [1.0]}),
        }
        return {
            "unmodified": original,
            "event": front(),
            "branches": dict.fromkeys(BRANCHES, of_branch) | {"0.25": None},
            "conventions": {
                "stencil 3": fronts | {"unmodified": front("fast")},
                "stencil 7": fronts,
            },
            "undriven": front(),
            "undriven_from": 1.5e-3,
        }

    @mark.parametrize(
        "claim, original, names",
        [
            ("4AB", "slow", [PRIMARY, *FURTHER, "stencil 7"]),
            ("4AB", "fast", []),
            ("5A", "fast", [PRIMARY]),
        ],
    )
    def test_4AB_compares_types_where_the_front_is_slow(self, claim, original, names):
        assert sorted(of_event(claim, self.event(original))) == sorted(names)

    @mark.parametrize("claim, held", [("3A", False), ("3B", True), ("3C", True)])
    def test_a_branch_without_a_front_counts_against_the_claim(self, claim, held):
        units = of_event(claim, self.event())
        found = {name: holds(claim, cases) for name, cases in units.items()}
        assert found == {PRIMARY: held, "branch at 0.2 L": held, "branch at 0.25 L": False}


# Five blocks; the third is in the middle of 0.12 m.
T_RUPTURE = [0.0, 1e-3, 2e-3, 3e-3, 4e-3]
BLOCKS = {"x": [0.0, 0.02, 0.06, 0.09, 0.12], "L": 0.12}


class TestBlocks:
    @mark.parametrize(
        "t_peak, ruptures, after, off, expected",
        [  # of the middle block: its peak, its rupture, friction in the end, how far off [ms]
            (2.09e-3, 2e-3, 0.1, 0.09, True),
            (2.2e-3, 2e-3, 0.1, 0.2, False),
            (2e-3, None, 0.1, None, False),  # it does not rupture
            (2e-3, 2e-3, 0.3, 0, False),  # friction does not fall again
            (2e-3, 2e-3, None, 0, False),  # it has lost contact
        ],
    )
    def test_1E(self, t_peak, ruptures, after, off, expected):
        levels = {"before": 0.2, "at_peak": 0.3, "after": after}
        peaks = {"t_peak": [9.0, 9.0, t_peak, 9.0, 9.0]}
        peaks |= {name: [level] * 5 for name, level in levels.items()}
        line = BLOCKS | {"t_rupture": [*T_RUPTURE[:2], ruptures, *T_RUPTURE[3:]]}
        case = curves.case_1E(peaks, line)
        assert holds("1E", [case]) == expected
        assert case["peak minus rupture [ms]"] == (None if off is None else approx(off))

    def test_peaks_count_until_shortly_after_the_first_rupture_of_the_last_block(self):
        class Record(dict):  # the second block has no contact; the first one ruptures once more
            time = LEAD * np.arange(4)
            ruptures = Ruptures(LEAD * np.array([0.5, 1, 3]), None, np.array([1, 0, 0]), None)

        tau = np.array([[0.1, 0.3, 0.2, 0.9], [0.0] * 4]).T
        found = peaks_of(Record(tau=tau, p=np.array([[1.0, 0.0]] * 4)))
        assert found["t_peak"][0] == LEAD
        assert [found[n] for n in ("before", "at_peak", "after")] == [
            [x, None] for x in (0.1, 0.3, 0.2)
        ]

    def test_slip_counts_until_two_t_R_or_until_nothing_slips(self):
        names = ("slip_after_two_t_R_over_f_slip_per_k_ij", "net_slip_over_f_slip_per_k_ij")
        reference, unbreakable = (dict(zip(names, slips)) for slips in ((7.0, 8.5), (5.0, 5.187)))
        script = runpy.run_path(str(ROOT / "recipes/estimate/figure.py"))
        cases = script["cases_SI"](reference, unbreakable)
        held = {until: holds("SI-slip", [case]) for until, case in cases.items()}
        assert held == {"until 2 <t_R>": False, "until nothing slips": True}
