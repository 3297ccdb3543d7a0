"""What goes wrong."""


class Failure(Exception):
    """One sentence: what was given, what was expected, what to do."""


class UsageError(Failure):
    """A command line that asks for what is not possible; exit code 2."""


class NoSuchName(Failure, KeyError):
    """As of any mapping, so that `file.get(name, default)` works."""

    __str__ = Exception.__str__  # that of a KeyError has quotation marks
