"""The programs as functions."""

import json
import os
import shutil
import subprocess
from contextlib import suppress
from functools import cached_property
from glob import escape
from pathlib import Path

import rupture
from rupture.errors import Failure, MachineFailure, UsageError

PACKAGE = Path(__file__).resolve().parent

DRAWING = ("map", "movie", "xdmf")  # they write no checkpoint, and have no --quiet


def own_folder():
    """Where the build or installation that this package belongs to has its programs."""
    if (PACKAGE / "../../CMakeLists.txt").exists():
        return PACKAGE.parents[1] / "build/release/bin"
    return PACKAGE.parents[3] / "libexec/rupture"  # from lib/python3/dist-packages


def path_of(program):
    """A program in the folder $RUPTURE_BIN, in this build or installation, or in that of the
    `rupture` on the PATH."""
    own = os.environ.get("RUPTURE_BIN")
    folders = [Path(own or own_folder())]
    if not own and (rupture := shutil.which("rupture")):
        bin_folder = Path(rupture).resolve().parent
        folders += [bin_folder.parent / "libexec/rupture", bin_folder]
    for path in (str(folder / program) for folder in folders):
        if os.access(path, os.X_OK):
            return path
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
    --for 0.02, True a flag; False and None are left out."""
    for name, value in options.items():
        if value is None or value is False:
            continue
        yield "--" + name.rstrip("_").replace("_", "-")
        yield from [] if value is True else words(value)


def output_of(program, *arguments):
    """Runs a program and returns its standard output. Raises Failure with its sentence if it
    failed, UsageError if it was asked for something impossible. That files differ is a result."""
    command = [path_of(program)] + [word for given in arguments for word in words(given)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    differs = done.returncode == 1 and done.stdout and not done.stderr
    if done.returncode and not differs:
        said = done.stderr.strip().splitlines()[-1:] or [f"{program} ended with {done.returncode}"]
        raise {2: UsageError, 3: MachineFailure}.get(done.returncode, Failure)(said[0])
    return done.stdout


class Result:
    """The files that a run wrote. They are opened when they are used."""

    def __init__(self, output, record):
        self.output = Path(output)  # the checkpoint at its end
        self.record_file = Path(record) if record else None

    def __repr__(self):
        return f"<rupture.Result {str(self.output)!r} {self.checksum[:8]}>"

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
    _ for -, and SI units; `set` changes parameters by their names.

    >>> after = rupture.run("restart", "small.h5", output="after.h5", record="after-record.h5",
    ...                     set={"driving.V": 0}, record_every=1e-5, for_=1e-3, force=True)
    >>> after.checkpoint.time, after.record.parameters["driving.V"], len(after.record.time)
    (0.003, 0.0, 101)
    """
    settings = [word for name, value in dict(set).items() for word in ("--set", f"{name}={value}")]
    files = {"output": output, "record": record}
    options = {"quiet": program not in DRAWING, **options, **files}
    output_of(program, *settings, *options_of(options), *(inputs and ("--", *inputs)))
    return Path(output) if program in DRAWING else Result(output, record)


def analyze(command, *inputs, **options):
    """The report of `analyze COMMAND` as a dict, in SI units; None where there is no value.

    >>> rupture.analyze("events", "small-record.h5")["events"][0]["type"]
    'fast'
    """
    options = {"json": True, **options}
    return json.loads(output_of("analyze", command, *options_of(options), "--", *inputs))


def verify(path):
    """Verifies a file's bytes and content with `analyze verify`, and returns its content checksum.
    Raises Failure if they do not have the checksums stored in the file, or if it is unfinished.

    >>> rupture.verify("small.h5") == rupture.open("small.h5").checksum
    True
    """
    output_of("analyze", "verify", "--", path)
    with rupture.open(*words(path)) as file:
        return file.checksum
