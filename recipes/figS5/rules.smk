# Figure S5: effective static friction for two shapes of phi. See README.md.
FIGS5_SHAPES = ["uniform", "bell"]
FIGS5_SIGMAS = [f"{0.02 * n:.2f}" for n in range(61)]  # up to 1.2, beyond the last change of branch


rule figS5_strength:
    output: f"{DATA}/figS5/{{shape}}.jsonl"
    params:
        code=CODE,
        sigmas=FIGS5_SIGMAS,
    wildcard_constraints: shape="|".join(FIGS5_SHAPES)
    log: f"{LOGS}/figS5/{{shape}}.log"
    message: "figS5: effective static friction of the {wildcards.shape} shape at 61 widths"
    shell:
        "for sigma in {params.sigmas}; do"
        " {BIN}/analyze strength --shape {wildcards.shape} --sigma-bar $sigma --json;"
        " done > {output} 2> {log}"


rule figS5:
    input:
        strength=[f"{DATA}/figS5/{shape}.jsonl" for shape in FIGS5_SHAPES],
        **script("recipes/figS5/figure.py"),
        quadrature="recipes/figS5/quadrature.py",
    output:
        claims=f"{RESULTS}/figS5/claims.json",
        **picture(f"{RESULTS}/figS5/figS5"),
        table=f"{RESULTS}/figS5/strength.csv",
        curves=f"{RESULTS}/figS5/displacement.csv",
    log: f"{LOGS}/figS5.log"
    message: "figS5: draw, compare with quadrature"
    shell: "{PYTHON} {input.script} {input.strength} {RESULTS}/figS5 2> {log}"
