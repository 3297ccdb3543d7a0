"""The quasi-static front between two dynamic events (claim 5B); made-up ruptures."""

import numpy as np

from claims_test import copied
from conftest import approx
from fig5.commands import speed
from fig5.quasistatic_stretch import advances, dynamic_events, quasistatic_stretch
from measure.ways import PRIMARY

EVERY = 0.01  # between checkpoints [s]
BLOCKS = 20


def ruptures(*later, tip=range(9)):
    """All blocks at 0.5 s and at later times; block n of the tip at 0.52 s + n/100."""
    all_blocks = np.arange(BLOCKS)
    times = [np.full(BLOCKS, 0.5), 0.52 + 0.01 * np.array(tip)]
    times += [np.full(BLOCKS, t) for t in later]
    blocks = [all_blocks, tip, *(all_blocks for _ in later)]
    return np.concatenate(times), np.concatenate(blocks), np.linspace(0, 0.19, BLOCKS)


def test_the_stretch_ends_before_the_second_event_whatever_comes_later():
    stretch = quasistatic_stretch(ruptures(0.65), EVERY)
    assert stretch["tip"][-1] == approx([0.6, 0.08])
    assert stretch["speed"] == approx(1)
    later = quasistatic_stretch(ruptures(0.65, 0.7), EVERY)
    assert later | {"dynamic_events": stretch["dynamic_events"]} == stretch


def test_branches_are_at_checkpoints_and_the_one_in_the_middle_is_named():
    branches = quasistatic_stretch(ruptures(0.65), EVERY)["branches"]
    assert [branch["t"] for branch in branches if branch["middle"]] == ["0.560000000"]
    assert len(branches) == 9 and branches[0]["t"] == "0.530000000"


def test_the_tip_advances_with_and_without_the_drive():
    for blocks, stopped in ((6, 2), (4, 1)):  # from block 2 on, until 0.5655 s
        without = ruptures(0.9, tip=range(blocks))
        found = advances(ruptures(0.9, tip=range(10)), without, 0.51, 0.5455)
        assert found == {"t": 0.5455, "tip": 2, "driven": 2, "stopped": stopped}


def test_half_of_the_blocks_are_no_dynamic_event():
    counts = [len(dynamic_events(np.zeros(n), np.arange(n), BLOCKS)) for n in (10, 11)]
    assert counts == [0, 1]


def test_a_speed_counts_where_the_tip_moves_with_the_drive():
    of = [{"advance": {"c_s": 968, "driven": n, "stopped": 0}} for n in (2, 3)]
    found = [speed(copied(one | {"stretch": {"speed": 484}}), PRIMARY) for one in of]
    assert (found[0], found[1]["c_s/speed"]) == (None, 2)
