# Figure 4 A-B: events I and II, and the same with a wider distribution of junction forces
# (runs/continuations.smk).
FIG4_WIDER = [f"{event}{run}" for event in FIG4_SHOWN for run in ("", "/wider")]


rule fig4_wider:
    input:
        fronts=[f"{DATA}/{run}-front.json" for run in FIG4_WIDER],
        phi=[f"{DATA}/{event}{state}-phi.json" for event in FIG4_SHOWN for state in ("", "/wider-start")],
        **content_of(records=[f"{DATA}/{run}-record.h5" for run in FIG4_WIDER]),
        continued=of_ensemble(f"{DATA}/ensemble/{load}-continued.json" for load in REFERENCE_LOADS),
        **script("recipes/fig4/wider.py"),
    output:
        claims=f"{DATA}/fig4/claims-AB.json",
        **picture(f"{RESULTS}/fig4/fig4AB"),
    log: f"{LOGS}/fig4-wider.log"
    message: "fig4: draw A-B, compare with the paper's claim"
    shell:
        "{PYTHON} {input.script} {DATA} {RESULTS}/fig4 {output.claims} {input.continued}"
        " 2> {log}"
