"""Three runs of the ensemble (seeds 201 to 203, the first ones): which of their events meet which
claim, read by eye off the rupture lines, and what claims.toml makes of their reports.

data/runs.json has the reports of `analyze` without those in other ways: of the events of
the run, of each fast-slow-fast one computed again, and of its branches at 0.14 L (block 8).
"""

import json
from types import SimpleNamespace

from pytest import fixture, mark
from rupture.once import Report

from claims.judge import by_way, counted, found_in, function, holds, shares_of
from claims.samples import Sample
from claims.table import table
from conftest import ROOT
from events import spanning
from measure.ways import PRIMARY

DATA = ROOT / "tests/recipes/data/runs.json"
RUNS = json.loads(DATA.read_text(encoding="utf-8"), object_hook=Report)
# Start [s] of the events that meet the claim. c_s/v of a stencil of five blocks was printed along
# the interface, with the time at which the front is at each block, and read: fast up to 10 or 20,
# slow beyond; < where it runs backwards, - where it jumps.
EVENTS = ["0.6877 0.8456 1.0041 1.0839 1.1616", "0.4202 0.6350 0.7944 0.9534 1.1113 1.1908"]
EVENTS += ["0.6418 0.7978 0.9530 1.0310 1.1876"]
BY_EYE = {
    # 0.7628: it starts amid its slow stretch, with nothing before
    "2A": EVENTS,
    # the others begin beyond block 28 (0.5 L) or end beyond 39 (0.7 L); 0.6418 takes 2.6 ms
    "2A-numbers": ["0.6877", "0.4202 0.9534", "0.9530"],
    "2B": ["0.9256", "0.7153 0.8760 1.0329", "0.8775 1.1108"],
    # 0.6877, 0.4202, 0.6418: slower than c_s/70 on average; 1.0839, 1.1908, 1.0310: nowhere as slow
    # as c_s/50; 0.8456, 1.1616, 1.1113, 1.1876: slower than c_s/6 before
    "2C": ["1.0041", "0.6350 0.7944 0.9534", "0.7978 0.9530"],
    # 1.1113: slower than c_s/10 before
    "3A": ["0.6877 0.8456 1.0041 1.0839 1.1616", "0.4202 0.6350 0.7944 0.9534 1.1908"]
    + ["0.6418 0.7978 0.9530 1.0310 1.1876"],
    # arrest at block 19, 35; 28, 31, 28; 19, 29, 26; the stretch begins at 19, 35; 30, 33, 27; 18,
    # 34, 26. In 0.4202, the front stops at block 21, where the stretch begins; block 34 ruptures
    # alone. 6 blocks or more apart, 0.107 L: 1.0839 (36, 42), 1.1616 (10, 27), 1.1908 (35, 43),
    # 1.0310 (8, 39), 1.1876 (15, 25). In 0.8456 and 1.1113 nothing ruptures: it arrests at block 8.
    "3B": ["0.6877 1.0041", "0.4202 0.6350 0.7944 0.9534", "0.6418 0.7978 0.9530"],
    # None reaches the end; with slow slip, all of them do.
    "no-crossing": EVENTS,
    # 0.6877, 0.6418, 1.1113: slower than c_s/20 somewhere
    "4AB": ["0.8456 1.0041 1.0839 1.1616", "0.4202 0.6350 0.7944 0.9534 1.1908"]
    + ["0.7978 0.9530 1.0310 1.1876"],
}
OF_RUNS = ("2A", "2A-numbers", "2B", "2C")  # the samples of these are runs, of others events
COUNTED = {"2A": ["3 of 3"], "no-crossing": ["16 of 16"]}  # what the rows count beside


@fixture(name="taken", scope="module")
def samples_of_runs_and_branches():
    runs, branches = [], []
    before = {"t_before": [0.0] * 9 + [None] * 48}  # the branch is at block 8
    for number, run in enumerate(RUNS.values()):
        runs.append(Sample(number, spanning({PRIMARY: run.events})))
        for whole, branch in zip(run.continued, run.branches):
            sample = SimpleNamespace(
                t_start=whole.t_start,
                fronts={PRIMARY: whole.front},
                stopped={PRIMARY: branch.front_stopped},
                no_slow_slip={PRIMARY: Report(branch.front_no_slow_slip | before)},
                block=8,
                wider={PRIMARY: branch.front_wider},
                phi=branch.phi,
                phi_wider=branch.phi_wider,
            )
            branches.append(Sample(number, sample))
    return runs, branches


def starts_of(one):
    """Of the events of a run, or of the event of a branch."""
    if isinstance(one.found, dict):
        return [event.t_start for event in one.found[PRIMARY]]
    return [one.found.t_start]


@mark.parametrize("claim_id", BY_EYE)
def test_the_events_of_three_runs_that_meet_a_claim_are_those_counted_by_eye(claim_id, taken):
    row = table()[claim_id] | {"ways": ()}
    measured, of_claim = function(row, "measured"), taken[claim_id not in OF_RUNS]
    met = [
        start
        for one in of_claim
        for start, found in zip(starts_of(one), found_in(measured, one.found) or ())
        if holds(row, [found])
    ]
    assert [f"{start:.4f}" for start in met] == " ".join(BY_EYE[claim_id]).split()
    found = by_way(row, measured, {PRIMARY: of_claim})
    assert [*counted(row, found[PRIMARY]).values()] == COUNTED.get(claim_id, [])
    counts = [len(starts.split()) for starts in BY_EYE[claim_id]]  # of each run
    expected = (sum(map(bool, counts)), 3) if claim_id in OF_RUNS else (sum(counts), 16)
    [share] = shares_of(row, found)
    assert (share.holds, share.samples) == expected
