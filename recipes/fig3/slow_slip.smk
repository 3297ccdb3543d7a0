# Figure 3 C, inset: slow-slip speed against Eq. S1. The sweeps are slow_slip.ini, slow_slip_event.ini.
FIG3_PARTS += [f"{DATA}/fig3/claims-Ci.json"]


rule fig3_slow_slip:
    input:
        prepared=f"{DATA}/fig3/slow_slip.csv",
        event=f"{DATA}/fig3/slow_slip_event.csv",
        other_seeds=of_ensemble(tables_of_seeds("fig3/slow_slip")),
        shared="recipes/fig3/slow_fronts.py",
        **script("recipes/fig3/slow_slip.py"),
    output:
        claims=f"{DATA}/fig3/claims-Ci.json",
        **picture(f"{RESULTS}/fig3/fig3C-inset"),
        table=f"{RESULTS}/fig3/slow-slip-speed.csv",
    log: f"{LOGS}/fig3-slow-slip.log"
    message: "fig3: draw the inset of C, compare the slow slip with Eq. S1"
    shell:
        "{PYTHON} {input.script} {input.prepared} {input.event} {RESULTS}/fig3 {output.claims}"
        " {input.other_seeds} 2> {log}"
