"""Figure 3 C, inset, and its data."""

from rupture.figures import BLUE, EVENT, OF_PAPER, SINGLE, figure, save

import paper
from claims.spread import spread
from fig3.slow_slip import MM, estimate_and_measured, fits_of, of_event
from measure.ways import PRIMARY
from measure.tables import numbers, write_columns

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


def draw(prepared, event, slope, stem):
    fig, axes = figure(SINGLE, SINGLE)
    for variant, (marker, label) in VARIED.items():
        rows = [row for row in prepared if row["varies"] == variant]
        draw_rows(axes, rows, marker, BLUE, f"prepared, {label}")
    draw_rows(axes, event, "^", EVENT["II"], r"event II, $\langle t_R\rangle$ varied")
    end = 1.08 * max(estimate_and_measured(prepared + event)[0])
    label = f"prepared: slope {slope:.2f}"
    axes.plot([0, end], [0, slope * end], color=BLUE, linewidth=0.8, label=label)
    axes.plot([0, end], [0, end], label="paper: Eq. S1", **OF_PAPER)
    estimate = rf"{paper.COEFFICIENT}\,\tau_\mathrm{{slip}}/(k_i\langle t_R\rangle)"
    axes.set(xlabel=rf"estimate ${estimate}$ [mm/s]", xlim=(0, end), ylim=(0, None))
    axes.set_ylabel(r"measured $v_\mathrm{slow\,slip}$ [mm/s]")
    axes.legend(loc="upper left")
    save(fig, stem)


def make(results):
    found = fits_of(SHOWN)
    slope = found.fits[PRIMARY].slope
    draw(found.varied, of_event(), slope, results / "fig3C-inset")
    rows = [{"interface": "prepared"} | row for row in found.rows[PRIMARY]]
    rows += [{"interface": "event"} | row for row in of_event()]
    names = ["interface", "variant", "blocks", "front speed [m/s]", "estimate [m/s]"]
    names += ["slow slip [m/s]", "slowest [m/s]", "fastest [m/s]", "type", "point"]
    write_columns(results / "slow-slip-speed.csv", names, rows)
    estimate, measured = estimate_and_measured(found.varied)
    ratio = "speed of slow slip over Eq. S1"
    return [spread(ratio, 1.0, measured / estimate, "{} prepared fronts", shown=slope)]
