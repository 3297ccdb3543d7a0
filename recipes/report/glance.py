"""All claims at a glance, figure by figure (a specification curve, Simonsohn et al. 2020): on the
left, for which share of its samples each claim holds, on the right, by which way to measure."""

import re
from collections import Counter

from claims.claim import DOES_NOT_HOLD, HOLDS
from claims.table import row_of
from claims.words import needed
from measure.ways import PRIMARY
from claims.recipes import label
from rupture.figures import BLACK, BLUE, DOUBLE, MM, SKY, VERMILION, figure, plt, save

ROW, HEAD = 3.9 * MM, 42 * MM  # heights of a claim, and of what is above all claims [inch]
SEEN = (
    "A row per claim, figure by figure. Left: for which share of its samples it holds, and whether"
    " it holds for what is shown; right: the share by each way to measure that several claims have,"
    " and the least by others."
)
GAP = 0.5  # before the next figure, behind the primary way, and before OTHERS
SEVERAL = 4  # claims whose common way has a column
OTHERS = "least by others"
MARKS = {
    HOLDS: ("^", "what is shown: holds"),
    DOES_NOT_HOLD: ("v", "what is shown: does not hold"),
}
PRIMARY_LOOK = {"color": BLACK, "marker": "s", "linewidth": 0.8}
OTHER_LOOK = {"color": SKY, "marker": "o", "linestyle": "", "markeredgecolor": BLUE}
NEEDED_LOOK = {"color": VERMILION, "linestyle": ":", "linewidth": 1.2}


def places_of(claims):
    """{way to measure: place of its column}: the primary one, then those of several claims."""
    times = Counter(share.way for claim in claims for share in claim.shares)
    common = [name for name, count in times.most_common() if count >= SEVERAL and name != PRIMARY]
    names = [PRIMARY, *common, OTHERS]
    return {name: n + GAP * (n > 0) + GAP * (name == OTHERS) for n, name in enumerate(names)}


def draw_shares(axes, claim, height):
    primary, *others = claim.shares
    axes.plot([share.part() for share in others], len(others) * [height], **OTHER_LOOK)
    if primary.low is not None:
        axes.plot([primary.low, primary.high], [height, height], color=BLACK, linewidth=0.8)
        axes.vlines(needed(row_of(claim.id)), height - 0.4, height + 0.4, **NEEDED_LOOK)
    axes.plot(primary.part(), height, **PRIMARY_LOOK)
    if claim.shown is not None:
        axes.plot(1.1, height, MARKS[claim.shown][0], color=BLACK, markersize=4)


def draw_ways(axes, places, claim, height):
    """Cells as dark as the share is large; OTHERS has the least of those without a column."""
    shares = {share.way: share.part() for share in claim.shares}
    others = [part for name, part in shares.items() if name not in places]
    cells = {name: part for name, part in shares.items() if name in places}
    for name, part in (cells | ({OTHERS: min(others)} if others else {})).items():
        place = places[name]
        axes.barh(height, 0.94, height=0.9, left=place - 0.47, color=plt.cm.Blues(0.75 * part))
        colour = "white" if part > 0.7 else BLACK
        axes.text(place, height, f"{part:.2f}", color=colour, size=6, ha="center", va="center")


def draw_legend(axes):
    """Above the axes and the names of the claims, beside the names of the ways."""
    looks = {
        "primary way to measure, 90 % interval": PRIMARY_LOOK,
        "other ways": OTHER_LOOK,
        "needed for “reproduced”": NEEDED_LOOK,
        **{text: {"color": BLACK, "marker": m, "linestyle": ""} for m, text in MARKS.values()},
    }
    lines = [plt.Line2D([], [], label=name, **look) for name, look in looks.items()]
    legend = axes.legend(handles=lines, loc="lower right", bbox_to_anchor=(1.05, 1.01))
    legend.set_in_layout(False)


def draw_glance(claims, stem):
    """Draws rows downwards; figures are separated, and named once."""
    recipes = [row_of(claim.id)["recipe"] for claim in claims]
    first = [recipe not in recipes[:n] for n, recipe in enumerate(recipes)]
    heights = {c.id: n + GAP * sum(first[1 : n + 1]) for n, c in enumerate(claims)}
    places, last = places_of(claims), max(heights.values())
    fig, (left, right) = figure(
        DOUBLE, HEAD + (last + 1) * ROW, ncols=2, sharey=True, width_ratios=(5, len(places) + 1)
    )
    for claim in claims:
        draw_shares(left, claim, heights[claim.id])
        draw_ways(right, places, claim, heights[claim.id])
        left.axhline(heights[claim.id], color=BLACK, linewidth=0.1, zorder=0)
    left.set(xlabel="share of the samples", xlim=(-0.05, 1.18), ylim=(last + 0.7, -0.7))
    names_of = [(label(recipe) or recipe) if new else "" for recipe, new in zip(recipes, first)]
    left.set_yticks([*heights.values()], [f"{f}   {c:5}" for f, c in zip(names_of, heights)])
    left.tick_params(axis="y", length=0)
    right.spines[:].set_visible(False)
    right.tick_params(length=0, labeltop=True, labelbottom=False)
    plain = (name.replace("$", r"\$") for name in places)
    names = [re.sub(r"\b([a-z])_(\w)\b", r"$\1_\2$", name) for name in plain]  # c_s
    right.set_xticks([*places.values()], names, rotation=90)
    draw_legend(left)
    save(fig, stem)
