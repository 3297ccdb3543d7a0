"""The one judge of claims: what a row of claims.toml measures, against its conditions.

docs/claims.md has the rules.
"""

from math import isfinite

import numpy as np
from rupture.errors import Failure
from scipy.stats import beta

from claims.claim import DOES_NOT_HOLD, HOLDS
from claims.claim import Claim, Share, split_unit
from claims.conditions import as_read, met, wanted
from claims.recipes import function_of
from claims.resampling import interval_by_runs
from claims.table import left_out, rows_of, ways_of
from claims.words import FEWEST, verdict_of
from measure.ways import PRIMARY

SHOWN = {True: HOLDS, False: DOES_NOT_HOLD}
WORDS = {True: "yes", False: "no"}


# --- one sample ----------------------------------------------------------------------------


def as_written(value):
    """Whether something is so is yes or no; what is not known is null."""
    if isinstance(value, (list, tuple)):
        return [as_written(one) for one in value]
    if isinstance(value, (bool, np.bool_)):
        return WORDS[bool(value)]
    value = value.item() if isinstance(value, np.generic) else value
    return None if isinstance(value, float) and not isfinite(value) else value


def found_in(measured, sample, way=PRIMARY):
    """[{quantity: value}] of what was found in a sample, such as the events of a run, of which one
    that holds is enough; None if there is nothing to compare. In one that failed, nothing is."""
    if isinstance(sample, Failure):
        return []
    if (found := measured(sample, way)) is None:
        return None
    several = [found] if isinstance(found, dict) else found
    return [{name: as_written(of) for name, of in one.items()} for one in several]


def holds(row, found):
    """Whether one of what was found in a sample meets all conditions."""
    return any(not unmet(row, one) for one in found)


def unmet(row, one):
    """The quantities whose conditions are not met; all must have been measured."""
    return [name for name, c in row["conditions"].items() if not met(c, one[name])]


def unmet_text(row, one):
    """Says which conditions do not hold: slowest is c_s/49.6, not c_s/200 to c_s/50"""
    parts = []
    for name in unmet(row, one):
        condition = row["conditions"][name]
        quantity, unit = split_unit(name.removesuffix("/c_s"))
        asked, got = f"{wanted(name, condition)} {unit}".rstrip(), as_read(name, one[name])
        if isinstance(one[name], float) and met(condition, float(f"{one[name]:.3g}")):
            got = f"{one[name]:.6g}"  # in three digits it would seem to be met
        parts.append(f"{quantity} is {got}, not {asked}")
    return "; ".join(parts)


# --- all samples ---------------------------------------------------------------------------


def interval(k, n):
    """90 % interval of a share (Jeffreys)."""
    low, high = beta.ppf((0.05, 0.95), k + 0.5, n - k + 0.5)
    return float(low if k else 0.0), float(high if k < n else 1.0)


def interval_of(of_runs):
    """90 % interval of the share of samples that hold; of each run, whether each of its samples
    does. Events of one run are not independent, so runs are drawn. It is at least as wide as if
    they were."""
    of_runs = [held for held in of_runs if held]
    samples = sum(map(len, of_runs))
    bounds = interval(sum(map(sum, of_runs)), samples)
    if len(of_runs) in (0, 1, samples):
        return bounds
    low, high = interval_by_runs(np.mean, of_runs)
    return min(bounds[0], low), max(bounds[1], high)


def is_one_state(row):
    """Prepared interfaces: the majority of their seeds decides."""
    return row.get("share_of") == "seeds"


def share_of(row, way, samples):
    """The share of samples for which the claim holds in one way; `samples`: (run, found). One in
    which nothing is found counts against the claim."""
    of_runs: dict = {}
    for run, found in samples:
        of_runs.setdefault(object() if run is None else run, []).append(holds(row, found))
    count = sum(map(sum, of_runs.values()))
    if is_one_state(row):
        return Share(way, int(2 * count > len(samples)), 1, 1, None, None)
    return Share(way, count, len(samples), len(of_runs), *interval_of(of_runs.values()))


def by_way(row, measured, taken):
    """{way: [(run, found)]}, the primary one first: ways to measure, then other samples. Samples
    with nothing to compare are left out."""
    ways = {PRIMARY: (taken[PRIMARY], PRIMARY)}
    ways |= {way: (taken[PRIMARY], way) for way in ways_of(row)}
    ways |= {name: (of, PRIMARY) for name, of in taken.items() if name != PRIMARY}
    return {
        name: [
            (run, found)
            for run, sample in of
            if (found := found_in(measured, sample, way)) is not None
        ]
        for name, (of, way) in ways.items()
    }


def shares_of(row, found):
    """One of each way; none of a state with too few seeds. `found`: of by_way()."""
    fewest = FEWEST if is_one_state(row) else 1
    if len(found[PRIMARY]) < fewest:
        return []
    return [share_of(row, way, samples) for way, samples in found.items()]


def held_in_state(row, measured, samples, shares):
    """{way: whether the claim holds} for one state; nothing for others."""
    if "share_of" in row:
        return {share.way: share.holds == 1 for share in shares if is_one_state(row)}
    if not samples.shown:
        return {}
    [first, *_] = samples.shown.values()
    ways = [PRIMARY, *ways_of(row)]
    return {way: holds(row, found_in(measured, first, way) or []) for way in ways}


# --- a claim -------------------------------------------------------------------------------


def counted(row, samples):
    """{what is counted: "4 of 20"}: samples in which a quantity is known and not "no"."""
    counts = {
        name: sum(any(one[of] not in (None, "no") for one in found) for _, found in samples)
        for name, of in row.get("counts", {}).items()
    }
    return {name: f"{n} of {len(samples)}" if samples else "not run" for name, n in counts.items()}


def share_of_all(row, samples):
    """For "there is such an event": of all events, how many are such."""
    every = [one for _, found in samples for one in found]
    if "one_of" not in row:
        return {}
    such = sum(holds(row, [one]) for one in every)
    return {f"of all {row['one_of']}": f"{such} of {len(every)}" if every else "not run"}


def shown_of(row, found):
    """Whether the claim holds for what the picture shows, and if not, why. Neither if that was
    chosen because it does. `found`: in the first that is shown."""
    if not found or "chosen" in row or not row["conditions"]:
        return None, ""
    [one, *_] = found
    return SHOWN[holds(row, [one])], unmet_text(row, one)


def judged(row, measured, samples):
    """The claim with its verdict. `measured`: (sample, way) -> what found_in() reads."""
    shown = {name: found_in(measured, one) for name, one in samples.shown.items()}
    found = by_way(row, measured, samples.taken) if samples.taken else {PRIMARY: []}
    shares = shares_of(row, found)
    verdict, reason = verdict_of(row, shares, held_in_state(row, measured, samples, shares))
    holds_as_shown, because = shown_of(row, next(iter(shown.values()), None))
    values = {
        f"{name}: {quantity}" if name else quantity: value
        for name, of in shown.items()
        for quantity, value in (of[0] if of else {}).items()
    }
    return Claim(
        id=row["id"],
        kind=row["kind"],
        fixed=row["fixed"],
        paper=row["says"],
        acceptance=row["accepted"],
        measured=values | counted(row, found[PRIMARY]) | share_of_all(row, found[PRIMARY]),
        shown=holds_as_shown,
        shares=shares,
        verdict=verdict,
        reason=f"{reason} (shown: {because})" if because else reason,
        note=" ".join(filter(None, [row.get("note", ""), left_out(row)])),
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
