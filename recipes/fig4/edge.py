"""Whether fronts become fast, with slow slip, where they cease to be arrested without it, as the
script of a chain:

    edge = script edge.py {all edges}

Reports the largest difference of these two edges of tau_bar_0 over all sigma_bar, in each way to
measure ("under"); and over all ways the largest change of the edge of fast fronts by slow slip.
"""

from chains.results import read_points
from measure.conventions import PRIMARY


def largest(with_slip, without, way, kind):
    """Distance of the edge of fast fronts from that of `kind` without slow slip; of {sigma_bar:
    {way: edges}}."""
    pairs = [(edges[way], without[sigma][way]) for sigma, edges in with_slip.items()]
    return max(abs(slip["fast"] - none[kind]) for slip, none in pairs)


def main(points):
    read = read_points(points)
    with_slip, without = (
        {p["sigma-bar"]: p["edges"] for p in read if p["variant"] == name}
        for name in ("reference", "no slow slip")
    )
    ways = next(iter(with_slip.values()))
    found = {way: {"difference": largest(with_slip, without, way, "slow")} for way in ways}
    change = max(largest(with_slip, without, way, "fast") for way in ways)
    return found.pop(PRIMARY) | {"change": change, "under": found}
