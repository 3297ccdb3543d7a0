# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

# Figure S2: the simplified law, one spring per block and slow slip imposed. See README.md.
import json

FIGS2_LOAD = f"{DATA}/ensemble/simplified-01"
FIGS2_CHOICE = Path(DATA, "figS2/choice.json")


def figS2_events():
    """Numbers of the fast-slow events that figS2_start has found."""
    if not FIGS2_CHOICE.exists():
        return range(0)
    return range(len(json.loads(FIGS2_CHOICE.read_text())["events"]))


rule figS2_choice:
    input:
        events=f"{FIGS2_LOAD}-events.json",
        **script("recipes/figS2/choose.py"),
    output: FIGS2_CHOICE.as_posix()
    log: f"{LOGS}/figS2/choice.log"
    message: "figS2: list the fast-slow events"
    shell: "{PYTHON} {input.script} {input.events} {CHECKPOINT_EVERY} > {output} 2> {log}"


STAGES["start"]["figS2"] = [FIGS2_CHOICE.as_posix()]


use rule restart_before_event as figS2_before with:
    input:
        choice=FIGS2_CHOICE.as_posix(),
        **content_of(checkpoints=checkpoints_of_load(FIGS2_LOAD)),
    output: **with_sums(h5=f"{DATA}/figS2/before-{{n}}.h5")
    params: **event_of(FIGS2_LOAD, "events.{n}")
    wildcard_constraints: n=r"\d+"
    log: f"{LOGS}/figS2/before-{{n}}.log"
    message: "figS2: go to 0.5 ms before event {wildcards.n}"


use rule restart_recorded as figS2_event with:
    input: **content_of(h5=f"{DATA}/figS2/before-0.h5")
    output: **recorded(f"{DATA}/figS2/event")
    params: **run_with("--for 0.015")
    log: f"{LOGS}/figS2/event.log"
    message: "figS2: run the first event as it is"


# Ends once nothing has broken for 12 ms, so that a record holds one event only.
use rule restart_recorded as figS2_no_slow_slip with:
    input: **content_of(h5=f"{DATA}/figS2/before-{{n}}.h5")
    output: **recorded(f"{DATA}/figS2/no-slow-slip-{{n}}")
    params: **run_with("--until-quiet 0.012 --for 0.05", changes="--set junctions.v_slow=0")
    wildcard_constraints: n=r"\d+"
    log: f"{LOGS}/figS2/no-slow-slip-{{n}}.log"
    message: "figS2: run event {wildcards.n} without slow slip"


rule figS2:
    input:
        choice=FIGS2_CHOICE.as_posix(),
        event=f"{DATA}/figS2/event-front.json",
        without=[f"{DATA}/figS2/no-slow-slip-{n}-front.json" for n in figS2_events()],
        **content_of(records=[f"{DATA}/figS2/{r}-record.h5" for r in ("event", "no-slow-slip-0")]),
        **script("recipes/figS2/figure.py"),
    output:
        claims=f"{RESULTS}/figS2/claims.json",
        **picture(f"{RESULTS}/figS2/figS2"),
        table=f"{RESULTS}/figS2/front-speed.csv",
        events=f"{RESULTS}/figS2/events.csv",
    log: f"{LOGS}/figS2.log"
    message: "figS2: draw, compare with the paper's claim"
    shell: "{PYTHON} {input.script} {DATA}/figS2 {RESULTS}/figS2 2> {log}"
