"""Fronts with other time steps and on finer lattices, and the bulk beside LAMMPS."""

import shutil
from functools import cache

from rupture.once import measured, run

from claims.recipes import RECIPES
from claims.samples import every
from convergence.lammps import compared
from events import EVENTS, FINE, shipped, shown_event
from maps import fronts_at, places_of, plain_front_at, spaced

STEPS = ("6e-7", "4e-7", "2e-7", "1e-7", "5e-8")  # [s]
UNCHANGED = "2e-7"  # as in the checkpoints
INPUTS = RECIPES.parent / "benchmarks/lammps"
# Without load, foundation, drive and junctions, blocks oscillate freely. The first step takes them
# to forces that are those of the free blocks.
FREE = (
    "--set slider.F_N=1e-9 --set slider.foundation=1e-15 --set driving.K=0"
    " --set junctions.kappa=1e-15"
)
LAMMPS = {  # name: options
    "LAMMPS": "",
    "LAMMPS, edge springs half and damping along spring": "--set slider.edge_springs=half"
    " --set slider.damping_along=spring",
}


def event_with(name, dt):
    """The front of event I, II or III with another time step."""
    recorded = f"--for 0.01 --set numerics.dt={dt} {FINE}"
    record = run(f"restart {shipped(EVENTS[name])} -o event.h5 {recorded}")["record.h5"]
    return run(f"analyze front {record} --event 0")


@cache
def events():
    """{event: its fronts, per time step}"""
    others = [(name, dt) for name in EVENTS for dt in STEPS if dt != UNCHANGED]
    found = every(event_with, others, "events")
    found |= {(name, UNCHANGED): shown_event(EVENTS[name]).front for name in EVENTS}
    return {name: [found[name, dt] for dt in STEPS] for name in EVENTS}


@cache
def prepared():
    """{(tau_bar_0, sigma_bar): its fronts, per time step}, on both edges of the map of Figure 4 D;
    None where no interface can be prepared."""
    places = places_of(spaced(0, 0.4, 0.02), (0, 0.285))
    by_step = [
        fronts_at(places, [1], f"--set numerics.dt={dt}", f"time step {dt} s", plain_front_at)
        for dt in STEPS
    ]
    return {at: [fronts[at][1] for fronts in by_step] for at in places}


@cache
def lammps():
    """{name: how far LAMMPS is from the slider of event I, released}; nothing without it."""
    if not shutil.which("lmp"):
        return {}
    found = {}
    for name, options in LAMMPS.items():
        start = f"restart {shipped('fast-slow-fast')} -o let-go.h5 {FREE} {options} --for 2e-7"
        let_go = run(start)["let-go.h5"]
        free = run(f"restart {let_go} -o free.h5 --for 0.0004")["free.h5"]
        found[name] = measured(compared, let_go, free, INPUTS / "compare.in", INPUTS / "bulk.in")
    return found
