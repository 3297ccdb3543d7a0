# Figure 5. A here: the driving stopped during the slow front (runs/continuations.smk). Each other
# part of Figure 5 has a file of its own beside this one, which adds the claims it writes to
# FIG5_PARTS. See README.md.
FIG5_PARTS = [f"{DATA}/fig5/claims-A.json"]
FIG5_RUNS = ["fast-slow-fast", "fast-slow-fast/undriven"]


STAGES["start"]["fig5"] = [f"{DATA}/fast-slow-fast.compared"]


rule fig5_driving:
    input:
        fronts=[f"{DATA}/{run}-front.json" for run in FIG5_RUNS],
        **content_of(records=[f"{DATA}/{run}-record.h5" for run in FIG5_RUNS]),
        continued=of_ensemble(f"{DATA}/ensemble/{load}-continued.json" for load in REFERENCE_LOADS),
        **script("recipes/fig5/driving.py"),
    output:
        claims=f"{DATA}/fig5/claims-A.json",
        **picture(f"{RESULTS}/fig5/fig5A"),
        table=f"{RESULTS}/fig5/rupture-lines.csv",
    log: f"{LOGS}/fig5-driving.log"
    message: "fig5: draw A, compare with the paper's claim"
    shell:
        "{PYTHON} {input.script} {DATA} {RESULTS}/fig5 {output.claims} {input.continued} 2> {log}"


for part in sorted(set(Path("recipes/fig5").glob("*.smk")) - {Path("recipes/fig5/rules.smk")}):
    include: part.name


use rule join_claims as fig5 with:
    input:
        parts=FIG5_PARTS,
        **script("recipes/common/claims/merge_claims.py"),
    output: f"{RESULTS}/fig5/claims.json"
    log: f"{LOGS}/fig5-claims.log"
    message: "fig5: join the claims"
