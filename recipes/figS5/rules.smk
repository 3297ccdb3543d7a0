# Figure S5: effective static friction for two shapes of phi. See README.md.
FIGS5_SHAPES = ["uniform", "bell"]
FIGS5_SIGMAS = [f"{0.02 * n:.2f}" for n in range(61)]  # up to 1.2, beyond the last change of branch


rule figS5_strength:
    output: f"{DATA}/figS5/{{shape}}.jsonl"
    log: f"{LOGS}/figS5/{{shape}}.log"
    params:
        code=CODE,
        sigmas=FIGS5_SIGMAS,
    wildcard_constraints: shape="|".join(FIGS5_SHAPES)
    message: "figS5: effective static friction of the {wildcards.shape} shape at 61 widths"
    shell:
        "for sigma in {params.sigmas}; do"
        " {BIN}/analyze strength --shape {wildcards.shape} --sigma-bar $sigma --json;"
        " done > {output} 2> {log}"


figure(
    "figS5",
    tables=["strength", "displacement"],
    reads=[f"figS5/{shape}.jsonl" for shape in FIGS5_SHAPES],
)
