# Events of the reference slider that figures show, each as a checkpoint from shortly before the event
# and as a record of it; choose_events.py says by which rule they are chosen. The paper's event I is
# fast-slow-fast, its event II second-slow, its event III fast-only.
EVENTS = ["fast-slow-fast", "fast-only", "second-slow"]

# The ensemble has its own events, to which all but what concerns the shipped checkpoints applies, too.
EVENT = "|".join([*EVENTS, r"ensemble/seed-\d\d"])


wildcard_constraints:
    event=EVENT,
    shown_event="|".join(EVENTS),


if FROM_SCRATCH:

    rule choice:
        input:
            events=f"{DATA}/events.json",
            script="recipes/common/choose_events.py",
            common=COMMON,
        output:
            f"{DATA}/choice.json",
        log:
            f"{LOGS}/choice.log",
        message:
            "choice: choose the events to be shown"
        shell:
            "{PYTHON} {input.script} {input.events} {CHECKPOINT_EVERY} > {output} 2> {log}"

    rule event_start:
        input:
            choice=f"{DATA}/choice.json",
            checkpoints=ancient(LOADED),
            sums=[f"{path}.sum" for path in LOADED],
        output:
            h5=f"{DATA}/{{shown_event}}.h5",
            sum=f"{DATA}/{{shown_event}}.h5.sum",
        params:
            code=CODE,
        log:
            f"{LOGS}/{{shown_event}}-start.log",
        message:
            "{wildcards.shown_event}: go to 0.5 ms before the event"
        shell:
            "{BIN}/restart {DATA}/load-t$({VALUE} {input.choice} {wildcards.shown_event}.from).h5"
            " -o {output.h5} --force --quiet --sum"
            " --until $({VALUE} {input.choice} {wildcards.shown_event}.until) 2> {log}"

else:

    rule event_start:
        input:
            h5="checkpoints/{shown_event}.h5",
        output:
            h5=f"{DATA}/{{shown_event}}.h5",
            sum=f"{DATA}/{{shown_event}}.h5.sum",
        params:
            code=CODE,
        log:
            f"{LOGS}/{{shown_event}}-start.log",
        message:
            "{wildcards.shown_event}: verify the shipped checkpoint"
        shell:
            "sum=$({BIN}/analyze checksum {input.h5} 2> {log}) && cp {input.h5} {output.h5}"
            " && echo \"content-sha256 $sum  {wildcards.shown_event}.h5\" > {output.sum}"


# In either case the checkpoint must be the one that the manifest names.
rule event_compared:
    input:
        sum=f"{DATA}/{{shown_event}}.h5.sum",
        manifest="checkpoints/manifest",
    output:
        f"{DATA}/{{shown_event}}.compared",
    log:
        f"{LOGS}/{{shown_event}}-compared.log",
    message:
        "{wildcards.shown_event}: compare its checksum with checkpoints/manifest"
    shell:
        "{{ grep -xFf {input.sum} {input.manifest} > {output}"
        " || {{ echo 'not in checkpoints/manifest (see checkpoints/README.md):';"
        " cat {input.sum}; false; }}; }} > {log}"


rule event_record:
    input:
        h5=ancient(f"{DATA}/{{event}}.h5"),
        sum=f"{DATA}/{{event}}.h5.sum",
    output:
        h5=f"{DATA}/{{event}}-after.h5",
        sum=f"{DATA}/{{event}}-after.h5.sum",
        record=f"{DATA}/{{event}}-record.h5",
        record_sum=f"{DATA}/{{event}}-record.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/{{event}}-record.log",
    message:
        "{wildcards.event}: run the event as it is"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum --for 0.01"
        " --record {output.record} --record-every 1e-5 2> {log}"


# What the junctions of each block carry just before the event, also after widening their phi.
rule event_phi:
    input:
        h5=ancient(f"{DATA}/{{state}}.h5"),
        sum=f"{DATA}/{{state}}.h5.sum",
    output:
        f"{DATA}/{{state}}-phi.json",
    params:
        code=CODE,
    wildcard_constraints:
        state=f"({EVENT})(/wider-start)?",
    log:
        f"{LOGS}/{{state}}-phi.log",
    message:
        "{wildcards.state}: measure the forces in the junctions"
    shell:
        "{BIN}/analyze phi {input.h5} --json > {output} 2> {log}"


# What friction each block can bear just before the event.
rule event_strength:
    input:
        h5=ancient(f"{DATA}/{{event}}.h5"),
        sum=f"{DATA}/{{event}}.h5.sum",
    output:
        f"{DATA}/{{event}}-strength.json",
    params:
        code=CODE,
    log:
        f"{LOGS}/{{event}}-strength.log",
    message:
        "{wildcards.event}: measure the strength of each block"
    shell:
        "{BIN}/analyze strength {input.h5} --json > {output} 2> {log}"


# The event from shortly before which, or amid which, the run goes on is the first in its record.
rule front:
    input:
        h5=ancient(f"{DATA}/{{run}}-record.h5"),
        sum=f"{DATA}/{{run}}-record.h5.sum",
    output:
        f"{DATA}/{{run}}-front.json",
    params:
        code=CODE,
    log:
        f"{LOGS}/{{run}}-front.log",
    message:
        "{wildcards.run}: measure the front"
    shell:
        "{BIN}/analyze front {input.h5} --event 0 --json > {output} 2> {log}"
