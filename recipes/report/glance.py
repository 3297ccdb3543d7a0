"""All claims at a glance: for which share of its units each one holds, by convention."""

from pictures.plotting import BLACK, BLUE, DOUBLE, VERMILION, figure, save

SHOWN = {True: ("^", 1.06), False: ("v", -0.06)}  # marker and place of the shown case


def draw_claim(axes, at, claim):
    first, *others = claim.shares
    axes.plot([at] * len(others), [share.part() for share in others], "o", color=BLUE, alpha=0.4)
    axes.vlines(at, first.low, first.high, BLACK)
    axes.plot(at, first.part(), "s", color=BLACK)
    if claim.shown is not None:
        marker, height = SHOWN[claim.shown]
        axes.plot(at, height, marker, color=VERMILION)


def draw_glance(claims, stem):
    """Black: the primary convention with its 90 % interval; blue: the others; red: the shown case,
    above where the claim holds for it, below where it does not."""
    fig, axes = figure(DOUBLE, 0.35 * DOUBLE)
    for at, claim in enumerate(claims):
        draw_claim(axes, at, claim)
    axes.axhline(0.8, color=BLACK, linewidth=0.5, linestyle=":")
    axes.set_xticks(range(len(claims)), [claim.id for claim in claims])
    axes.set(ylabel="share of the units", ylim=(-0.12, 1.12), xlim=(-0.5, len(claims) - 0.5))
    save(fig, stem)
