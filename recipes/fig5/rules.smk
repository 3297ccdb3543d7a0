# Figure 5: dynamic and quasi-static slow fronts. Each part adds its claims to FIG5_PARTS.
FIG5_PARTS = []


include: "quasistatic.smk"


rule fig5:
    input:
        parts=lambda wildcards: FIG5_PARTS,
        script="recipes/common/merge_claims.py",
        common=COMMON,
    output:
        f"{RESULTS}/fig5/claims.json",
    log:
        f"{LOGS}/fig5.log",
    message:
        "fig5: join the claims of its parts"
    shell:
        "{PYTHON} {input.script} {input.parts} {output} 2> {log}"
