"""What the recipe `barrier` counts, on made-up fronts."""

import pytest
from rupture.once import Report

from barrier import figure as barrier


def pair(*arrived):
    """Fronts with slow slip and without that pass the patch of one block at these times [s]."""
    return [Report(t_front=[None] * 30 + [t]) for t in arrived]


def test_counts_the_fronts_that_only_slow_slip_carries_across():
    places = {(0.15, *barrier.PLAIN): pair(1e-3, 1e-3), (0.3, *barrier.PLAIN): pair(1e-3, 1e-3)}
    places |= {(0.15, 0.5, 1): pair(4e-3, None), (0.3, 0.5, 1): pair(None, None)}
    places |= {(0.3, 0.6, 1): pair(2e-3, 2e-3), (0.1, 0.5, 1): pair(None, 3e-3)}
    result = barrier.own_result(places)
    assert list(result.measured.values())[:4] == [0.5, 1, pytest.approx(1.5), 2]
    assert not result.met  # because of the one that only crosses without
    del places[0.1, 0.5, 1]
    assert barrier.own_result(places).met
