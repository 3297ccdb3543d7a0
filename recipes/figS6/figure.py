"""Figure S6 and its data."""

import rupture
from rupture.figures import AS_IT_IS, BLACK, CHANGED, DOUBLE, draw_ahead, draw_front_speeds
from rupture.figures import figure, letter, save, window_of
from rupture.plotting import draw_pinned, draw_pinned_scale, name_line

from events import shown_events
from figS6.commands import LAW, event, map_of_types
from measure.ways import PRIMARY
from measure.map_panels import write_map
from measure.tables import write_events, write_fronts

LOOKS = {  # run: label, colour, marker
    "event": (r"$\langle t_R\rangle$ (as in A)", AS_IT_IS, "o"),
    "t_R-double": (r"$2\,\langle t_R\rangle$", CHANGED, "^"),
}
SLOW_BELOW = (20, 8, 10, 30, 40)  # c_s over these


def draw_speeds(axes, fronts):
    draw_front_speeds(axes, fronts, LOOKS)
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
    draw_ahead(axes[0], fronts["event"], t_zero, color="white")
    draw_speeds(axes[1], fronts)
    letter(axes[0], "A")
    save(fig, stem)


def make(results):
    of_runs = dict(zip(LOOKS, (event().front, event().front_double)))
    draw(event().record, of_runs, results / "figS6A")
    write_fronts(results / "front-speed.csv", of_runs)
    spanning = (one for one in shown_events(LAW)[PRIMARY] if one["spanning"])
    in_order = {"fast-slow-fast in words": lambda event: "yes" if event["fast_slow_fast"] else "no"}
    write_events(results / "events.csv", spanning, in_order)
    of = map_of_types()
    write_map(of.fronts, of.on_grid(), results, panel="B", slow_below=SLOW_BELOW)
