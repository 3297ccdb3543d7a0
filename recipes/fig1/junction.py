"""The forces of Figure 1 F beside those that the law demands.

Blocks of one junction each are pulled, with a sample in each time step; checkpoints taken while all
of them slip say until when. From the displacements alone the law says what each junction's force
should be; tau of the record is what it was.
"""

import numpy as np
import rupture
from rupture.errors import Failure

EVERY = 20  # of the steps that go into the table; where something changes, all
SHOWN = 1  # block


class Pulled:
    """Blocks of one junction: [step][block]."""

    def __init__(self, prepared, record, *slipping):
        names = ("step", "time", "u_x", "tau", "p", "pinned")  # [1, s, m, N, N, 1]
        series = rupture.open(record)
        step, self.time, self.u, self.f, self.f_N, pinned = (series[name] for name in names)
        kappa, self.mu_s, self.mu_d = (series[f"junctions.{n}"] for n in ("kappa", "mu_s", "mu_d"))
        if not np.all(np.diff(step) == 1):
            raise Failure("the record does not have a sample of each step")
        self.attachment = rupture.open(prepared)["junctions/attachment"][:, 0]  # [m]
        self.k = np.sqrt(kappa * self.f_N)
        self.f_thres, self.f_slip = self.mu_s * self.f_N, self.mu_d * self.f_N
        self.pinned = pinned == 1
        change = np.diff(self.pinned.astype(int), axis=0, prepend=self.pinned[:1])
        self.breaks, self.repins = change < 0, change > 0
        self.repin_times = np.array([repin_times(path) for path in slipping])  # [s]

    def stretched(self):
        """The force of a pinned junction that never breaks: k_ij (x - x_ij), with x_ij the position
        at which it was pinned last."""
        steps = np.arange(len(self.time))[:, None]
        last = np.maximum.accumulate(np.where(self.repins, steps, 0))
        attached = np.where(last, np.take_along_axis(self.u, last, 0), self.attachment)
        return self.k * (self.u - attached)

    def deviation(self, expected, where):
        """The largest one, in units of mu_s f_N."""
        return np.max((np.abs(self.f - expected) / self.f_thres)[where])

    def late(self):
        """Steps by which each repinning came later than the first with t >= t_break + t_R."""
        due = (np.searchsorted(self.time, times) for times in self.repin_times.T)
        repins = map(np.flatnonzero, self.repins.T)
        return [int(n - d) for steps in zip(repins, due) for n, d in zip(*steps)]

    def is_forward(self):
        """All blocks, from their first break on."""
        broken = np.maximum.accumulate(self.breaks)[:-1]
        return bool(np.all(np.diff(self.u, axis=0)[broken] >= 0))


def repin_times(checkpoint):
    state = rupture.open(checkpoint)
    if not state["junctions/slipping"].all():
        raise Failure("not all junctions slip in a checkpoint in which they should")
    return state["junctions/repin_time"][:, 0]


def law_of(pulled):
    """The largest deviation of a force from the law's, over f_thres and all steps; whether each
    junction breaks in the first step in which it would carry more than mu_s f_N; the steps by which
    the latest is pinned again after t_R."""
    stretched, ratio = pulled.stretched(), pulled.f / pulled.f_N
    step, block = np.nonzero(pulled.breaks)
    before, later = ratio[step - 1, block], (stretched / pulled.f_N)[step, block]
    linear = pulled.deviation(stretched, pulled.pinned)
    dropped = pulled.deviation(pulled.f_slip, ~pulled.pinned)
    zero = np.abs(ratio[pulled.repins]).max()
    return {
        "junctions": ratio.shape[1],
        "breaks": len(step),
        "repinnings": int(pulled.repins.sum()),
        "deviation": float(max(linear, dropped, zero)),
        "breaks_beyond_f_thres": bool(np.all((before <= pulled.mu_s) & (pulled.mu_s < later))),
        "latest_repinning": max(pulled.late()),
        "moves_forwards": pulled.is_forward(),
    }


def rows(pulled):
    """Yields the rows of the table of the shown block: regular samples, and before each change."""
    changes = np.flatnonzero((pulled.breaks | pulled.repins)[:, SHOWN])
    for n in sorted({*range(0, len(pulled.time), EVERY), *changes, *(changes - 1)}):
        moved = pulled.u[n, SHOWN] - pulled.attachment[SHOWN]
        ratio = pulled.f[n, SHOWN] / pulled.f_N[n, SHOWN]
        yield pulled.time[n], moved, ratio, int(pulled.pinned[n, SHOWN])


def law_of_pulled(*files):
    return law_of(Pulled(*files))
