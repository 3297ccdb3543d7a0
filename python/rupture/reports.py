"""Numbers in reports of `analyze`, to calculate with: NaN where a report says null."""

from math import nan

import numpy as np

LOADING_ZONE = 0.02  # [m]; speeds within it do not count: the programs' default


def value(report, path):
    """The number that a path such as in_words.x_from leads to; NaN where it leads to null."""
    for name in path.split("."):
        report = report and report[name]
    return nan if report is None else report


def values(numbers):
    """A list as an array."""
    return np.array([nan if number is None else number for number in numbers])
