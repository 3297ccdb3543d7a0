"""Figure 3 C, inset, its data and the claims 3C-inset and 3C-neighbours."""

from claims import paper
from claims.judge import holds, judged
from claims.spread import spread
from measure.tables import numbers, rows_of, write_columns
from measure.conventions import PRIMARY
from report.plotting import BLUE, EVENT, OF_PAPER, SINGLE, figure, save
import slow_fronts as slow

MM = 1e3  # [mm/m]
WIDTH = 0.14 / 56  # of a block [m]
K_I = {  # the variant in which k_i varies, by convention; primary: as the SI says
    PRIMARY: "k_i",
    "trigger's prestress unchanged": "k_i alone",
    "K scaled with E": "k_i and K",
}
VARIED = {  # marker and label
    "reference": ("o", "reference"),
    "t_R": ("^", r"$\langle t_R\rangle$ varied"),
    "tau_slip": ("s", r"$\tau_\mathrm{slip}$ varied"),
    "k_i": ("<", "$k_i$ varied"),
}


def varied(rows, k_i=K_I[PRIMARY]):
    """What the claim is about, k_i varied in one way; the quantity that varies is `varies`."""
    names = {name: name for name in ("reference", "t_R", "tau_slip")} | {k_i: "k_i"}
    return [row | {"varies": names[row["variant"]]} for row in rows if row["variant"] in names]


def estimate_and_measured(rows):
    return numbers(rows, "estimate [m/s]") * MM, numbers(rows, "slow slip [m/s]") * MM


def fit(rows):
    return slow.fit_through_origin(*estimate_and_measured(rows))


def case_of(rows):
    """Where each quantity could be varied: at two values or more, beside the reference."""
    counts = [sum(row["varies"] == name for row in rows) for name in ("t_R", "tau_slip", "k_i")]
    found = fit(rows) if min(counts) >= 2 else None
    return {"slope": found and found.slope, "R^2": found and found.r_squared}


def conventions(points):
    rows, primary = slow.fronts(points), K_I[PRIMARY]
    cases = {name: case_of(varied(rows, k_i)) for name, k_i in K_I.items()}
    for window in slow.OTHER_WINDOWS:
        cases[window] = case_of(varied(slow.fronts(points, window), primary))
    cases[slow.WITHOUT_NEAR_ARREST] = case_of(slow.without_near_arrest(varied(rows, primary)))
    return {name: [case] for name, case in cases.items()}


def largest_ratio(row):
    """The faster over the slower of two neighbours behind a front; None if there are none, or one
    does not slip forwards."""
    blocks = [round(x / WIDTH) for x in row["per_block"]["x"]]
    speed = row["per_block"]["speed"]
    pairs = zip(blocks, blocks[1:], speed, speed[1:])
    if min(speed) <= 0:
        return None
    ratios = (max(v, w) / min(v, w) for one, next_one, v, w in pairs if next_one == one + 1)
    return max(ratios, default=None)


def case_of_neighbours(rows):
    ratios = [largest_ratio(row) for row in rows if row["variant"] == "reference"]
    return {"largest ratio of neighbours": ratios[0] if ratios else None}


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


def of_event(points):
    """Event II with other slipping times. Its front's speed is that of the slow stretch."""
    rows = [
        slow.in_window(row, result, PRIMARY)
        | {"front speed [m/s]": (result["slow_slip"]["slow"] or {}).get("speed")}
        for row, result in rows_of(points)
    ]
    return slow.usable(rows)


def claim(prepared, event, points):
    """`event`: fronts of event II; they are reported."""
    case, speeds = case_of(prepared), slow.speeds(prepared)
    return judged(
        "3C-inset",
        shown=case,
        units=slow.of_seeds(conventions, points),
        measured={
            **case,
            "prepared interfaces": len(prepared),
            "slowest and fastest front [m/s]": [speeds.min(), speeds.max()],
            "slope, event II": fit(event).slope if event else None,
        },
        note=f"{slow.WHERE} Event: blocks at x = 0.2-0.5 L, until the front is no longer"
        " slow. A change of tau_slip alone is nearly a change of units (p and k_i do not depend on"
        " it).",
    )


def neighbours(points):
    return {PRIMARY: [case_of_neighbours(slow.fronts(points))]}


def claim_neighbours(rows, points):
    shown = case_of_neighbours(rows)
    cases = [{"largest ratio of neighbours": largest_ratio(row)} for row in rows]
    return judged(
        "3C-neighbours",
        shown=shown,
        units=slow.of_seeds(neighbours, points),
        measured={
            **shown,
            "fronts of all variants": len(rows),
            "of these it holds for": sum(holds("3C-neighbours", [each]) for each in cases),
        },
        note="Judged by the front with the reference parameters; fronts of all variants are"
        " listed, too. Speeds as for 3C-inset: a block's time begins H/c_s after its rupture.",
    )


def make(chains, results):
    points, event = chains["slow_slip"], of_event(chains["slow_slip_event"])
    prepared = slow.fronts(slow.of_seed(points))
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
    return [claim(of_SI, event, points), claim_neighbours(prepared, points), number]
