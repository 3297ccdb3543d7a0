"""Which runs and events the claims are about, what is changed in them, in which ways they are
measured, and that texts and code have the same numbers. What is right is written out here, from the
paper and from docs/claims.md."""

import re
import tomllib
from types import SimpleNamespace

from pytest import mark
from rupture.errors import Failure
from rupture.once import Report

import events
import fig1.commands
import fig2.commands
import fig3.commands
import fig4.commands
import fig5.commands
import figS4.commands
import figS6.commands
import maps
import measure.ways
import robustness.commands
from claims.judge import by_way, shares_of
from claims.spread import spread
from claims.table import table
from conftest import ROOT, approx
from event_numbers import crossing_time
from ensemble import precursors
from fig3 import front_speed, slow_fronts
from fig5 import quasistatic_stretch
from measure import fronts, slip
from measure.fronts import last_block
from measure.ways import PRIMARY, RAW

L = 0.14
FROZEN = tomllib.loads((ROOT / "recipes/frozen.toml").read_text("utf-8"))


# --- ways ----------------------------------------------------------------------------------


def test_each_way_changes_what_its_name_says():
    assert measure.ways.WAYS == {
        "primary": "",
        "stencil 3": "--stencil 3",
        "stencil 7": "--stencil 7",
        "20 % pinned": "--ruptured-below 0.2",
        "50 % pinned": "--ruptured-below 0.5",
        "slow below c_s/10": "--slow-below 0.1",
        "slow below c_s/30": f"--slow-below {1 / 30}",
        "lattice's c_s": f"--slow-below {993 / 968 / 20}",
        "raw line": "--line raw",
    }


def test_reports_belong_to_their_ways(monkeypatch):
    def run(line):
        return ["", *line.split("'")[1].split("; ")]

    monkeypatch.setattr("measure.ways.run", run)
    assert measure.ways.by_way("analyze front r.h5") == measure.ways.WAYS
    assert measure.ways.by_way("analyze", measure.ways.ON_MAP) == measure.ways.ON_MAP


def test_the_contiguous_front_stops_at_a_gap_and_the_raw_line_goes_on():
    front = Report(t_rupture=[None, None, 1.0, 2.0, None, 3.0], t_before=[0.1, 0.2] + [None] * 4)
    assert [last_block(front, 1, way) for way in (PRIMARY, "stencil 3", RAW)] == [3, 3, 5]
    quiet = Report(t_rupture=[None] * 6, t_before=[0.1, 0.2] + [None] * 4)
    assert [last_block(quiet, 1, way) for way in (PRIMARY, RAW)] == [1, 1]


# --- which runs, and which events ----------------------------------------------------------


@mark.parametrize(
    "function, law",
    [
        (fig1.commands.each_run, "reference"),
        (fig2.commands.runs_beside_I, "reference"),
        (fig2.commands.runs_beside_III, "reference"),
        (figS6.commands.each_run, "decaying"),
        (robustness.commands.each_run, "exponential"),
    ],
)
def test_runs_are_those_of_the_law_on_the_seeds_of_this_version(function, law, monkeypatch):
    asked = []

    def sampled(_, points, *__):
        asked.extend(points)
        return [(points[0], Failure("it was refused"))]

    for name in ("fig1", "fig2", "figS6", "robustness"):
        for shown in ("shown_event", "shown_of", "shown_events"):
            anything = lambda _: {PRIMARY: SimpleNamespace(front=None)}  # noqa: E731
            monkeypatch.setattr(f"{name}.commands.{shown}", anything, raising=False)
    monkeypatch.setattr("fig2.commands.shown_event", lambda _: SimpleNamespace(front=None))
    monkeypatch.setattr("events.sampled", sampled)
    events.runs.cache_clear()
    [sample] = function().taken[PRIMARY]
    events.runs.cache_clear()
    seeds = FROZEN["seeds"][: 20 if law == "reference" else 10]
    assert asked == [(seed, law) for seed in seeds] and len({*seeds}) == len(asked) > 9
    assert sample.run == seeds[0] and isinstance(sample.found, Failure)


