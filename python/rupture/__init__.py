"""Checkpoints and records of rupture as numpy arrays, and its programs as functions.

    import rupture
    result = rupture.run("load", output="load.h5", record="load-record.h5", until=0.85)
    record = result.record
    record.time, record.x, record["tau"], record.units("tau")
    sim = rupture.Simulation("load.h5"); sim.run(until=0.9, call=print)

All numbers are in SI units. What goes wrong raises `rupture.Failure`, one sentence.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from rupture.errors import Failure
from rupture.programs import Result, analyze, output_of, run, verify

if TYPE_CHECKING:
    from rupture.files import Checkpoint, File, Record, open_file as open
    from rupture.simulation import Simulation

__all__ = ["Checkpoint", "Failure", "File", "Record", "Result", "Simulation"]
__all__ += ["analyze", "open", "run", "verify"]


def __dir__():
    return [*__all__, "__version__"]


def __getattr__(name):
    """`rupture.__version__` is that of the programs; h5py is imported only when it is needed."""
    if name == "__version__":
        return output_of("analyze", "--version").split("rupture ")[1].split(",")[0]
    if name in ("Checkpoint", "File", "Record", "open"):
        return getattr(import_module("rupture.files"), {"open": "open_file"}.get(name, name))
    if name == "Simulation":
        return import_module("rupture.simulation").Simulation
    raise AttributeError(f"module 'rupture' has no attribute '{name}'")
