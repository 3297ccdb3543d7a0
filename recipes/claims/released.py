"""The verdicts of the release, from the table docs/verdicts.csv, to stand beside those of a run."""

import csv
import re

TABLE = "docs/verdicts.csv"


def version_of(build):
    """The version in the text about a build (rupture/commands/code.py)."""
    found = re.match(r"rupture ([^,]+), ", build)
    return found and found[1]


def released(root, builds):
    """{claim: "0.6.0: in part, 58 of 91"}. Nothing unless builds of that version, from unchanged
    sources, wrote all that is behind the results."""
    table = root / TABLE
    known = {None if "-dirty" in build else version_of(build) for build, _ in builds}
    lines = table.read_text(encoding="utf-8").splitlines() if table.is_file() else ()
    return {
        row["id"]: f"{row['version']}: {row['verdict']}{share_of(row)}"
        for row in csv.DictReader(lines)
        if row["verdict"] and known <= {row["version"]}
    }


def share_of(row):
    """Nothing for one state."""
    return f", {row['holds']} of {row['samples']}" if row["samples"] not in ("", "1") else ""
