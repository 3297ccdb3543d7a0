"""From the short form of a user's sweep to the long one of common/sweeps.py: [commands] and [table]
instead of base, prepare, load and restart in [sweep], [quantities] and [analyze]."""

from common.sweeps import SweepError, is_values
from sweep.names import CHECKPOINT, RECORD, options_in

STARTS = ("base", "prepare", "load")
GIVEN_BY_THE_SWEEP = ("o", "output", "record", "f", "force", "resume", "json", "csv", "dry-run")


def words(*texts):
    return " ".join(text for text in texts if text)


def check_options(key, text, values):
    """Options of the file that the chain gives itself, or that have values in [values]."""
    for option in options_in(text):
        if option in GIVEN_BY_THE_SWEEP:
            raise SweepError(f"'{key}' must not have '{option}', which the sweep gives itself")
        if option in values:
            raise SweepError(f"--{option} is both in '{key}' and in [values]; remove one of them")


def start_of(sweep):
    """Which of base, prepare and load the points start from."""
    found = [key for key in STARTS if key in sweep]
    if len(found) != 1:
        given = " and ".join(found) or "none"
        raise SweepError(
            f"[sweep] needs one of base, prepare and load, to start from; it has {given}"
        )
    return found[0]


def chain(start, sweep):
    """The commands that run the model, and the names of the last checkpoint and the record."""
    restart = sweep.get("restart")
    goes_on = "-o end.h5 --record record.h5 --quiet"
    if start == "base":
        if restart is None:
            raise SweepError(
                "[sweep] has a base, but not how it goes on, as in restart = --for 0.01"
            )
        return {"restart": words("restart {base}", restart, "{values}", goes_on)}, "end.h5", True
    if start == "load" and restart is None:
        return {"load": words("load", sweep["load"], "{values}", goes_on)}, "end.h5", True
    first = words(start, sweep[start], "{values} -o start.h5 --quiet")
    if restart is None:
        return {start: first}, "start.h5", False
    return {start: first, "restart": words("restart start.h5", restart, goes_on)}, "end.h5", True


def reads(analysis, checkpoint, has_record):
    """The file that `analyze ANALYSIS` measures."""
    if analysis in CHECKPOINT:
        return checkpoint
    if analysis not in RECORD:
        raise SweepError(f"analyze {analysis} reads no file of the points; use [commands] for it")
    if not has_record:
        raise SweepError(
            f"analyze {analysis} reads the record of a run, and there is none: say how the points"
            " go on, as in restart = --until-quiet 0.01"
        )
    return "record.h5"


def expand(ini, names):
    """{section: {key: text}} of the long form. Raises SweepError."""
    sweep, quantities = ini["sweep"], dict(ini["quantities"])
    options = dict(ini["analyze"]) if "analyze" in ini else {}
    values = {name for section in ini.values() if is_values(section.name) for name in section}
    start = start_of(sweep)
    for key in ("prepare", "load", "restart"):
        check_options(key, sweep.get(key, ""), values if key in (start, "restart") else ())
    for path in quantities.values():
        names.quantity_unit(path, of_file=True)
    commands, checkpoint, has_record = chain(start, sweep)
    analyses = sorted({path.split(".")[0] for path in quantities.values()})
    for name in options:
        if name not in analyses:
            raise SweepError(f"[analyze] has options for '{name}', of which there is no quantity")
    for name in analyses:
        check_options(name, options.get(name, ""), ())
        file = reads(name, checkpoint, has_record)
        commands[name] = words("analyze", name, file, options.get(name), "--json")
    kept = {key: text for key, text in sweep.items() if key not in ("prepare", "load", "restart")}
    return {"sweep": kept, "commands": commands, "table": quantities}
