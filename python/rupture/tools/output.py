"""Files appear complete or not at all, and replace others only on request."""

import os
import shlex
import sys
from contextlib import contextmanager
from pathlib import Path

from rupture.errors import Failure, UsageError
from rupture.replacing import replacing, temporary_for
from rupture.tools.command_line import CLEAR, in_one_line

EXISTS = "exists; give another name, or --force to replace it"


def check_output(name, force, endings=(), inputs=()):
    """Checks the path of an output before anything is computed."""
    path = Path(name)
    if not os.fspath(name):
        raise UsageError("the name of an output is empty; give the path of a file")
    if endings and path.suffix.lower() not in endings:
        raise UsageError(f"{path} must end with {', '.join(endings[:-1])} or {endings[-1]}")
    if any(path.exists() and os.path.exists(one) and path.samefile(one) for one in inputs):
        raise UsageError(f"{path} is the input, which is never changed: give another output")
    if path.exists() and not path.is_file():
        raise Failure(f"{path} is not a regular file; give the path of a file to write")
    if os.path.lexists(path) and not force:
        raise Failure(f"{path} {EXISTS}")
    try:  # before anything is lost at the end
        with temporary_for(path):
            pass
    except OSError as error:
        raise Failure(f"cannot write {path}: {error.strerror}; give another path") from None


def progress(items, count, what):
    """Yields the items, and shows the progress in one line of the terminal, unless --quiet has
    closed standard output."""
    on_terminal = sys.stdout and sys.stderr.isatty()
    for number, item in enumerate(items, 1):
        if on_terminal:
            print(f"{CLEAR}{what} {number} of {count}", end="", file=sys.stderr, flush=True)
        yield item
    if on_terminal:
        print(CLEAR, end="", file=sys.stderr, flush=True)


def say_written(*paths):
    for path in paths:
        print(f"wrote {in_one_line(str(path))}")


def origin_of(name, files):
    """The command of a program in Python, and the files that it read."""
    command = shlex.join(["rupture", name, *sys.argv[1:]])
    sums = [f"{file.path}: content-sha256 {file.checksum or 'unknown'}" for file in files]
    return "\n".join(in_one_line(line) for line in (command, *sums))


@contextmanager
def complete(path, force):
    """The temporary path to write to; its file is renamed to `path` if all goes well."""
    path = Path(path)
    try:
        with replacing(path, force) as hidden:
            yield hidden
    except FileExistsError:
        raise Failure(f"{path} {EXISTS}") from None
    except OSError as error:
        raise Failure(f"cannot write {path}: {error.strerror or error}") from None
