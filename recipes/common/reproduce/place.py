"""Where commands run: on this machine, or in an allocation of SLURM (docs/cluster.md)."""

import os
import re

from reproduce.project import Failure

STEP = "step"  # file of a profile with which commands become steps of an allocation
INSIDE_STEP = re.compile(r"\d{1,6}")  # the interactive step of salloc has a larger number


def count_cores(text):
    """Of all nodes: SLURM_JOB_CPUS_PER_NODE is like 16(x2),8."""
    return sum(
        int(cores) * int(nodes or 1) for cores, nodes in re.findall(r"(\d+)(?:\(x(\d+)\))?", text)
    )


def memory_of_machine():
    return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") // 2**20


def memory_of_allocation(environment, cores):
    """[MB], as far as SLURM says how much it gives; else None."""
    if per_core := environment.get("SLURM_MEM_PER_CPU"):
        return int(per_core) * cores
    if per_node := environment.get("SLURM_MEM_PER_NODE"):
        return int(per_node) * int(environment.get("SLURM_JOB_NUM_NODES", 1))
    return None


class ThisMachine:
    def __init__(self, cores):
        self.cores = cores
        self.megabytes = memory_of_machine()
        self.shell = None

    def __str__(self):
        return f"with {self.cores} cores"


class Allocation:
    def __init__(self, profile, environment):
        if "SLURM_JOB_ID" not in environment:
            raise Failure(
                f"the profile {profile.name} computes in an allocation of SLURM; give the command"
                " to sbatch or salloc, as docs/cluster.md says"
            )
        if INSIDE_STEP.fullmatch(environment.get("SLURM_STEP_ID", "")):
            raise Failure(
                "inside a step of a job (srun), further steps would wait for its cores for ever;"
                " use the usual profile here, or salloc or sbatch."
            )
        self.name = f"in job {environment['SLURM_JOB_ID']} of SLURM"
        self.cores = count_cores(environment["SLURM_JOB_CPUS_PER_NODE"])
        self.megabytes = memory_of_allocation(environment, self.cores)
        self.shell = profile / STEP

    def __str__(self):
        return f"{self.name}, with {self.cores} cores"


def place_of(request):
    """Raises Failure if the profile cannot be used here."""
    if (request.profile / STEP).exists():
        return Allocation(request.profile, os.environ)
    return ThisMachine(request.cores)
