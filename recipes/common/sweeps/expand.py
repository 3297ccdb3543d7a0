"""From the short form of a user's sweep to the long one of sweeps/sweep.py: [commands] and [table]
instead of base, prepare, load and restart in [sweep], [quantities] and [analyze]."""

from sweeps.names import options_in
from sweeps.sweep import SweepError

STARTS = ("base", "prepare", "load")
GIVEN_BY_THE_SWEEP = ("o", "output", "record", "q", "quiet", "json", "csv")


def words(*texts):
    return " ".join(text for text in texts if text)


def check_options(key, text):
    """Options that the chain gives itself."""
    for option in options_in(text):
        if option in GIVEN_BY_THE_SWEEP:
            raise SweepError(f"'{key}' must not have '{option}', which the sweep gives itself")


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


def reads(analysis, programs, checkpoint, has_record):
    """The file that `analyze ANALYSIS` measures."""
    kind = programs[f"analyze {analysis}"].input
    if kind == "checkpoint":
        return checkpoint
    if kind != "record":
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
    start = start_of(sweep)
    for key in ("prepare", "load", "restart"):
        check_options(key, sweep.get(key, ""))
    for path in quantities.values():
        names.quantity_unit(path, of_file=True)
    commands, checkpoint, has_record = chain(start, sweep)
    analyses = sorted({path.split(".")[0] for path in quantities.values()})
    for name in options:
        if name not in analyses:
            raise SweepError(f"[analyze] has options for '{name}', of which there is no quantity")
    for name in analyses:
        check_options(name, options.get(name, ""))
        file = reads(name, names.programs, checkpoint, has_record)
        commands[name] = words("analyze", name, file, options.get(name), "--json")
    kept = {key: text for key, text in sweep.items() if key not in ("prepare", "load", "restart")}
    return {"sweep": kept, "commands": commands, "table": quantities}
