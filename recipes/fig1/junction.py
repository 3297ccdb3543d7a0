"""Table and claim of Figure 1 F. Blocks of one junction each are pulled, with a sample in each time
step; checkpoints taken while all of them slip say until when. From the displacements alone the law
says what each junction's force should be; tau of the record is what it was.
"""

import sys

import h5py
import numpy as np

from claims.judge import judged
from data.tables import write_table

EVERY = 20  # of the steps that go into the table; where something changes, all
SHOWN = 1  # block


class Pulled:
    """Blocks of one junction: [step][block]."""

    def __init__(self, prepared, record, slipping):
        with h5py.File(record) as file:
            self.step = file["series/step"][()]
            self.time = file["series/time"][()]  # [s]
            self.u = file["series/u_x"][()]  # [m]
            self.f = file["series/tau"][()]  # [N]
            self.pinned = file["series/pinned"][()] == 1
            self.f_N = file["series/p"][()]  # [N]
            self.law = {name: d[()] for name, d in file["parameters/junctions"].items()}
        with h5py.File(prepared) as file:
            self.attachment = file["state/junctions/attachment"][()][:, 0]  # [m]
        self.repin_times = np.array([repin_times(path) for path in slipping])  # [s]
        if not np.all(np.diff(self.step) == 1):
            sys.exit(f"{record} does not have a sample of each step")


def repin_times(checkpoint):
    with h5py.File(checkpoint) as file:
        slipping = file["state/junctions/slipping"][()][:, 0]
        if not slipping.all():
            sys.exit(f"{checkpoint}: not all junctions slip")
        return file["state/junctions/repin_time"][()][:, 0]


class Junction:
    """One of them. Deviations are in units of mu_s f_N."""

    def __init__(self, pulled, i):
        law = pulled.law
        self.time, self.u, self.f = pulled.time, pulled.u[:, i], pulled.f[:, i]
        self.f_N = pulled.f_N[:, i]
        self.k = np.sqrt(law["kappa"] * self.f_N)
        self.f_thres, self.f_slip = law["mu_s"] * self.f_N, law["mu_d"] * self.f_N
        self.pinned = pulled.pinned[:, i]
        self.changes = np.flatnonzero(np.diff(self.pinned.astype(int))) + 1
        self.breaks = [n for n in self.changes if not self.pinned[n]]
        self.repins = [n for n in self.changes if self.pinned[n]]
        self.attachment = pulled.attachment[i]
        self.repin_times = pulled.repin_times[:, i]

    def stretched(self):
        """The force of a pinned junction that never breaks: k_ij (x - x_ij), with x_ij the position
        at which it was pinned last."""
        attached = np.full(self.u.shape, self.attachment)
        for n in self.repins:
            attached[n:] = self.u[n]
        return self.k * (self.u - attached)

    def linear(self):
        return np.max(np.abs(self.f - self.stretched())[self.pinned] / self.f_thres[self.pinned])

    def dropped(self):
        slips = ~self.pinned
        return np.max(np.abs(self.f - self.f_slip)[slips] / self.f_thres[slips])

    def largest(self):
        """f/f_N in the last step before each break, and what it would have been one step later."""
        later = self.stretched()
        return [(self.f[n - 1] / self.f_N[n - 1], (later / self.f_N)[n]) for n in self.breaks]

    def after_repinning(self):
        """f/f_N in the step of each repinning, and steps by which it came later than the first step
        with t >= t_break + t_R."""
        due = np.searchsorted(self.time, self.repin_times[: len(self.repins)])
        return [(self.f[n] / self.f_N[n], int(n - d)) for n, d in zip(self.repins, due)]

    def is_forward(self):
        return bool(np.all(np.diff(self.u)[self.changes[0] :] >= 0))


def claim_1F(junctions):
    largest = np.array([pair for junction in junctions for pair in junction.largest()])
    repinned = [pair for junction in junctions for pair in junction.after_repinning()]
    mu_s = junctions[0].f_thres[0] / junctions[0].f_N[0]
    linear = max(junction.linear() for junction in junctions)
    dropped = max(junction.dropped() for junction in junctions)
    zero = max(abs(f) for f, _ in repinned)
    late = sorted({steps for _, steps in repinned})
    bracketed = bool(np.all((largest[:, 0] <= mu_s) & (mu_s < largest[:, 1])))
    forward = all(junction.is_forward() for junction in junctions)
    return judged(
        "1F",
        shown={
            "largest deviation": max(linear, dropped, zero),
            "breaks in the first step beyond f_thres": "yes" if bracketed else "no",
            "latest repinning after t_R [steps]": max(late),
        },
        measured={
            "junctions, breaks, repinnings": [len(junctions), len(largest), len(repinned)],
            "pinned: |f - k_ij (x - x_ij)|/f_thres": linear,
            "largest f/f_N before a break": largest[:, 0].max(),
            "smallest that would have been reached a step later": largest[:, 1].min(),
            "slipping: |f - 0.17 f_N|/f_thres": dropped,
            "repinned: |f|/f_N": zero,
            "steps between t_R and the repinning": late,
            "blocks moved forwards throughout": "yes" if forward else "no",
        },
        note="Relative to f_thres, over every step of all junctions. Time is discrete: a junction"
        " breaks in the first step in which it would carry more than 0.4 f_N, so that the largest"
        " force is up to one step's stretch below that; it is zero in the first step at or after"
        " t_R.",
    )


def rows(junction):
    kept = np.zeros(junction.time.shape, dtype=bool)
    kept[::EVERY] = True
    for n in junction.changes:
        kept[n - 1 : n + 1] = True
    for n in np.flatnonzero(kept):
        ratio = junction.f[n] / junction.f_N[n]
        yield junction.time[n], junction.u[n] - junction.attachment, ratio, int(junction.pinned[n])


def make(data, results):
    slipping = sorted(data.glob("fig1/pulled-t*.h5"))
    pulled = Pulled(data / "fig1/junctions.h5", data / "fig1/pulled-record.h5", slipping)
    junctions = [Junction(pulled, i) for i in range(pulled.u.shape[1])]
    names = ["time [s]", "displacement [m]", "f_T/f_N", "pinned"]
    write_table(results / "junction.csv", names, rows(junctions[SHOWN]))
    return [claim_1F(junctions)]
