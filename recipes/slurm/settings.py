"""What a profile's srun.ini says. As a program it checks one: settings.py SRUN.ini"""

import configparser
import shlex
import sys
import time
from dataclasses import dataclass
from pathlib import Path

DEFAULTS = {"options": "", "jobs": "50", "group": "20", "group_time": "120"}


@dataclass(frozen=True)
class Settings:
    options: list  # of srun
    jobs: int  # at the same time
    group: int  # commands in one job at most
    group_time: int  # that such a job asks for at most [min]
    logs: Path
    folder: str  # by which squeue tells jobs of this folder,
    run: str  # and of this run


def values_of(path):
    """Raises ValueError with a sentence."""
    ini = configparser.ConfigParser(interpolation=None, inline_comment_prefixes=("#", ";"))
    try:
        ini.read_string(Path(path).read_text(encoding="utf-8"), str(path))
        values = dict(ini["srun"])
    except (OSError, UnicodeError, configparser.Error) as error:
        raise ValueError(f"it cannot be read ({' '.join(str(error).split())})") from None
    except KeyError:
        raise ValueError("it has no section [srun]") from None
    for name in values:
        if name not in DEFAULTS:
            raise ValueError(f"there is no key '{name}' (there are {', '.join(DEFAULTS)})")
    return DEFAULTS | values


def whole_number(name, text):
    if not text.isdecimal() or int(text) < 1:
        raise ValueError(f"{name} is a whole number from 1, not '{text}'")
    return int(text)


def read_settings(path, root, logs):
    values = values_of(path)
    numbers = [whole_number(name, values[name]) for name in ("jobs", "group", "group_time")]
    try:
        options = shlex.split(values["options"])
    except ValueError as error:
        raise ValueError(f"options cannot be split into words ({error})") from None
    started = time.strftime("%Y%m%d-%H%M%S")
    folder = f"rupture:{root}:"
    return Settings(options, *numbers, Path(logs) / "slurm" / started, folder, folder + started)


def main(path):
    try:
        read_settings(path, "", "")
    except ValueError as error:
        sys.exit(f"reproduce.sh: {path}: {error}")


if __name__ == "__main__":
    main(*sys.argv[1:])
