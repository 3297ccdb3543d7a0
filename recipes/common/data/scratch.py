"""A folder for files that nobody needs afterwards."""

import shutil
from contextlib import contextmanager


@contextmanager
def scratch(path):
    """An empty folder until the end of the block. One that a killed run left is replaced."""
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir(parents=True)
    try:
        yield path
    finally:
        shutil.rmtree(path)
