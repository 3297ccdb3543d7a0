# Robustness of the results. Exponential slipping times here; what else there is has a file of its own
# beside this one, which adds the claims it writes, if any, to ROBUSTNESS_PARTS. See README.md.
ROBUSTNESS_PARTS = [f"{DATA}/robustness/claims-Exp.json"]
ROBUSTNESS_EVENT = f"{DATA}/fast-slow-fast"


STAGES["start"]["robustness"] = [f"{ROBUSTNESS_EVENT}.compared"]


# Until the first junction breaks, at 0.18 s, no slipping time is drawn: the reference run is also the
# beginning of this one.
use rule restart_recorded as robustness_exponential with:
    input: **content_of(h5=f"{DATA}/load-t0.150000000.h5")
    output: **recorded(f"{DATA}/robustness/exponential")
    priority: 90  # long: first
    params:
        **run_with(
            f"--until {LOAD_UNTIL}",
            changes="--set junctions.slipping_times=exponential",
            record_every="1e-3",
        ),
    log: f"{LOGS}/robustness/exponential.log"
    message: "robustness: drive the slider with exponential slipping times to t = 1.2 s"


use rule analyze as robustness_exponential_events with:
    input: **content_of(h5=f"{DATA}/robustness/exponential-record.h5")
    output: f"{DATA}/robustness/exponential-events.json"
    params: **analysis("events")
    log: f"{LOGS}/robustness/exponential-events.log"
    message: "robustness: find the events with exponential slipping times"


rule robustness_Exp:
    input:
        events=f"{DATA}/robustness/exponential-events.json",
        unmodified=f"{ROBUSTNESS_EVENT}-front.json",
        continued=f"{ROBUSTNESS_EVENT}/exponential-front.json",
        **script("recipes/robustness/exponential.py"),
    output:
        claims=f"{DATA}/robustness/claims-Exp.json",
        **picture(f"{RESULTS}/robustness/exponential"),
        table=f"{RESULTS}/robustness/exponential-events.csv",
    log: f"{LOGS}/robustness/Exp.log"
    message: "robustness: draw the events with exponential slipping times, compare with the claim"
    shell:
        "{PYTHON} {input.script} {input.events} {input.unmodified} {input.continued}"
        " {RESULTS}/robustness {output.claims} 2> {log}"


for part in sorted(
    set(Path("recipes/robustness").glob("*.smk")) - {Path("recipes/robustness/rules.smk")}
):
    include: part.name


use rule join_claims as robustness with:
    input:
        parts=ROBUSTNESS_PARTS,
        own=f"{RESULTS}/robustness/own.json",
        **script("recipes/claims/merge_claims.py"),
    output: f"{RESULTS}/robustness/claims.json"
    log: f"{LOGS}/robustness-claims.log"
    message: "robustness: join the claims"
