"""Where commands run: on this machine, or in an allocation of SLURM (docs/cluster.md)."""

import os
import re
from dataclasses import dataclass
from pathlib import Path

from reproduce.project import Failure

STEP = "step"  # file of a profile with which commands become steps of an allocation
INSIDE_STEP = re.compile(r"\d{1,6}")  # the interactive step of salloc has a larger number


def count_cores(text):
    """Of all nodes: SLURM_JOB_CPUS_PER_NODE is like 16(x2),8."""
    return sum(
        int(cores) * int(nodes or 1) for cores, nodes in re.findall(r"(\d+)(?:\(x(\d+)\))?", text)
    )


def memory_of_allocation(environment, cores):
    """[MB], as far as SLURM says how much it gives; else None."""
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
    shell: Path | None = None


def place_of(request):
    """Raises Failure if the profile cannot be used here."""
    step = request.profile / STEP
    if not step.exists():
        megabytes = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") // 2**20
        return Place(f"with {request.cores} cores", request.cores, megabytes)
    if "SLURM_JOB_ID" not in os.environ:
        raise Failure(
            f"the profile {request.profile.name} computes in an allocation of SLURM; give the"
            " command to sbatch or salloc, as docs/cluster.md says"
        )
    if INSIDE_STEP.fullmatch(os.environ.get("SLURM_STEP_ID", "")):
        raise Failure(
            "inside a step of a job (srun), further steps would wait for its cores for ever;"
            " use the usual profile here, or salloc or sbatch."
        )
    cores = count_cores(os.environ["SLURM_JOB_CPUS_PER_NODE"])
    name = f"in job {os.environ['SLURM_JOB_ID']} of SLURM, with {cores} cores"
    return Place(name, cores, memory_of_allocation(os.environ, cores), step)
