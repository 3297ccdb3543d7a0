"""Plans and computes with Snakemake, in a process of its own:

    pipeline.py TARGET... -- OPTION OF SNAKEMAKE...
"""

import contextlib
import io
import sys

from snakemake import main as run_snakemake

STAGES = ("start", "refine")  # recipes/Snakefile


def snakemake(*arguments):
    """Its exit code. This is the program `snakemake`, without starting it anew each time."""
    try:
        run_snakemake([*arguments])
    except SystemExit as end:
        return end.code
    return 0


def missing_files(targets, options):
    """Files that are gone although what was made from them is not, as after an interrupted run.
    Snakemake would take the older results for finished. None if it cannot plan."""
    table = io.StringIO()
    with contextlib.redirect_stdout(table):
        if snakemake(*targets, "--summary", *options):
            return None
    rows = (line.split("\t") for line in table.getvalue().splitlines()[1:])
    return [row[0] for row in rows if row[5:7] == ["missing", "no update"]]


def compute(targets, options):
    for stage in STAGES:
        if code := snakemake(stage, *options):
            return code
    missing = missing_files(targets, options)
    return 1 if missing is None else snakemake(*targets, *missing, *options)


def main(*words):
    at = words.index("--")
    return compute(words[:at], words[at + 1 :])


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
