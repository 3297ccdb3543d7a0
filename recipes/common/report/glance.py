"""All claims at a glance, as a specification curve (Simonsohn et al. 2020): above, for which share
of its units each claim holds under each convention, sorted; below, which convention that is."""

import re
from dataclasses import dataclass

from claims.judge import needed
from pictures.plotting import BLACK, BLUE, DOUBLE, MM, VERMILION, figure, save

SHOWN = {True: ("^", 1.07), False: ("v", -0.07)}  # marker and height of the shown case
GAP, LEAST = 1.5, 3  # between two claims, and width of a claim, in widths of a convention
ROW = 3.0 * MM  # height of a convention's line [inch]
SHARES = 45 * MM  # height of the upper panel [inch]


@dataclass(frozen=True)
class Column:
    """One claim under one convention."""

    at: float
    share: object  # claims.claim.Share
    is_primary: bool


def columns_of(claims):
    """{claim: [Column, ...]}, from the smallest share to the largest."""
    at, columns = 0.0, {}
    for claim in claims:
        primary = claim.shares[0]
        shares = sorted(claim.shares, key=lambda share: share.part())
        columns[claim.id] = [
            Column(at + n, share, share is primary) for n, share in enumerate(shares)
        ]
        at += max(len(shares), LEAST) + GAP
    return columns


def conventions_of(claims):
    """All names, the primary one first, then those that most claims have."""
    names = [share.convention for claim in claims for share in claim.shares]
    first = claims[0].shares[0].convention
    return sorted(dict.fromkeys(names), key=lambda name: (name != first, -names.count(name)))


def symbols_in(text):
    """c_s in Matplotlib's way of typesetting."""
    return re.sub(r"\b([a-z])_(\w)\b", r"$\1_\2$", text)


def draw_shares(axes, claim, columns):
    for column in columns:
        colour = BLACK if column.is_primary else BLUE
        if column.share.low is not None:
            axes.vlines(column.at, column.share.low, column.share.high, colour, linewidth=0.5)
        axes.plot(column.at, column.share.part(), "s" if column.is_primary else "o", color=colour)
    first, last = columns[0].at - 0.5, columns[-1].at + 0.5
    axes.hlines(needed(claim.id), first, last, BLACK, linewidth=0.6, linestyle=":")
    if claim.shown is not None:
        marker, height = SHOWN[claim.shown]
        axes.plot((first + last) / 2, height, marker, color=VERMILION, markersize=4)


def draw_conventions(axes, names, columns):
    for column in columns:
        colour = BLACK if column.is_primary else BLUE
        axes.plot(column.at, names.index(column.share.convention), "s", color=colour, markersize=2)


def draw_glance(claims, stem, source):
    """Black: the primary convention; blue: the others, each with its 90 % interval. Red: the shown
    case, above where the claim holds for it, below where it does not. Dotted: the share that
    `reproduced` needs. `source`: what it is drawn from, for the PNG."""
    columns, names = columns_of(claims), conventions_of(claims)
    lines = len(names) * ROW
    fig, (upper, lower) = figure(
        DOUBLE, SHARES + lines + 12 * MM, nrows=2, sharex=True, height_ratios=(SHARES, lines)
    )
    for claim in claims:
        draw_shares(upper, claim, columns[claim.id])
        draw_conventions(lower, names, columns[claim.id])
    middles = [(c[0].at + c[-1].at) / 2 for c in columns.values()]
    upper.set(ylabel="share of the units", ylim=(-0.14, 1.14))
    upper.xaxis.tick_top()
    upper.set_xticks(middles, list(columns))
    upper.tick_params(axis="x", length=0, labeltop=True, labelbottom=False, rotation=90)
    for row in range(len(names)):
        lower.axhline(row, color=BLACK, linewidth=0.1, alpha=0.5)
    lower.set_yticks(range(len(names)), [symbols_in(name) for name in names])
    lower.tick_params(axis="x", length=0, labelbottom=False, labeltop=False, top=False)
    lower.tick_params(axis="y", length=0)
    lower.set(ylim=(len(names) - 0.5, -0.5), xlim=(-1, columns[claims[-1].id][-1].at + 1))
    save(fig, stem, source)
