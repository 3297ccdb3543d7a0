"""Figure 3: A-C and their data here, the rest in the modules beside this one."""

import numpy as np
import rupture
from rupture.figures import AS_IT_IS, BLUE, CHANGED, DOUBLE, OF_PAPER, SKY, figure, letter, save
from rupture.plotting import draw_pinned, draw_pinned_scale
from rupture.reports import values

import paper
from claims.claim import Number
from fig3 import decay_length_figure, front_speed_figure, no_slip_force, slow_slip_figure
from fig3.commands import SHOWN, continued, every_step, fastest
from measure.ways import PRIMARY
from measure.tables import write_table

OF_REF_20 = f"The experiment of the paper's ref. 20: about {paper.FAST_SLIP_SPEED * 1e3:.0f} mm/s."
SINCE = "time since the change [ms]"
SLIPS = {  # run: label, colour, line style
    "t_R-half": (r"$\langle t_R\rangle/2$", CHANGED, "--"),
    "stopped": (r"$\langle t_R\rangle$ (as in A)", AS_IT_IS, "-"),
    "t_R-double": (r"$2\,\langle t_R\rangle$", SKY, "-."),
}


def draw_maps(fig, axes, event, t_zero, window):
    for axis, run, title in zip(axes, ("stopped", "no_slow_slip"), ("$V = 0$", "no slow slip")):
        record = rupture.open(event.records[run])
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


def slips_of(event):
    """{run: slip of the block at 0.34 L}"""
    return dict(zip(("stopped", "t_R-half", "t_R-double"), event.slips))


def draw(events, stem):
    """Event I above, event II, which the paper shows, below; the times of all maps are the same."""
    wide = {"width_ratios": (1, 1, 1.25)}
    fig, axes = figure(DOUBLE, 0.7 * DOUBLE, nrows=len(events), ncols=3, **wide)
    t_zero = {name: event.slips[0].time[0] for name, event in events.items()}
    arrivals = {n: np.nanmax(values(e.stopped[PRIMARY].t_rupture)) for n, e in events.items()}
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
        slips = slips_of(event)
        for run in SLIPS:
            for row in zip(slips[run].time, slips[run].slip):
                yield [name, run, *row]


def numbers_of(events, peaks):
    """`peaks`: of the slip speed [m/s]."""
    numbers = [
        Number(
            f"peak slip speed as the front passes, {name} [mm/s]", None, 1e3 * peak, note=OF_REF_20
        )
        for name, peak in peaks.items()
    ]
    for name, event in events.items():
        slip = event.slips[0]
        speed, distance = peaks[name] / slip.slow_speed, slip.fast_slip / slip.slow_slip
        numbers.append(Number(f"{name}: peak/slow slip speed", None, speed))
        numbers.append(Number(f"{name}: fast/slow slip distance", None, distance))
    return numbers


def make(results):
    events = {name: continued(name) for name in SHOWN}
    draw(events, results / "fig3")
    write_table(results / "slip.csv", ["event", "run", "time [s]", "slip [m]"], rows(events))
    numbers = numbers_of(
        events, {name: float(fastest(every_step(name), np.isfinite)) for name in SHOWN}
    )
    no_slip_force.make(results)
    for part in (decay_length_figure, front_speed_figure, slow_slip_figure):
        numbers += part.make(results)
    return numbers
