"""Plans a user's sweep.

Checks the file and writes RESULTS/sweeps/NAME/NAME.ini, which Snakemake and report.py read. In
it, base and table of points are copies (decision 7, docs/sweeps.md), and every column has a unit.
"""

import io
import os
import re
from pathlib import Path

from rupture.errors import Failure, UsageError
from rupture.programs import output_of
from rupture.replacing import replacing
from runs.written import take
from sweeps.check import Programs, check_columns, check_points
from sweeps.sweep import check_form, errors_of, parse_ini, read_sweep, sweep_of

ENDINGS = (".csv", ".hdf5", ".png", ".pdf")


def write(results, path, content, *others):
    """Also reserves the names of the files that are written later."""
    take(results, path, *others)
    with replacing(path) as part:
        part.write_bytes(content)


def keep_base(path, results):
    """Makes a copy named after its content, with its .sum."""
    try:
        checksum = output_of("analyze", "checksum", path).strip()
    except Failure as failure:
        said = str(failure).removeprefix("analyze: ")
        raise UsageError(f"the base cannot be used: {said}") from None
    content = Path(path).read_bytes()
    if not content.startswith(b"rupture-checkpoint\n"):
        raise UsageError(f"the base {path} is a record; runs continue from checkpoints")
    copy = results / "data/bases" / f"{checksum[:16]}.h5"
    write(results, copy, content)
    write(results, Path(f"{copy}.sum"), f"content-sha256 {checksum}  {copy.name}\n".encode())
    return copy


def write_plan(ini, output, results):
    section = ini["sweep"]
    others = [output.with_suffix(ending) for ending in ENDINGS]
    if "base" in section:
        section["base"] = os.path.relpath(section["base"], output.parent)
    if "points" in section:
        copy = output.with_name(f"{output.stem}-points.csv")
        write(results, copy, Path(section["points"]).read_bytes(), output, *others)
        section["points"] = copy.name
    text = io.StringIO()
    ini.write(text)
    write(results, output, text.getvalue().encode(), *others)


def make_plan(path, results, is_dry):
    """The sweep. Replaces the former plan, which tells what the table is of, once nothing is wrong,
    unless it is only to be shown."""
    if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]*", path.stem):
        raise UsageError(
            "rename the file: its results take its name, which may contain only letters, digits,"
            " '.', '_' and '-'"
        )
    ini = parse_ini(path)
    check_form(ini)
    section = ini["sweep"]
    if "seeds" in section:
        raise UsageError("'seeds' is for recipes; write seed = 1 to 5 in [values]")
    if "points" in section and not Path(section["points"]).is_file():
        raise UsageError(f"there is no table of points {section['points']}")
    if "base" in section:
        section["base"] = str(keep_base(section["base"], results))
    sweep = sweep_of(ini, path.stem)
    programs = Programs()
    units = check_points(sweep.points, programs)
    ini["quantities"], units_of_columns = check_columns(sweep, programs)
    ini["units"] = units | units_of_columns
    if is_dry:
        return sweep
    output = results / "sweeps" / path.stem / f"{path.stem}.ini"
    write_plan(ini, output, results)
    return read_sweep(output)


def plan_sweep(path, results, is_dry=False):
    """The sweep as it is planned. The programs are those of $RUPTURE_BIN."""
    with errors_of(path):
        return make_plan(path, results, is_dry)
