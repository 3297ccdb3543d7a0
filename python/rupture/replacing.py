"""Files that appear whole or not at all. They can be made again, so nothing is synced."""

import os
import secrets
import shutil
import signal
from contextlib import contextmanager, suppress
from pathlib import Path

WARNING = (signal.SIGUSR1, signal.SIGUSR2, signal.SIGXCPU)  # of schedulers
ENDING = (signal.SIGHUP, signal.SIGINT, signal.SIGTERM, *WARNING)
unfinished: set[Path] = set()  # temporary files


def end_by_signal(number, _):
    """A signal handler. It raises nothing: a library could swallow or replace an exception."""
    for temporary in unfinished:
        temporary.unlink(missing_ok=True)
    signal.signal(number, signal.SIG_DFL)
    os.kill(os.getpid(), number)
    os._exit(128 + number)  # a process with the number 1, as in a container, is still there


@contextmanager
def temporary_for(path):
    """Yields a new, empty, hidden file beside `path`, with the mode of `path`.
    Deletes it at the end."""
    temporary = path.with_name(f".{path.stem}.tmp.{secrets.token_hex(4)}{path.suffix}")
    unfinished.add(temporary)  # as long as it may be there: a signal can come at any time
    try:
        temporary.touch(exist_ok=False)
    except OSError:  # what is there is not ours
        unfinished.remove(temporary)
        raise
    try:
        with suppress(OSError):  # there is none, or no mode
            shutil.copymode(path, temporary)
        yield temporary
    finally:
        temporary.unlink(missing_ok=True)
        unfinished.remove(temporary)


@contextmanager
def replacing(path, force=True):
    """Yields a temporary file, which is renamed to `path` at the end. Without `force`, raises
    FileExistsError if something has that name by then."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    with temporary_for(path) as temporary:
        yield temporary
        if not force and os.path.lexists(path):
            raise FileExistsError(path)
        os.replace(temporary, path)


def write_whole(path, text):
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
