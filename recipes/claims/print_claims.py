"""Claims on the terminal, as a table that fits into 100 columns."""

import textwrap
from collections import Counter

from claims.claim import CLAIMS, HOLDS, VERDICTS, Share, read_results
from claims.own_result import results_in, text_of
from claims.released import released
from claims.table import samples_from

WIDTH = 100
HEADS = ("shown", "verdict", "share", "least", "measured by")
INDENT = " " * 6
FORM = INDENT + "{:16}{:16}{:20}{:7}{}"


def cells(claim):
    """Share in the primary way with its 90 % interval, and the least of all."""
    shown, verdict = claim.shown or "-", claim.verdict or "-"
    if not claim.shares:
        return shown, verdict, "", "", ""
    primary, least = claim.shares[0], min(claim.shares, key=Share.part)
    within = "" if primary.low is None else f" ({primary.low:.2f}-{primary.high:.2f})"
    shares = f"{primary.part():.2f}{within}", f"{least.part():.2f}", least.way
    return shown, verdict, *shares


def print_table(claims, others):
    """`others`: the released verdicts, by claim."""
    print(f"claim of the paper\n{FORM.format(*HEADS).rstrip()}")
    print("-" * WIDTH)
    for claim in claims:
        print(textwrap.shorten(f"{claim.id}: {claim.paper}", WIDTH, placeholder=" ..."))
        print(FORM.format(*cells(claim)).rstrip())
        texts = [claim.reason] if claim.reason != claim.shown else []
        if claim.verdict is None and claim.id in others:
            texts.append(f"released verdict: {others[claim.id]}")
        for line in textwrap.wrap("; ".join(texts), WIDTH - len(INDENT)):
            print(INDENT + line)


def summary(claims):
    """Verdicts, and what is known without one."""
    verdicts = Counter(claim.verdict for claim in claims)
    texts = [f"{verdicts[name]} {name}" for name in VERDICTS if verdicts[name]]
    shown = [claim.shown for claim in claims if claim.verdict is None]
    if shown:
        held = shown.count(HOLDS)
        of = f"{held} of {len(shown)} claims {'holds' if held == 1 else 'hold'}"
        texts.append(f"for what is shown, without a verdict, {of}")
    return "; ".join(texts)


def print_claims(name, results, root):
    """Prints the claims of a recipe. The folder `root` has the verdicts of the release."""
    folder = results / name
    claims, _, builds = read_results(folder / CLAIMS)
    print(f"\n{name}: {summary(claims) or 'no claims of its own'}\n")
    if claims:
        print_table(claims, released(root, builds))
    for result in results_in(folder):
        print(text_of(result), end="\n\n")
    print(f"Pictures and data: {folder}/")
    samples = samples_from(name)
    if samples and any(claim.verdict is None for claim in claims):
        print(
            f"A verdict needs runs with other random numbers: ./reproduce.sh {samples} {name}"
            " makes them once, which takes long."
        )
