"""The one judge of claims: cases measured by the recipes, against the conditions of claims.toml.

docs/claims.md has the rules.
"""

import tomllib
from functools import cache
from pathlib import Path

from scipy.stats import beta

from claims.claim import DEPENDS, DIFFERS, DOES_NOT_HOLD, HOLDS, NOT_COMPARABLE, PRIMARY, REPRODUCED
from claims.claim import Claim, Share, plural, split_unit
from claims.conditions import as_read, met, wanted
from rupture.errors import Failure

TABLE = Path(__file__).with_name("claims.toml")
NEEDED, NEEDED_IF_ONE_EXISTS = 0.8, 0.5  # share of the units, for `reproduced`
FEW = 0.2  # share up to which it `differs`
FEWEST = 5  # units; fewer tell nothing
CASES = {True: HOLDS, False: DOES_NOT_HOLD}


@cache
def table():
    """{claim id: its row, with its recipe}"""
    try:
        recipes = tomllib.loads(TABLE.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise Failure(f"The claims in {TABLE} cannot be read ({error}).") from error
    return {name: row | {"recipe": r} for r, rows in recipes.items() for name, row in rows.items()}


# --- one case ------------------------------------------------------------------------------


def conditions_of(claim_id):
    """{quantity: {relation: bound, ...}, or the value that it must have}"""
    row = table()[claim_id]
    return (conditions_of(row["like"]) if "like" in row else {}) | row.get("conditions", {})


def yes(so):
    """As conditions ask for it."""
    return "yes" if so else "no"


def holds(claim_id, cases):
    """Whether one of the cases of a unit meets all conditions."""
    return any(not unmet(claim_id, case) for case in cases)


def unmet(claim_id, case):
    """The quantities whose conditions a case does not meet; all must have been measured."""
    return [name for name, c in conditions_of(claim_id).items() if not met(c, case[name])]


def unmet_text(claim_id, case):
    """The same for readers: slowest is c_s/49.6, not c_s/200 to c_s/50"""
    parts = []
    for name in unmet(claim_id, case):
        condition = conditions_of(claim_id)[name]
        quantity, unit = split_unit(name.removesuffix("/c_s"))
        asked, got = f"{wanted(name, condition)} {unit}".rstrip(), as_read(name, case[name])
        if isinstance(case[name], float) and met(condition, float(f"{case[name]:.3g}")):
            got = f"{case[name]:.6g}"  # in three digits it would seem to be met
        parts.append(f"{quantity} is {got}, not {asked}")
    return "; ".join(parts)


# --- all units -----------------------------------------------------------------------------


def interval(k, n):
    """90 % interval of a share (Jeffreys)."""
    low, high = beta.ppf((0.05, 0.95), k + 0.5, n - k + 0.5)
    return float(low if k else 0.0), float(high if k < n else 1.0)


def is_one_state(claim_id):
    return table()[claim_id].get("unit") == "seed"


def share_of(claim_id, convention, units):
    """The share of units under one convention; for one state, the majority of its seeds decides."""
    held = [holds(claim_id, cases) for cases in units]
    if is_one_state(claim_id):
        return Share(convention, int(2 * sum(held) > len(held)), 1, None, None)
    return Share(convention, sum(held), len(held), *interval(sum(held), len(held)))


def shares_of(claim_id, units):
    """One per convention, the primary one first. `units`: {unit: {convention: [case, ...]}}. A unit
    that has no case under a convention counts against the claim; one without the convention is not
    a unit under it."""
    by_convention: dict[str, list] = {PRIMARY: []}
    for measured in units.values():
        for convention, cases in measured.items():
            by_convention.setdefault(convention, []).append(cases)
    return [share_of(claim_id, name, found) for name, found in by_convention.items() if found]


def needed(claim_id):
    return NEEDED_IF_ONE_EXISTS if table()[claim_id].get("exists") else NEEDED


def verdict_of_shares(claim_id, shown, shares):
    """The 90 % intervals must lie beyond the limit, not only the shares."""
    unit = table()[claim_id]["unit"]
    worst, best = min(shares, key=lambda s: s.low), max(shares, key=lambda s: s.high)
    if shown and worst.low >= needed(claim_id):
        return REPRODUCED, f"holds in at least {worst.text(unit)}"
    if not shown and best.high <= FEW:
        return DIFFERS, f"holds in at most {best.text(unit)}"
    primary, decides, to = shares[0], *((worst, "down") if shown else (best, "up"))
    extreme = "" if decides is primary else f", {to} to {decides.text(unit)}"
    parts = [share.part() for share in shares]
    enough = min(parts) >= needed(claim_id) if shown else max(parts) <= FEW
    few = f"; too few {plural(unit)} for a verdict" if enough else ""
    beside = "" if shown else ", but not in the case shown"
    return DEPENDS, f"holds in {primary.text(unit)}{extreme}{beside}{few}"


def verdict_of(claim_id, shown, shares):
    """The verdict, None without units, and its reason in one line."""
    row = table()[claim_id]
    if not conditions_of(claim_id):
        return NOT_COMPARABLE, "the paper gives no number to compare with; ours are reported"
    if shown is None:
        return NOT_COMPARABLE, "it could not be measured"
    if shares and is_one_state(claim_id):
        return verdict_of_state({share.convention: share.holds == 1 for share in shares})
    if shares:
        return verdict_of_shares(claim_id, shown, shares)
    if row.get("unit"):
        what = "seeds" if is_one_state(claim_id) else plural(row["unit"])
        return None, f"only the case shown was judged, no other {what}"
    return (REPRODUCED, HOLDS) if shown else (DIFFERS, DOES_NOT_HOLD)


def verdict_of_state(held):
    """The verdict for one state. `held`: {convention: whether the claim holds under it}"""
    holding, failing = ([name for name, does in held.items() if does == so] for so in (True, False))
    ways = f"the {len(held)} ways to measure"
    if not failing:
        return REPRODUCED, f"holds in all of {ways}" if len(held) > 1 else HOLDS
    if not holding:
        return DIFFERS, f"holds in none of {ways}" if len(held) > 1 else DOES_NOT_HOLD
    if len(holding) < len(failing):
        return DEPENDS, f"of {ways}, holds only in {', '.join(holding)}"
    return DEPENDS, f"of {ways}, does not hold in {', '.join(failing)}"


def units_with(is_so, units):
    """How many have a case that is so, under the primary convention, as "4 of 20"."""
    found = [any(map(is_so, measured.get(PRIMARY, []))) for measured in units.values()]
    return f"{sum(found)} of {len(found)}" if found else "not run"


def share_of_spanning(claim_id, units):
    """For "there is such an event": how many of the spanning events of all runs are such."""
    cases = [case for measured in units.values() for case in measured.get(PRIMARY, [])]
    spanning = [case for case in cases if case.get("spans") == "yes"]
    if not (table()[claim_id].get("exists") and spanning):
        return ""
    return f"; {sum(holds(claim_id, [c]) for c in spanning)} of {len(spanning)} spanning events"


def judged(claim_id, measured, shown, units=None, note="", others=None):
    """The claim with its verdict. `measured`: what readers see of the shown case; `shown`: that
    case, None if it could not be measured; `units`: {unit: {convention: [case, ...]}}. For a claim
    about one state `others` has its cases under other conventions, {convention: case}."""
    row = table()[claim_id]
    accepted = None if shown is None else holds(claim_id, [shown])
    units = units or {}
    shares = shares_of(claim_id, units) if len(units) >= FEWEST else []
    if others and accepted is not None:
        held = {name: holds(claim_id, [case]) for name, case in others.items()}
        verdict, reason = verdict_of_state({PRIMARY: accepted} | held)
    else:
        verdict, reason = verdict_of(claim_id, accepted, shares)
    if shares:
        reason += share_of_spanning(claim_id, units)
    if accepted is False:
        reason += f" ({unmet_text(claim_id, shown)})"
    return Claim(
        id=claim_id,
        kind=row["kind"],
        fixed=row["fixed"],
        paper=row["says"],
        acceptance=row["accepted"],
        measured=measured,
        case=None if accepted is None or not conditions_of(claim_id) else CASES[accepted],
        shares=shares,
        verdict=verdict,
        reason=reason,
        note=note,
    )
