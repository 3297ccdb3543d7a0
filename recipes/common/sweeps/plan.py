"""Plans a user's sweep.

Checks the file, expands its short form and writes RESULTS/sweeps/NAME/NAME.ini, which Snakemake and
report.py read. In it, all is settled that is not in the file itself: the base is a copy that is
named after its content, so that a point's name follows from that; a table of points is a copy, too;
every column has a unit.
"""

import configparser
import re
import subprocess
from contextlib import contextmanager
from pathlib import Path

from rupture.replacing import replacing
from runs.written import note
from sweeps.columns import check_values, settle_columns, units_of_values
from sweeps.expand import expand
from sweeps.form import check_command, check_form, check_given_once, check_name, check_needed
from sweeps.names import names_of
from sweeps.sweep import SweepError, empty_ini, is_values, parse_ini, sentence_of, sweep_of

ENDINGS = (".ini", "-points.csv", ".csv", ".hdf5", ".png", ".pdf")


@contextmanager
def writing(path):
    try:
        with replacing(path) as part:
            yield part
    except OSError as error:
        raise SweepError(f"{path} cannot be written ({error.strerror})") from None


def keep_base(path, tools, results):
    """A copy whose name is that of its content, with its .sum."""
    done = subprocess.run(
        [Path(tools) / "analyze", "checksum", path], capture_output=True, text=True, check=False
    )
    if done.returncode:
        raise SweepError(
            f"the base cannot be used: {done.stderr.strip().removeprefix('analyze: ')}"
        )
    content = path.read_bytes()
    if not content.startswith(b"rupture-checkpoint\n"):
        raise SweepError(f"the base {path} is a record; runs go on from checkpoints")
    checksum = done.stdout.strip()
    copy = Path(results) / "data/bases" / f"{checksum[:16]}.h5"
    with writing(copy) as part:
        note(results, copy, f"{copy}.sum")
        part.write_bytes(content)
    with writing(f"{copy}.sum") as part:
        part.write_text(f"content-sha256 {checksum}  {copy.name}\n", encoding="utf-8")
    return copy


def settle_files(sweep, folder, tools, results):
    """Paths in [sweep] are relative to the folder of the file."""
    if "base" in sweep:
        sweep["base"] = str(keep_base(folder / sweep["base"], tools, results))
    if "points" in sweep:
        sweep["points"] = str(folder / sweep["points"])
        if not Path(sweep["points"]).is_file():
            raise SweepError(f"there is no table of points {sweep['points']}")


def keep_points(path, copy):
    """Copies the table: a change that a user makes during a run is for the next one."""
    content = Path(path).read_bytes()
    with writing(copy) as part:
        part.write_bytes(content)
    return str(copy)


def long_form(ini, names):
    """{section: {key: text}}, as in the recipes."""
    table = check_form(ini)
    if "commands" not in ini:
        return expand(ini, names)
    return {
        "sweep": dict(ini["sweep"]),
        "commands": dict(ini["commands"]),
        "table": dict(ini[table]),
    }


def parser_of(sections):
    ini = empty_ini()
    ini.read_dict(sections)
    return ini


def make_plan(path, names, tools, results):
    """The path of the plan, which replaces the former one once nothing is wrong."""
    if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._-]*", path.stem):
        raise SweepError(
            "the results get the name of the file: use letters, digits, '.', '_' and '-' for it"
        )
    ini = parse_ini(path)
    plan = long_form(ini, names)
    for name, line in plan["commands"].items():
        check_name(name)
        check_command(line, names.programs)
    plan["table"], units = settle_columns(plan["table"], plan["commands"], names)
    settle_files(plan["sweep"], path.parent, tools, results)
    plan |= {name: dict(ini[name]) for name in ini.sections() if is_values(name)}
    points = sweep_of(parser_of(plan), path.stem).points
    units_in_points = units_of_values(points, plan["commands"], names)
    check_values(points, units_in_points, plan["table"])
    for line in plan["commands"].values():
        check_needed(line, units_in_points, names.programs)
        check_given_once(line, units_in_points)
    plan["units"] = units_in_points | units
    output = Path(results) / "sweeps" / path.stem / f"{path.stem}.ini"
    if "points" in plan["sweep"]:
        copy = output.with_name(f"{path.stem}-points.csv")
        plan["sweep"]["points"] = keep_points(plan["sweep"]["points"], copy)
    with writing(output) as part, part.open("w", encoding="utf-8") as file:
        note(results, *(output.with_name(f"{path.stem}{ending}") for ending in ENDINGS))
        parser_of(plan).write(file)
    return output


def plan_sweep(path, tools, results):
    """The path of the plan. Raises SweepError, with the file and one sentence."""
    try:
        return make_plan(path, names_of(tools), tools, results)
    except (OSError, ValueError, configparser.Error) as error:
        raise SweepError(f"{path}: {sentence_of(error)}") from None
