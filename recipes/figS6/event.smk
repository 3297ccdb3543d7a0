# Figure S6 A: a fast-slow-fast event that arises while the slider is driven.
FIGS6_PARTS.append(f"{DATA}/figS6/claims-event.json")
FIGS6_UNTIL = 1.2  # s
FIGS6_LOADED = [
    f"{DATA}/figS6/load-t{n * CHECKPOINT_EVERY:.9f}.h5"
    for n in range(1, round(FIGS6_UNTIL / CHECKPOINT_EVERY) + 1)
]
# The slow stretch of an event is where v_c is below this part of c_s: a speed of c_s/8 passes as
# slow here, and with the tools' default it would not.
FIGS6_SLOW_BELOW = 1 / 8


rule figS6_load:
    output:
        record=f"{DATA}/figS6/load-record.h5",
        sum=f"{DATA}/figS6/load-record.h5.sum",
        checkpoints=FIGS6_LOADED,
        checkpoint_sums=[f"{path}.sum" for path in FIGS6_LOADED],
        last=f"{DATA}/figS6/load.h5",
        last_sum=f"{DATA}/figS6/load.h5.sum",
    priority: 90  # long: first
    params:
        code=CODE,
        law=FIGS6_LAW,
    log:
        f"{LOGS}/figS6/load.log",
    message:
        f"figS6: drive the slider with the decaying law to t = {FIGS6_UNTIL} s (about a minute)"
    shell:
        "{BIN}/load -o {output.last} --force --quiet --sum --until {FIGS6_UNTIL} {params.law}"
        " --checkpoint-every {CHECKPOINT_EVERY}"
        " --record {output.record} --record-every 1e-3 2> {log}"


rule figS6_events:
    input:
        h5=ancient(f"{DATA}/figS6/load-record.h5"),
        sum=f"{DATA}/figS6/load-record.h5.sum",
    output:
        f"{DATA}/figS6/events.json",
    params:
        code=CODE,
    log:
        f"{LOGS}/figS6/events.log",
    message:
        "figS6: find the rupture events"
    shell:
        "{BIN}/analyze events {input.h5} --slow-below {FIGS6_SLOW_BELOW} --json > {output} 2> {log}"


rule figS6_choice:
    input:
        events=f"{DATA}/figS6/events.json",
        script="recipes/figS6/event_choice.py",
        common=COMMON,
    output:
        f"{DATA}/figS6/choice.json",
    log:
        f"{LOGS}/figS6/choice.log",
    message:
        "figS6: judge the events"
    shell:
        "{PYTHON} {input.script} {input.events} {CHECKPOINT_EVERY} > {output} 2> {log}"


rule figS6_before:
    input:
        choice=f"{DATA}/figS6/choice.json",
        checkpoints=ancient(FIGS6_LOADED),
        sums=[f"{path}.sum" for path in FIGS6_LOADED],
    output:
        h5=f"{DATA}/figS6/before.h5",
        sum=f"{DATA}/figS6/before.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/figS6/before.log",
    message:
        "figS6: go to 0.5 ms before the event"
    shell:
        "{BIN}/restart {DATA}/figS6/load-t$({VALUE} {input.choice} from).h5"
        " -o {output.h5} --force --quiet --sum --until $({VALUE} {input.choice} until) 2> {log}"


# The event as it is, and with longer slipping times: what of it follows from the decay.
FIGS6_RUNS = {
    "event": "",
    "t_R-double": "--set junctions.t_R=4e-3 --set junctions.delta_t_R=1.2e-3",
}


rule figS6_run:
    input:
        h5=ancient(f"{DATA}/figS6/before.h5"),
        sum=f"{DATA}/figS6/before.h5.sum",
    output:
        h5=f"{DATA}/figS6/{{run}}.h5",
        sum=f"{DATA}/figS6/{{run}}.h5.sum",
        record=f"{DATA}/figS6/{{run}}-record.h5",
        record_sum=f"{DATA}/figS6/{{run}}-record.h5.sum",
    params:
        code=CODE,
        changes=lambda wildcards: FIGS6_RUNS[wildcards.run],
    wildcard_constraints:
        run="|".join(FIGS6_RUNS),
    log:
        f"{LOGS}/figS6/{{run}}.log",
    message:
        "figS6: run the event ({wildcards.run})"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum {params.changes} --for 0.01"
        " --record {output.record} --record-every 1e-5 2> {log}"


rule figS6_front:
    input:
        h5=ancient(f"{DATA}/figS6/{{run}}-record.h5"),
        sum=f"{DATA}/figS6/{{run}}-record.h5.sum",
    output:
        f"{DATA}/figS6/{{run}}-front-c_s-8.json",
    params:
        code=CODE,
    wildcard_constraints:
        run="|".join(FIGS6_RUNS),
    log:
        f"{LOGS}/figS6/{{run}}-front.log",
    message:
        "figS6: measure the front ({wildcards.run})"
    shell:
        "{BIN}/analyze front {input.h5} --event 0 --slow-below {FIGS6_SLOW_BELOW} --json"
        " > {output} 2> {log}"


rule figS6_event:
    input:
        choice=f"{DATA}/figS6/choice.json",
        fronts=[f"{DATA}/figS6/{run}-front-c_s-8.json" for run in FIGS6_RUNS],
        record=ancient(f"{DATA}/figS6/event-record.h5"),
        sum=f"{DATA}/figS6/event-record.h5.sum",
        script="recipes/figS6/event.py",
        common=COMMON,
    output:
        claims=f"{DATA}/figS6/claims-event.json",
        png=f"{RESULTS}/figS6/figS6A.png",
        pdf=f"{RESULTS}/figS6/figS6A.pdf",
        table=f"{RESULTS}/figS6/front-speed.csv",
        events=f"{RESULTS}/figS6/events.csv",
    log:
        f"{LOGS}/figS6/event-figure.log",
    message:
        "figS6: draw the event, compare with the paper's claim"
    shell:
        "{PYTHON} {input.script} {DATA}/figS6 {RESULTS}/figS6 2> {log}"
