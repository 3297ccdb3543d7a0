"""Fronts as maps have them, without a run."""

import numpy as np

from maps.front_map import speeds

C_S = 1000.0  # [m/s]
SPACING = 0.0025  # [m]
LAST = 19  # block; the first ten do not count


def front(slower=None, arrives=True):
    """A front at 300 m/s, but at {n: speed} from block n to block n + 1 [m/s]."""
    between = [300.0] * LAST
    for block, speed in (slower or {}).items():
        between[block] = speed
    t_rupture = np.cumsum([0.0, *(SPACING / speed for speed in between)]).tolist()
    line = {
        "x": [n * SPACING for n in range(LAST + 1)],
        "t_rupture": t_rupture if arrives else [*t_rupture[:-1], None],
        "c_s": C_S,
    }
    line |= {"v_c": speeds(line, 5)}
    return line | {"at": {0.2: line, 0.5: line}}
