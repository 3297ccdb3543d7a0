"""The one judge of claims: what a row of claims.toml measures, against its conditions.

docs/claims.md has the rules.
"""

import tomllib
from functools import cache
from pathlib import Path

import numpy as np
from scipy.stats import beta

from claims import cases
from claims.claim import DEPENDS, DIFFERS, DOES_NOT_HOLD, HOLDS, NOT_COMPARABLE, PRIMARY, REPRODUCED
from claims.claim import Claim, Share, plural, split_unit
from claims.conditions import as_read, met, wanted
from claims.resampling import interval_by_runs
from reproduce.recipes import paper_of
from rupture.errors import Failure

RECIPES = Path(__file__).parents[1]
NEEDED, NEEDED_IF_ONE_EXISTS = 0.8, 0.5  # share of the samples, for `reproduced`
FEW = 0.2  # share up to which it `differs`
FEWEST = 5  # units; fewer tell nothing
CASES = {True: HOLDS, False: DOES_NOT_HOLD}


@cache
def read(paper):
    """What a paper is, and {recipe: {claim: its row}}."""
    path = RECIPES / paper / "claims.toml"
    try:
        recipes = tomllib.loads(path.read_text(encoding="utf-8"))
        return recipes.pop("paper"), recipes
    except (OSError, KeyError, ValueError) as error:
        raise Failure(f"The claims in {path} cannot be read ({error}).") from error


@cache
def table(paper=""):
    """{claim id: its row, with its id and recipe}, of another paper PAPER/2A and PAPER/fig2. A row
    has all of the one that it is like, except for what it says itself."""
    found: dict[str, dict] = {}
    for recipe, rows in read(paper)[1].items():
        for name, row in rows.items():
            name, like, of = (str(Path(paper, n)) for n in (name, row.get("like", "-"), recipe))
            found[name] = found.get(like, {}) | row | {"id": name, "recipe": of}
    return found


def row_of(claim_id):
    return table(paper_of(claim_id))[claim_id]


# --- one case ------------------------------------------------------------------------------


def holds(claim_id, cases):
    """Whether one of the cases of a unit meets all conditions."""
    return any(not unmet(claim_id, case) for case in cases)


def unmet(claim_id, case):
    """The quantities whose conditions a case does not meet; all must have been measured."""
    return [name for name, c in row_of(claim_id)["conditions"].items() if not met(c, case[name])]


def unmet_text(claim_id, case):
    """Says which conditions do not hold: slowest is c_s/49.6, not c_s/200 to c_s/50"""
    parts = []
    for name in unmet(claim_id, case):
        condition = row_of(claim_id)["conditions"][name]
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
    """The share of units for which the claim holds under one convention; `units`: {unit: [case,
    ...]}. One without a case counts against the claim."""
    of_runs: dict = {}
    for (_, run), found in units.items():
        of_runs.setdefault(run, []).append(holds(row["id"], found))
    count = sum(map(sum, of_runs.values()))
    if is_one_state(row):
        return Share(convention, int(2 * count > len(units)), 1, None, None)
    return Share(convention, count, len(units), *interval_of(of_runs.values()))


def case_of(names):
    """What its conditions are about."""
    return names.case(names.row["conditions"])


def cases_of_units(row, chains, way=PRIMARY):
    """{unit: [case, ...]}"""
    found = cases.units(row, chains, way)
    return {unit: [*map(case_of, names)] for unit, names in found.items()}


def shares_of(row, chains, fewest=1):
    """One per convention, the primary one first; none if there are too few units. `chains`: {name:
    points} (chains/results.py)."""
    found = {
        name: cases_of_units(instead, chains, way)
        for name, (instead, way) in cases.conventions(row, chains).items()
    }
    if len(found[PRIMARY]) < fewest:
        return []
    return [share_of(row, name, units) for name, units in found.items() if units]


