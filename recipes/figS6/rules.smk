PLACES["figS6/boundary"] = ("boundary", "figS6/map")
EVENTS_OF["figS6"] = ("decaying-01", "decaying")
# The event as it is, and with longer slipping times: what of it follows from the decay.
FIGS6_RUNS = {"event": "", "t_R-double": "--set junctions.t_R=4e-3 --set junctions.delta_t_R=1.2e-3"}
RUNS |= {f"figS6/{name}": run("figS6/before", "--for 0.01", of) for name, of in FIGS6_RUNS.items()}


figure(
    "figS6",
    pictures=["figS6A", "figS6B"],
    tables=["front-speed", "events", "front-types", "thresholds"],
    start=["figS6/boundary.csv"],
    reads=[
        *("figS6/event-record.h5", "ensemble/decaying-01-events.json"),
        *(f"figS6/{run}-front.json" for run in FIGS6_RUNS),
        *of_ensemble("decaying", "events"),
        *(f"figS6/{part}.csv" for part in ("map", "map-boundary", "boundary")),
    ],
)
