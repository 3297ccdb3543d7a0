# Figure S4: Figure 4 A-B with the distributions of junction forces. See README.md.
FIGS4_STATES = ["second-slow", "second-slow/wider-start"]
FIGS4_RECORDS = ["second-slow", "second-slow/wider"]


STAGES["start"]["figS4"] = [f"{DATA}/second-slow.compared"]


rule figS4:
    input:
        **content_of(
            checkpoints=[f"{DATA}/{state}.h5" for state in FIGS4_STATES],
            records=[f"{DATA}/{run}-record.h5" for run in FIGS4_RECORDS],
        ),
        phi=[f"{DATA}/{state}-phi.json" for state in FIGS4_STATES],
        fronts=[f"{DATA}/{run}-front.json" for run in FIGS4_RECORDS],
        **script("recipes/figS4/figure.py"),
    output:
        claims=f"{RESULTS}/figS4/claims.json",
        **picture(f"{RESULTS}/figS4/figS4"),
        table=f"{RESULTS}/figS4/phi.csv",
    log: f"{LOGS}/figS4.log"
    message: "figS4: draw, compare with the paper's claim"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/figS4 2> {log}"
