"""Figure S1 and its data."""

from rupture.figures import BLACK, BLUE, DOUBLE, VERMILION, lettered, save

from figS1.commands import Stress, states
from measure.tables import write_table


def draw_stress(axes, stress):
    x = stress.x / stress.L
    axes.plot(x, stress.p, color=BLUE, marker="o", label="$p$")
    axes.plot(x, stress.tau, color=VERMILION, marker="^", label=r"$\tau$")
    axes.axhline(0, color=BLACK, linewidth=0.6)
    axes.set(xlabel="$x/L$", xlim=(-0.01, 1.01))


def draw(unloaded, before, stem):
    fig, panels = lettered("AB", DOUBLE, 0.38 * DOUBLE, sharey=True)
    draw_stress(panels["A"], unloaded)
    draw_stress(panels["B"], before)
    panels["A"].set(title="$F_T = 0$", ylabel="force on a block [N]")
    panels["B"].set_title(f"0.5 ms before event I, $F_T$ = {before.F_T:.0f} N")
    panels["A"].legend(loc="center")
    save(fig, stem)


def make(results):
    unloaded, before = Stress(states().unloaded), Stress(states().before)
    draw(unloaded, before, results / "figS1")
    names = ["p [N]", "tau [N]"]
    write_table(
        results / "stress.csv",
        ["x [m]", *(f"{state} {n}" for state in ("unloaded", "before event") for n in names)],
        zip(unloaded.x, unloaded.p, unloaded.tau, before.p, before.tau),
    )
