# Continuations of an event whose front becomes slow: the runs behind Figures 3 A-C, 4 A-B, 5 A and S4.
# {event} is one that figures show (events.smk); events/continuations.py says what each run changes.
from events.continuations import CONTINUATIONS, WIDER

WITHOUT_DRIVE = CONTINUATIONS["stopped"]
for event in EVENTS:
    for continuation, changes in CONTINUATIONS.items():
        RUNS[f"{event}/{continuation}"] = run(f"{event}/branch", f"--for {DURATION}", changes)
    # The fast slip of the block that Figure 3 C shows, at every step.
    RUNS[f"{event}/every-step"] = run(f"{event}/branch", "--for 0.001", WITHOUT_DRIVE, "2e-7")
    RUNS[f"{event}/wider"] = run(f"{event}/wider-start", f"--for {DURATION}")
    RUNS[f"{event}/undriven"] = run(f"{event}/amid-slow", f"--for {DURATION}", WITHOUT_DRIVE)


# The moment when block 8, at 0.14 L, ruptures: the front has left the loading zone, and all that
# happens where it will be slow is still to come.
use rule restart as event_branch with:
    input:
        **content_of(h5=f"{DATA}/{{event}}.h5"),
        front=f"{DATA}/{{event}}-front.json",
    output: **with_sums(h5=f"{DATA}/{{event}}/branch.h5")
    log: f"{LOGS}/{{event}}/branch.log"
    params: **run_with(lambda wildcards, input: f"--until $({VALUE} {input.front} t_rupture.8)")
    message: "{wildcards.event}: run until the front is at 0.14 L"


rule event_wider_phi:
    input: **content_of(h5=f"{DATA}/{{event}}.h5")
    output:
        **with_sums(h5=f"{DATA}/{{event}}/wider-start.h5"),
        histogram=f"{DATA}/{{event}}/wider-start.txt",
    log: f"{LOGS}/{{event}}/wider-start.log"
    params: code=CODE
    message: "{wildcards.event}: make phi uniform and as wide as each block allows for x > 0.25 L"
    shell:
        "{BIN}/modify-phi {input.h5} -o {output.h5} --force --sum {WIDER}"
        " > {output.histogram} 2> {log}"


use rule restart as event_amid_slow with:
    input:
        **content_of(h5=f"{DATA}/{{event}}.h5"),
        front=f"{DATA}/{{event}}-front.json",
        script="recipes/common/events/middle.py",
        shared="recipes/common/events/fronts.py",
    output: **with_sums(h5=f"{DATA}/{{event}}/amid-slow.h5")
    log: f"{LOGS}/{{event}}/amid-slow.log"
    params: **run_with(lambda wildcards, input: f"--until $({CALL} {input.script} {input.front})")
    message: "{wildcards.event}: run to the middle of the slow stretch"
