"""The programs as functions."""

import json
import os
import re
import shutil
import signal
import subprocess
import threading
from contextlib import contextmanager, suppress
from functools import cached_property
from glob import escape
from pathlib import Path

import rupture
from rupture.errors import Failure, MachineFailure, UsageError

PACKAGE = Path(__file__).resolve().parent

DRAWING = ("map", "movie", "xdmf")  # they write no checkpoint


def own_folder():
    """The folder of programs of the build or installation that this package belongs to."""
    if (PACKAGE / "../../CMakeLists.txt").exists():
        return PACKAGE.parents[1] / "build/release/bin"
    return PACKAGE.parents[3] / "libexec/rupture"  # from lib/python3/dist-packages


def folders():
    """Where programs are: the folder $RUPTURE_BIN; or that of this build or installation, then
    those of the `rupture` on the PATH."""
    own = os.environ.get("RUPTURE_BIN")
    yield Path(own or own_folder())
    if not own and (found := shutil.which("rupture")):
        bin_folder = Path(found).resolve().parent
        yield from (bin_folder.parent / "libexec/rupture", bin_folder)


def path_of(program):
    """The path of a program in one of these folders."""
    for path in (str(folder / program) for folder in folders()):
        if os.path.isfile(path) and os.access(path, os.X_OK):
            return path
    own = os.environ.get("RUPTURE_BIN")
    where = f"not in RUPTURE_BIN={own}" if own else "neither built nor installed, nor on the PATH"
    raise Failure(
        f"program {program} not found: {where}; build it, or set RUPTURE_BIN to its folder"
    )


def words(value):
    """The values of an option, or several in a list or an array, as words of a command line."""
    value = value.tolist() if hasattr(value, "tolist") else value
    several = value if isinstance(value, (list, tuple)) else [value]
    return [str(getattr(one, "path", one)) for one in several]  # that of an opened file


def options_of(options):
    """Keyword arguments as options: `until_quiet=0.01` is --until-quiet 0.01, `for_=0.02` is
    --for 0.02, True a flag; False and None are left out. Several values are one word, such as
    0.2,0.5, but of --checkpoint-at."""
    for name, value in options.items():
        if value is None or value is False:
            continue
        yield "--" + name.rstrip("_").replace("_", "-")
        if value is not True:
            yield from words(value) if name == "checkpoint_at" else [",".join(words(value))]


def settings_of(parameters):
    """--set for each of these: one value, a list or an array with that of each block, or a list of
    parts, such as "0.5 from 70mm to 84mm", of which each changes what those before it left."""
    try:
        parameters = dict(parameters)
    except (TypeError, ValueError):
        wanted = "a dict, such as {'driving.V': 0}"
        raise UsageError(f"set must be {wanted} (got {parameters!r})") from None
    for name, value in parameters.items():
        has_parts = isinstance(value, (list, tuple)) and any(" from " in f"{one}" for one in value)
        for part in value if has_parts else [value]:
            yield from ("--set", f"{name}={','.join(words(part))}")


@contextmanager
def passing_on_interruptions(process):
    """Ctrl-C within goes to the process, which may be in another group, instead of ending us. (One
    from a terminal reaches it twice at once; a run takes this for one.) Yields a list, which is not
    empty once it came."""
    came: list = []
    is_main = threading.current_thread() is threading.main_thread()
    is_default = is_main and signal.getsignal(signal.SIGINT) is signal.default_int_handler
    if is_default:
        signal.signal(signal.SIGINT, lambda *_: came.append(process.send_signal(signal.SIGINT)))
    try:
        yield came
    finally:
        if is_default:
            signal.signal(signal.SIGINT, signal.default_int_handler)


