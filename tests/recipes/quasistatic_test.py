"""When a load at h = 0 (claim 5B) has run for long enough; made-up ruptures."""

import numpy as np

from quasistatic_seed import is_over

EVERY = 0.01  # between checkpoints [s]
BLOCKS = 20


def ruptures(creep_to, second=None):
    """A dynamic event at 0.5 s, a tip that creeps from 0.52 s on, and perhaps a second event."""
    creep = np.linspace(0.52, creep_to, 8)
    times = [np.full(BLOCKS, 0.5), creep, np.full(BLOCKS if second else 0, second or 0)]
    blocks = [np.arange(BLOCKS), np.arange(8), np.arange(BLOCKS if second else 0)]
    return np.concatenate(times), np.concatenate(blocks), np.linspace(0, 0.14, BLOCKS)


class TestEnd:
    def test_the_second_dynamic_event_ends_it(self):
        assert not is_over(ruptures(0.6), 0.7, EVERY)
        assert is_over(ruptures(0.6, second=0.65), 0.65, EVERY)

    def test_the_time_without_driving_is_waited_for(self):
        """The branch at 0.53 s is followed for 20 ms, longer than until the event."""
        short = ruptures(0.536, second=0.547)
        assert not is_over(short, 0.549, EVERY)
        assert is_over(short, 0.55, EVERY)
