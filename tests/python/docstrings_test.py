"""The examples in the docstrings of the package give what they say."""

import doctest
import os
import sys

import rupture.files
import rupture.programs
import small

try:
    import pandas  # noqa: F401
    import xarray  # noqa: F401
except ImportError:
    print("Skipped: the examples need pandas and xarray, of which one is not installed.")
    sys.exit(1 if os.environ.get("CI") else 77)


def failures(module, files):
    names = {"rupture": rupture, **files}
    return doctest.testmod(module, extraglobs=names, optionflags=doctest.ELLIPSIS).failed


if __name__ == "__main__":
    small.folder()
    opened = {
        "checkpoint": rupture.open("small.h5"),
        "record": rupture.open("small-record.h5"),
    }
    sys.exit(sum(failures(module, opened) for module in (rupture.files, rupture.programs)))
