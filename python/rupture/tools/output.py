# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""Files appear complete or not at all, and replace others only if that is asked for."""

import os
from contextlib import contextmanager
from pathlib import Path

from rupture.tools.command_line import Failure, UsageError


def check_output(path, force, endings=()):
    """Before anything is computed."""
    path = Path(path)
    if endings and path.suffix.lower() not in endings:
        raise UsageError(f"{path} has to end with {' or '.join(endings)}")
    if not path.parent.is_dir():
        raise Failure(f"the folder {path.parent} does not exist; make it first")
    if path.exists() and not force:
        raise Failure(f"{path} exists; give another name, or --force to replace it")


@contextmanager
def complete(path):
    """The name to write to, whose file gets the name `path` when all has gone well."""
    path = Path(path)
    hidden = path.with_name(f".{path.stem}.tmp.{os.getpid()}{path.suffix}")
    try:
        yield hidden
        with open(hidden, "rb") as file:
            os.fsync(file.fileno())
        os.replace(hidden, path)
    finally:
        hidden.unlink(missing_ok=True)
