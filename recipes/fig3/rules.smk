# Figure 3 A-C: the fast-slow-fast event restarted under other conditions. See README.md.
FIG3_RUNS = {
    "stopped": "--set driving.V=0",
    "no-slow-slip": "--set driving.V=0 --set junctions.f_new=f_slip",
    "t_R-half": "--set driving.V=0 --set junctions.t_R=1e-3 --set junctions.delta_t_R=0.3e-3",
    "t_R-double": "--set driving.V=0 --set junctions.t_R=4e-3 --set junctions.delta_t_R=1.2e-3",
}
FIG3_SLIPS = ["stopped", "t_R-half", "t_R-double"]


rule fig3_start:
    input:
        f"{DATA}/fast-slow-fast.compared",


# The moment when block 8, at 0.14 L, ruptures: the front has left the loading zone, and all that
# happens where it will be slow is still to come.
rule fig3_branch:
    input:
        h5=ancient(f"{DATA}/fast-slow-fast.h5"),
        sum=f"{DATA}/fast-slow-fast.h5.sum",
        front=f"{DATA}/fast-slow-fast-front.json",
    output:
        h5=f"{DATA}/fig3/branch.h5",
        sum=f"{DATA}/fig3/branch.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/fig3/branch.log",
    message:
        "fig3: go to the moment when the front is at 0.14 L"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet"
        " --until $({VALUE} {input.front} t_rupture.8) 2> {log}"


rule fig3_run:
    input:
        h5=ancient(f"{DATA}/fig3/branch.h5"),
        sum=f"{DATA}/fig3/branch.h5.sum",
    output:
        h5=f"{DATA}/fig3/{{run}}.h5",
        sum=f"{DATA}/fig3/{{run}}.h5.sum",
        record=f"{DATA}/fig3/{{run}}-record.h5",
        record_sum=f"{DATA}/fig3/{{run}}-record.h5.sum",
    params:
        code=CODE,
        changes=lambda wildcards: FIG3_RUNS[wildcards.run],
    wildcard_constraints:
        run="|".join(FIG3_RUNS),
    log:
        f"{LOGS}/fig3/{{run}}.log",
    message:
        "fig3: restart {wildcards.run} ({params.changes})"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet {params.changes} --for 0.01"
        " --record {output.record} --record-every 1e-5 2> {log}"


# Slip is followed until the front leaves its slow stretch; then the whole slider moves.
rule fig3_slip:
    input:
        h5=ancient(f"{DATA}/fig3/{{run}}-record.h5"),
        sum=f"{DATA}/fig3/{{run}}-record.h5.sum",
        front=f"{DATA}/fig3/{{run}}-front.json",
    output:
        f"{DATA}/fig3/{{run}}-slip.json",
    params:
        code=CODE,
    log:
        f"{LOGS}/fig3/{{run}}-slip.log",
    message:
        "fig3: measure the slip at x = 0.34 L ({wildcards.run})"
    shell:
        "{BIN}/analyze slip {input.h5} --x 0.0476 --to $({VALUE} {input.front} slow.t_to)"
        " --json > {output} 2> {log}"


rule fig3:
    input:
        fronts=[f"{DATA}/fig3/{run}-front.json" for run in FIG3_RUNS],
        records=ancient([f"{DATA}/fig3/{run}-record.h5" for run in FIG3_RUNS]),
        sums=[f"{DATA}/fig3/{run}-record.h5.sum" for run in FIG3_RUNS],
        slips=[f"{DATA}/fig3/{run}-slip.json" for run in FIG3_SLIPS],
        unmodified=f"{DATA}/fast-slow-fast-front.json",
        script="recipes/fig3/figure.py",
        common=COMMON,
    output:
        claims=f"{RESULTS}/fig3/claims.json",
        png=f"{RESULTS}/fig3/fig3.png",
        pdf=f"{RESULTS}/fig3/fig3.pdf",
        table=f"{RESULTS}/fig3/slip.csv",
    log:
        f"{LOGS}/fig3.log",
    message:
        "fig3: draw, compare with the paper's claims"
    shell:
        "{PYTHON} {input.script} {DATA} {RESULTS}/fig3 2> {log}"
