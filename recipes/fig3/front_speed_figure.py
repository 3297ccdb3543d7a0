"""Figure 3 D and its data."""

from rupture.figures import AS_IT_IS, CHANGED, SINGLE, lettered, save

from claims.spread import spread
from fig3 import slow_fronts as slow
from fig3.front_speed import chosen, fit, fits_of, scaled_slip, slip, usable_fronts
from measure.ways import PRIMARY
from measure.tables import write_columns

SHOWN = 1  # seed
MODELS = {  # label and colour
    "simplified": ("simplified", CHANGED),
    "full": ("reference", AS_IT_IS),
}
VARIED = {  # marker and label
    "v_slow and tau_0": ("D", r"$v_\mathrm{slow}$, $\tau_0$"),
    "t_R and tau_0": ("o", r"$\langle t_R\rangle$, $\tau_0$"),
    "t_R": ("^", r"$\langle t_R\rangle$"),
    "f_slip": ("s", r"$f_\mathrm{slip}$"),
    "k_i": ("<", "$k_i$"),
    "F_N": ("v", "$F_N$"),
}


def draw_points(axes, rows, x, label):
    for model, (law, colour) in MODELS.items():
        for variant, (marker, name) in VARIED.items():
            points = chosen(rows, model, [variant])
            if points:
                text = f"{law}: {name}" if label else None
                style = {"color": colour, "markerfacecolor": "none", "markeredgewidth": 0.7}
                axes.plot(
                    x(points), slow.speeds(points), marker, label=text, markersize=3.5, **style
                )


def draw(rows, fits, stem):
    fig, panels = lettered("D", 1.5 * SINGLE, 1.1 * SINGLE)
    axes = panels["D"]
    draw_points(axes, rows, scaled_slip, label=True)
    end = 1.08 * max(scaled_slip(rows))
    for model, (law, colour) in MODELS.items():
        slope = fits[model].slope
        look = {"color": colour, "linewidth": 0.8, "label": f"{law}: slope {slope:.2f}"}
        axes.plot([0, end], [0, slope * end], **look)
    axes.set_xlabel(r"$v_\mathrm{slow\,slip}\,k_i l_0/(\tau_\mathrm{thres}-\tau_0)$ [m/s]")
    axes.set(ylabel=r"$v_{c,\mathrm{slow}}$ [m/s]", xlim=(0, end), ylim=(0, None))
    by_law = sorted(zip(*axes.get_legend_handles_labels()), key=lambda of: of[1][0], reverse=True)
    look = {"columnspacing": 0.8, "handletextpad": 0.4, "handlelength": 1.2}
    axes.legend(*zip(*by_law), loc="upper left", ncols=2, **look)
    inset = axes.inset_axes([0.68, 0.13, 0.3, 0.3])
    draw_points(inset, rows, lambda points: slip(points) * 1e3, label=False)
    inset.set(xlim=(0, None), ylim=(0, None))
    inset.set_title("unscaled", fontsize=7, pad=2)
    inset.set_ylabel(r"$v_{c,\mathrm{slow}}$ [m/s]", fontsize=6.5, labelpad=1)
    inset.tick_params(labelsize=6)
    inset.set_xlabel(r"$v_\mathrm{slow\,slip}$ [mm/s]", fontsize=6.5, labelpad=1)
    save(fig, stem)


def make(results):
    rows = usable_fronts(SHOWN)[PRIMARY]
    draw(rows, fits_of(rows), results / "fig3D")
    scaled = [row | {"scaled slow slip [m/s]": x} for row, x in zip(rows, scaled_slip(rows))]
    names = ["variant", "tau-bar", "sigma-bar", "junctions.t_R", "junctions.mu_d", "slider.E"]
    names += ["slider.F_N", "junctions.v_slow", "type", "blocks", "slow slip [m/s]"]
    names += ["scaled slow slip [m/s]", "front speed [m/s]", "point"]
    write_columns(results / "front-speed.csv", names, scaled)
    full = chosen(rows, "full")
    factor = spread(
        "factor of Figure 3 D",
        None,
        slow.speeds(full) / scaled_slip(full),
        "{} prepared fronts, reference law",
        shown=fit(full).slope,
    )
    return [factor]
