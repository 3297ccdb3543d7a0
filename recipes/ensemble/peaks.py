"""When tau/p of each block is largest in an event, as the script of a chain:

    peaks = script peaks.py record.h5
"""

import rupture

from measure.slip import peaks_of


def main(record):
    return peaks_of(rupture.open(record))
