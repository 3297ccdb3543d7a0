# What is done with an event whose front becomes slow: the runs behind Figures 3 A-C, 4 A-B, 5 A and S4.
# {event} is the one that the figures show, or any of the ensemble (events.smk).
CONTINUATIONS = {  # from the moment when the front is at 0.14 L
    "stopped": "--set driving.V=0",
    "no-slow-slip": "--set driving.V=0 --set junctions.f_new=f_slip",
    "t_R-half": "--set driving.V=0 --set junctions.t_R=1e-3 --set junctions.delta_t_R=0.3e-3",
    "t_R-double": "--set driving.V=0 --set junctions.t_R=4e-3 --set junctions.delta_t_R=1.2e-3",
    "exponential": "--set junctions.slipping_times=exponential",
}
SLIPS = ["stopped", "t_R-half", "t_R-double"]


# The moment when block 8, at 0.14 L, ruptures: the front has left the loading zone, and all that
# happens where it will be slow is still to come.
rule event_branch:
    input:
        h5=ancient(f"{DATA}/{{event}}.h5"),
        sum=f"{DATA}/{{event}}.h5.sum",
        front=f"{DATA}/{{event}}-front.json",
    output:
        h5=f"{DATA}/{{event}}/branch.h5",
        sum=f"{DATA}/{{event}}/branch.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/{{event}}/branch.log",
    message:
        "{wildcards.event}: go to the moment when the front is at 0.14 L"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum"
        " --until $({VALUE} {input.front} t_rupture.8) 2> {log}"


rule event_continuation:
    input:
        h5=ancient(f"{DATA}/{{event}}/branch.h5"),
        sum=f"{DATA}/{{event}}/branch.h5.sum",
    output:
        h5=f"{DATA}/{{event}}/{{continuation}}.h5",
        sum=f"{DATA}/{{event}}/{{continuation}}.h5.sum",
        record=f"{DATA}/{{event}}/{{continuation}}-record.h5",
        record_sum=f"{DATA}/{{event}}/{{continuation}}-record.h5.sum",
    params:
        code=CODE,
        changes=lambda wildcards: CONTINUATIONS[wildcards.continuation],
    wildcard_constraints:
        continuation="|".join(CONTINUATIONS),
    log:
        f"{LOGS}/{{event}}/{{continuation}}.log",
    message:
        "{wildcards.event}: restart {wildcards.continuation} ({params.changes})"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum {params.changes} --for 0.01"
        " --record {output.record} --record-every 1e-5 2> {log}"


# Slip is followed until the front leaves its slow stretch; then the whole slider moves. A front
# without one is followed until it reaches the leading edge, one that stops until the end.
rule event_slip:
    input:
        h5=ancient(f"{DATA}/{{event}}/{{continuation}}-record.h5"),
        sum=f"{DATA}/{{event}}/{{continuation}}-record.h5.sum",
        front=f"{DATA}/{{event}}/{{continuation}}-front.json",
    output:
        f"{DATA}/{{event}}/{{continuation}}-slip.json",
    params:
        code=CODE,
    wildcard_constraints:
        continuation="|".join(SLIPS),
    log:
        f"{LOGS}/{{event}}/{{continuation}}-slip.log",
    message:
        "{wildcards.event}: measure the slip at x = 0.34 L ({wildcards.continuation})"
    shell:
        "{BIN}/analyze slip {input.h5} --x 0.0476"
        " --to $({VALUE} {input.front} slow.t_to t_rupture.56 2> {log} || echo 1e9)"
        " --json > {output} 2>> {log}"


rule event_wider_phi:
    input:
        h5=ancient(f"{DATA}/{{event}}.h5"),
        sum=f"{DATA}/{{event}}.h5.sum",
    output:
        h5=f"{DATA}/{{event}}/wider-start.h5",
        sum=f"{DATA}/{{event}}/wider-start.h5.sum",
        histogram=f"{DATA}/{{event}}/wider-start.txt",
    params:
        code=CODE,
    log:
        f"{LOGS}/{{event}}/wider-start.log",
    message:
        "{wildcards.event}: make phi uniform and as wide as each block allows for x > 0.25 L"
    shell:
        "{BIN}/modify-phi {input.h5} -o {output.h5} --force --sum --shape uniform --x-from 0.035"
        " > {output.histogram} 2> {log}"


rule event_wider:
    input:
        h5=ancient(f"{DATA}/{{event}}/wider-start.h5"),
        sum=f"{DATA}/{{event}}/wider-start.h5.sum",
    output:
        h5=f"{DATA}/{{event}}/wider.h5",
        sum=f"{DATA}/{{event}}/wider.h5.sum",
        record=f"{DATA}/{{event}}/wider-record.h5",
        record_sum=f"{DATA}/{{event}}/wider-record.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/{{event}}/wider.log",
    message:
        "{wildcards.event}: restart with the wider phi"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum --for 0.01"
        " --record {output.record} --record-every 1e-5 2> {log}"


rule event_amid_slow:
    input:
        h5=ancient(f"{DATA}/{{event}}.h5"),
        sum=f"{DATA}/{{event}}.h5.sum",
        front=f"{DATA}/{{event}}-front.json",
        script="recipes/common/middle.py",
    output:
        h5=f"{DATA}/{{event}}/amid-slow.h5",
        sum=f"{DATA}/{{event}}/amid-slow.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/{{event}}/amid-slow.log",
    message:
        "{wildcards.event}: go to the middle of the slow stretch"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum"
        " --until $({PYTHON} {input.script} {input.front}) 2> {log}"


rule event_undriven:
    input:
        h5=ancient(f"{DATA}/{{event}}/amid-slow.h5"),
        sum=f"{DATA}/{{event}}/amid-slow.h5.sum",
    output:
        h5=f"{DATA}/{{event}}/undriven.h5",
        sum=f"{DATA}/{{event}}/undriven.h5.sum",
        record=f"{DATA}/{{event}}/undriven-record.h5",
        record_sum=f"{DATA}/{{event}}/undriven-record.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/{{event}}/undriven.log",
    message:
        "{wildcards.event}: stop the driving during the slow front"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum --set driving.V=0 --for 0.01"
        " --record {output.record} --record-every 1e-5 2> {log}"
