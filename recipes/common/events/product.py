"""The full product of the ways to measure a front (conventions.py): any stencil with any pinned
fraction, and so on. Verdicts go by one convention at a time; the product shows how far the shares
could move."""

from itertools import product

from claims.judge import holds
from events.conventions import CONVENTIONS, PRIMARY
from events.front_claims import case_of_event

CLAIMS = {  # on fronts as they are, which costs no further simulation, by the setting of a load
    "load": ("2A", "2B", "2C"),
    "decaying": ("S6A",),
    "exponential": ("Exp",),
}


def combinations():
    """{name: options of `analyze events`}, the primary convention first."""
    ways: dict[str, list] = {}  # by what they change
    for name, options in CONVENTIONS.items():
        for option in options:
            ways.setdefault(option, [(PRIMARY, {})]).append((name, options))
    found = {}
    for chosen in product(*ways.values()):
        names = [name for name, _ in chosen if name != PRIMARY]
        options = {key: value for _, part in chosen for key, value in part.items()}
        found[", ".join(names) or PRIMARY] = options
    return found


def claims_held(setting, events):
    """{claim: whether one of the events of a load meets it}"""
    cases = [case_of_event(event) for event in events]
    return {claim: holds(claim, cases) for claim in CLAIMS[setting]}


def range_of(reports, claim):
    """Fewest and most loads for which the claim holds, over all combinations. `reports`: for each
    load {combination: {claim: held}}."""
    held = [sum(report[name][claim] for report in reports) for name in reports[0]]
    return min(held), max(held)
