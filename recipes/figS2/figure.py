"""Figure S2, its data and its claim."""

import numpy as np
import rupture

from claims.judge import judged
from measure.records import values
from measure.tables import write_events, write_fronts
from measure.conventions import PRIMARY
from measure.event_claims import case_S2
from measure.fronts import is_fast_slow
from measure.cases import simplified_of, without_slow_slip
from report.panels import draw_front_speeds, draw_image, window_of
from report.plotting import AS_IT_IS, CHANGED, DOUBLE, lettered, save

SPEEDS = {  # label, colour, marker
    "event": ("slow slip", AS_IT_IS, "o"),
    "no-slow-slip": ("no slow slip", CHANGED, "^"),
}
FILES = ("event-record.h5", "without-record.h5")


def draw_map(axes, path, front, t_zero, window):
    record = rupture.open(path)
    time = (record.time - t_zero) * 1e3
    shown = (time >= window[0]) & (time <= window[1])
    p = np.where(record["p"] > 0, record["p"], np.nan)  # where there is contact
    ratio = (record["tau"] / p)[shown]
    image = draw_image(axes, record, ratio, shown, t_zero, vmin=-0.1, vmax=0.4)
    line = (values(front["t_rupture"]) - t_zero) * 1e3
    axes.plot(record.x / record.x[-1], line, color="white", linewidth=1)
    axes.set(ylim=window)
    return image


def draw_speeds(axes, fronts):
    draw_front_speeds(axes, fronts, SPEEDS)
    axes.set(ylim=(1, None))
    axes.legend(loc="upper right", bbox_to_anchor=(1, 0.9))


def draw(event, fronts, stem):
    t_zero, window = window_of(fronts["event"])
    fig, panels = lettered("ABC", DOUBLE, 0.36 * DOUBLE)
    for text, name, file in zip("AC", SPEEDS, FILES):
        image = draw_map(panels[text], event.file(file), fronts[name], t_zero, window)
        panels[text].set_title(SPEEDS[name][0])
    draw_speeds(panels["B"], fronts)
    fig.colorbar(image, ax=panels["C"], label=r"$\tau/p$ (white: rupture)", aspect=30)
    save(fig, stem)


def claim_S2(fronts, pairs, others):
    event, without = fronts.values()
    slow = event["slow"]
    lost = sum(case_S2(*pair)["transition without"] == "no" for pair in pairs)
    return judged(
        "S2",
        shown=case_S2(event, without),
        measured={
            "slow [m/s]": slow["speed"],
            "for [ms]": slow["duration"] * 1e3,
            "without slow slip": without["type"],
            "fast-slow events of the run": len(pairs),
            "of them without a slow stretch when slow slip is off": lost,
        },
        others={name: case for name, case in others.items() if name != PRIMARY},
        note="Present: the front crosses the interface and runs at least 10 times as fast between"
        " the loading zone (x = 2 cm) and its slow stretch as within it. Absent: restarted with"
        " v_slow = 0 from 0.5 ms before its first rupture, it has no stencil below c_s/20 beyond"
        " the loading zone. With this law a seed has no effect, so there is one load.",
    )


def make(chains, results):
    [event], continued = chains["event"], simplified_of(chains["ensemble/simplified"])
    fronts = dict(zip(SPEEDS, (event["front"], event["front_without"])))
    events = (of_event[PRIMARY] for of_event in continued.values())
    pairs = [(of["with"], of["without"]) for of in events if is_fast_slow(of["with"])]
    draw(event, fronts, results / "figS2")
    write_fronts(results / "front-speed.csv", fronts)
    write_events(
        results / "events.csv",
        (event | {"without": without or {}} for event, without in pairs),
        {
            "without slow slip": lambda event: event["without"].get("type", "none"),
            "arrest without slow slip [m]": lambda event: event["without"].get("x_arrest"),
        },
    )
    return [claim_S2(fronts, pairs, without_slow_slip(continued))]
