"""The one judge of claims: what a row of claims.toml measures, against its conditions.

docs/claims.md has the rules.
"""

from math import isfinite

import numpy as np
from rupture.errors import Failure
from scipy.stats import beta

from claims.claim import DEPENDS, DIFFERS, DOES_NOT_HOLD, HOLDS, NOT_COMPARABLE, REPRODUCED
from claims.claim import Claim, Share, plural, split_unit
from claims.conditions import as_read, met, wanted
from claims.recipes import function_of
from claims.resampling import interval_by_runs
from claims.table import rows_of, ways_of
from measure.conventions import PRIMARY

NEEDED, NEEDED_IF_ONE_EXISTS = 0.8, 0.5  # share of the samples, for `reproduced`
FEW = 0.2  # share up to which it `differs`
FEWEST = 5  # units; fewer tell nothing
CASES = {True: HOLDS, False: DOES_NOT_HOLD}
WORDS = {True: "yes", False: "no"}


# --- one case ------------------------------------------------------------------------------


def as_written(value):
    """Whether something is so is yes or no; what is not known is null."""
    if isinstance(value, (list, tuple)):
        return [as_written(one) for one in value]
    if isinstance(value, (bool, np.bool_)):
        return WORDS[bool(value)]
    value = value.item() if isinstance(value, np.generic) else value
    return None if isinstance(value, float) and not isfinite(value) else value


def cases_of(measured, sample, way=PRIMARY):
    """[{quantity: value}] of a sample, of which one that holds is enough; None if there is nothing
    to compare. A sample that failed has no case."""
    if isinstance(sample, Failure):
        return []
    if (found := measured(sample, way)) is None:
        return None
    cases = [found] if isinstance(found, dict) else found
    return [{name: as_written(of) for name, of in case.items()} for case in cases]


def holds(row, cases):
    """Whether one of the cases of a unit meets all conditions."""
    return any(not unmet(row, case) for case in cases)


def unmet(row, case):
    """The quantities whose conditions a case does not meet; all must have been measured."""
    return [name for name, c in row["conditions"].items() if not met(c, case[name])]


def unmet_text(row, case):
    """Says which conditions do not hold: slowest is c_s/49.6, not c_s/200 to c_s/50"""
    parts = []
    for name in unmet(row, case):
        condition = row["conditions"][name]
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


def interval_of(of_runs):
    """90 % interval of the share of units that hold; of each run, whether each of its units does.
    Events of one run are not independent. It is at least as wide as if they were."""
    of_runs = [held for held in of_runs if held]
    units = sum(map(len, of_runs))
    bounds = interval(sum(map(sum, of_runs)), units)
    if len(of_runs) in (1, units):
        return bounds
    low, high = interval_by_runs(np.mean, of_runs)
    return min(bounds[0], low), max(bounds[1], high)


def is_one_state(row):
    """Prepared interfaces: the majority of their seeds decides."""
    return row.get("unit") == "seed"


def share_of(row, convention, units):
    """The share of units for which the claim holds under one convention; `units`: (run, cases). One
    without a case counts against the claim."""
    of_runs: dict = {}
    for run, cases in units:
        of_runs.setdefault(object() if run is None else run, []).append(holds(row, cases))
    count = sum(map(sum, of_runs.values()))
    if is_one_state(row):
        return Share(convention, int(2 * count > len(units)), 1, None, None)
    return Share(convention, count, len(units), *interval_of(of_runs.values()))


def by_convention(row, measured, units):
    """{convention: [(run, cases)]}, the primary one first: ways to measure, then other units."""
    found = {PRIMARY: (units[PRIMARY], PRIMARY)}
    found |= {way: (units[PRIMARY], way) for way in ways_of(row)}
    found |= {name: (of, PRIMARY) for name, of in units.items() if name != PRIMARY}
    return {
        name: [
            (run, cases)
            for run, sample in of
            if (cases := cases_of(measured, sample, way)) is not None
        ]
        for name, (of, way) in found.items()
    }


def shares_of(row, found, fewest=1):
    """One per convention; none if there are too few units. `found`: of by_convention()."""
    if len(found[PRIMARY]) < fewest:
        return []
    return [share_of(row, name, units) for name, units in found.items() if units]


def held_in_state(row, measured, first, accepted):
    """{convention: whether the claim holds} for the one state that is shown."""
    others = {way: holds(row, cases_of(measured, first, way) or []) for way in ways_of(row)}
    return {PRIMARY: accepted} | others


def needed(row):
    """Less for "there is such an event": the paper shows one run."""
    return NEEDED_IF_ONE_EXISTS if "one_of" in row else NEEDED


