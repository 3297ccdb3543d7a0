# Events of the reference slider that figures show, each as a checkpoint from shortly before the event
# and as a record of it; choose_events.py says by which rule they are chosen. The paper's event I is
# fast-slow-fast, its event II second-slow, its event III fast-only.
from events.continuations import DURATION

EVENTS = ["fast-slow-fast", "fast-only", "second-slow"]
EVENTS_OF["shown"] = ("load-01", "shown")
RUNS |= {event: run(event, f"--for {DURATION}") for event in EVENTS}

wildcard_constraints:
    event="|".join(EVENTS),


if FROM_SCRATCH:

    use rule restart_before_event as event_start with:
        input:
            choice=f"{DATA}/shown/choice.json",
            **content_of(checkpoints=checkpoints_of_load(SHOWN_LOAD)),
        output: **with_sums(h5=f"{DATA}/{{event}}.h5")
        log: f"{LOGS}/{{event}}.log"
        params: **event_of(SHOWN_LOAD, "{event}")
        message: "{wildcards.event}: run to 0.5 ms before the event"

else:

    rule event_start:
        input: h5="checkpoints/{event}.h5"
        output: **with_sums(h5=f"{DATA}/{{event}}.h5")
        log: f"{LOGS}/{{event}}.log"
        params: code=CODE
        message: "{wildcards.event}: verify the shipped checkpoint"
        shell:
            "sum=$({BIN}/analyze checksum {input.h5} 2> {log}) && cp {input.h5} {output.h5}"
            " && echo \"content-sha256 $sum  {wildcards.event}.h5\" > {output.h5_sum}"


# In either case the checkpoint must be the one that the manifest names.
rule event_compared:
    input:
        sum=f"{DATA}/{{event}}.h5.sum",
        manifest="checkpoints/manifest",
    output: f"{DATA}/{{event}}.compared"
    log: f"{LOGS}/{{event}}.compared.log"
    message: "{wildcards.event}: compare the checksum with checkpoints/manifest"
    shell:
        "{{ grep -xFf {input.sum} {input.manifest} > {output}"
        " || {{ echo 'not in checkpoints/manifest (see checkpoints/README.md):';"
        " cat {input.sum}; false; }}; }} > {log}"
