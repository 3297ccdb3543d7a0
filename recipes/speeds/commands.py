"""Speeds of slip and of fronts on prepared interfaces; how unevenly the blocks of loads slip."""

from functools import cache
from itertools import product

from rupture.once import measured, run

from claims.samples import every
from events import checkpoint_at
from fig3.slow_fronts import as_typed, rows_of, words_of
from maps import record_of
from measure.fronts import front_spans
from speeds.slip_history import history_of

TAU_BARS = (
    *(0.06, 0.07, 0.08, 0.09, 0.1, 0.12, 0.14, 0.16, 0.18, 0.2),
    *(0.25, 0.3, 0.35, 0.4, 0.45, 0.5),
)
SEEDS = range(1, 6)
PLACES = (0.055, 0.07, 0.085, 0.1)  # where slip is followed [m]
LOADS = range(201, 206)  # seeds
EVERY = 0.05  # [s]
TIMES = [n / 20 for n in range(1, 25)]  # of checkpoints [s]


# --- fronts ------------------------------------------------------------------------------------


def parameters(**changed):
    """The mass and load per block are kept; with M so are the damping ratio and the number of steps
    in which a wave passes a block."""
    of = {"numerics.seed": 1, "tau-bar": 0.1, "sigma-bar": 0.1, "slider.L": 0.14, "slider.Nx": 57}
    blocks = changed.get("slider.Nx", 57) / 57
    of |= {"slider.M": 0.0756 * blocks, "slider.F_N": 1920 * blocks, "slider.damping": 0.1}
    return as_typed(of | {"numerics.dt": 2e-7} | changed)


def of_mass(M):
    return {"slider.M": M, "numerics.dt": 2e-7 * (M / 0.0756) ** 0.5}


VARIANTS = {
    "prestress": [{"tau-bar": t, "sigma-bar": s} for t, s in product(TAU_BARS, (0, 0.1, 0.2))],
    "long": [{"tau-bar": t, "slider.L": 0.28, "slider.Nx": 113} for t in TAU_BARS],
    "mass": [
        {"numerics.seed": seed, "tau-bar": tau_bar} | of_mass(M)
        for seed, tau_bar, M in product(SEEDS, (0.1, 0.3), (0.0378, 0.0756, 0.1512))
    ],
    "damping": [
        {"numerics.seed": seed, "tau-bar": tau_bar, "slider.damping": damping}
        for seed, tau_bar, damping in product(SEEDS, (0.1, 0.3), (0.025, 0.1, 0.4))
    ],
}


def front_of(variant, parameters):
    """(row of the parameters, front, slip of four blocks). Records of each microsecond are too
    large to keep."""
    record = record_of(words_of(parameters), "--record record.h5 --record-every 1e-6")
    front = run(f"analyze front {record}")
    slips = [run(f"analyze slip {record} --x {x}") for x in PLACES]
    return {"variant": variant, **parameters}, front, slips


@cache
def fronts():
    """The fronts that span."""
    found = rows_of(VARIANTS, parameters, "fronts", front_of)
    return [(row, front, slips) for row, front, slips in found if front_spans(front)]


# --- loads -------------------------------------------------------------------------------------


def history(seed):
    """Rows of a load that is recorded with small intervals."""
    names = [checkpoint_at(time) for time in TIMES]
    recorded = f"--checkpoint-every {EVERY} --record record.h5 --record-every 1e-4"
    line = f"load --set numerics.seed={seed} -o load.h5 --until 1.2 {recorded}"
    load = run(line, keep=["record.h5", *names])
    rows = measured(history_of, load["record.h5"], *(load[name] for name in names))
    return [{"load": seed, **row} for row in rows]


@cache
def histories():
    found = every(history, [(seed,) for seed in LOADS], "loads")
    return [row for rows in found.values() for row in rows]
