"""The verdicts of the release, from the table docs/verdicts.csv, to stand beside those of a run."""

from pathlib import Path

from data.tables import read_rows
from runs.origin import builds

TABLE = "docs/verdicts.csv"


def released(root, files):
    """{claim: "0.4.0: depends, 58 of 91"}. Nothing unless all checkpoints and records among the
    files behind the results were written by programs of that version, built from unchanged sources.
    Shipped checkpoints do not count: they are older, and their content has been verified."""
    runs = [name for name in files if not (root / "checkpoints" / Path(name).name).exists()]
    rows = read_rows(root / TABLE) if (root / TABLE).is_file() else []
    return {
        row["id"]: f"{row['version']}: {row['verdict']}{share_of(row)}"
        for row in rows
        if row["verdict"] and all(is_of(row["version"], build) for build, _ in builds(root, runs))
    }


def is_of(version, build):
    return build.startswith(f"rupture {version}, ") and "-dirty," not in build


def share_of(row):
    """Nothing for one state."""
    return f", {row['holds']} of {row['units']}" if row["units"] not in ("", "1") else ""