def test_seeds_are_those_that_the_documents_say():
    text = " ".join((ROOT / "docs/frozen.md").read_text("utf-8").split())
    assert "The first twenty are those of the runs, and of the runs at h = 0; the first ten" in text
    assert "the first five those at h = 0 with f_slip = 0. The next five are those of" in text
    assert fig5.commands.SEEDS == FROZEN["seeds"] and len({*FROZEN["seeds"]}) == 20
    assert fig5.commands.SEEDS_WITHOUT_FORCE == FROZEN["seeds"][:5]
    assert maps.SEEDS == sorted(FROZEN["prepared"]) and len({*maps.SEEDS}) == 5
    assert maps.FIRST == maps.SEEDS[0]


def event(slow, spanning=True):
    return Report(fast_slow_fast=slow, spanning=spanning)


def test_only_fast_slow_fast_events_are_changed_and_only_those_that_span_are_counted():
    run = [event(None), event(False), event(True), event(True), event(False, None)]
    run.append(event(False, False))
    found = [(1, {PRIMARY: run}), (2, Failure("refused")), (3, {PRIMARY: [event(True)]})]
    assert events.slow_events(found) == [(1, 2), (1, 3), (3, 0)]
    assert events.spanning({"way": run}) == {"way": run[:4]}


@mark.parametrize("function", (events.samples_of_events, events.samples_of_branches))
def test_from_events_with_seeds_1_1_and_2_to_the_interval_of_a_row(function, monkeypatch):
    """The events of seed 1 hold, that of seed 2 does not. Of two runs that are drawn, in a quarter
    of the cases both are the first one, and in a quarter the second. A third run without such an
    event counts against."""
    runs = [(1, {PRIMARY: 2 * [event(True)]}), (2, {PRIMARY: [event(True)]})]
    monkeypatch.setattr("events.sampled", lambda _, points, __: [(p, p) for p in points])
    row = {"conditions": {"holds": "yes"}, "share_of": "events"}

    def shares(runs):
        monkeypatch.setattr("events.runs", lambda: runs)
        function.cache_clear()
        taken = function()
        function.cache_clear()
        found = by_way(row, lambda point, _: {"holds": point[0] == 1}, taken)
        return taken, shares_of(row, found)[0]

    _, share = shares(runs)
    assert (share.holds, share.samples, share.runs) == (2, 3, 2)
    assert (share.low, share.high) == (0, 1)
    taken, share = shares([*runs, (3, {PRIMARY: [event(False)]}), (4, Failure("refused"))])
    assert (share.holds, share.samples, share.runs) == (2, 5, 4)
    if len(taken) > 1:
        assert [*taken] == [PRIMARY, "branch at 0.2 L", "branch at 0.25 L"]
        blocks = [{of.found[2] for of in taken[name][:3]} for name in taken]
        assert blocks == [{8}, {11}, {14}]  # 0.143, 0.196, 0.25 of 56


# --- what is changed -----------------------------------------------------------------------


def test_what_is_changed_at_a_branch(monkeypatch):
    lines = []

    def run(line, *_, **__):
        lines.append(line)
        return {name: f"{len(lines)}.h5" for name in re.findall(r"\S+\.h5", line)}

    monkeypatch.setattr("events.run", run)
    monkeypatch.setattr("events.by_way", lambda line, *_: lines.append(line))
    front = Report(in_words=Report(x_from=0.07), L=L)
    whole = SimpleNamespace(start="start.h5", fronts={PRIMARY: front})
    events.branch_of(whole, 11, 0.01)
    branch, *changed = [line for line in lines if line.startswith("restart")]
    assert branch.endswith("--until-rupture-at 0.0275 --for 0.01")
    ends = [" ".join(line.split()).split(" --record record.h5 ") for line in changed]
    assert {end for _, end in ends} == {"--record-every 1e-5 --crossings 0.2,0.5"}
    assert [before.partition("-o end.h5 ")[2] for before, _ in ends] == [
        "--set driving.V=0 --for 0.01",
        "--set driving.V=0 --set junctions.t_R=0.001 --set junctions.delta_t_R=0.0003 --for 0.01",
        "--set driving.V=0 --set junctions.t_R=0.004 --set junctions.delta_t_R=0.0012 --for 0.01",
        "--set driving.V=0 --set junctions.f_new=f_slip --for 0.04 --until-quiet",
        "--for 0.01",  # a wider phi, driven
    ]
    wider = next(line for line in lines if line.startswith("modify-phi"))
    assert wider.endswith("--shape uniform --x-from 0.035")  # 0.25 L
    places = [float(line.split()[-1]) / L for line in lines if line.startswith("analyze slip")]
    assert places == approx(3 * [0.34] + 3 * [0.44] + 3 * [0.4])  # the stretch begins at 0.5 L
    measured = [line for line in lines if line.startswith("analyze front")]
    assert len(measured) == 5 and all(line.endswith("--skip-below-x 0.0275") for line in measured)


