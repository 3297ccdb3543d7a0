# Figure 2: two events that span the interface. The chain of commands is in README.md.
FIG2_EVENTS = ["fast-slow-fast", "fast-only"]


STAGES["start"]["fig2"] = [f"{DATA}/{event}.compared" for event in EVENTS]


rule fig2:
    input:
        fronts=[f"{DATA}/{event}-front.json" for event in FIG2_EVENTS],
        **content_of(records=[f"{DATA}/{event}-record.h5" for event in FIG2_EVENTS]),
        in_words=f"{DATA}/fast-slow-fast-front-in-words.json",
        loads=of_ensemble(f"{DATA}/ensemble/{load}-events.json" for load in REFERENCE_LOADS),
        **script("recipes/fig2/figure.py"),
    output:
        claims=f"{RESULTS}/fig2/claims.json",
        **picture(f"{RESULTS}/fig2/fig2"),
        table=f"{RESULTS}/fig2/front-speed.csv",
    log: f"{LOGS}/fig2.log"
    message: "fig2: draw, compare with the paper's claims"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/fig2 {input.loads} 2> {log}"
