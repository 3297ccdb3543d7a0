"""Which fronts cross a patch of stronger junctions, with slow slip and without: a result of ours.
What is expected was fixed before any of these fronts was run."""

import numpy as np
from rupture.figures import BLACK, BLUE, DOUBLE, VERMILION, figure, save

import paper
from barrier.commands import FIRST, FRONTS, PLAIN, places
from claims.own_result import compared, write_own
from events import WIDTH
from measure.tables import write_table

T_R = 2e-3  # [s]
JUDGED = (0.15, 0.3)  # where plain fronts are fast with slow slip and without
COLOURS = (BLUE, VERMILION)  # with slow slip, without
CROSSES = {  # with slow slip, without: name, symbol, colour
    (True, True): ("both cross", "o", BLACK),
    (True, False): ("only with slow slip", "o", BLUE),
    (False, True): ("only without", "s", VERMILION),
    (False, False): ("neither", "o", "none"),
}
EXPECTED = {
    "of the patches that stop a fast front without slow slip, crossed with it": {"at_least": 0.5},
    "patches crossed only without slow slip": {"at_most": 0},
    "delay behind the plain front where only slow slip crosses, median [<t_R>]": {"at_least": 0.5},
}


def in_l_0(width):
    """A width in blocks as the decay length of the shear force ahead of a front."""
    return round(width * WIDTH / paper.L_0, 2)


def arrivals(pair, width):
    """When the front has passed a patch by two blocks, with slow slip and without [s], or None."""
    return [front.t_front[FIRST + width + 1] for front in pair]


def crossed(place, pair):
    return tuple(t is not None for t in arrivals(pair, place[2]))


def outcome(front, width):
    """What a front makes of a patch; it may leave it whole, and go on behind it."""
    if front.t_front[FIRST + width + 1] is None:
        return "stops"
    broke = all(t is not None for t in front.t_rupture[FIRST : FIRST + width])
    return "breaks it" if broke else "jumps over it"


def jumps(places, number):
    """Patches over which fronts jump, with slow slip (0) or without (1)."""
    of = patches(places, *FRONTS).items()
    return sum(outcome(pair[number], at[2]) == "jumps over it" for at, pair in of)


def patches(places, *tau_bars):
    return {at: of for at, of in places.items() if at[0] in tau_bars and at[1:] != PLAIN}


def only_slow_slip(places):
    """The patches that a fast front crosses only with slow slip."""
    judged = patches(places, *JUDGED).items()
    return [place for place, pair in judged if crossed(place, pair) == (True, False)]


def own_result(places):
    stopped = [a for a, b in (crossed(*one) for one in patches(places, *JUDGED).items()) if not b]
    late = [
        arrivals(places[place], place[2])[0] - arrivals(places[place[0], *PLAIN], place[2])[0]
        for place in only_slow_slip(places)
    ]
    numbers = (
        float(np.mean(stopped)) if stopped else None,
        sum(crossed(*one) == (False, True) for one in patches(places, *FRONTS).items()),
        float(np.median(late)) / T_R if late else None,
    )
    others: dict = {"patches that stop a fast front without slow slip": len(stopped)}
    others["patches left whole behind the front, with slow slip"] = jumps(places, 0)
    others["patches left whole behind the front, without"] = jumps(places, 1)
    for tau_bar, name in FRONTS.items():
        pairs = [crossed(*one) for one in patches(places, tau_bar).items()]
        text = f"{sum(a for a, _ in pairs)} with slow slip, {sum(b for _, b in pairs)} without"
        others[f"{name} front (tau_bar_0 = {tau_bar}), crosses of {len(pairs)} patches"] = text
    question = "does slow slip carry fronts across barriers that stop them otherwise?"
    return compared("barrier", dict(zip(EXPECTED, numbers)) | others, question, EXPECTED)


def draw_fronts(axes, places):
    """Draws the fronts at the first patch that only slow slip crosses, from the weakest and
    narrowest on."""
    tau_bar, strength, width = only_slow_slip(places)[0]
    axes.axvspan(70 - 1.25, 70 + 2.5 * width - 1.25, color=BLACK, alpha=0.15, linewidth=0)
    for place, style in (((strength, width), "-"), (PLAIN, ":")):
        for front, colour in zip(places[tau_bar, *place], COLOURS):
            line = [(x * 1e3, t * 1e3) for x, t in zip(front.x, front.t_front) if t]
            axes.plot(*zip(*line), style, color=colour)
    axes.set(xlabel="$x$ [mm]", ylabel="$t$ [ms]")
    axes.set_title(rf"$\mu_s = {strength:g}$, $\bar\tau_0 = {tau_bar:g}$")


def draw(places, stem):
    """Maps of the patches, one for each prestress, and the fronts at one of them."""
    fig, panels = figure(DOUBLE, 0.3 * DOUBLE, ncols=5)
    for axes, (tau_bar, name) in zip(panels, FRONTS.items()):
        for place, pair in patches(places, tau_bar).items():
            _, mark, fill = CROSSES[crossed(place, pair)]
            look = {"markerfacecolor": fill, "markeredgecolor": BLACK, "markersize": 4}
            axes.plot(in_l_0(place[2]), place[1], mark, **look)
        axes.set(xlabel="width [$l_0$]", xscale="log", xlim=(0.25, 4), ylim=(0.4, 1.05))
        axes.set_xticks([0.36, 0.71, 1.4, 2.9], ["0.36", "0.71", "1.4", "2.9"])
        axes.minorticks_off()
        axes.set_title(rf"{name}, $\bar\tau_0 = {tau_bar:g}$")
    panels[0].set_ylabel(r"$\mu_s$ of the patch")
    draw_fronts(panels[-1], places)
    save(fig, stem)


def make(results):
    found = places()
    draw(found, results / "barrier")
    rows = [
        [*at, in_l_0(at[2]), CROSSES[crossed(at, of)][0], *(outcome(front, at[2]) for front in of)]
        for at, of in patches(found, *FRONTS).items()
    ]
    names = ["tau_bar_0", "mu_s", "width [blocks]", "width [l_0]", "crosses"]
    names += ["with slow slip", "without"]
    write_table(results / "barrier.csv", names, rows)
    write_own(results, [own_result(found)])
