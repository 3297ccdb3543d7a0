"""Reports of the tools; the Python package reads records and checkpoints."""

import json

import numpy as np


def report(path):
    """Reads a report of `analyze ... --json`."""
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def values(numbers):
    """A list from a report as an array, NaN where it says null."""
    return np.array([np.nan if number is None else number for number in numbers])
