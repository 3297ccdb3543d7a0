# The SI's arithmetic of slow slip: relaxation of one block. See README.md.
ESTIMATES = {
    "reference": f"{DATA}/fast-slow-fast.h5",
    "unbreakable": f"{DATA}/estimate/unbreakable.h5",
}


STAGES["start"]["estimate"] = [f"{DATA}/fast-slow-fast.compared"]


# A force 600 times f_slip is out of reach in the relaxation.
rule estimate_unbreakable:
    output:
        h5=f"{DATA}/estimate/unbreakable.h5",
        sum=f"{DATA}/estimate/unbreakable.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/estimate/unbreakable.log",
    message:
        "estimate: a slider whose junctions do not break again"
    shell:
        "{BIN}/load -o {output.h5} --force --quiet --sum --until 0 --set junctions.mu_s=100"
        " 2> {log}"


rule estimate_relaxation:
    input:
        h5=lambda wildcards: ancient(ESTIMATES[wildcards.junctions]),
        sum=lambda wildcards: f"{ESTIMATES[wildcards.junctions]}.sum",
    output:
        f"{DATA}/estimate/{{junctions}}.json",
    params:
        code=CODE,
    wildcard_constraints:
        junctions="|".join(ESTIMATES),
    log:
        f"{LOGS}/estimate/{{junctions}}-relaxation.log",
    message:
        "estimate: relax one block ({wildcards.junctions})"
    shell:
        "{BIN}/analyze estimate {input.h5} --ensemble 1000 --json > {output} 2> {log}"


rule estimate:
    input:
        reports=[f"{DATA}/estimate/{junctions}.json" for junctions in ESTIMATES],
        script="recipes/estimate/figure.py",
        common=COMMON,
    output:
        claims=f"{RESULTS}/estimate/claims.json",
        png=f"{RESULTS}/estimate/estimate.png",
        pdf=f"{RESULTS}/estimate/estimate.pdf",
        table=f"{RESULTS}/estimate/relaxation.csv",
        blocks=f"{RESULTS}/estimate/blocks.csv",
    log:
        f"{LOGS}/estimate.log",
    message:
        "estimate: draw, compare with the paper's numbers"
    shell:
        "{PYTHON} {input.script} {input.reports} {RESULTS}/estimate 2> {log}"