def test_laws_are_those_of_the_paper():
    assert "kappa=54.1e9" in events.LAWS["decaying"] and "mu_d=0.28" in events.LAWS["decaying"]
    assert "mu_new=0.196" in events.LAWS["decaying"]  # 0.7 mu_d
    assert "v_slow=1.5e-3" in events.LAWS["simplified"]
    assert events.LAWS["exponential"].endswith("slipping_times=exponential")


CUT = Report(type=None, fast_slow_fast=None, t_rupture=[None] * 57, x=[0.0] * 57, L=L, c_s=968.0)
WHOLE = Report(CUT, type="slow", fast_slow_fast=True, in_words=Report(x_from=0.07, duration=1.0))


@mark.parametrize(
    "measured, cut",
    [
        *((fig3.commands.still_slow, "stopped"), (fig3.commands.arrest, "no_slow_slip")),
        *((fig3.commands.crossing, "no_slow_slip"), (fig3.commands.dose, "half")),
        *((fig3.commands.dose, "double"), (fig4.commands.types, "wider")),
        *((figS4.commands.beginning, "wider"), (fig5.commands.difference, "undriven")),
    ],
)
def test_an_event_that_the_record_cuts_off_is_no_sample(measured, cut):
    names = ("fronts", "stopped", "no_slow_slip", "half", "double", "wider", "undriven")
    sample = SimpleNamespace(**{name: {PRIMARY: WHOLE} for name in names}, block=8, stop=0.0)
    setattr(sample, cut, {PRIMARY: CUT})
    assert measured(sample, PRIMARY) is None


def test_a_wider_phi_concerns_ruptures_after_the_branch_however_they_are_measured():
    """Block 1 is where the branch begins, at 1 ms; measured in the other way it ruptured at 0.5 ms,
    and so did block 2, at 0.9 ms: the wider event begins without it."""
    line = {"x": [0.01, 0.02, 0.03, 0.034], "L": L, "in_words": Report(duration=1e-3)}
    fronts = {PRIMARY: Report(line, t_rupture=[0.0, 1e-3, 1.1e-3, 2e-3])}
    fronts["50 % pinned"] = Report(line, t_rupture=[0.0, 0.5e-3, 0.9e-3, 2e-3])
    wider = {"50 % pinned": Report(type="fast", t_rupture=[None, None, None, 2.01e-3])}
    of = SimpleNamespace(fronts=fronts, wider=wider, block=1)
    assert figS4.commands.beginning(of, "50 % pinned")["largest difference [ms]"] == approx(0.01)


BEGINS: list[list[float]] = [[2.0, 0.1, 0.5, 0.6], [0.3], [0.2, 0.9], [2.0]]  # 2: not such an event


def test_a_block_is_slow_by_the_limit_of_each_way():
    """At c_s/15, block 1 is slow below c_s/10 and fast above c_s/20."""
    front = Report(x=[0.03, 0.04, 0.05], v_c=[1 / 15, 1 / 25, 1.0], c_s=1.0)
    ways = {PRIMARY: 1 / 20, "slow below c_s/10": 1 / 10}
    fronts = {way: Report(front, criteria=Report(slow_below=limit)) for way, limit in ways.items()}
    of = SimpleNamespace(fronts=fronts, strength=Report(tau_bar_0=[0.1, 0.3, 0.5]))
    found = [fig4.commands.stress(of, way)["slow minus fast"] for way in ways]
    assert found == approx([0.3 - 0.3, 0.2 - 0.5])


