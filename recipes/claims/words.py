"""The word for a claim, from its samples alone; docs/claims.md has the table."""

from claims.claim import BY_THE_MEASURE, DIFFERS, DOES_NOT_HOLD, HOLDS, IN_PART
from claims.claim import NOT_COMPARABLE, REPRODUCED, UNDECIDED

NEEDED, NEEDED_IF_ONE_EXISTS = 0.8, 0.5  # of the samples
FEW = 0.2  # of the samples; a claim that differs holds in fewer
FEWEST = 5  # runs; fewer tell nothing


def needed(row):
    """Less for "there is such an event": the paper shows one run."""
    return NEEDED_IF_ONE_EXISTS if "one_of" in row else NEEDED


def word_of_shares(shares, bound):
    """The 90 % intervals must lie beyond a bound, not only the shares. The primary way is first."""
    primary, *others = shares
    above = [share.low > bound for share in shares]
    failing = [share.high < bound for share in shares]
    conditions = {
        UNDECIDED: primary.runs < FEWEST,
        REPRODUCED: all(above),
        DIFFERS: primary.high < FEW and all(failing),
        BY_THE_MEASURE: any(above) and any(failing),
        IN_PART: failing[0],
    }
    return next((word for word, is_so in conditions.items() if is_so), UNDECIDED)


def word_of_state(held):
    """Of one state. `held`: {way: whether the claim holds}"""
    return {(True, True): REPRODUCED, (False, False): DIFFERS}.get(
        (all(held.values()), any(held.values())), BY_THE_MEASURE
    )


# --- why -----------------------------------------------------------------------------------


def reason_of_shares(word, shares, row):
    def text(share):
        return f"{share.holds} of {share.samples} {row['share_of']} ({share.way})"

    primary = shares[0]
    worst, best = min(shares, key=lambda s: s.low), max(shares, key=lambda s: s.high)
    decides = worst if primary.part() > needed(row) else best
    beside = "" if decides is primary else f", and in {text(decides)}"
    more = "more runs would tell"
    if primary.runs < FEWEST:
        more = f"a verdict needs {FEWEST} runs"
    return {
        REPRODUCED: f"holds in at least {text(worst)}",
        DIFFERS: f"holds in at most {text(best)}",
        BY_THE_MEASURE: f"holds in {text(max(shares, key=lambda s: s.low))},"
        f" but in {text(min(shares, key=lambda s: s.high))}",
        IN_PART: f"holds in {text(primary)}",
        UNDECIDED: f"holds in {text(primary)}{beside}; {more}",
    }[word]


def reason_of_state(held):
    holding, failing = ([way for way, does in held.items() if does == so] for so in (True, False))
    ways = f"the {len(held)} ways to measure"
    if not failing:
        return f"holds in all of {ways}" if len(held) > 1 else HOLDS
    if not holding:
        return f"holds in none of {ways}" if len(held) > 1 else DOES_NOT_HOLD
    if len(holding) < len(failing):
        return f"of {ways}, holds only in {', '.join(holding)}"
    return f"of {ways}, does not hold in {', '.join(failing)}"


def verdict_of(row, shares, held):
    """The word and its reason in one line; no word where no sample is known yet. `shares`: of each
    way; `held`: {way: whether the claim holds}, of one state."""
    if not row["conditions"]:
        return NOT_COMPARABLE, "the paper gives no number to compare with; ours are reported"
    if held:
        return word_of_state(held), reason_of_state(held)
    if not shares:
        return None, "no sample has been computed yet"
    word = word_of_shares(shares, needed(row))
    return word, reason_of_shares(word, shares, row)
