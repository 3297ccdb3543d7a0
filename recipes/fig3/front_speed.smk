# Figure 3 D: speed of slow fronts against slow-slip speed. The sweeps are front_speed.ini,
# front_speed_phi.ini.
FIG3_PARTS += [f"{DATA}/fig3/claims-D.json"]


rule fig3_front_speed:
    input:
        points=f"{DATA}/fig3/front_speed.csv",
        phi=f"{DATA}/fig3/front_speed_phi.csv",
        **script("recipes/fig3/front_speed.py"),
    output:
        claims=f"{DATA}/fig3/claims-D.json",
        **picture(f"{RESULTS}/fig3/fig3D"),
        table=f"{RESULTS}/fig3/front-speed.csv",
    log: f"{LOGS}/fig3-front-speed.log"
    message: "fig3: draw D, compare the collapse of the front speeds"
    shell:
        "{PYTHON} {input.script} {input.points} {input.phi} {RESULTS}/fig3 {output.claims}"
        " 2> {log}"
