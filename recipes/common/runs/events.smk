# Events of the reference slider that figures show, each as a checkpoint from shortly before the event
# and as a record of it; choose_events.py says by which rule they are chosen. The paper's event I is
# fast-slow-fast, its event II second-slow, its event III fast-only.
from events.continuations import DURATION
from events.conventions import DECAYING, IN_WORDS, WAYS, words_of

EVENTS = ["fast-slow-fast", "fast-only", "second-slow"]


wildcard_constraints:
    event="|".join(EVENTS),


if FROM_SCRATCH:

    use rule choose as choice with:
        input: **events_of(SHOWN_LOAD)
        output: f"{DATA}/choice.json"
        params: by="shown"
        log: f"{LOGS}/choice.log"

    use rule restart_before_event as event_start with:
        input:
            choice=f"{DATA}/choice.json",
            **content_of(checkpoints=checkpoints_of_load(SHOWN_LOAD)),
        output: **with_sums(h5=f"{DATA}/{{event}}.h5")
        params: **event_of(SHOWN_LOAD, "{event}")
        log: f"{LOGS}/{{event}}-start.log"
        message: "{wildcards.event}: go to 0.5 ms before the event"

else:

    rule event_start:
        input: h5="checkpoints/{event}.h5"
        output: **with_sums(h5=f"{DATA}/{{event}}.h5")
        params: code=CODE
        log: f"{LOGS}/{{event}}-start.log"
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
    log: f"{LOGS}/{{event}}-compared.log"
    message: "{wildcards.event}: compare its checksum with checkpoints/manifest"
    shell:
        "{{ grep -xFf {input.sum} {input.manifest} > {output}"
        " || {{ echo 'not in checkpoints/manifest (see checkpoints/README.md):';"
        " cat {input.sum}; false; }}; }} > {log}"


use rule restart_recorded as event_record with:
    input: **content_of(h5=f"{DATA}/{{event}}.h5")
    output: **with_sums(h5=f"{DATA}/{{event}}-after.h5", record=f"{DATA}/{{event}}-record.h5")
    params: **run_with(f"--for {DURATION}")
    log: f"{LOGS}/{{event}}-record.log"
    message: "{wildcards.event}: run the event as it is"


# Forces of each block's junctions just before the event, also after widening their phi.
use rule analyze as event_phi with:
    input: **content_of(h5=f"{DATA}/{{state}}.h5")
    output: f"{DATA}/{{state}}-phi.json"
    params: **analysis("phi")
    wildcard_constraints: state=f"({'|'.join(EVENTS)})(/wider-start)?"
    log: f"{LOGS}/{{state}}-phi.log"
    message: "{wildcards.state}: measure the forces in the junctions"


# The friction that each block can bear just before the event.
use rule analyze as event_strength with:
    input: **content_of(h5=f"{DATA}/{{event}}.h5")
    output: f"{DATA}/{{event}}-strength.json"
    params: **analysis("strength")
    log: f"{LOGS}/{{event}}-strength.log"
    message: "{wildcards.event}: measure the strength of each block"


# The event from shortly before which, or amid which, the run goes on is the first in its record.
use rule analyze as front with:
    input: **content_of(h5=f"{DATA}/{{run}}-record.h5")
    output: f"{DATA}/{{run}}-front.json"
    params: **analysis("front --event 0")
    log: f"{LOGS}/{{run}}-front.log"
    message: "{wildcards.run}: measure the front"


# The same in other ways (events/conventions.py): with the only definition of "slow" in the paper, as claim
# S6A allows it, and from where the front falls below the threshold to where it rises above it.
FRONT_WAYS = {
    "in-words": WAYS[IN_WORDS],
    "c_s-8": WAYS[DECAYING],
    "with-ends": WAYS["ends to the slow"],
}


use rule analyze as front_measured_so with:
    input: **content_of(h5=f"{DATA}/{{run}}-record.h5")
    output: f"{DATA}/{{run}}-front-{{way}}.json"
    params:
        **analysis(lambda wildcards: f"front --event 0 {' '.join(words_of(FRONT_WAYS[wildcards.way]))}"),
    wildcard_constraints: way="|".join(FRONT_WAYS)
    log: f"{LOGS}/{{run}}-front-{{way}}.log"
    message: "{wildcards.run}: measure the front {wildcards.way}"
