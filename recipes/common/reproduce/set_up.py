"""Packages and building, by set-up.sh."""

import sys
from pathlib import Path

from reproduce.project import WORK

SCRIPT = Path(__file__).with_name("set-up.sh")


def set_up(processes, *words):
    """The script has said why, if it fails."""
    if code := processes.run([SCRIPT, *map(str, words)]):
        sys.exit(code)


def ensure_packages(processes, *purposes):
    """An installed rupture has been installed with them."""
    if not WORK:
        set_up(processes, "packages", *purposes)


def build(processes, cores, target, *purposes):
    """While it compiles, packages for these purposes are installed."""
    set_up(processes, "build", cores, target, *purposes)
