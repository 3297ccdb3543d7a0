"""Figure 3 C, inset, its data and the claims 3Ci and co."""

from functools import partial

import numpy as np

from claims import paper
from claims.judge import holds, judged
from data.tables import numbers, read_rows, write_columns
from events.conventions import PRIMARY
from pictures.plotting import BLUE, EVENT, OF_PAPER, SINGLE, figure, save
import slow_fronts as slow

MM = 1e3  # [mm/m]
WIDTH = 0.14 / 56  # of a block [m]
K_I = {  # the variant in which k_i varies, by convention
    PRIMARY: "k_i alone",
    "trigger's prestress varied with k_i": "k_i",
    "K scaled with E": "k_i and K",
}
K_I_OF_SI = {
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


def case_3Ci(rows):
    """Where each quantity could be varied: at two values or more, beside the reference."""
    counts = [sum(row["varies"] == name for row in rows) for name in ("t_R", "tau_slip", "k_i")]
    found = fit(rows) if min(counts) >= 2 else None
    return {"slope": found and found.slope, "R^2": found and found.r_squared}


def conventions_3Ci(path, protocols=K_I):
    rows, primary = slow.fronts(path), protocols[PRIMARY]
    cases = {name: case_3Ci(varied(rows, k_i)) for name, k_i in protocols.items()}
    for window in slow.OTHER_WINDOWS:
        cases[window] = case_3Ci(varied(slow.fronts(path, window), primary))
    cases[slow.WITHOUT_NEAR_ARREST] = case_3Ci(slow.without_near_arrest(varied(rows, primary)))
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


def case_co(rows):
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


def beside_text(rows, variant):
    """Measured over estimate in a variant that is reported beside the claim, by front speed."""
    rows = [row for row in rows if row["variant"] == variant]
    x, y = estimate_and_measured(rows)
    return ", ".join(f"{r:.2f} at {v:.1f} m/s" for v, r in sorted(zip(slow.speeds(rows), y / x)))


def claim_3Ciw(path, others):
    """With the protocol of the SI."""
    case = case_3Ci(varied(slow.fronts(path), K_I_OF_SI[PRIMARY]))
    conventions = partial(conventions_3Ci, protocols=K_I_OF_SI)
    return judged("3Ciw", case, case, slow.of_seeds([path, *others], conventions, ["slow_slip"]))


def claim_3Ci(path, event, others):
    rows = slow.fronts(path)
    prepared = varied(rows)
    fitted, speeds = fit(prepared), slow.speeds(prepared)
    longer = fit(varied(slow.fronts(path, slow.FOR_TWO_T_R)))
    x, y = estimate_and_measured(event)
    case = case_3Ci(prepared)
    units = slow.of_seeds([path, *others], conventions_3Ci, ["slow_slip"])
    return judged(
        "3Ci",
        shown=case,
        units=units,
        measured={
            **case,
            "prepared interfaces": fitted.points,
            f"slow fronts left out, with fewer than {slow.BLOCKS} blocks": slow.too_short(path),
            "slowest and fastest front [m/s]": [speeds.min(), speeds.max()],
            "slope if followed for up to 2 <t_R>": longer.slope,
            "event, slope": fit(event).slope if event else None,
            "event, measured/estimate": [np.min(y / x), np.max(y / x)] if event else None,
        },
        note=f"{slow.WHERE} Event: blocks at x = 0.2-0.5 L, until the front is no longer"
        " slow. A change of tau_slip alone is nearly a change of units (p and k_i do not depend on"
        " it). Where k_i varies, the trigger region's prestress does not change. Measured/estimate"
        f" there: {beside_text(rows, K_I[PRIMARY])}; with a prestress that compensates for the"
        f" driving spring: {beside_text(rows, 'k_i')}; with a driving spring stiffened like"
        f" the slider instead: {beside_text(rows, 'k_i and K')}. At other prestresses of the"
        f" interface: {beside_text(rows, 'prestress')}.",
    )


def claim_co(path, others):
    rows = slow.fronts(path)
    shown = case_co(rows)
    cases = [{"largest ratio of neighbours": largest_ratio(row)} for row in rows]
    return judged(
        "co",
        shown=shown,
        units=slow.of_seeds(
            [path, *others], lambda of: {PRIMARY: [case_co(slow.fronts(of))]}, ["slow_slip"]
        ),
        measured={
            **shown,
            "fronts of all variants": len(rows),
            "of these it holds for": sum(holds("co", [each]) for each in cases),
        },
        note="Judged by the front with the reference parameters; fronts of all variants are"
        " listed, too. Speeds as for 3Ci: a block's time begins H/c_s after its rupture.",
    )


def make(data, results):
    path, *others = slow.tables_of(data, "slow_slip")
    prepared, of_event = slow.fronts(path), read_rows(data / "slow_slip_event.csv")
    event = slow.usable([row | {"blocks": int(row["blocks"] or 0)} for row in of_event])
    of_SI = varied(prepared, K_I_OF_SI[PRIMARY])
    draw(of_SI, event, fit(of_SI), results / "fig3C-inset")
    rows = [{"interface": "prepared"} | row for row in prepared]
    rows += [{"interface": "event"} | row for row in event]
    names = ["interface", "variant", "blocks", "front speed [m/s]", "estimate [m/s]"]
    names += ["slow slip [m/s]", "slowest [m/s]", "fastest [m/s]", "type", "point"]
    write_columns(results / "slow-slip-speed.csv", names, rows)
    return [claim_3Ciw(path, others), claim_3Ci(path, event, others), claim_co(path, others)]
