"""Figure S2 and its data."""

import numpy as np
import rupture
from rupture.figures import AS_IT_IS, CHANGED, DOUBLE, draw_ahead, draw_front_speeds, lettered
from rupture.figures import save, window_of
from rupture.plotting import draw_image
from rupture.reports import values

from events import all_simplified
from figS2.commands import shown
from measure.ways import PRIMARY
from measure.fronts import is_fast_slow
from measure.tables import write_events, write_fronts

SPEEDS = {  # label, colour, marker
    "event": ("slow slip", AS_IT_IS, "o"),
    "no-slow-slip": ("no slow slip", CHANGED, "^"),
}


def draw_map(axes, path, front, t_zero, window):
    record = rupture.open(path)
    time = (record.time - t_zero) * 1e3
    shown = (time >= window[0]) & (time <= window[1])
    p = np.where(record["p"] > 0, record["p"], np.nan)  # where there is contact
    ratio = (record["tau"] / p)[shown]
    image = draw_image(axes, record, ratio, shown, t_zero, vmin=-0.1, vmax=0.4)
    line = (values(front["t_front"]) - t_zero) * 1e3
    axes.plot(record.x / record.x[-1], line, color="white", linewidth=1)
    draw_ahead(axes, front, t_zero, color="white")
    axes.set(ylim=window)
    return image


def draw_speeds(axes, fronts):
    draw_front_speeds(axes, fronts, SPEEDS)
    axes.set(ylim=(1, None))
    axes.legend(loc="upper right", bbox_to_anchor=(1, 0.9))


def draw(event, fronts, stem):
    t_zero, window = window_of(fronts["event"])
    fig, panels = lettered("ABC", DOUBLE, 0.36 * DOUBLE)
    for text, name, record in zip("AC", SPEEDS, (event.record, event.without_record)):
        image = draw_map(panels[text], record, fronts[name], t_zero, window)
        panels[text].set_title(SPEEDS[name][0])
    draw_speeds(panels["B"], fronts)
    fig.colorbar(image, ax=panels["C"], label=r"$\tau/p$ (white: front)", aspect=30)
    save(fig, stem)


def make(results):
    event = shown()
    fronts = dict(zip(SPEEDS, (event.front, event.without[PRIMARY])))
    draw(event, fronts, results / "figS2")
    write_fronts(results / "front-speed.csv", fronts)
    write_events(
        results / "events.csv",
        (
            of.event | {"without": of.without[PRIMARY]}
            for of in all_simplified()
            if is_fast_slow(of.event)
        ),
        {
            "without slow slip": lambda event: event["without"]["type"],
            "arrest without slow slip [m]": lambda event: event["without"]["x_arrest"],
        },
    )
