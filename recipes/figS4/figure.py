"""Figure S4, its data and its claim."""

import numpy as np
import rupture
from scipy import stats

from claims.judge import judged
from measure.tables import write_table
from measure.event_claims import largest_change_of_mean
from report.panels import draw_pinned, draw_pinned_scale, window_of
from report.plotting import DOUBLE, VERMILION, figure, letter, save

TITLES = ("event II, unchanged", r"event II, wider $\varphi$ beyond $0.25\,L$")
REGION = 0.25  # phi was changed from here on, this block included [L]
BINS = 30
MN = 1e3  # [mN/N]


class Junctions:
    """Of a checkpoint, and of what `analyze phi --json` says of it: [blocks][junctions]: force [N],
    slipping; per block: f_thres [N], x / L."""

    def __init__(self, checkpoint, phi):
        self.f_thres = np.array(phi["f_thres"])
        state = rupture.open(checkpoint)
        k_ij = np.sqrt(state["junctions.kappa"] * self.f_thres / state["junctions.mu_s"])
        stretch = state["u_x"][0][:, None] - state["junctions/attachment"]
        self.slipping = state["junctions/slipping"] == 1
        self.x_over_L = np.array(phi["x"]) / state["slider.L"]
        self.force = k_ij[:, None] * stretch
        np.testing.assert_allclose(self.force.mean(axis=1), phi["mean"], rtol=1e-9)

    def pinned(self, block):
        """Forces in the pinned junctions of one block, ascending [N]."""
        return np.sort(self.force[block][~self.slipping[block]])


def beside_widest_uniform(junctions, block):
    """The forces in a block's pinned junctions and the widest uniform phi with their mean: p of the
    Kolmogorov-Smirnov test, and the largest distance of a force from its exact quantile
    (j + 1/2)/n, over f_thres."""
    forces, f_thres = junctions.pinned(block), junctions.f_thres[block]
    mean = forces.mean()
    half_width = f_thres - abs(mean)
    uniform = stats.uniform(mean - half_width, 2 * half_width)
    quantiles = (2 * np.arange(len(forces)) + 1) / len(forces) - 1
    distance = np.max(np.abs(forces - mean - half_width * quantiles)) / f_thres
    return stats.kstest(forces, uniform.cdf).pvalue, distance


def draw_phi(axes, junctions, edges):
    """Histogram of the pinned junctions' forces per block. Returns the image."""
    blocks = range(len(junctions.f_thres))
    counts = np.array([np.histogram(junctions.pinned(block), edges)[0] for block in blocks]).T
    places, shares = (block_edges(junctions), edges * MN), counts / counts.sum(axis=0)
    look = {"cmap": "cividis", "vmin": 0, "vmax": 0.2, "rasterized": True}
    image = axes.pcolormesh(*places, shares, **look)
    axes.stairs(junctions.f_thres * MN, block_edges(junctions), baseline=None, color="white")
    axes.axhline(0, color="white", linewidth=0.9)
    axes.set(ylim=(edges[0] * MN, edges[-1] * MN))
    return image


def block_edges(junctions):
    x = junctions.x_over_L
    half = (x[1] - x[0]) / 2
    return np.append(x - half, x[-1] + half)


def draw(records, junctions, fronts, stem):
    shared = {"sharex": True, "sharey": "row", "height_ratios": (5, 5, 1)}
    fig, axes = figure(0.75 * DOUBLE, 0.66 * DOUBLE, nrows=3, ncols=2, **shared)
    t_zero, window = window_of(*fronts)
    lowest, highest = min(j.force.min() for j in junctions), max(j.f_thres.max() for j in junctions)
    bins = np.linspace(lowest, highest, BINS + 1)  # edges, the same for both states [N]
    for column, (path, title) in enumerate(zip(records, TITLES)):
        record = rupture.open(path)
        pinned = draw_pinned(axes[0, column], record, t_zero, window)
        shares = draw_phi(axes[1, column], junctions[column], bins)
        slipping, edges = junctions[column].slipping.mean(axis=1), block_edges(junctions[column])
        axes[2, column].stairs(slipping, edges, color=VERMILION, fill=True)
        axes[2, column].set(xlabel="$x/L$", xlim=(0, 1), ylim=(0, 1))
        axes[0, column].set(title=title, xlabel="")
        letter(axes[0, column], "AB"[column])
    axes[0, 1].set_ylabel("")
    axes[1, 0].set_ylabel("force in a junction [mN]")
    axes[2, 0].set_ylabel("share\nslipping")
    draw_pinned_scale(fig, pinned, axes[0])
    label = "share of the pinned junctions\n" + r"(white: $f_\mathrm{thres}$, and no force)"
    fig.colorbar(shares, ax=axes[1], label=label, aspect=30, extend="max")
    save(fig, stem)


def write_phi(path, junctions, phis):
    names = ["mean before [N]", "mean after [N]", "sigma before [N]", "sigma after [N]"]
    columns = [phi[key] for key in ("mean", "sigma") for phi in phis]
    rows = zip(phis[0]["x"], junctions[0].f_thres, phis[0]["slipping"], *columns)
    write_table(path, ["x [m]", "f_thres [N]", "slipping", *names], rows)


def claim_S4(wider, phis):
    changed = np.flatnonzero(wider.x_over_L > REGION - 1e-9)
    p, distances = zip(*(beside_widest_uniform(wider, block) for block in changed))
    case = {
        "largest relative change of a block's mean": largest_change_of_mean(*phis),
        "smallest Kolmogorov-Smirnov p": min(p),
    }
    return judged(
        "S4",
        shown=case,
        measured={
            **case,
            "changed blocks": len(changed),
            "largest distance from exact quantiles [f_thres]": max(distances),
        },
        note="Means over all junctions of a block; the slipping ones keep their force, the others"
        " get the quantiles of the widest uniform distribution that f_thres allows.",
    )


def make(chains, results):
    [event], [wider] = chains["fig2/event"], chains["fig4/wider"]
    phis, fronts = [event["phi"], wider["phi_wider"]], [event["front"], wider["front_wider"]]
    states = event.base, wider.file("wider-start.h5")
    records = event.file("record.h5"), wider.file("wider-record.h5")
    junctions = [Junctions(state, phi) for state, phi in zip(states, phis)]
    draw(records, junctions, fronts, results / "figS4")
    write_phi(results / "phi.csv", junctions, phis)
    return [claim_S4(junctions[1], phis)]