def output_of(program, *arguments):
    """Runs a program and returns its standard output. Raises Failure with its sentence if it
    failed, UsageError if it was asked for something impossible, KeyboardInterrupt after Ctrl-C.
    That files differ is a result."""
    command = [path_of(program)] + [word for given in arguments for word in words(given)]
    streams: dict = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "encoding": "utf-8"}
    try:
        process = subprocess.Popen(command, errors="surrogateescape", **streams)
    except (OSError, ValueError) as error:
        hint = "check its options, and give very many values with --profile"
        raise Failure(f"{program} cannot be started: {error}; {hint}") from None
    with process, passing_on_interruptions(process) as came:
        output, errors = process.communicate()
    code, lines = process.returncode, errors.strip().splitlines()
    said = lines[-1] if lines else f"{program} ended with {code}"
    said = re.sub("; to continue: .*", "; with resume=True it goes on from there", said)
    if came:
        raise KeyboardInterrupt(said)
    if code and not (code == 1 and output and not errors):
        raise {2: UsageError, 3: MachineFailure}.get(code, Failure)(said)
    return output


class Result:
    """The files that a run wrote. They are opened when they are used."""

    def __init__(self, output, record):
        self.output = Path(output)  # the checkpoint at its end
        self.record_file = Path(record) if record else None

    def __repr__(self):
        with suppress(Failure):
            return f"<rupture.Result {str(self.output)!r} {self.checksum[:8]}>"
        return f"<rupture.Result {str(self.output)!r}: not there>"

    @cached_property
    def checkpoint(self):
        """The state at the end, a `Checkpoint`."""
        return rupture.open(self.output)

    @cached_property
    def record(self):
        """The `Record` of the run; None if none was asked for."""
        return rupture.open(self.record_file) if self.record_file else None

    @property
    def checksum(self):
        """The content checksum of the checkpoint."""
        return self.checkpoint.checksum

    @property
    def checkpoints(self):
        """The paths of the checkpoints written during the run, in order of time."""
        if not (own := self.checkpoint.get("run/id")):
            return []
        mine = []
        for path in self.output.parent.glob(f"{escape(self.output.stem)}-t*{self.output.suffix}"):
            with suppress(Failure), rupture.open(path) as file:  # others may be of any kind
                if isinstance(file, rupture.Checkpoint) and file.get("run/id") == own:
                    mine.append((file.time, path))
        return [path for _, path in sorted(mine)]


def run(program, *inputs, output, record=None, set=(), **options):
    """Runs `load`, `prepare`, `restart` or `modify-phi`, and returns its `Result`; or `map`,
    `movie` or `xdmf`, and returns the path of what it drew.

    Inputs are paths or opened files. Options have the names of the command line with
    _ for -, and SI units. `set` changes parameters by their names: to one value, to a list or an
    array with the value of each block, or to a list of parts. It takes what `parameters` returns.
    After Ctrl-C, a KeyboardInterrupt names the checkpoint that was saved; `resume=True` goes on.

    >>> after = rupture.run("restart", "small.h5", output="after.h5", record="after-record.h5",
    ...                     set={"driving.V": 0}, record_every=1e-5, for_=1e-3, force=True)
    >>> after.checkpoint.time, after.record.parameters["driving.V"], len(after.record.time)
    (0.003, 0.0, 101)
    """
    options = {"quiet": True, **options, "output": output, "record": record}
    output_of(program, *settings_of(set), *options_of(options), *(inputs and ("--", *inputs)))
    return Path(output) if program in DRAWING else Result(output, record)


def analyze(command, *inputs, **options):
    """The report of `analyze COMMAND` as a dict, in SI units; None where there is no value. With
    `also`, a list of such reports.

    >>> rupture.analyze("events", "small-record.h5")["events"][0]["type"]
    'fast'
    """
    options = options_of({**options, "json": True})
    said = output_of("analyze", command, *options, "--", *inputs)
    try:
        reports = [json.loads(line) for line in said.strip().split("\n")]
    except ValueError:  # that of --help
        raise UsageError(f"analyze {command} prints no report with these options") from None
    return reports[0] if len(reports) == 1 else reports


def verify(path):
    """Verifies a file's bytes and content with `analyze verify`, and returns its content checksum.
    Raises Failure if they do not have the checksums stored in the file, or if it is unfinished.

    >>> rupture.verify("small.h5") == rupture.open("small.h5").checksum
    True
    """
    output_of("analyze", "verify", "--", path)
    with rupture.open(*words(path)) as file:
        return file.checksum
