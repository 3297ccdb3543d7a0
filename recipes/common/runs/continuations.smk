# Continuations of an event whose front becomes slow: the runs behind Figures 3 A-C, 4 A-B, 5 A and S4.
# {event} is one that figures show (events.smk); events/continuations.py says what each run changes.
from events.continuations import CONTINUATIONS, SLIPS, WIDER


# The moment when block 8, at 0.14 L, ruptures: the front has left the loading zone, and all that
# happens where it will be slow is still to come.
use rule restart as event_branch with:
    input:
        **content_of(h5=f"{DATA}/{{event}}.h5"),
        front=f"{DATA}/{{event}}-front.json",
    output: **with_sums(h5=f"{DATA}/{{event}}/branch.h5")
    params: **run_with(lambda wildcards, input: f"--until $({VALUE} {input.front} t_rupture.8)")
    log: f"{LOGS}/{{event}}/branch.log"
    message: "{wildcards.event}: go to the moment when the front is at 0.14 L"


use rule restart_recorded as event_continuation with:
    input: **content_of(h5=f"{DATA}/{{event}}/branch.h5")
    output: **recorded(f"{DATA}/{{event}}/{{continuation}}")
    params:
        **run_with(
            f"--for {DURATION}",
            changes=lambda wildcards: CONTINUATIONS[wildcards.continuation],
        ),
    wildcard_constraints: continuation="|".join(CONTINUATIONS)
    log: f"{LOGS}/{{event}}/{{continuation}}.log"
    message: "{wildcards.event}: restart {wildcards.continuation} ({params.changes})"


# The fast slip of the block that Figure 3 C shows, at every step.
use rule restart_recorded as event_every_step with:
    input: **content_of(h5=f"{DATA}/{{event}}/branch.h5")
    output: **recorded(f"{DATA}/{{event}}/every-step")
    params: **run_with("--for 0.001", changes=CONTINUATIONS["stopped"], record_every="2e-7")
    log: f"{LOGS}/{{event}}/every-step.log"
    message: "{wildcards.event}: restart with V = 0, recording every step for 1 ms"


# Slip is followed until the front leaves its slow stretch; then the whole slider moves. A front
# without one is followed until it reaches the leading edge, one that stops until the end.
rule event_slip:
    input:
        **content_of(h5=f"{DATA}/{{event}}/{{continuation}}-record.h5"),
        front=f"{DATA}/{{event}}/{{continuation}}-front.json",
    output: f"{DATA}/{{event}}/{{continuation}}-slip.json"
    params: code=CODE
    wildcard_constraints: continuation="|".join(SLIPS)
    log: f"{LOGS}/{{event}}/{{continuation}}-slip.log"
    message: "{wildcards.event}: measure the slip at x = 0.34 L ({wildcards.continuation})"
    shell:
        "{BIN}/analyze slip {input.h5} --x 0.0476"
        " --to $({VALUE} {input.front} slow.t_to t_rupture.56 2> {log} || echo 1e9)"
        " --json > {output} 2>> {log}"


rule event_wider_phi:
    input: **content_of(h5=f"{DATA}/{{event}}.h5")
    output:
        **with_sums(h5=f"{DATA}/{{event}}/wider-start.h5"),
        histogram=f"{DATA}/{{event}}/wider-start.txt",
    params: code=CODE
    log: f"{LOGS}/{{event}}/wider-start.log"
    message: "{wildcards.event}: make phi uniform and as wide as each block allows for x > 0.25 L"
    shell:
        "{BIN}/modify-phi {input.h5} -o {output.h5} --force --sum {WIDER}"
        " > {output.histogram} 2> {log}"


use rule restart_recorded as event_wider with:
    input: **content_of(h5=f"{DATA}/{{event}}/wider-start.h5")
    output: **recorded(f"{DATA}/{{event}}/wider")
    params: **run_with(f"--for {DURATION}")
    log: f"{LOGS}/{{event}}/wider.log"
    message: "{wildcards.event}: restart with the wider phi"


use rule restart as event_amid_slow with:
    input:
        **content_of(h5=f"{DATA}/{{event}}.h5"),
        front=f"{DATA}/{{event}}-front.json",
        script="recipes/common/events/middle.py",
    output: **with_sums(h5=f"{DATA}/{{event}}/amid-slow.h5")
    params: **run_with(lambda wildcards, input: f"--until $({PYTHON} {input.script} {input.front})")
    log: f"{LOGS}/{{event}}/amid-slow.log"
    message: "{wildcards.event}: go to the middle of the slow stretch"


use rule restart_recorded as event_undriven with:
    input: **content_of(h5=f"{DATA}/{{event}}/amid-slow.h5")
    output: **recorded(f"{DATA}/{{event}}/undriven")
    params: **run_with(f"--for {DURATION}", changes="--set driving.V=0")
    log: f"{LOGS}/{{event}}/undriven.log"
    message: "{wildcards.event}: stop the driving during the slow front"
