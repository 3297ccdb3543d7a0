# Figure 3. A-C here: events I and II restarted under other conditions
# (runs/continuations.smk). Each other part of Figure 3 has a file of its own beside this
# one, which adds the claims it writes to FIG3_PARTS. See README.md.
FIG3_RUNS = ["stopped", "no-slow-slip", "t_R-half", "t_R-double"]
FIG3_EVENTS = [f"{DATA}/{event}" for event in ("fast-slow-fast", "second-slow")]  # I, II
FIG3_PARTS = [f"{DATA}/fig3/claims-ABC.json"]


STAGES["start"]["fig3"] = [f"{event}.compared" for event in FIG3_EVENTS]


rule fig3_ABC:
    input:
        fronts=[f"{event}/{run}-front.json" for event in FIG3_EVENTS for run in FIG3_RUNS],
        **content_of(
            records=[f"{event}/{run}-record.h5" for event in FIG3_EVENTS for run in FIG3_RUNS]
        ),
        slips=[f"{event}/{run}-slip.json" for event in FIG3_EVENTS for run in SLIPS],
        unmodified=[f"{event}-front.json" for event in FIG3_EVENTS],
        continued=of_ensemble(f"{DATA}/ensemble/{load}-continued.json" for load in REFERENCE_LOADS),
        **script("recipes/fig3/figure.py"),
    output:
        claims=f"{DATA}/fig3/claims-ABC.json",
        **picture(f"{RESULTS}/fig3/fig3"),
        table=f"{RESULTS}/fig3/slip.csv",
    log: f"{LOGS}/fig3.log"
    message: "fig3: draw A-C, compare with the paper's claims"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/fig3 {output.claims} {input.continued} 2> {log}"


for part in sorted(set(Path("recipes/fig3").glob("*.smk")) - {Path("recipes/fig3/rules.smk")}):
    include: part.name


use rule join_claims as fig3 with:
    input:
        parts=FIG3_PARTS,
        **script("recipes/common/claims/merge_claims.py"),
    output: f"{RESULTS}/fig3/claims.json"
    log: f"{LOGS}/fig3-claims.log"
    message: "fig3: join the claims"
