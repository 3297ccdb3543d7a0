"""What the recipe `barrier` counts, on made-up fronts."""

import pytest
from rupture.once import Report

from barrier import figure as barrier


def pair(*arrived):
    """Fronts with slow slip and without that pass the patch of one block at these times [s], which
    breaks."""
    return [Report(t_front=[None] * 30 + [t], t_rupture=[t] * 31) for t in arrived]


def test_counts_the_fronts_that_only_slow_slip_carries_across():
    places = {(0.15, *barrier.PLAIN): pair(1e-3, 1e-3), (0.3, *barrier.PLAIN): pair(1e-3, 1e-3)}
    places |= {(0.15, 0.5, 1): pair(4e-3, None), (0.3, 0.5, 1): pair(None, None)}
    places |= {(0.3, 0.6, 1): pair(2e-3, 2e-3), (0.1, 0.5, 1): pair(None, 3e-3)}
    result = barrier.own_result(places)
    assert list(result.measured.values())[:4] == [0.5, 1, pytest.approx(1.5), 2]
    assert not result.met  # because of the one that only crosses without
    names = [name for name in result.measured if name.startswith("patches left whole")]
    assert [result.measured[name] for name in names] == [0, 0]
    jumping = [Report(t_front=[0.0] * 31, t_rupture=[0.0] * 28 + [None, 0.0, 0.0])]
    counted = barrier.own_result(places | {(0.3, 0.5, 1): jumping + pair(None)}).measured
    assert [counted[name] for name in names] == [1, 0]
    del places[0.1, 0.5, 1]
    assert barrier.own_result(places).met


@pytest.mark.parametrize(
    "t_patch, t_behind, outcome",
    [
        ([1.0, 1.0], 1.0, "breaks it"),
        ([1.0, None], 1.0, "jumps over it"),
        ([None, 1.0], 1.0, "jumps over it"),
        ([1.0, 1.0], None, "stops"),
    ],
)
def test_a_patch_breaks_if_all_of_its_blocks_do(t_patch, t_behind, outcome):
    line = [1.0] * 28 + t_patch + [t_behind] * 2
    front = Report(t_front=[1.0] * 31 + [t_behind], t_rupture=line)
    assert barrier.outcome(front, 2) == outcome


def test_widths_are_in_decay_lengths():
    assert [barrier.in_l_0(width) for width in (1, 2, 4, 8)] == [0.36, 0.71, 1.43, 2.86]