def test_first_events_are_one_of_each_run_and_all_others_are_later():
    def words(begin):
        stretch = Report(x_from=begin * L, x_to=L, slowest=9.0, fast_before=300.0, duration=1e-3)
        return Report(fast_slow_fast=begin < 1, in_words=stretch, L=L, c_s=968.0)

    runs = [{PRIMARY: [words(x) for x in of]} for of in BEGINS]
    found = fig2.commands.first_event(runs, PRIMARY)
    assert found["begin [L]"] == approx(0.2) and found["later events: begin [L]"] == approx(0.6)
    assert found["runs with such an event"] == 3


# --- numbers of texts and of code ----------------------------------------------------------

NUMBERS = [  # a row, a part of its text, and what the code has
    ("1E", "Peaks count until 0.5 ms after", slip.AFTER, 0.5e-3),
    ("2A", "three stencils or more below c_s/10", fronts.SLOW_BELOW, 1 / 20),
    ("2B", "v_c >= c_s/20", fronts.SLOW_BELOW, 1 / 20),
    ("3D", "at least 5 measured blocks", slow_fronts.BLOCKS, 5),
    ("4AB", "in all blocks from x = 0.25 L on", fig4.commands.REGION, 0.25),
    ("4D-edge", "bisected to 0.00025 at seven sigma_bar", maps.STEP, 0.00025),
    ("4D-edge", "at seven sigma_bar", len(fig4.commands.SIGMA_BARS), 7),
    ("5B", "advances by at most 2 blocks in 20 ms", quasistatic_stretch.STOPPED_FOR, 20e-3),
    ("5B", "from 10 ms after the first to 10 ms before", quasistatic_stretch.APART, 10e-3),
    ("5B", "blocks rupture within 1 ms", quasistatic_stretch.WINDOW, 1e-3),
    ("5B", "at most 2 blocks", fig5.commands.MOVES, 2),
    ("S2", "its slow stretch lasts at least 0.5 ms", fronts.SLOW_FOR, 0.5e-3),
    ("S2", "at least 10 times as fast", fronts.FAST_OVER_SLOW, 10),
]


@mark.parametrize("claim_id, text, found, expected", NUMBERS)
def test_texts_and_code_have_the_same_numbers(claim_id, text, found, expected):
    row = table()[claim_id]
    assert re.search(text, f"{row['accepted']} {row.get('note', '')}")
    assert found == approx(expected)


def test_the_middle_of_the_interface_and_the_turn_of_precursors():
    assert fig1.commands.MIDDLE == 57 // 2
    assert (precursors.TURN, precursors.OFFSET) == (0.715, -0.107)
    assert slow_fronts.NEAR_ARREST == 3 and front_speed.FASTER == 10


def test_the_scale_of_3D_is_that_of_the_SI():
    """v_slow slip k_i l_0/(tau_thres - tau_0), with the reference parameters and tau_bar_0 = 0.1:
    p = 1920 N/57, k_i = sqrt(39.2 GN/m^2 100 p), l_0 = 7 mm, and 0.9 times 0.23 p."""
    of = front_speed.parameters(1) | {"slow slip [m/s]": 2e-3}
    p = 1920 / 57
    expected = 2e-3 * (39.2e9 * 100 * p) ** 0.5 * 7e-3 / (0.9 * 0.23 * p)
    assert front_speed.scaled_slip([of])[0] == approx(expected)


def test_a_range_is_from_5_to_95_percent_about_the_median():
    found = spread("a", None, [*range(101), None], "{} of 102")
    assert (found.low, found.median, found.high, found.of) == (5, 50, 95, "101 of 102")
    assert spread("a", None, [0, 0, 0, 1, 9], "").median == 0


def test_a_crossing_is_of_the_front_and_not_of_a_block_ahead_of_it():
    t_front = [n * 1e-4 for n in range(11)]
    ruptured = t_front[:6] + [1e-5] + t_front[7:]  # the block at 0.6 L ruptures alone
    assert crossing_time({"t_rupture": ruptured, "t_front": t_front}) == approx(0.2)
