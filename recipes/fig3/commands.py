"""Figure 3 A-C: events I and II from 0.14 L on, with the driving stopped, without slow slip, and
with other slipping times."""

from functools import cache
from types import SimpleNamespace

import numpy as np
from rupture.once import keep, run
from rupture.reports import value

from claims.samples import Samples, Unit
from events import EVENTS, branch_of, shown_event, units_of_branches
from measure.conventions import PRIMARY

SHOWN = ("event II", "event I")  # the paper shows the first
BLOCK = 8  # of the branch, at 0.14 L


@cache
def continued(name):
    """Event I or II, continued as those of the ensemble are."""
    of = branch_of(shown_event(EVENTS[name]), BLOCK, 0.01)
    keep(of.start, *of.records.values())
    return of


@cache
def every_step(name):
    """The fast slip of the block that Figure 3 C shows, at every step."""
    changed = "--set driving.V=0 --for 0.001 --record record.h5 --record-every 2e-7"
    record = run(f"restart {continued(name).start} -o end.h5 {changed}")["record.h5"]
    return run(f"analyze slip {record} --x 0.0476")


def branches():
    """Events I and II, and those of the ensemble; elsewhere is another convention."""
    return Samples({name: continued(name) for name in SHOWN}, units_of_branches())


def still_slow(of, way):
    """3A"""
    front = of.stopped[way]
    return {
        "fast-slow-fast in words": front.fast_slow_fast,
        "front": front.type,
        "below c_s/10 from [L]": value(front, "in_words.x_from") / front.L,
    }


def arrest(of, way):
    """3B: from the centre of the first stencil below c_s/10 of the unmodified event."""
    x_arrest, L = value(of.no_slow_slip, "x_arrest"), of.no_slow_slip.L
    x_from = value(of.fronts[way], "in_words.x_from")
    return {
        "arrest [L]": x_arrest / L,
        "arrest - first stencil below c_s/10 [L]": (x_arrest - x_from) / L,
    }


# --- C: slip of a block ------------------------------------------------------------------------


def followed():
    """A sample is the slip of the block 0.06 L before an event's own transition, for <t_R> as it
    is, half and double. A block farther away is another convention."""
    units = units_of_branches()
    found = {name: [Unit(run, of.own_slips) for run, of in own] for name, own in units.items()}
    found["block 0.1 L before it"] = [Unit(run, of.far_slips) for run, of in units[PRIMARY]]
    return Samples({name: continued(name).own_slips for name in SHOWN}, found)


def slip(slips, way):
    """3C"""
    fast = [value(one, "fast_slip") for one in slips]
    rms = [value(one, "slow_rms") / value(one, "slow_slip") for one in slips]
    return {
        "largest/smallest fast slip": np.max(fast) / np.min(fast),
        "smallest R^2": np.min([value(one, "slow_r_squared") for one in slips]),
        "largest rms from the line/slow slip": np.max(rms),
    }


def beginning(slips, way):
    """3C-begin: when half of the fast slip has happened, and 5 % of the slow slip."""
    of, *_ = slips
    time, moved, fast = np.array(of.time), np.array(of.slip), value(of, "fast_slip")
    t_arrest, slow = value(of, "t_arrest"), value(of, "slow_slip")
    half = time[moved >= fast / 2]
    again = time[(time >= t_arrest) & (moved >= fast + slow / 20)]
    return {
        "half of the fast slip after the rupture by [ms]": (
            np.min(half, initial=np.inf) - value(of, "t_rupture")
        )
        * 1e3,
        "arrest [ms]": (np.min(again, initial=np.inf) - t_arrest) * 1e3,
    }


def peaks():
    found = {name: (every_step(name), continued(name).slips[0]) for name in SHOWN}
    return Samples({n: SimpleNamespace(every_step=e, slip=s) for n, (e, s) in found.items()})


def fastest(slip, shown):
    """The largest speed between samples that begin at times that are shown [m/s]."""
    time = np.array(slip.time)
    speeds = np.diff(slip.slip) / np.diff(time)
    return np.max(speeds[shown(time[:-1])], initial=-np.inf)


def ratios(of, way):
    """3C-ratios: the peak over all steps until the arrest, and that of the slide later."""
    slip = of.slip
    peak = fastest(of.every_step, lambda time: time <= slip.t_arrest)
    slide = fastest(slip, lambda time: time >= slip.slow_end)
    return {
        "peak/slow slip speed": peak / slip.slow_speed,
        "fast/slow slip distance": slip.fast_slip / slip.slow_slip,
        "peak slip speed while the front passes [mm/s]": peak * 1e3,
        "peak slip speed while the whole slider slides [mm/s]": slide * 1e3,
    }
