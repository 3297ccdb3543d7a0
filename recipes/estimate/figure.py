"""The SI's arithmetic of slow slip, and its data."""

import numpy as np
from rupture.figures import AS_IT_IS, BLACK, BLUE, CHANGED, DOUBLE, OF_PAPER, lettered, save

import paper
from claims.claim import Number
from estimate.commands import estimates, net_slip
from measure.tables import write_table


def numbers_of(reference):
    return [
        Number(
            "net slow slip, until nothing slips [f_slip/k_ij]", paper.NET_SLIP, net_slip(reference)
        ),
        Number(
            "time until all junctions are pinned again [<t_R>]",
            paper.ALL_PINNED,
            reference["duration_over_t_R"],
        ),
    ]


def draw_band(axes, relaxations, longest):
    """The range of the slip of most blocks, each with its own slipping times."""
    time = np.linspace(0, longest, 400)
    slips = []
    for course in relaxations:
        passed = np.searchsorted(course["time_over_t_R"], time, side="right")
        slips.append(np.array([0.0, *course["slip_over_f_slip_per_k_ij"]])[passed])
    low, high = np.quantile(slips, (0.05, 0.95), axis=0)
    label = f"5 to 95 % of {len(slips)} blocks"
    axes.fill_between(time, low, high, color="0.85", linewidth=0, label=label)


def draw_relaxation(axes, reference, unbreakable, relaxations):
    longest = reference["relaxation"]["time_over_t_R"][-1]
    draw_band(axes, relaxations, longest)
    for estimate, colour, line, label in (
        (reference, AS_IT_IS, "-", "as in the model"),
        (unbreakable, CHANGED, "--", "without re-breaking"),
    ):
        time = np.array([0.0, *estimate["relaxation"]["time_over_t_R"], longest])
        slip = [0.0, *estimate["relaxation"]["slip_over_f_slip_per_k_ij"], net_slip(estimate)]
        axes.step(time, slip, line, where="post", color=colour, label=label)
    axes.plot([0, 2], [0, 2 * paper.COEFFICIENT], label="paper: Eq. S1", **OF_PAPER)
    axes.axhline(paper.NET_SLIP, **OF_PAPER)
    text = f"paper: net slip {paper.NET_SLIP}"
    axes.annotate(text, (0, paper.NET_SLIP), xytext=(3, 2), textcoords="offset points")
    axes.set(xlabel=r"time $[\langle t_R\rangle]$", ylabel=r"slip $[f_\mathrm{slip}/k_{ij}]$")
    axes.set(xlim=(0, longest), ylim=(0, 10))
    axes.legend(loc="lower right")


def draw_blocks(axes, reference):
    block = reference["block"]
    x, v = np.array(block["x"]) * 1e3, np.array(block["v_slow_slip"]) * 1e3
    axes.plot(x, v, "o", color=BLUE, label="each block")
    mean = reference["v_slow_slip"] * 1e3
    axes.axhline(mean, color=BLACK, linewidth=0.8, label="at the mean normal force")
    axes.set(xlabel="$x$ [mm]", ylabel="slow slip speed by Eq. S1 [mm/s]", xlim=(-2, 142))
    axes.legend(loc="upper center")


def draw(reference, unbreakable, relaxations, stem):
    fig, panels = lettered("AB", DOUBLE, 0.38 * DOUBLE)
    draw_relaxation(panels["A"], reference, unbreakable, relaxations)
    draw_blocks(panels["B"], reference)
    save(fig, stem)


def course_rows(**estimates):
    for junctions, estimate in estimates.items():
        course = estimate["relaxation"]
        for row in zip(course["time_over_t_R"], course["slip_over_f_slip_per_k_ij"]):
            yield junctions, *row


def make(results):
    reference, unbreakable = estimates().reference, estimates().unbreakable
    draw(reference, unbreakable, estimates().relaxations, results / "estimate")
    names = ["junctions", "time [<t_R>]", "slip [f_slip/k_ij]"]
    rows = course_rows(reference=reference, unbreakable=unbreakable)
    write_table(results / "relaxation.csv", names, rows)
    block = reference["block"]
    columns = {"x [m]": "x", "p [N]": "p", "v_slow_slip [m/s]": "v_slow_slip"}
    write_table(results / "blocks.csv", columns, zip(*map(block.get, columns.values())))
    return numbers_of(reference)
