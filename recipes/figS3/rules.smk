# Figure S3: the prestress of prepared interfaces. The chain of commands is in README.md.
rule figS3:
    input:
        table=f"{DATA}/figS3/profiles.csv",
        **script("recipes/figS3/figure.py"),
    output:
        claims=f"{RESULTS}/figS3/claims.json",
        **picture(f"{RESULTS}/figS3/figS3"),
        table=f"{RESULTS}/figS3/profiles.csv",
    log: f"{LOGS}/figS3.log"
    message: "figS3: draw, compare with the paper's claim"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/figS3 2> {log}"
