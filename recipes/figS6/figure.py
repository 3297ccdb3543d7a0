"""Figure S6, its data and its claims."""

import numpy as np
import rupture

from claims.judge import judged, unmet
from data.records import report, values
from data.tables import write_events, write_fronts
from events.choose_events import first_in_words
from events.front_claims import case_of_event, judged_in_words
from events.units import below_c_s_over_8, of_ensemble
from events.units import in_words as units_in_words
from maps.front_map import STENCIL
from maps.map_claims import make_map
from pictures.panels import draw_front_speeds, draw_pinned, draw_pinned_scale, name_line
from pictures.panels import ruptured_early, window_of
from pictures.plotting import AS_IT_IS, BLACK, CHANGED, DOUBLE, figure, letter, save

RUNS = {  # run: label, colour, marker
    "event": (r"$\langle t_R\rangle$ (as in A)", AS_IT_IS, "o"),
    "t_R-double": (r"$2\,\langle t_R\rangle$", CHANGED, "^"),
}
ENDS = STENCIL // 2  # blocks between the middle and either end of a stencil
MAP = dict(
    panel="B",
    tables=["map-boundary"],
    slow_below=(20, 8, 10, 30, 40),
    claims=("S6Bw", "S6B"),
    note="As in 4D, slow means below c_s/20; only S6A allows slow stretches of up to c_s/8."
    " tau_bar_0 is relative to mu_d, the friction just after breaking. Friction falls further"
    " to mu_new while junctions slip, so fronts also cross at negative tau_bar_0.",
)
RATIOS = {"fast/slow before", "fast/slow after"}


def ahead_of_front(front):
    """Of each stencil, whether a block at its end ruptured ahead of the front."""
    ends = np.pad(ruptured_early(front), ENDS)
    return ends[: -2 * ENDS] | ends[2 * ENDS :]


def draw_speeds(axes, fronts):
    joined = {
        run: front | {"v_c": np.where(ahead_of_front(front), np.nan, values(front["v_c"]))}
        for run, front in fronts.items()
    }
    draw_front_speeds(axes, joined, RUNS)
    for run, (_, colour, marker) in RUNS.items():
        front, ahead = fronts[run], ahead_of_front(fronts[run])
        x, v_c = (values(front[name])[ahead] for name in ("x", "v_c"))
        axes.plot(x / front["L"], v_c, marker, color=colour, markerfacecolor="none")
    axes.plot([], [], "o", color=BLACK, markerfacecolor="none", label="block ahead of the front")
    limit = fronts["event"]["c_s"] / 10
    axes.axhline(limit, color=BLACK, linewidth=0.8)
    name_line(axes, "$c_s/10$", limit)
    axes.set(ylim=(5, 1e4))
    axes.legend(loc="upper right")


def draw(record, fronts, stem):
    t_zero, window = window_of(fronts["event"])
    fig, axes = figure(DOUBLE, 0.42 * DOUBLE, ncols=2)
    image = draw_pinned(axes[0], rupture.open(record), t_zero, window)
    draw_pinned_scale(fig, image, axes[0])
    draw_speeds(axes[1], fronts)
    letter(axes[0], "A")
    save(fig, stem)


def measured(fronts, with_ends, events):
    slow, longer = fronts["event"]["slow"], fronts["t_R-double"]["slow"] or {}
    case = case_of_event(fronts["event"])
    as_judged = ("duration [ms]", "from [L]", "to [L]", "fast/slow before", "fast/slow after")
    return {
        "slow speed [m/s]": slow["speed"],
        "c_s/slow speed": fronts["event"]["c_s"] / slow["speed"],
        **{name: case[name] for name in as_judged},
        "between the crossings of c_s/8 [ms]": with_ends["slow"]["duration"] * 1e3,
        "fast after [m/s]": slow["fast_after"],
        "slow with doubled t_R [m/s]": longer.get("speed"),
        "fast after with doubled t_R [m/s]": longer.get("fast_after"),
        "not met": ", ".join(unmet("S6A", case)) or "none",
        "spanning events": len(events),
        "of them meet all but the ratios": sum(set(e["unmet"]) <= RATIOS for e in events),
    }


def make(data, results):
    loads = of_ensemble(data, "decaying", "events")
    events = report(data / "figS6/choice.json")["events"]
    fronts = {run: report(data / f"figS6/{run}-front-c_s-8.json") for run in RUNS}
    with_ends = report(data / "figS6/event-front-c_s-8-with-ends.json")
    draw(data / "figS6/event-record.h5", fronts, results / "figS6A")
    write_fronts(results / "front-speed.csv", fronts)
    not_met = {"conditions of S6A not met": lambda event: "; ".join(event["unmet"])}
    write_events(results / "events.csv", events, not_met)
    first = first_in_words(data / "ensemble/decaying-01-events.json")
    return [
        judged(
            "S6A",
            shown=case_of_event(fronts["event"]),
            measured=measured(fronts, with_ends, events),
            units=below_c_s_over_8(loads, case_of_event),
            note="Slow means below c_s/8. Shown: the first event fast-slow-fast in words.",
        ),
        judged_in_words("S6Aw", first, units_in_words(loads)),
        *make_map(data, results, **MAP),
    ]
