"""Files appear complete or not at all, and replace others only on request."""

import os
import sys
from contextlib import contextmanager
from pathlib import Path

from rupture.replacing import rename_to_new, replacing
from rupture.tools.command_line import CLEAR, Failure, UsageError, in_one_line


def refuse_existing(path):
    raise Failure(f"{path} exists; give another name, or --force to replace it") from None


def check_folder(path):
    folder = path.parent
    if not folder.is_dir():
        raise Failure(f"cannot write {path}: {folder} is not an existing folder; give another path")
    if not os.access(folder, os.W_OK | os.X_OK):
        name = "the current folder" if folder == Path(".") else folder
        raise Failure(f"cannot write {path}: no write permission in {name}; give another path")


def check_output(name, force, endings=(), inputs=()):
    """Checks the path of an output before anything is computed."""
    path = Path(name)
    if not os.fspath(name):
        raise UsageError("the name of an output is empty; give the path of a file")
    if endings and path.suffix.lower() not in endings:
        raise UsageError(f"{path} must end with {', '.join(endings[:-1])} or {endings[-1]}")
    check_folder(path)
    if any(path.exists() and os.path.exists(one) and path.samefile(one) for one in inputs):
        raise UsageError(f"{path} is the input, which is never changed: give another output")
    if path.is_dir():
        raise Failure(f"{path} is a folder; give the path of a file to write")
    if path.exists() and not force:
        refuse_existing(path)
    if path.exists() and not path.is_file():
        raise Failure(f"{path} is not a regular file; give another path")


def progress(items, count, what):
    """Yields the items, and shows the progress in one line of the terminal."""
    on_terminal = sys.stderr.isatty()
    for number, item in enumerate(items, 1):
        if on_terminal:
            print(f"{CLEAR}{what} {number} of {count}", end="", file=sys.stderr, flush=True)
        yield item
    if on_terminal:
        print(CLEAR, end="", file=sys.stderr, flush=True)


def say_written(*paths):
    for path in paths:
        print(f"wrote {in_one_line(str(path))}")


@contextmanager
def complete(path, force):
    """The temporary path to write to; its file is renamed to `path` if all goes well."""
    path = Path(path)
    try:
        with replacing(path, os.replace if force else rename_to_new) as hidden:
            yield hidden
    except FileExistsError:
        refuse_existing(path)
    except OSError as error:
        reason = os.strerror(error.errno) if error.errno else str(error)
        raise Failure(f"cannot write {path}: {reason}") from None
