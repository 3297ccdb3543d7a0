# Figure S6: the decaying law. A: a fast-slow-fast event that arises while the slider is driven. B: the map
# of front types, of which a grid with one seed decides where five are needed.
FIGS6_LOAD = f"{DATA}/ensemble/decaying-01"


STAGES["start"]["figS6"] = [f"{DATA}/figS6/boundary.csv"]


use rule places as figS6_boundary with:
    input:
        tables=f"{DATA}/figS6/map.csv",
        **places(),
    output: f"{DATA}/figS6/boundary.csv"
    params: which="boundary"
    log: f"{LOGS}/figS6/boundary.log"


use rule choose as figS6_choice with:
    input: **events_of(FIGS6_LOAD)
    output: f"{DATA}/figS6/choice.json"
    params: by="decaying"
    log: f"{LOGS}/figS6/choice.log"


use rule restart_before_event as figS6_before with:
    input:
        choice=f"{DATA}/figS6/choice.json",
        **content_of(checkpoints=checkpoints_of_load(FIGS6_LOAD)),
    output: **with_sums(h5=f"{DATA}/figS6/before.h5")
    params: **event_of(FIGS6_LOAD)
    log: f"{LOGS}/figS6/before.log"
    message: "figS6: go to 0.5 ms before the event"


# The event as it is, and with longer slipping times: what of it follows from the decay.
FIGS6_RUNS = {
    "event": "",
    "t_R-double": "--set junctions.t_R=4e-3 --set junctions.delta_t_R=1.2e-3",
}


use rule restart_recorded as figS6_run with:
    input: **content_of(h5=f"{DATA}/figS6/before.h5")
    output: **recorded(f"{DATA}/figS6/{{run}}")
    params: **run_with("--for 0.01", changes=lambda wildcards: FIGS6_RUNS[wildcards.run])
    wildcard_constraints: run="|".join(FIGS6_RUNS)
    log: f"{LOGS}/figS6/{{run}}.log"
    message: "figS6: run the event ({wildcards.run})"


use rule figure as figS6 with:
    input:
        choice=f"{DATA}/figS6/choice.json",
        fronts=[f"{DATA}/figS6/{run}-front-c_s-8.json" for run in FIGS6_RUNS],
        **content_of(record=f"{DATA}/figS6/event-record.h5"),
        load=f"{FIGS6_LOAD}-events.json",
        others=of_ensemble("decaying", "events"),
        tables=[f"{DATA}/figS6/{part}.csv" for part in ("map", "map-boundary", "boundary")],
        **scripts_of("figS6"),
    output:
        results_of(
            "figS6",
            pictures=["figS6A", "figS6B"],
            tables=["front-speed", "events", "front-types", "thresholds"],
        ),
    log: f"{LOGS}/figS6.log"
