"""The one judge of claims: cases measured by the recipes, against the conditions of claims.toml.

A claim is judged over units (independent realisations: loads, events) and under conventions (ways
to measure that the paper leaves open). The shares over the conventions are what statistics calls a
multiverse (Steegen et al. 2016). docs/claims.md has the rules.
"""

import tomllib
from fractions import Fraction
from functools import cache
from operator import ge, gt, le, lt
from pathlib import Path

from scipy.stats import beta

from claims.claim import (
    DEPENDS,
    DIFFERS,
    NOT_COMPARABLE,
    PRIMARY,
    REPRODUCED,
    SHOWN_ONLY,
    Claim,
    Share,
    number,
)

TABLE = Path(__file__).with_name("claims.toml")
NEEDED, NEEDED_IF_ONE_EXISTS = 0.8, 0.5  # share of the units, for `reproduced`
FEW = 0.2  # share up to which it `differs`
FEWEST = 5  # units; fewer tell nothing
RELATIONS = {"at_least": ge, "at_most": le, "above": gt, "below": lt}


@cache
def table():
    return tomllib.loads(TABLE.read_text(encoding="utf-8"))


# --- one case ------------------------------------------------------------------------------


def conditions_of(claim_id):
    """{quantity: {relation: bound, ...}, or what it has to be}"""
    conditions = table()[claim_id]["conditions"]
    return conditions_of(conditions) if isinstance(conditions, str) else conditions


def as_number(bound):
    """Of 0.5 or "1/200"."""
    return float(Fraction(str(bound)))


def met(condition, value):
    """A quantity that could not be measured (None) meets no condition."""
    if value is None or not isinstance(condition, dict):
        return value is not None and str(value) == str(condition)
    return all(RELATIONS[name](value, as_number(bound)) for name, bound in condition.items())


def wanted(condition):
    if not isinstance(condition, dict):
        return str(condition)
    return " and ".join(f"{name.replace('_', ' ')} {bound}" for name, bound in condition.items())


def holds(claim_id, cases):
    """Whether one of the cases of a unit meets all conditions."""
    return any(not unmet(claim_id, case) for case in cases)


def unmet(claim_id, case):
    """The quantities of the conditions that a case does not meet; all have to be measured."""
    return [name for name, c in conditions_of(claim_id).items() if not met(c, case[name])]


def unmet_text(claim_id, case):
    """The same for readers: what was wanted, and what there is."""
    conditions = conditions_of(claim_id)
    return "; ".join(
        f"wanted {name} {wanted(conditions[name])}: it is {number(case[name])}"
        for name in unmet(claim_id, case)
    )


# --- all units -----------------------------------------------------------------------------


def interval(k, n):
    """90 % interval of a share (Jeffreys)."""
    low, high = beta.ppf((0.05, 0.95), k + 0.5, n - k + 0.5)
    return float(low if k else 0.0), float(high if k < n else 1.0)


def shares_of(claim_id, units):
    """One per convention, the primary one first. `units`: {unit: {convention: [case, ...]}}. A unit
    that has nothing under a convention counts against the claim."""
    conventions = dict.fromkeys(c for measured in units.values() for c in measured)
    shares = []
    for convention in sorted(conventions, key=lambda c: c != PRIMARY):
        held = [holds(claim_id, measured.get(convention, [])) for measured in units.values()]
        shares.append(Share(convention, sum(held), len(held), *interval(sum(held), len(held))))
    return shares


def needed(claim_id):
    return NEEDED_IF_ONE_EXISTS if table()[claim_id].get("exists") else NEEDED


def verdict_of(claim_id, shown, shares):
    """The verdict, and its reason in one line."""
    unit = table()[claim_id].get("unit")
    if not conditions_of(claim_id):
        return NOT_COMPARABLE, "the paper states nothing to compare with; ours is reported"
    if shown is None:
        return NOT_COMPARABLE, "it could not be measured"
    holding = "holds" if shown else "does not hold"
    if not shares:
        verdict = REPRODUCED if shown else DIFFERS
        return verdict, f"{SHOWN_ONLY}: {holding}" if unit else holding
    worst, best = min(shares, key=Share.part), max(shares, key=Share.part)
    if shown and worst.part() >= needed(claim_id):
        return REPRODUCED, f"holds as shown and in at least {worst.text(unit)}"
    if not shown and best.part() <= FEW:
        return DIFFERS, f"does not hold as shown, and in at most {best.text(unit)}"
    decides = worst if shown else best
    return DEPENDS, f"{holding} as shown; in {decides.text(unit)}"


def verdict_of_state(shown, others):
    """The same for one state: whether the claim holds as shown, and under other conventions."""
    held = {PRIMARY: shown} | others
    holding = ", ".join(name for name, does in held.items() if does)
    failing = ", ".join(name for name, does in held.items() if not does)
    if shown is None:
        return NOT_COMPARABLE, "it could not be measured"
    if not failing:
        return REPRODUCED, f"holds under each convention ({holding})"
    if not holding:
        return DIFFERS, f"does not hold under any convention ({failing})"
    return DEPENDS, f"on the convention: holds under {holding}; does not under {failing}"


def judged(claim_id, measured, shown, units=None, note="", others=None):
    """The claim with its verdict. `measured`: what readers see of the shown case; `shown`: that
    case, None if it could not be measured; `units`: {unit: {convention: [case, ...]}}. For a claim
    about one state `others` has its cases under other conventions, {convention: case}."""
    row = table()[claim_id]
    accepted = None if shown is None else holds(claim_id, [shown])
    units = units or {}
    shares = shares_of(claim_id, units) if len(units) >= FEWEST else []
    if others:
        held = {name: holds(claim_id, [case]) for name, case in others.items()}
        verdict, reason = verdict_of_state(accepted, held)
    else:
        verdict, reason = verdict_of(claim_id, accepted, shares)
    if accepted is False:
        reason += f" ({unmet_text(claim_id, shown)})"
    return Claim(
        id=claim_id,
        paper=row["says"],
        acceptance=row["accepted"],
        measured=measured,
        shown=accepted,
        shares=shares,
        verdict=verdict,
        reason=reason,
        note=note,
    )
