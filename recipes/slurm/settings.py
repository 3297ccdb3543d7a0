"""What a profile's srun.ini says."""

import configparser
import shlex
import time
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Settings:
    options: list  # of srun
    jobs: int  # at the same time
    group: int  # commands in one job at most
    group_time: int  # that such a job asks for at most [min]
    logs: Path
    label: str  # by which squeue tells jobs of this folder


def read_settings(path, root, logs):
    ini = configparser.ConfigParser(interpolation=None)
    ini.read_string(Path(path).read_text(encoding="utf-8"), str(path))
    srun = ini["srun"]
    return Settings(
        shlex.split(srun.get("options", "")),
        srun.getint("jobs", 50),
        srun.getint("group", 20),
        srun.getint("group_time", 120),
        Path(logs) / "slurm" / time.strftime("%Y%m%d-%H%M%S"),
        f"rupture:{root}",
    )
