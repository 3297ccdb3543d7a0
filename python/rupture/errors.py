"""What goes wrong."""

import errno

OF_MACHINE = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS, errno.EACCES, errno.EPERM}
OF_MACHINE |= {errno.ENOMEM, errno.EIO, errno.EMFILE, errno.ENFILE}


class Failure(Exception):
    """One sentence: what was given, what was expected, what to do."""


class UsageError(Failure):
    """A command line that asks for something impossible; exit code 2."""


class MachineFailure(Failure):
    """The machine failed, not the request: full disk, no memory, no permission; exit code 3."""


class NoSuchName(Failure, KeyError):
    """A KeyError, as in any mapping, so that `file.get(name, default)` works."""

    __str__ = Exception.__str__  # that of a KeyError has quotation marks


def is_of_machine(error):
    """Whether the same may succeed elsewhere or later."""
    cause = error.__context__ if isinstance(error, Failure) else error
    is_its = isinstance(error, MachineFailure) or isinstance(cause, MemoryError)
    return is_its or isinstance(cause, OSError) and cause.errno in OF_MACHINE
