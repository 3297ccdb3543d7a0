"""Compares the bulk with LAMMPS."""

import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import rupture
from rupture.errors import Failure

ALONE = {"OMP_NUM_THREADS": "1", "OMPI_MCA_ess_singleton_isolated": "1"}  # one process, no daemon
HEADER = """ITEM: TIMESTEP
{time}
ITEM: NUMBER OF ATOMS
{n}
ITEM: BOX BOUNDS ff ff pp
-1 1
-1 1
-1 1
ITEM: ATOMS id x y vx vy
"""


@dataclass(frozen=True)
class Blocks:
    """All blocks of a checkpoint, row by row from below: [blocks][2]."""

    step: int
    places: np.ndarray  # at rest [m]; the spacing is the same along x and z
    u: np.ndarray  # displacements [m]
    v: np.ndarray  # velocities [m/s]
    v_before: np.ndarray  # half a step before
    choices: dict[str, str]  # variables of bulk.in; older files have the defaults


def read_blocks(path):
    state = rupture.open(path)
    p, (rows, columns) = state.parameters, state["u_x"].shape
    u, v, f = (
        np.column_stack([state[f"{name}_{axis}"].ravel() for axis in "xz"]) for name in "uvf"
    )
    x, z = np.meshgrid(np.arange(columns), np.arange(rows))
    places = np.column_stack([x.ravel(), z.ravel()]) * p["slider.L"] / (columns - 1)
    mass, half_a_step = p["slider.M"] / (rows * columns), p["numerics.dt"] / 2
    names = {"edge": "slider.edge_springs", "along": "slider.damping_along"}
    choices = {key: p[name] for key, name in names.items() if name in p}
    return Blocks(state["step"], places, u, v, v - f / mass * half_a_step, choices)


def write_start(path, blocks):
    """LAMMPS numbers the blocks of a lattice in the same order, from 1."""
    numbers = np.arange(1, len(blocks.u) + 1)
    with open(path, "wb") as file:
        for time, velocities in enumerate((blocks.v_before, blocks.v)):
            file.write(HEADER.format(time=time, n=len(numbers)).encode())
            rows = np.column_stack([numbers, blocks.places + blocks.u, velocities])
            np.savetxt(file, rows, fmt=["%d", *["%.17g"] * 4])


def run_lammps(folder, steps, choices, inputs):
    compare, bulk = map(os.path.abspath, inputs)
    variables = {"bulk": bulk, "variant": "damping", "start": "start.dump"}
    pairs = (variables | {"steps": steps} | choices).items()
    words = [word for name, value in pairs for word in ("-var", name, str(value))]
    command = ["lmp", "-log", "none", "-nocite", "-in", compare, *words]
    subprocess.run(command, cwd=folder, env=os.environ | ALONE, stdout=sys.stderr, check=True)


def compared(start, end, *inputs):
    """Both files are checkpoints of free blocks of the same slider, without load, foundation, drive
    or junctions. LAMMPS takes the first one as many steps further as lie between them."""
    before, after = read_blocks(start), read_blocks(end)
    steps = after.step - before.step
    with tempfile.TemporaryDirectory() as folder:
        write_start(Path(folder, "start.dump"), before)
        run_lammps(folder, steps, after.choices, inputs)
        dumps = (Path(folder, f"{name}.dump") for name in ("places", "end"))
        places, moved = (np.loadtxt(path, skiprows=9)[:, 1:] for path in dumps)
    if np.abs(places - before.places).max() > 1e-12:
        raise Failure("LAMMPS numbers the blocks in another order: they cannot be compared")
    return {
        "steps": steps,
        "largest displacement [m]": np.abs(after.u).max(),
        "largest difference [m]": np.abs(moved - places - after.u).max(),
    }
