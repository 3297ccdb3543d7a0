"""Figure 3 A-C: events I and II from 0.14 L on, with the driving stopped, without slow slip, and
with other slipping times."""

from functools import cache
from types import SimpleNamespace

import numpy as np
from rupture.errors import Failure
from rupture.once import keep, run
from rupture.reports import value

from claims.samples import Samples, Sample
from events import EVENTS, WIDTH, branch_of, samples_of_branches, shown_event
from measure.fronts import front_spans, is_cut, last_block
from measure.ways import PRIMARY

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
    """Events I and II, and those of the ensemble; elsewhere is another way."""
    return Samples({name: continued(name) for name in SHOWN}, samples_of_branches())


def still_slow(of, way):
    """3A"""
    front = of.stopped[way]
    if front.fast_slow_fast is None:  # the record begins or ends amid its slow stretch
        return None
    return {
        "fast-slow-fast in words": front.fast_slow_fast,
        "front": front.type,
        "below c_s/10 from [L]": value(front, "in_words.x_from") / front.L,
    }


def arrest(of, way):
    """3B: from the centre of the first stencil below c_s/10 of the unmodified event."""
    front, x_from = of.no_slow_slip[way], value(of.fronts[way], "in_words.x_from")
    if is_cut(front):
        return None
    x_arrest = np.nan if front_spans(front) else WIDTH * last_block(front, of.block, way)
    return {
        "arrest [L]": x_arrest / front.L,
        "arrest - first stencil below c_s/10 [L]": (x_arrest - x_from) / front.L,
    }


def crossing(of, way):
    """no-crossing; the control has slow slip, and no drive, either."""
    front, control = of.no_slow_slip[way], of.stopped[way]
    if is_cut(front):
        return None
    return {
        "crosses without slow slip": front_spans(front),
        "crosses with slow slip": None if is_cut(control) else front_spans(control),
    }


def dose(of, way):
    """dose: steps are from <t_R>/2 to <t_R>, and from there to 2 <t_R>."""
    fronts = [of.half[way], of.stopped[way], of.double[way]]
    if any(map(is_cut, fronts)):
        return None
    half, as_it_is, double = (value(front, "in_words.slowest") for front in fronts)
    ends = np.array([value(front, "in_words.x_to") / front.L for front in fronts])
    return {
        "slowest speed, <t_R>/2 over <t_R>": half / as_it_is,
        "slowest speed, <t_R> over 2 <t_R>": as_it_is / double,
        "largest move of the end [L]": np.max(np.abs(ends - ends[1])),
        "exponent of the slowest speed in <t_R>": np.log2(double / half) / 2,
    }


# --- C: slip of a block ------------------------------------------------------------------------


def followed():
    """A sample is the slip of the block 0.06 L before an event's own transition, for <t_R> as it
    is, half and double. A block farther away is another way."""
    taken = samples_of_branches()
    found = {name: parts("own_slips", of) for name, of in taken.items()}
    found["block 0.1 L before it"] = parts("far_slips", taken[PRIMARY])
    return Samples({name: continued(name).own_slips for name in SHOWN}, found)


def parts(name, samples):
    """The samples with one part of what was found."""
    return [
        Sample(run, of if isinstance(of, Failure) else getattr(of, name)) for run, of in samples
    ]


def ruptured_before(slips):
    """Whether the block had ruptured before the branch, and so before anything was changed."""
    return any(one.get("t_before") is not None for one in slips)


def slip(slips, way):
    """3C"""
    if ruptured_before(slips):
        return None
    fast = [value(one, "fast_slip") for one in slips]
    rms = [value(one, "slow_rms") / value(one, "slow_slip") for one in slips]
    return {
        "largest/smallest fast slip": np.max(fast) / np.min(fast),
        "smallest R^2": np.min([value(one, "slow_r_squared") for one in slips]),
        "largest rms from the line/slow slip": np.max(rms),
    }


def beginning(slips, way):
    """3C-begin: when half of the fast slip has happened, and 5 % of the slow slip."""
    if ruptured_before(slips):
        return None
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
