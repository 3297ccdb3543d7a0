# Robustness of the results. Exponential slipping times here; what else there is has a file of its own
# beside this one, which adds the claims it writes, if any, to ROBUSTNESS_PARTS. See README.md.
ROBUSTNESS_PARTS = [f"{DATA}/robustness/claims-Exp.json"]
ROBUSTNESS_EVENT = f"{DATA}/fast-slow-fast"


STAGES["start"]["robustness"] = [f"{ROBUSTNESS_EVENT}.compared"]


rule robustness_Exp:
    input:
        events=f"{DATA}/ensemble/exponential-01-events.json",
        unmodified=f"{ROBUSTNESS_EVENT}-front.json",
        continued=f"{ROBUSTNESS_EVENT}/exponential-front.json",
        map=f"{DATA}/robustness/exponential-map.csv",
        others=of_ensemble(
            f"{DATA}/ensemble/{load}-events.json" for load in LOADS_OF["exponential"][1:]
        ),
        **script("recipes/robustness/exponential.py"),
    output:
        claims=f"{DATA}/robustness/claims-Exp.json",
        **picture(f"{RESULTS}/robustness/exponential"),
        map_png=f"{RESULTS}/robustness/exponential-map.png",
        map_pdf=f"{RESULTS}/robustness/exponential-map.pdf",
        map_table=f"{RESULTS}/robustness/exponential-map.csv",
        table=f"{RESULTS}/robustness/exponential-events.csv",
    log: f"{LOGS}/robustness/Exp.log"
    message: "robustness: draw events and map with exponential slipping times, compare with the claims"
    shell:
        "{PYTHON} {input.script} {DATA} {input.unmodified} {input.continued} {RESULTS}/robustness"
        " {output.claims} {input.events} {input.others} 2> {log}"


for part in sorted(
    set(Path("recipes/robustness").glob("*.smk")) - {Path("recipes/robustness/rules.smk")}
):
    include: part.name


use rule join_claims as robustness with:
    input:
        parts=ROBUSTNESS_PARTS,
        own=f"{RESULTS}/robustness/own.json",
        **script("recipes/common/claims/merge_claims.py"),
    output: f"{RESULTS}/robustness/claims.json"
    log: f"{LOGS}/robustness-claims.log"
    message: "robustness: join the claims"
