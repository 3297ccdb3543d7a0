"""What a claim is measured of: what the picture shows, and samples of it."""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

from rupture.errors import Failure
from rupture.once import each, known


class Sample(NamedTuple):
    """Samples of a run share a history; one without a run is a run of its own. `found` is a Failure
    if it failed, or if the run has no such event: this counts against the claim."""

    run: Any
    found: Any


@dataclass(frozen=True)
class Samples:
    """`shown`: {name in the picture: what is found there}, the first of which is reported as
    holding or not. `taken`: {way: list of Sample}, the primary one first; empty for one state."""

    shown: dict
    taken: dict = field(default_factory=dict)


class Sampling:
    """Whether samples are computed; otherwise those count that are there."""

    is_whole = False


def outcomes(points, found):
    """[(point, what was found there, or a Failure)] of those that `each` or `known` knows."""
    results = dict(found) | {point: Failure(sentence) for point, sentence in found.refused}
    return [(point, results[point]) for point in points if point in results]


def sampled(function, points, title=""):
    """outcomes() of all points, or of those that are there."""
    if Sampling.is_whole:
        return outcomes(points, each(function, points, title))
    return outcomes(points, known(function, points))


def every(function, points, title=""):
    """{point: what was found there}. Raises Failure if one of them was refused."""
    found = each(function, points, title)
    for _, sentence in found.refused:
        raise Failure(f"{title}: {sentence}")
    return dict(found)
