# Robustness of the results. Exponential slipping times here; what else there is has a file of its own
# beside this one, which adds the claims it writes to ROBUSTNESS_PARTS. See README.md.
ROBUSTNESS_PARTS = [f"{DATA}/robustness/claims-Exp.json"]
ROBUSTNESS_EVENT = f"{DATA}/fast-slow-fast"


STAGES["start"]["robustness"] = [f"{ROBUSTNESS_EVENT}.compared"]


# Until the first junction breaks, at 0.18 s, no slipping time is drawn: the reference run is also the
# beginning of this one.
rule robustness_exponential:
    input:
        h5=ancient(f"{DATA}/load-t0.150000000.h5"),
        sum=f"{DATA}/load-t0.150000000.h5.sum",
    output:
        h5=f"{DATA}/robustness/exponential.h5",
        sum=f"{DATA}/robustness/exponential.h5.sum",
        record=f"{DATA}/robustness/exponential-record.h5",
        record_sum=f"{DATA}/robustness/exponential-record.h5.sum",
    priority: 90  # long: first
    params:
        code=CODE,
    log:
        f"{LOGS}/robustness/exponential.log",
    message:
        "robustness: drive the slider with exponential slipping times to t = 1.2 s"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum --until {LOAD_UNTIL}"
        " --set junctions.slipping_times=exponential"
        " --record {output.record} --record-every 1e-3 2> {log}"


rule robustness_exponential_events:
    input:
        h5=ancient(f"{DATA}/robustness/exponential-record.h5"),
        sum=f"{DATA}/robustness/exponential-record.h5.sum",
    output:
        f"{DATA}/robustness/exponential-events.json",
    params:
        code=CODE,
    log:
        f"{LOGS}/robustness/exponential-events.log",
    message:
        "robustness: find the events with exponential slipping times"
    shell:
        "{BIN}/analyze events {input.h5} --json > {output} 2> {log}"


rule robustness_Exp:
    input:
        events=f"{DATA}/robustness/exponential-events.json",
        unmodified=f"{ROBUSTNESS_EVENT}-front.json",
        continued=f"{ROBUSTNESS_EVENT}/exponential-front.json",
        script="recipes/robustness/exponential.py",
        common=COMMON,
    output:
        claims=f"{DATA}/robustness/claims-Exp.json",
        png=f"{RESULTS}/robustness/exponential.png",
        pdf=f"{RESULTS}/robustness/exponential.pdf",
        table=f"{RESULTS}/robustness/exponential-events.csv",
    log:
        f"{LOGS}/robustness/Exp.log",
    message:
        "robustness: draw the events with exponential slipping times, compare with the claim"
    shell:
        "{PYTHON} {input.script} {input.events} {input.unmodified} {input.continued}"
        " {RESULTS}/robustness {output.claims} 2> {log}"


for part in sorted(
    set(Path("recipes/robustness").glob("*.smk")) - {Path("recipes/robustness/rules.smk")}
):
    include: part.name


rule robustness:
    input:
        parts=ROBUSTNESS_PARTS,
        script="recipes/common/merge_claims.py",
        common=COMMON,
    output:
        f"{RESULTS}/robustness/claims.json",
    log:
        f"{LOGS}/robustness-claims.log",
    message:
        "robustness: join the claims"
    shell:
        "{PYTHON} {input.script} {input.parts} {output} 2> {log}"
