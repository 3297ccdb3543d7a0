"""Figure 3 C, inset, and its data."""

import slow_fronts as slow
from claims import paper
from claims.spread import spread
from measure.tables import numbers, write_columns
from slow_slip import MM, estimate_and_measured, fit, of_event, varied
from rupture.figures import BLUE, EVENT, OF_PAPER, SINGLE, figure, save

SHOWN = 1  # seed
VARIED = {  # marker and label
    "reference": ("o", "reference"),
    "t_R": ("^", r"$\langle t_R\rangle$ varied"),
    "tau_slip": ("s", r"$\tau_\mathrm{slip}$ varied"),
    "k_i": ("<", "$k_i$ varied"),
}


def draw_rows(axes, rows, marker, colour, label):
    x, y = estimate_and_measured(rows)
    low = y - numbers(rows, "slowest [m/s]") * MM
    high = numbers(rows, "fastest [m/s]") * MM - y
    look = {"fmt": marker, "color": colour, "markersize": 4, "elinewidth": 0.6, "capsize": 1.5}
    axes.errorbar(x, y, yerr=[low, high], label=label, **look)


def draw(prepared, event, prepared_fit, stem):
    fig, axes = figure(SINGLE, SINGLE)
    for variant, (marker, label) in VARIED.items():
        rows = [row for row in prepared if row["varies"] == variant]
        draw_rows(axes, rows, marker, BLUE, f"prepared, {label}")
    draw_rows(axes, event, "^", EVENT["II"], r"event II, $\langle t_R\rangle$ varied")
    end = 1.08 * max(estimate_and_measured(prepared + event)[0])
    slope = prepared_fit.slope
    label = f"prepared: slope {slope:.2f}"
    axes.plot([0, end], [0, slope * end], color=BLUE, linewidth=0.8, label=label)
    axes.plot([0, end], [0, end], label="paper: Eq. S1", **OF_PAPER)
    estimate = rf"{paper.COEFFICIENT}\,\tau_\mathrm{{slip}}/(k_i\langle t_R\rangle)"
    axes.set(xlabel=rf"estimate ${estimate}$ [mm/s]", xlim=(0, end), ylim=(0, None))
    axes.set_ylabel(r"measured $v_\mathrm{slow\,slip}$ [mm/s]")
    axes.legend(loc="upper left")
    save(fig, stem)


def make(chains, results):
    points = [point for point in chains["slow_slip"] if point["numerics.seed"] == SHOWN]
    event = of_event(chains["slow_slip_event"])
    prepared = slow.fronts(points)
    of_SI = varied(prepared)
    draw(of_SI, event, fit(of_SI), results / "fig3C-inset")
    rows = [{"interface": "prepared"} | row for row in prepared]
    rows += [{"interface": "event"} | row for row in event]
    names = ["interface", "variant", "blocks", "front speed [m/s]", "estimate [m/s]"]
    names += ["slow slip [m/s]", "slowest [m/s]", "fastest [m/s]", "type", "point"]
    write_columns(results / "slow-slip-speed.csv", names, rows)
    fitted, (estimate, measured) = fit(of_SI), estimate_and_measured(of_SI)
    ratio = "speed of slow slip over Eq. S1"
    number = spread(ratio, 1.0, measured / estimate, "{} prepared fronts", shown=fitted.slope)
    return [number]
