"""What goes wrong."""


class Failure(Exception):
    """One sentence: what was given, what was expected, what to do."""


class UsageError(Failure):
    """A command line that asks for something impossible; exit code 2."""


class NoSuchName(Failure, KeyError):
    """A KeyError, as in any mapping, so that `file.get(name, default)` works."""

    __str__ = Exception.__str__  # that of a KeyError has quotation marks
