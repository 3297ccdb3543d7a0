# Independent loads (runs/ensemble.smk), all their events, and each fast-slow-fast one continued in other
# ways. The chain of commands is in README.md.
rule ensemble:
    input:
        events=[f"{DATA}/ensemble/{load}-events.json" for load in LOADS],
        continued=[f"{DATA}/ensemble/{load}-continued.json" for load in CONTINUED_LOADS],
        quasistatic=[f"{DATA}/ensemble/h0-{seed:02d}.json" for seed in range(1, 21)],
        products=[
            f"{DATA}/ensemble/{load}-product.json"
            for setting in ("load", "decaying", "exponential")
            for load in LOADS_OF[setting]
        ],
        beside="recipes/ensemble/alternation.py",
        **script("recipes/ensemble/figure.py"),
    output:
        claims=f"{RESULTS}/ensemble/claims.json",
        events=f"{RESULTS}/ensemble/events.csv",
        **picture(f"{RESULTS}/ensemble/ensemble"),
        alternation=f"{RESULTS}/ensemble/alternation.png",
        alternation_pdf=f"{RESULTS}/ensemble/alternation.pdf",
        own=f"{RESULTS}/ensemble/own.json",
        summary=f"{RESULTS}/ensemble/summary.txt",
    log: f"{LOGS}/ensemble.log"
    message: "ensemble: draw, list the events of all loads"
    shell: "{PYTHON} {input.script} {RESULTS}/ensemble {input.events} {input.products} 2> {log}"
