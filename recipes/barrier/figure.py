"""Which fronts cross a patch of stronger junctions, with slow slip and without: a result of ours.
What is expected was fixed before any of these fronts was run."""

import numpy as np

from claims.own_result import compared, write_own
from measure.tables import write_table
from report.plotting import BLACK, BLUE, DOUBLE, VERMILION, figure, save

T_R = 2e-3  # [s]
FIRST = 28  # block at 70 mm
FRONTS = {
    0.06: "arrested",
    0.1: "slow",
    0.15: "fast",
    0.3: "very fast",
}  # plain ones, with slow slip
JUDGED = (0.15, 0.3)  # where plain fronts are fast with slow slip and without
SHOWN = (0.15, 0.6, 2)  # tau-bar, mu_s and width of the space-time picture
COLOURS = {"zero": BLUE, "f_slip": VERMILION}
MARKS = {(True, True): ("o", BLACK), (True, False): ("o", BLUE), (False, True): ("s", VERMILION)}
NAMES = {(True, True): "both cross", (True, False): "only with slow slip"}
NAMES |= {(False, True): "only without", (False, False): "neither"}
STOPPED = "of the patches that stop a fast front without slow slip, crossed with it"
EXPECTED = {
    STOPPED: {"at_least": 0.5},
    "patches crossed only without slow slip": {"at_most": 0},
    "delay behind the plain front where only slow slip crosses, median [<t_R>]": {"at_least": 0.5},
}


def arrival(point):
    """When the front has passed the patch by two blocks [s], or None."""
    return point["front"]["t_front"][FIRST + int(point["width"]) + 1]


def by_place(points):
    """The fronts by f_new, for each (tau-bar, mu_s, width)."""
    places: dict = {}
    for point in points:
        place = (point["tau-bar"], point["strength"], int(point["width"]))
        places.setdefault(place, {})[point["junctions.f_new"]] = point
    return places


def crossed(pair):
    """(with slow slip, without)"""
    return tuple(arrival(pair[f_new]) is not None for f_new in COLOURS)


def delays(places, plain):
    """Where only slow slip crosses: behind the plain front at the same block [<t_R>]."""
    for place, pair in places.items():
        if place[0] in JUDGED and crossed(pair) == (True, False):
            block = FIRST + place[2] + 1
            t_plain = plain[place[0], 0.4, 1]["zero"]["front"]["t_front"][block]
            yield (arrival(pair["zero"]) - t_plain) / T_R


def own_result(places, plain):
    judged = [crossed(pair) for place, pair in places.items() if place[0] in JUDGED]
    stopped = [slip for slip, without in judged if not without]
    late = list(delays(places, plain))
    numbers = (
        float(np.mean(stopped)) if stopped else None,
        sum(crossed(pair) == (False, True) for pair in places.values()),
        float(np.median(late)) if late else None,
    )
    others: dict = {"patches that stop a fast front without slow slip": len(stopped)}
    for tau_bar, name in FRONTS.items():
        pairs = [crossed(pair) for place, pair in places.items() if place[0] == tau_bar]
        text = f"{sum(a for a, _ in pairs)} with slow slip, {sum(b for _, b in pairs)} without"
        others[f"{name} front (tau_bar_0 = {tau_bar}), crosses of {len(pairs)} patches"] = text
    question = "does slow slip carry fronts across barriers that stop them otherwise?"
    return compared("barrier", dict(zip(EXPECTED, numbers)) | others, question, EXPECTED)


def draw(places, plain, stem):
    """Maps of the patches, one for each prestress, and the fronts at one of them."""
    fig, panels = figure(DOUBLE, 0.3 * DOUBLE, ncols=5)
    for axes, (tau_bar, name) in zip(panels, FRONTS.items()):
        for (_, strength, width), pair in ((k, v) for k, v in places.items() if k[0] == tau_bar):
            mark, colour = MARKS.get(crossed(pair), ("o", BLACK))
            fill = colour if any(crossed(pair)) else "none"
            axes.plot(2.5 * width, strength, mark, color=colour, markerfacecolor=fill, markersize=4)
        axes.set(xlabel="width [mm]", xscale="log", xlim=(1.8, 28), ylim=(0.4, 1.05))
        axes.set_xticks([2.5, 5, 10, 20], ["2.5", "5", "10", "20"], minor=False)
        axes.set_xticks([], minor=True)
        axes.set_title(rf"{name}, $\bar\tau_0 = {tau_bar:g}$")
    panels[0].set_ylabel(r"$\mu_s$ of the patch")
    axes, (tau_bar, strength, width) = panels[-1], SHOWN
    axes.axvspan(70 - 1.25, 70 + 2.5 * width - 1.25, color=BLACK, alpha=0.15, linewidth=0)
    for f_new, colour in COLOURS.items():
        for of, style in ((places[SHOWN], "-"), (plain[tau_bar, 0.4, 1], ":")):
            front = of[f_new]["front"]
            known = [
                (x * 1e3, t * 1e3) for x, t in zip(front["x"], front["t_front"]) if t is not None
            ]
            axes.plot(*zip(*known), style, color=colour)
    axes.set(xlabel="$x$ [mm]", ylabel="$t$ [ms]")
    axes.set_title(rf"$\mu_s = {strength:g}$, $\bar\tau_0 = {tau_bar:g}$")
    save(fig, stem)


def make(chains, results):
    points = list(chains["fronts"])
    plain = by_place(point for point in points if point["variant"] == "plain")
    places = by_place(point for point in points if point["variant"] == "patch")
    draw(places, plain, results / "barrier")
    rows = [[*place, NAMES[crossed(pair)]] for place, pair in places.items()]
    write_table(results / "barrier.csv", ["tau_bar_0", "mu_s", "width [blocks]", "crosses"], rows)
    write_own(results, [own_result(places, plain)])
