"""Claims on the terminal, as a table that fits into 100 columns."""

import textwrap

from claims.claim import CLAIMS, STANDINGS, Share, read_claims

SUMMARY = "summary.txt"  # what a recipe has to say beyond claims, beside its claims.json
WIDTH = 100
HEADS = ("verdict", "shown", "share", "least", "under")
INDENT = " " * 6
FORM = INDENT + "{:16}{:8}{:20}{:7}{}"
SHOWN = {True: "holds", False: "fails", None: "-"}


def cells(claim):
    """Share under the primary convention with its 90 % interval, and the least of all."""
    if not claim.shares:
        return claim.standing, SHOWN[claim.shown], "", "", ""
    primary, least = claim.shares[0], min(claim.shares, key=Share.part)
    within = "" if primary.low is None else f" ({primary.low:.2f}-{primary.high:.2f})"
    shares = f"{primary.part():.2f}{within}", f"{least.part():.2f}", least.convention
    return claim.standing, SHOWN[claim.shown], *shares


def print_table(claims):
    """A row that asks for more than the paper says is indented below the leading one."""
    print(f"{'claim':6}of the paper\n{FORM.format(*HEADS).rstrip()}")
    print("-" * WIDTH)
    for claim in claims:
        name = f" {claim.id}" if claim.closeness_of else claim.id
        print(f"{name:6}{textwrap.shorten(claim.paper, WIDTH - len(INDENT), placeholder=' ...')}")
        print(FORM.format(*cells(claim)).rstrip())
        print(textwrap.fill(claim.reason, WIDTH, initial_indent=INDENT, subsequent_indent=INDENT))


def summary(claims):
    counts = {s: sum(claim.standing == s for claim in claims) for s in STANDINGS}
    return ", ".join(f"{count} {name}" for name, count in counts.items() if count)


def print_claims(folder):
    """Prints the claims of the recipe with these results."""
    claims = read_claims(folder / CLAIMS)
    print(f"\n{folder.name}: {summary(claims) or 'no claims of its own'}\n")
    if claims:
        print_table(claims)
    if (folder / SUMMARY).exists():
        print((folder / SUMMARY).read_text(encoding="utf-8"))
    print(f"Pictures and data: {folder}/")
