"""Plans a user's sweep.

Checks the file and writes RESULTS/sweeps/NAME/NAME.ini, which Snakemake and report.py read. In
it, all is settled that is not in the file itself: the base is a copy that is named after its
content, so that the name of a point follows from that; a table of points is a copy, too; every
column has a unit.
"""

import io
import os
import re
import subprocess
from pathlib import Path

from rupture.replacing import replacing
from runs.written import note
from sweeps.check import Programs, check_columns, check_points
from sweeps.sweep import SweepError, check_form, errors_of, parse_ini, sweep_of

ENDINGS = (".csv", ".hdf5", ".png", ".pdf")


def write(results, path, content, *others):
    """Notes the others, which are to come, too."""
    try:
        note(results, path, *others)
        with replacing(path) as part:
            part.write_bytes(content)
    except OSError as error:
        raise SweepError(f"{path} cannot be written ({error.strerror})") from None


def keep_base(path, tools, results):
    """A copy whose name is that of its content, with its .sum."""
    done = subprocess.run(
        [Path(tools) / "analyze", "checksum", path], capture_output=True, text=True, check=False
    )
    if done.returncode:
        said = done.stderr.strip().removeprefix("analyze: ")
        raise SweepError(f"the base cannot be used: {said}")
    content = Path(path).read_bytes()
    if not content.startswith(b"rupture-checkpoint\n"):
        raise SweepError(f"the base {path} is a record; runs go on from checkpoints")
    checksum = done.stdout.strip()
    copy = Path(results) / "data/bases" / f"{checksum[:16]}.h5"
    write(results, copy, content)
    write(results, Path(f"{copy}.sum"), f"content-sha256 {checksum}  {copy.name}\n".encode())
    return str(copy)


def make_plan(path, tools, results):
    """Replaces the former plan once nothing is wrong."""
    if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]*", path.stem):
        raise SweepError(
            "the results get the name of the file: use letters, digits, '.', '_' and '-' for it"
        )
    ini = parse_ini(path)
    check_form(ini)
    section = ini["sweep"]
    if "seeds" in section:
        raise SweepError("'seeds' is for recipes; write seed = 1 to 5 in [values]")
    if "points" in section and not Path(section["points"]).is_file():
        raise SweepError(f"there is no table of points {section['points']}")
    if "base" in section:
        section["base"] = keep_base(section["base"], tools, results)
    sweep, programs = sweep_of(ini, path.stem), Programs(tools)
    units = check_points(sweep.points, programs)
    ini["quantities"], units_of_columns = check_columns(sweep, programs)
    ini["units"] = units | units_of_columns
    return write_plan(ini, Path(results) / "sweeps" / path.stem / f"{path.stem}.ini", results)


def write_plan(ini, output, results):
    """Its own table of points: a change that a user makes during a run is for the next one."""
    section = ini["sweep"]
    if "base" in section:
        section["base"] = os.path.relpath(section["base"], output.parent)
    if "points" in section:
        copy = output.with_name(f"{output.stem}-points.csv")
        write(results, copy, Path(section["points"]).read_bytes())
        section["points"] = copy.name
    text = io.StringIO()
    ini.write(text)
    others = (output.with_name(f"{output.stem}{ending}") for ending in ENDINGS)
    write(results, output, text.getvalue().encode(), *others)
    return output


def plan_sweep(path, tools, results):
    """The path of the plan."""
    with errors_of(path):
        return make_plan(path, tools, results)
