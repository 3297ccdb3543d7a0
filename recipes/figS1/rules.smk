# Figure S1: normal and friction forces along the interface, unloaded and before an event. See
# README.md.
FIGS1_STATES = {
    "unloaded": f"{DATA}/figS1/unloaded.h5",
    "before-event": f"{DATA}/fast-slow-fast.h5",
}


STAGES["start"]["figS1"] = [f"{DATA}/fast-slow-fast.compared"]


rule figS1_unloaded:
    output:
        h5=f"{DATA}/figS1/unloaded.h5",
        sum=f"{DATA}/figS1/unloaded.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/figS1/unloaded.log",
    message:
        "figS1: find the equilibrium under the normal load"
    shell:
        "{BIN}/load -o {output.h5} --force --quiet --sum --until 0 2> {log}"


rule figS1_stress:
    input:
        h5=lambda wildcards: ancient(FIGS1_STATES[wildcards.state]),
        sum=lambda wildcards: f"{FIGS1_STATES[wildcards.state]}.sum",
    output:
        f"{DATA}/figS1/{{state}}-stress.json",
    params:
        code=CODE,
    wildcard_constraints:
        state="|".join(FIGS1_STATES),
    log:
        f"{LOGS}/figS1/{{state}}-stress.log",
    message:
        "figS1: read the forces on the interface ({wildcards.state})"
    shell:
        "{BIN}/analyze stress {input.h5} --json > {output} 2> {log}"


rule figS1:
    input:
        stress=[f"{DATA}/figS1/{state}-stress.json" for state in FIGS1_STATES],
        checkpoint=ancient(f"{DATA}/fast-slow-fast.h5"),
        sum=f"{DATA}/fast-slow-fast.h5.sum",
        script="recipes/figS1/figure.py",
        common=COMMON,
    output:
        claims=f"{RESULTS}/figS1/claims.json",
        png=f"{RESULTS}/figS1/figS1.png",
        pdf=f"{RESULTS}/figS1/figS1.pdf",
        table=f"{RESULTS}/figS1/stress.csv",
    log:
        f"{LOGS}/figS1.log",
    message:
        "figS1: draw, compare with the paper's claim"
    shell:
        "{PYTHON} {input.script} {input.stress} {input.checkpoint} {RESULTS}/figS1 2> {log}"
