"""Figure 3: A-C and their data here, the rest in the modules beside this one."""

import decay_length_figure
import front_speed_figure
import no_slip_force
import numpy as np
import rupture
import slow_slip_figure

from claims import paper
from claims.claim import Number
from measure.tables import values, write_table
from rupture.figures import AS_IT_IS, BLUE, CHANGED, DOUBLE, OF_PAPER, SKY, figure, letter, save
from rupture.plotting import draw_pinned, draw_pinned_scale

EVENTS = {"second-slow": "event II", "fast-slow-fast": "event I"}  # the paper shows the first
OF_REF_20 = f"The experiment of the paper's ref. 20: about {paper.FAST_SLIP_SPEED * 1e3:.0f} mm/s."
SINCE = "time since the change [ms]"
RUNS = {"t_R-half": "half", "stopped": "stopped", "t_R-double": "double"}  # of a point
SLIPS = {  # run: label, colour, line style
    "t_R-half": (r"$\langle t_R\rangle/2$", CHANGED, "--"),
    "stopped": (r"$\langle t_R\rangle$ (as in A)", AS_IT_IS, "-"),
    "t_R-double": (r"$2\,\langle t_R\rangle$", SKY, "-."),
}


def draw_maps(fig, axes, event, t_zero, window):
    for axis, run, title in zip(axes, ("stopped", "no-slow-slip"), ("$V = 0$", "no slow slip")):
        record = rupture.open(event.file(f"{run}-record.h5"))
        image = draw_pinned(axis, record, t_zero, window)
        axis.set(title=title, ylabel=SINCE)
    draw_pinned_scale(fig, image, axes)


def draw_slip(axes, slips, t_zero):
    for run, (label, colour, style) in SLIPS.items():
        slip = slips[run]
        shown = np.array(slip["time"]) <= slip["slow_end"]
        time = (np.array(slip["time"])[shown] - t_zero) * 1e3
        u = np.array(slip["slip"])[shown] * 1e6
        axes.plot(time, u, style, color=colour, label=label)
        axes.plot(time[-1], u[-1], "o", color=colour)
        fitted = np.array([slip["slow_from"], slip["slow_to"]])
        start = np.interp(slip["slow_from"], slip["time"], slip["slip"])
        line = start + slip["slow_speed"] * (fitted - fitted[0])
        axes.plot((fitted - t_zero) * 1e3, line * 1e6, color=BLUE, linewidth=0.8, zorder=3)
    axes.plot([], [], color=BLUE, linewidth=0.8, label="slow slip, fitted")
    highest = max(slip["fast_slip"] + slip["slow_slip"] for slip in slips.values())
    fastest = [0, highest / paper.FAST_SLIP_SPEED * 1e3]
    label = f"{paper.FAST_SLIP_SPEED * 1e3:.0f} mm/s: experiment\n(paper's ref. 20)"
    axes.plot(fastest, [0, highest * 1e6], label=label, **OF_PAPER)
    axes.set(xlabel=SINCE, ylabel=r"slip at $x = 0.34\,L$ [µm]")


def slips_of(event, report="slip"):
    """The slip of a block in each run; `own_slip` takes the block 0.06 L before the event's own
    transition."""
    return {run: event[f"{report}_{name}"] for run, name in RUNS.items()}


def peak_speed(slip):
    """Between steps [m/s]."""
    return float(np.max(np.diff(slip["slip"]) / np.diff(slip["time"])))


def draw(events, stem):
    """Event I above, event II, which the paper shows, below; the times of all maps are the same."""
    wide = {"width_ratios": (1, 1, 1.25)}
    fig, axes = figure(DOUBLE, 0.7 * DOUBLE, nrows=len(events), ncols=3, **wide)
    t_zero = {name: event["slip_stopped"]["time"][0] for name, event in events.items()}
    arrivals = {n: np.nanmax(values(e["front_stopped"]["t_rupture"])) for n, e in events.items()}
    window = (0, max(arrivals[name] - t_zero[name] for name in events) * 1e3 + 0.5)
    for row, (name, event) in zip(axes, reversed(events.items())):
        draw_maps(fig, row[:2], event, t_zero[name], window)
        draw_slip(row[2], slips_of(event), t_zero[name])
        for axis in row:
            axis.set_title(", ".join(filter(None, (name, axis.get_title()))))
    axes[0, 2].legend(loc="lower right", handlelength=1.5)
    for row, number in zip(axes, ("", "2")):
        for axis, text in zip(row, "ABC"):
            letter(axis, text + number)
    save(fig, stem)


def rows(events):
    for name, event in events.items():
        for run, slip in slips_of(event).items():
            for row in zip(slip["time"], slip["slip"]):
                yield [name, run, *row]


def numbers_of(events, peaks):
    """`peaks`: of the slip speed [m/s]."""
    of_slip = {name: event["slip_stopped"] for name, event in events.items()}
    return [
        *(
            Number(
                f"peak slip speed as the front passes, {name} [mm/s]",
                None,
                peak * 1e3,
                note=OF_REF_20,
            )
            for name, peak in peaks.items()
        ),
        *(
            Number(f"{name}: {quantity}", None, value)
            for name, slip in of_slip.items()
            for quantity, value in (
                ("peak/slow slip speed", peaks[name] / slip["slow_speed"]),
                ("fast/slow slip distance", slip["fast_slip"] / slip["slow_slip"]),
            )
        ),
    ]


def by_title(points):
    found = {point["name"]: point for point in points}
    return {title: found[name] for name, title in EVENTS.items()}


def make(chains, results):
    events = by_title(chains["continued"])
    draw(events, results / "fig3")
    write_table(results / "slip.csv", ["event", "run", "time [s]", "slip [m]"], rows(events))
    peaks = {n: peak_speed(e["fast_slip"]) for n, e in by_title(chains["every_step"]).items()}
    numbers = numbers_of(events, peaks)
    no_slip_force.make(chains, results)
    for part in (decay_length_figure, front_speed_figure, slow_slip_figure):
        numbers += part.make(chains, results)
    return numbers
