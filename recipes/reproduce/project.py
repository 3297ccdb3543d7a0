"""Where things are, and how the commands fail."""

import ast
import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LOGS = Path("build/log")
PROGRAMS = Path("build/release/bin")
PROFILES = Path("recipes/profiles")


class Failure(Exception):
    """A command failed; the text says why."""


class UsageError(Exception):
    """The command line makes no sense; the text says why."""


def recipe_names():
    """The figures, and recipes that belong to none."""
    return [path.parent.name for path in Path("recipes").glob("*/rules.smk")]


def recipes_of_all():
    """Those that `all` computes; the Snakefile names the ones that it leaves out."""
    text = Path("recipes/Snakefile").read_text(encoding="utf-8")
    left_out = ast.literal_eval(re.findall(r"^BESIDE_ALL = (.*)$", text, re.MULTILINE)[0])
    return [name for name in recipe_names() if name not in left_out]


def use_own_environment():
    """Caches in the project's folder; with Debian's Snakemake, no packages of the user's own."""
    cache = ROOT / "build/cache"
    (cache / "matplotlib").mkdir(parents=True, exist_ok=True)
    if os.access("/usr/bin/snakemake", os.X_OK):
        os.environ["PYTHONNOUSERSITE"] = "1"
    os.environ.update(XDG_CACHE_HOME=str(cache), MPLCONFIGDIR=str(cache / "matplotlib"))


def say(text=""):
    """At once: the programs that are started next print, too."""
    print(text, flush=True)


def complain(text):
    print(f"reproduce.sh: {text}", file=sys.stderr, flush=True)
