"""Whether fronts become fast, with slow slip, where they cease to be arrested without it, as the
script of a chain:

    edge = script edge.py {all edges}

Reports the largest difference of these two edges of tau_bar_0 over all sigma_bar, and the largest
change of the edge of fast fronts by slow slip; in each way to measure ("under").
"""

from chains.results import read_points
from measure.conventions import PRIMARY


def largest(with_slip, without, way):
    """Of {sigma_bar: {way: edges}}."""
    pairs = [(edges[way], without[sigma][way]) for sigma, edges in with_slip.items()]
    return {
        "difference": max(abs(slip["fast"] - none["slow"]) for slip, none in pairs),
        "change": max(abs(slip["fast"] - none["fast"]) for slip, none in pairs),
    }


def main(points):
    read = read_points(points)
    with_slip, without = (
        {p["sigma-bar"]: p["edges"] for p in read if p["variant"] == name}
        for name in ("reference", "no slow slip")
    )
    found = {way: largest(with_slip, without, way) for way in next(iter(with_slip.values()))}
    return found.pop(PRIMARY) | {"under": found}
