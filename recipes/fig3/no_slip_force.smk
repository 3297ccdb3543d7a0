# Beside Figure 3: no slow fronts without a slipping force. The sweep is no_slip_force.ini.
FIG3_PARTS += [f"{DATA}/fig3/claims-0slip.json"]


rule fig3_no_slip_force:
    input:
        shown=f"{DATA}/fig3/no_slip_force.csv",
        seeds=of_ensemble(tables_of_seeds("fig3/no_slip_force")),
        **script("recipes/fig3/no_slip_force.py"),
    output:
        claims=f"{DATA}/fig3/claims-0slip.json",
        table=f"{RESULTS}/fig3/no-slip-force.csv",
    log: f"{LOGS}/fig3-no-slip-force.log"
    message: "fig3: find the fronts without a slipping force, compare with the claim"
    shell:
        "{PYTHON} {input.script} {RESULTS}/fig3 {output.claims} {input.shown} {input.seeds}"
        " 2> {log}"