def held_in_state(row, chains, accepted):
    """{convention: whether the claim holds} for one state: that in the picture, or any of the
    points of `each`."""
    held = {PRIMARY: accepted}
    for name, (instead, way) in cases.conventions(row, chains).items():
        if name != PRIMARY and "each" in row:
            held[name] = any(
                holds(row["id"], of) for of in cases_of_units(instead, chains, way).values()
            )
        elif name != PRIMARY:
            first, *_ = cases.of_shown(instead, chains, way).values()
            held[name] = holds(row["id"], [case_of(first)])
    return held


def needed(row):
    """Less for "there is such an event": the paper shows one run."""
    return NEEDED_IF_ONE_EXISTS if cases.one_exists(row) else NEEDED


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


def verdict_of(row, shown, shares, held):
    """The verdict, None without units, and its reason in one line. `shown`: whether the claim holds
    for the case in the picture; `held`: {convention: whether it holds} for one state."""
    if not row["conditions"]:
        return NOT_COMPARABLE, "the paper gives no number to compare with; ours are reported"
    if shown is None:
        return NOT_COMPARABLE, "it could not be measured"
    if shares and is_one_state(row):
        return verdict_of_state({share.convention: share.holds == 1 for share in shares})
    if shares:
        return verdict_of_shares(row, shown, shares)
    if row.get("unit"):
        what = "seeds" if is_one_state(row) else plural(row["unit"])
        return None, f"only the case shown was judged, no other {what}"
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


def counted(row, chains):
    """{what is counted: "4 of 20"}: units with a case for which a text in `counts` is true."""
    units = cases.units(row, chains).values() if row.get("counts") else []

    def is_so(names, text):
        names.given["holds"] = not unmet(row["id"], case_of(names))
        return names.value(text)

    found = {
        name: sum(any(is_so(names, text) for names in unit) for unit in units)
        for name, text in row.get("counts", {}).items()
    }
    return {name: f"{n} of {len(units)}" if units else "not run" for name, n in found.items()}


def share_of_all(row, chains):
    """For "there is such an event": of all events that `among` says, how many are such."""
    parts = []
    for what, text in row.get("among", {}).items():
        among = [n for unit in cases.units(row, chains).values() for n in unit if n.value(text)]
        held = sum(holds(row["id"], [case_of(names)]) for names in among)
        parts += [f"; {held} of {len(among)} {what}"] if among else []
    return "".join(parts)


def judged(claim_id, chains):
    """The claim with its verdict. `chains`: {name: points}, those that its recipe reads."""
    row = row_of(claim_id)
    shown = cases.of_shown(row, chains)
    first = next(iter(shown.values()), None)
    case = first.case() if first and ("if" not in row or first.value(row["if"])) else None
    accepted = None if case is None else holds(claim_id, [case])
    is_over_units = "unit" in row and "each" in row
    shares = shares_of(row, chains, FEWEST) if is_over_units else []
    held = {} if accepted is None or is_over_units else held_in_state(row, chains, accepted)
    verdict, reason = verdict_of(row, accepted, shares, held)
    if shares:
        reason += share_of_all(row, chains)
    if accepted is False:
        reason += f" ({unmet_text(claim_id, case)})"
    measured = {
        f"{name}: {quantity}" if name else quantity: value
        for name, of in shown.items()
        for quantity, value in of.case().items()
    }
    return Claim(
        id=claim_id,
        kind=row["kind"],
        fixed=row["fixed"],
        paper=row["says"],
        acceptance=row["accepted"],
        measured=measured | counted(row, chains),
        case=None if accepted is None or not row["conditions"] else CASES[accepted],
        shares=shares,
        verdict=verdict,
        reason=reason,
        note=row.get("note", ""),
    )


def judge(recipe, chains):
    """All claims of a recipe."""
    rows = table(paper_of(recipe)).values()
    try:
        return [judged(row["id"], chains) for row in rows if row["recipe"] == recipe]
    except KeyError as error:
        raise Failure(f"a row of claims.toml needs {error}: a key, or a chain to read") from error
