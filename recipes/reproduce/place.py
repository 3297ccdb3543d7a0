"""The place where commands run: on this machine, or in an allocation of SLURM (docs/cluster.md)."""

import os
import re
from dataclasses import dataclass
from pathlib import Path

from rupture.commands.machine import programs_at_a_time, usable_cores, usable_megabytes
from rupture.errors import Failure
from rupture.tools.command_line import plural

INSIDE_STEP = re.compile(r"\d{1,6}")  # the interactive step of salloc has a larger number


def count_cores(text):
    """The cores of all nodes: SLURM_JOB_CPUS_PER_NODE is like 16(x2),8."""
    found = re.findall(r"(\d+)(?:\(x(\d+)\))?", text)
    return sum(int(cores) * int(nodes or 1) for cores, nodes in found)


def memory_of_allocation(environment, cores):
    """Memory [MB], or None if SLURM does not state it."""
    if per_core := environment.get("SLURM_MEM_PER_CPU"):
        return int(per_core) * cores
    if per_node := environment.get("SLURM_MEM_PER_NODE"):
        return int(per_node) * int(environment.get("SLURM_JOB_NUM_NODES", 1))
    return None


@dataclass(frozen=True)
class Place:
    name: str
    cores: int
    megabytes: int | None
    step: Path | None = None  # with which a command becomes a step of an allocation


def place_of(request):
    """Raises Failure if the profile cannot be used here."""
    if not request.profile:
        is_sweep = request.command == "sweep"  # whose file says what memory points need
        cores = request.given or (usable_cores() if is_sweep else programs_at_a_time())
        return Place(f"with {plural(cores, 'core')}", cores, usable_megabytes())
    if "SLURM_JOB_ID" not in os.environ:
        raise Failure(
            f"the profile {request.profile.parent.name} needs an allocation of SLURM; run the"
            " command with sbatch or salloc, as in docs/cluster.md"
        )
    if INSIDE_STEP.fullmatch(os.environ.get("SLURM_STEP_ID", "")):
        raise Failure(
            "inside a step of a job (srun), further steps would wait for its cores for ever;"
            " use the default profile here, or salloc or sbatch."
        )
    cores = count_cores(os.environ["SLURM_JOB_CPUS_PER_NODE"])
    name = f"in job {os.environ['SLURM_JOB_ID']} of SLURM, with {plural(cores, 'core')}"
    memory = memory_of_allocation(os.environ, cores)
    return Place(name, cores, memory, step=request.profile)
