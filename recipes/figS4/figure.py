"""Figure S4 and its data."""

import numpy as np
import rupture
from rupture.figures import DOUBLE, VERMILION, figure, letter, save, window_of
from rupture.plotting import draw_pinned, draw_pinned_scale

from figS4.commands import shown
from figS4.junctions import Junctions
from measure.ways import PRIMARY
from measure.tables import write_table

TITLES = ("event II, unchanged", r"event II, wider $\varphi$ beyond $0.25\,L$")
BINS = 30
MN = 1e3  # [mN/N]


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


def make(results):
    of = shown()
    phis, fronts = [of.phi, of.phi_wider], [of.front, of.wider[PRIMARY]]
    junctions = [Junctions(state, phi) for state, phi in zip((of.start, of.wider_start), phis)]
    draw([of.record, of.wider_record], junctions, fronts, results / "figS4")
    write_phi(results / "phi.csv", junctions, phis)
