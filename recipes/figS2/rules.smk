# Figure S2: the simplified law, one spring per block and slow slip imposed. See README.md.
import json

FIGS2_UNTIL = 0.65  # s; there are three fast-slow events until then
FIGS2_LOADED = [
    f"{DATA}/figS2/load-t{n * CHECKPOINT_EVERY:.9f}.h5"
    for n in range(1, round(FIGS2_UNTIL / CHECKPOINT_EVERY) + 1)
]
FIGS2_CHOICE = Path(DATA, "figS2/choice.json")


def figS2_events():
    """Numbers of the fast-slow events that figS2_start has found."""
    if not FIGS2_CHOICE.exists():
        return range(0)
    return range(len(json.loads(FIGS2_CHOICE.read_text())["events"]))


rule figS2_load:
    output:
        record=f"{DATA}/figS2/load-record.h5",
        sum=f"{DATA}/figS2/load-record.h5.sum",
        checkpoints=FIGS2_LOADED,
        checkpoint_sums=[f"{path}.sum" for path in FIGS2_LOADED],
        last=f"{DATA}/figS2/load.h5",
        last_sum=f"{DATA}/figS2/load.h5.sum",
    priority: 90  # long: first
    params:
        code=CODE,
    log:
        f"{LOGS}/figS2/load.log",
    message:
        f"figS2: drive the slider with the simplified law to t = {FIGS2_UNTIL} s"
    shell:
        "{BIN}/load -o {output.last} --force --quiet --sum --until {FIGS2_UNTIL}"
        " --set junctions.law=simplified --set junctions.v_slow=1.5e-3"
        " --checkpoint-every {CHECKPOINT_EVERY}"
        " --record {output.record} --record-every 1e-3 2> {log}"


rule figS2_events:
    input:
        h5=ancient(f"{DATA}/figS2/load-record.h5"),
        sum=f"{DATA}/figS2/load-record.h5.sum",
    output:
        f"{DATA}/figS2/events.json",
    params:
        code=CODE,
    log:
        f"{LOGS}/figS2/events.log",
    message:
        "figS2: find the rupture events"
    shell:
        "{BIN}/analyze events {input.h5} --json > {output} 2> {log}"


rule figS2_choice:
    input:
        events=f"{DATA}/figS2/events.json",
        script="recipes/figS2/choose.py",
        common=COMMON,
    output:
        FIGS2_CHOICE.as_posix(),
    log:
        f"{LOGS}/figS2/choice.log",
    message:
        "figS2: list the fast-slow events"
    shell:
        "{PYTHON} {input.script} {input.events} {CHECKPOINT_EVERY} > {output} 2> {log}"


STAGES["start"]["figS2"] = [FIGS2_CHOICE.as_posix()]


rule figS2_before:
    input:
        choice=FIGS2_CHOICE.as_posix(),
        checkpoints=ancient(FIGS2_LOADED),
        sums=[f"{path}.sum" for path in FIGS2_LOADED],
    output:
        h5=f"{DATA}/figS2/before-{{n}}.h5",
        sum=f"{DATA}/figS2/before-{{n}}.h5.sum",
    params:
        code=CODE,
    wildcard_constraints:
        n=r"\d+",
    log:
        f"{LOGS}/figS2/before-{{n}}.log",
    message:
        "figS2: go to 0.5 ms before event {wildcards.n}"
    shell:
        "{BIN}/restart {DATA}/figS2/load-t$({VALUE} {input.choice} events.{wildcards.n}.from).h5"
        " -o {output.h5} --force --quiet --sum"
        " --until $({VALUE} {input.choice} events.{wildcards.n}.until) 2> {log}"


rule figS2_event:
    input:
        h5=ancient(f"{DATA}/figS2/before-0.h5"),
        sum=f"{DATA}/figS2/before-0.h5.sum",
    output:
        h5=f"{DATA}/figS2/event.h5",
        sum=f"{DATA}/figS2/event.h5.sum",
        record=f"{DATA}/figS2/event-record.h5",
        record_sum=f"{DATA}/figS2/event-record.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/figS2/event.log",
    message:
        "figS2: run the first event as it is"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum --for 0.015"
        " --record {output.record} --record-every 1e-5 2> {log}"


# Ends once nothing has broken for 12 ms, so that a record holds one event only.
rule figS2_no_slow_slip:
    input:
        h5=ancient(f"{DATA}/figS2/before-{{n}}.h5"),
        sum=f"{DATA}/figS2/before-{{n}}.h5.sum",
    output:
        h5=f"{DATA}/figS2/no-slow-slip-{{n}}.h5",
        sum=f"{DATA}/figS2/no-slow-slip-{{n}}.h5.sum",
        record=f"{DATA}/figS2/no-slow-slip-{{n}}-record.h5",
        record_sum=f"{DATA}/figS2/no-slow-slip-{{n}}-record.h5.sum",
    params:
        code=CODE,
    wildcard_constraints:
        n=r"\d+",
    log:
        f"{LOGS}/figS2/no-slow-slip-{{n}}.log",
    message:
        "figS2: run event {wildcards.n} without slow slip"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum --set junctions.v_slow=0"
        " --until-quiet 0.012 --for 0.05"
        " --record {output.record} --record-every 1e-5 2> {log}"


rule figS2:
    input:
        choice=FIGS2_CHOICE.as_posix(),
        event=f"{DATA}/figS2/event-front.json",
        without=[f"{DATA}/figS2/no-slow-slip-{n}-front.json" for n in figS2_events()],
        records=ancient([f"{DATA}/figS2/{r}-record.h5" for r in ("event", "no-slow-slip-0")]),
        sums=[f"{DATA}/figS2/{r}-record.h5.sum" for r in ("event", "no-slow-slip-0")],
        script="recipes/figS2/figure.py",
        common=COMMON,
    output:
        claims=f"{RESULTS}/figS2/claims.json",
        png=f"{RESULTS}/figS2/figS2.png",
        pdf=f"{RESULTS}/figS2/figS2.pdf",
        table=f"{RESULTS}/figS2/front-speed.csv",
        events=f"{RESULTS}/figS2/events.csv",
    log:
        f"{LOGS}/figS2.log",
    message:
        "figS2: draw, compare with the paper's claim"
    shell:
        "{PYTHON} {input.script} {DATA}/figS2 {RESULTS}/figS2 2> {log}"
