"""Figure 1 D-G: the driving force of a run, a block in event I, one junction, steady sliding."""

from functools import cache
from types import SimpleNamespace

import numpy as np
from rupture.once import measured, run
from rupture.reports import values

from claims.samples import Samples, Sample
from events import runs, shipped, shown_events, shown_load, samples_of_events
from fig1.junction import law_of_pulled
from measure.ways import PRIMARY
from measure.slip import peaks_of_record

MIDDLE = 28  # the block in the middle of the interface
# One junction per block, which carries the normal force of a reference junction (F_N/57/100), under
# a small stiff slider without prestress: tau/p = 0 is tau-bar = -mu_d/(mu_s - mu_d).
JUNCTIONS = (
    "--tau-bar -0.7391304347826086 --x-trigger 0 --set junctions.N_s=1 --set slider.Nx=3"
    " --set slider.Nz=3 --set slider.L=5e-3 --set slider.H=5e-3 --set driving.h=2.5e-3"
    " --set slider.F_N=1.01052631578947"
)
STEADY = "analyze steady-state --steps-per-cycle 20000"


def loading():
    return run(f"analyze loading {shown_load('reference')['record.h5']}")


@cache
def event():
    """Event I, at a sample per microsecond."""
    recorded = "--record record.h5 --record-every 1e-6"
    line = f"restart {shipped('fast-slow-fast')} -o event.h5 --for 0.005 {recorded}"
    record = run(line, keep=["record.h5"])["record.h5"]
    front = run(f"analyze front {record} --event 0")
    peaks = measured(peaks_of_record, record)
    return SimpleNamespace(record=record, fronts={PRIMARY: front}, peaks=peaks)


@cache
def pulled():
    """Junctions pulled at 1 mm/s, every step recorded: the files that Pulled reads."""
    prepared = run(f"prepare {JUNCTIONS} --no-trigger -o junctions.h5", keep=["junctions.h5"])
    slipping = [f"pulled-t{time:.9f}.h5" for time in (0.002, 0.0046)]  # all of them
    files = run(
        f"restart {prepared['junctions.h5']} -o pulled.h5 --set driving.V=1e-3 --for 6e-3"
        " --checkpoint-at 0.002 0.0046 --record record.h5 --record-every 2e-7",
        keep=["record.h5", *slipping],
    )
    return prepared["junctions.h5"], files["record.h5"], *(files[name] for name in slipping)


@cache
def steady():
    """The interface law at constant speed, without a slider."""
    return SimpleNamespace(
        range=run(f"{STEADY} --v-from 1e-4 --v-to 1 --points 17"),
        limits=run(f"{STEADY} --v-from 1e-9 --v-to 1e3 --points 2"),
    )


# --- what claims measure -----------------------------------------------------------------------


def each_run():
    taken = [Sample(seed, events) for seed, events in runs("reference")]
    return Samples({"": shown_events("reference")}, {PRIMARY: taken})


def drops(events, way):
    """1D"""
    over = [e for e in events[way] if e.is_over]
    first = min((e.t_start for e in over if e.spanning), default=np.inf)
    early = [e for e in over if e.t_start < first]
    largest = max(e.F_T_before - e.F_T_after for e in over)
    large = [e for e in over if e.F_T_before - e.F_T_after >= largest / 2]
    return {
        "early events that reach the leading edge": sum(e.t_rupture[-1] is not None for e in early),
        "large drops by other events": sum(not e.spanning for e in large),
        "large drops by spanning events": sum(e.spanning for e in large),
        "first spanning event at [s]": first,
    }


def each_event():
    return Samples({"": event()}, samples_of_events())


def peak(of, way):
    """1E"""
    front, peaks = of.fronts[way], of.peaks
    before, highest, after = (values(peaks[n])[MIDDLE] for n in ("before", "at_peak", "after"))
    late = peaks.t_peak[MIDDLE] - values(front.t_rupture)[MIDDLE]
    return {
        "block at [L]": front.x[MIDDLE] / front.L,
        "tau/p 0.5 ms before the event": before,
        "at its peak": highest,
        "peak minus rupture [ms]": late * 1e3,
        "rises and falls": before < highest > after,
    }


def junctions():
    return Samples({"": measured(law_of_pulled, *pulled())})


def law(found, _):
    """1F"""
    return {
        "junctions, breaks, repinnings": [found.junctions, found.breaks, found.repinnings],
        "largest deviation": found.deviation,
        "breaks in the first step beyond f_thres": found.breaks_beyond_f_thres,
        "latest repinning after t_R [steps]": found.latest_repinning,
        "blocks moved forwards throughout": found.moves_forwards,
    }


def both_ranges():
    return Samples({"": steady()})


def steady_friction(of, _):
    """1G"""
    found, mu = of.range, np.array(of.range.mu)
    off_limits = np.abs(np.array(of.limits.mu) / [0.4 / 2, 0.17] - 1)
    return {
        "tau/p at 0.1 mm/s and 1 m/s": [found.mu[0], found.mu[-1]],
        "largest change to the next speed": np.diff(mu).max(),
        "largest deviation from renewal theory": np.abs(mu / found.mu_theory - 1).max(),
        "largest deviation from the limits": off_limits.max(),
        "largest standard error": max(found.mu_error),
    }
