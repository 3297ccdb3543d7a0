# Figure S2: the simplified law, one spring per block and slow slip imposed. See README.md.
from events.continuations import WITHOUT_SLOW_SLIP

FIGS2_LOAD = f"{DATA}/ensemble/simplified-01"


use rule choose as figS2_choice with:
    input: **events_of(FIGS2_LOAD)
    output: f"{DATA}/figS2/choice.json"
    params: by="fast-slow"
    log: f"{LOGS}/figS2/choice.log"


use rule restart_before_event as figS2_before with:
    input:
        choice=f"{DATA}/figS2/choice.json",
        **content_of(checkpoints=checkpoints_of_load(FIGS2_LOAD)),
    output: **with_sums(h5=f"{DATA}/figS2/before.h5")
    params: **event_of(FIGS2_LOAD)
    log: f"{LOGS}/figS2/before.log"
    message: "figS2: go to 0.5 ms before the event"


FIGS2_RUNS = {"event": "--for 0.015", "no-slow-slip": WITHOUT_SLOW_SLIP}


use rule restart_recorded as figS2_run with:
    input: **content_of(h5=f"{DATA}/figS2/before.h5")
    output: **recorded(f"{DATA}/figS2/{{run}}")
    params: **run_with(lambda wildcards: FIGS2_RUNS[wildcards.run])
    wildcard_constraints: run="|".join(FIGS2_RUNS)
    log: f"{LOGS}/figS2/{{run}}.log"
    message: "figS2: run the event ({wildcards.run})"


# The other fast-slow events of the load are run without slow slip by ensemble/without_slow_slip.py.
use rule figure as figS2 with:
    input:
        fronts=[f"{DATA}/figS2/{run}-front.json" for run in FIGS2_RUNS],
        **content_of(records=[f"{DATA}/figS2/{run}-record.h5" for run in FIGS2_RUNS]),
        load=f"{FIGS2_LOAD}-continued.json",
        **scripts_of("figS2"),
    output: results_of("figS2", pictures=["figS2"], tables=["front-speed", "events"])
    log: f"{LOGS}/figS2.log"
