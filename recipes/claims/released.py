"""The verdicts of the release, from the table docs/verdicts.csv, to stand beside those of a run."""

import csv
from pathlib import Path

from report.origin import builds, version_of

TABLE = "docs/verdicts.csv"


def released(root, files):
    """{claim: "0.4.0: depends, 58 of 91"}. Nothing unless all checkpoints and records among the
    files behind the results were written by programs of that version, built from unchanged sources.
    Shipped checkpoints do not count: they are older, and their content has been verified."""
    table = root / TABLE
    runs = [name for name in files if not (root / "checkpoints" / Path(name).name).exists()]
    known = {None if "-dirty," in build else version_of(build) for build, _ in builds(root, runs)}
    lines = table.read_text(encoding="utf-8").splitlines() if table.is_file() else ()
    return {
        row["id"]: f"{row['version']}: {row['verdict']}{share_of(row)}"
        for row in csv.DictReader(lines)
        if row["verdict"] and known <= {row["version"]}
    }


def share_of(row):
    """Nothing for one state."""
    return f", {row['holds']} of {row['units']}" if row["units"] not in ("", "1") else ""
