"""Files that appear whole or not at all, even after a power cut or in folders of other users."""

import ctypes
import errno
import os
import secrets
import signal
import stat
from contextlib import contextmanager, suppress
from pathlib import Path

HERE, NO_REPLACE = -100, 1  # AT_FDCWD and RENAME_NOREPLACE of Linux


def rename_to_new(temporary, path):
    """Raises FileExistsError if there is a file already. Many file systems lack such a renaming,
    some have no links either; there one can only look before."""
    names = HERE, os.fsencode(temporary), HERE, os.fsencode(path)
    if not ctypes.CDLL(None, use_errno=True).renameat2(*names, NO_REPLACE):
        return None
    if ctypes.get_errno() != errno.EEXIST:
        with suppress(OSError):
            os.link(temporary, path)
            return os.unlink(temporary)
    if os.path.lexists(path):
        raise FileExistsError(errno.EEXIST, "File exists", str(temporary), None, str(path))
    return os.rename(temporary, path)


def is_at(file, path):
    """Whether the path is this very file, and not a link to it."""
    with suppress(FileNotFoundError):
        return os.path.samestat(os.fstat(file), os.lstat(path))
    return False


def sync_folder(path):
    """Makes a renaming durable. Some file systems cannot, and a folder may forbid reading; then the
    file is in place all the same."""
    try:
        opened = os.open(path, os.O_RDONLY)
        try:
            os.fsync(opened)
        finally:
            os.close(opened)
    except OSError as error:
        if error.errno not in (errno.EACCES, errno.EINVAL):
            raise


WARNING = (signal.SIGUSR1, signal.SIGUSR2, signal.SIGXCPU)  # of schedulers
ENDING = (signal.SIGHUP, signal.SIGINT, signal.SIGTERM, *WARNING)
unfinished: dict[Path, int] = {}  # temporary files and their descriptors


def discard(temporary):
    """Deletes a temporary file, unless it has been renamed or is gone."""
    file = unfinished.pop(temporary)
    if is_at(file, temporary):
        temporary.unlink()
    os.close(file)


def end_by_signal(number, _):
    """A signal handler. It raises nothing: a library could swallow or replace an exception."""
    for temporary in list(unfinished):
        discard(temporary)
    signal.signal(number, signal.SIG_DFL)
    os.kill(os.getpid(), number)
    os._exit(128 + number)  # a process with the number 1, as in a container, is still there


@contextmanager
def undisturbed():
    """Signals that end the program wait until all is done, such as a file and the note of it."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, ENDING)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


@contextmanager
def replacing(path, rename=os.replace):
    """Yields a temporary path, whose file is renamed to `path` at the end; with `rename_to_new`,
    only if there is none by then. If that fails, the file stays, and the error has both names."""
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.stem}.tmp.{secrets.token_hex(4)}{path.suffix}")
    with undisturbed():
        file = os.open(temporary, os.O_RDWR | os.O_CREAT | os.O_EXCL, 0o666)
        unfinished[temporary] = file
    try:
        with suppress(OSError):  # there is none, or no mode
            if stat.S_ISREG(mode := path.lstat().st_mode):
                os.fchmod(file, mode & 0o777)
        yield temporary
        if not is_at(file, temporary):
            raise OSError(errno.ESTALE, "its temporary file was moved", str(path))
        os.fsync(file)
        os.close(unfinished.pop(temporary))
        rename(temporary, path)
        sync_folder(path.parent)
    finally:
        if temporary in unfinished:
            discard(temporary)


def write_whole(path, text):
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8")
