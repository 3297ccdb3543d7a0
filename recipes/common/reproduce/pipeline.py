"""Plans and computes with Snakemake, in a separate process:

    pipeline.py TARGET... -- OPTION OF SNAKEMAKE...
"""

import contextlib
import io
import sys

# Packages that would be imported where they are installed, which takes as long as planning; with
# None, they are not. Snakemake asks smart_open whether a path is one of a cloud, and pandas whether
# a parameter of a rule is a table, which none is here.
for package in ("azure", "boto3", "paramiko", "pandas"):
    sys.modules[package] = None  # type: ignore  # Python's manual allows it

from snakemake import main as run_snakemake  # noqa: E402

STAGES = ("start", "refine")  # recipes/Snakefile


class Errors(io.StringIO):
    """Standard error without the note about the profile, which newer Snakemakes print each time."""

    hidden = False

    def write(self, text):
        self.hidden = text.startswith("Using profile ") or (self.hidden and text == "\n")
        return len(text) if self.hidden else sys.__stderr__.write(text)

    def flush(self):
        sys.__stderr__.flush()


def snakemake(*arguments):
    """Does what the program `snakemake` does, in this process. Returns the exit code."""
    try:
        with contextlib.redirect_stderr(Errors()):
            run_snakemake([*arguments])
    except SystemExit as end:
        return end.code
    return 0


def plan(targets, options):
    """(file, state, what to do) for all files behind the targets; None if planning fails."""
    table = io.StringIO()
    with contextlib.redirect_stdout(table):
        if snakemake(*targets, "--summary", *options):
            return None
    rows = (line.split("\t") for line in table.getvalue().splitlines()[1:])
    return [(row[0], *row[5:7]) for row in rows]


def is_done(rows):
    return all(state != "missing" and to_do == "no update" for _, state, to_do in rows)


def compute(targets, options):
    """The first plan shows whether there is anything to do. If so, each stage has its own plan."""
    rows = plan([*STAGES, *targets], options)
    if rows is None:
        return 1
    if is_done(rows):
        print("Nothing to compute: all results are up to date.")
        return 0
    for stage in STAGES:
        if code := snakemake(stage, *options):
            return code
    rows = plan(targets, options)
    if rows is None:
        return 1
    # Files may be gone although what was made from them is not, as after an interrupted run:
    # Snakemake would take the older results for finished.
    missing = [path for path, state, to_do in rows if (state, to_do) == ("missing", "no update")]
    return snakemake(*targets, *missing, *options)


def main(*words):
    at = words.index("--")
    return compute(words[:at], words[at + 1 :])


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
