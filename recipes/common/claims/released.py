"""The verdicts of the release, from the table docs/verdicts.csv, to stand beside those of a run."""

from data.tables import read_rows

TABLE = "docs/verdicts.csv"


def released(root, builds):
    """{claim: "0.4.0: depends, 58 of 91"}. Nothing unless all records behind the results were
    written by programs of that version, built from unchanged sources. `builds`: their texts, as
    origin.builds() has them."""
    rows = read_rows(root / TABLE) if (root / TABLE).is_file() else []
    return {
        row["id"]: f"{row['version']}: {row['verdict']}{share_of(row)}"
        for row in rows
        if row["verdict"] and all(is_of(row["version"], build) for build in builds)
    }


def is_of(version, build):
    return build.startswith(f"rupture {version}, ") and "-dirty," not in build


def share_of(row):
    """None for one state."""
    return f", {row['holds']} of {row['units']}" if row["units"] not in ("", "1") else ""