def verdict_of_shares(row, shown, shares):
    """The 90 % intervals must lie beyond the limit, not only the shares."""
    unit = row["unit"]
    worst, best = min(shares, key=lambda s: s.low), max(shares, key=lambda s: s.high)
    if shown and worst.low >= needed(row):
        return REPRODUCED, f"holds in at least {worst.text(unit)}"
    if not shown and best.high <= FEW:
        return DIFFERS, f"holds in at most {best.text(unit)}"
    primary, decides, to = shares[0], *((worst, "down") if shown else (best, "up"))
    extreme = "" if decides is primary else f", {to} to {decides.text(unit)}"
    parts = [share.part() for share in shares]
    enough = min(parts) >= needed(row) if shown else max(parts) <= FEW
    few = f"; too few {plural(unit)} for a verdict" if enough else ""
    beside = "" if shown else ", but not in the case shown"
    return DEPENDS, f"holds in {primary.text(unit)}{extreme}{beside}{few}"


def too_few(row, count):
    what = "seeds" if is_one_state(row) else plural(row["unit"])
    if not count:
        return f"only the case shown was judged, no other {what}"
    judged = f"{count} {what} were" if count > 1 else f"1 {row['unit']} was"
    return f"only {judged} judged; a verdict needs {FEWEST}"


def verdict_of(row, shown, shares, held, count):
    """The verdict, None without units, and its reason in one line. `shown`: whether the claim holds
    for the case in the picture; `held`: {convention: whether it holds} for one state; `count`: of
    units, which may be too few for shares."""
    if not row["conditions"]:
        return NOT_COMPARABLE, "the paper gives no number to compare with; ours are reported"
    if shown is None:
        return NOT_COMPARABLE, "it could not be measured"
    if shares and is_one_state(row):
        return verdict_of_state({share.convention: share.holds == 1 for share in shares})
    if shares:
        return verdict_of_shares(row, shown, shares)
    if row.get("unit"):
        return None, too_few(row, count)
    return verdict_of_state(held)


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


# --- a claim -------------------------------------------------------------------------------


def counted(row, units):
    """{what is counted: "4 of 20"}: units with a case in which a quantity is known and not "no"."""
    found = {
        name: sum(any(case[of] not in (None, "no") for case in cases) for _, cases in units)
        for name, of in row.get("counts", {}).items()
    }
    return {name: f"{n} of {len(units)}" if units else "not run" for name, n in found.items()}


def share_of_all(row, units):
    """For "there is such an event": of all cases, how many are such."""
    cases = [case for _, of_unit in units for case in of_unit]
    if not cases or "one_of" not in row:
        return ""
    return f"; {sum(holds(row, [case]) for case in cases)} of {len(cases)} {row['one_of']}"


def judged(row, measured, samples):
    """The claim with its verdict. `measured`: (sample, way) -> what cases_of() reads."""
    shown = {name: cases_of(measured, one) for name, one in samples.shown.items()}
    case = next((cases[0] if cases else None for cases in shown.values()), None)
    accepted = None if case is None else holds(row, [case])
    found = by_convention(row, measured, samples.units) if samples.units else {PRIMARY: []}
    shares = shares_of(row, found, FEWEST)
    held = {}
    if accepted is not None and not samples.units:
        held = held_in_state(row, measured, next(iter(samples.shown.values())), accepted)
    verdict, reason = verdict_of(row, accepted, shares, held, len(found[PRIMARY]))
    if shares:
        reason += share_of_all(row, found[PRIMARY])
    if accepted is False:
        reason += f" ({unmet_text(row, case)})"
    values = {
        f"{name}: {quantity}" if name else quantity: value
        for name, cases in shown.items()
        for quantity, value in (cases[0] if cases else {}).items()
    }
    return Claim(
        id=row["id"],
        kind=row["kind"],
        fixed=row["fixed"],
        paper=row["says"],
        acceptance=row["accepted"],
        measured=values | counted(row, found[PRIMARY]),
        case=None if accepted is None or not row["conditions"] else CASES[accepted],
        shares=shares,
        verdict=verdict,
        reason=reason,
        note=row.get("note", ""),
    )


def function(row, key):
    try:
        return function_of(row["recipe"], row[key])
    except (AttributeError, ImportError, KeyError) as error:
        raise Failure(f"claims.toml, claim {row['id']}, '{key}': {error}") from error


def claim_of(row, known):
    """`known`: samples, by the functions of which they come."""
    measured, samples = function(row, "measured"), function(row, "samples")
    if samples not in known:
        known[samples] = samples()
    return judged(row, measured, known[samples])


def judge(recipe):
    """All claims of a recipe."""
    known: dict = {}
    return [claim_of(row, known) for row in rows_of(recipe)]
