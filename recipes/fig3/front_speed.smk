# Figure 3 D: speed of slow fronts against slow-slip speed. The sweeps are front_speed.ini,
# front_speed_phi.ini, front_speed_widths.ini.
FIG3_PARTS += [f"{DATA}/fig3/claims-D.json"]


rule fig3_front_speed:
    input:
        points=f"{DATA}/fig3/front_speed.csv",
        phi=f"{DATA}/fig3/front_speed_phi.csv",
        widths=of_ensemble([f"{DATA}/fig3/front_speed_widths.csv"]),
        other_seeds=of_ensemble(
            tables_of_seeds("fig3/front_speed") + tables_of_seeds("fig3/front_speed_widths")
        ),
        l_0=f"{DATA}/fig3/l0-seed-1.json",
        shared=["recipes/fig3/slow_fronts.py", "recipes/fig3/decay_length.py"],
        **script("recipes/fig3/front_speed.py"),
    output:
        claims=f"{DATA}/fig3/claims-D.json",
        **picture(f"{RESULTS}/fig3/fig3D"),
        table=f"{RESULTS}/fig3/front-speed.csv",
    log: f"{LOGS}/fig3-front-speed.log"
    message: "fig3: draw D, compare the collapse of the front speeds"
    shell:
        "{PYTHON} {input.script} {input.points} {input.phi} {input.l_0} {RESULTS}/fig3"
        " {output.claims} {input.widths} {input.other_seeds} 2> {log}"
