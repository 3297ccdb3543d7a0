"""Ways to read a map of front types that the paper leaves open, as data, and the map of each seed
under each of them: the units of claims 4D, S6B and geometry.

A way is options of front_type(). Where stencils at the ends of a slow stretch count makes no
difference to a type, so those ways are left out.
"""

from claims.judge import judged
from events.conventions import CONVENTIONS
from maps.front_map import fast_below_left_of_arrested, steps_back, types_of, types_of_seeds

OPTIONS = {  # of `analyze`: of front_type()
    "--stencil": "stencil",
    "--slow-below": "slow_below",
    "--ruptured-below": "ruptured_below",
}


MEASURES = {  # those that make a difference to types
    name: {OPTIONS[option]: value for option, value in options.items()}
    for name, options in CONVENTIONS.items()
    if set(options) <= set(OPTIONS)
}

ABOUT_UNITS = "The map of a seed has its own fronts at the boundary and those of seed 1 elsewhere."


def out_of_order(fronts):
    """Places that are fast below-left of an arrested one, over all seeds, and those where the type
    steps back along tau_bar_0."""
    found = {fast for fast, _ in fast_below_left_of_arrested(types_of_seeds(fronts))}
    return found | steps_back(types_of(fronts))


def units_of_seeds(seeds, ways, case):
    """{seed: {convention: [case]}}; `case` measures the map of a seed in a way."""
    return {
        f"seed {seed}": {name: [case(seed, **way)] for name, way in ways.items()} for seed in seeds
    }


def claim_over_seeds(claim_id, shown, of_seeds, case):
    """`shown`: the map of all seeds, or several; `of_seeds`: the same of each seed, {seed: map}.
    The function measures the case in them."""

    def of_seed(seed, **way):
        return case(of_seeds[seed], **way)

    units = units_of_seeds(of_seeds, MEASURES, of_seed)
    return judged(claim_id, case(shown), case(shown), units, ABOUT_UNITS)
