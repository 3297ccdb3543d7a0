# Figure S3: the prestress of prepared interfaces. The chain of commands is in README.md.
rule figS3:
    input:
        table=f"{DATA}/figS3/profiles.csv",
        script="recipes/figS3/figure.py",
        common=COMMON,
    output:
        claims=f"{RESULTS}/figS3/claims.json",
        png=f"{RESULTS}/figS3/figS3.png",
        pdf=f"{RESULTS}/figS3/figS3.pdf",
        table=f"{RESULTS}/figS3/profiles.csv",
    log:
        f"{LOGS}/figS3.log",
    message:
        "figS3: draw, compare with the paper's claim"
    shell:
        "{PYTHON} {input.script} {DATA} {RESULTS}/figS3 2> {log}"
