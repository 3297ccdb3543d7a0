# Robustness of the results: exponential slipping times, other lengths and nucleation energies (does the
# order of regions in Figure 4 D survive?), and the distance law, a question of our own: are there slow
# fronts without a time scale? See README.md.
ROBUSTNESS_EVENT = f"{DATA}/fast-slow-fast"


STAGES["start"]["robustness"] = [f"{ROBUSTNESS_EVENT}.compared"]
STAGES["refine"]["robustness"] = [f"{DATA}/robustness/geometry-boundary.csv"]


use rule places as robustness_boundary with:
    input:
        tables=f"{DATA}/robustness/geometry.csv",
        **places(),
    output: f"{DATA}/robustness/geometry-boundary.csv"
    params: which="variants"
    log: f"{LOGS}/robustness/geometry-boundary.log"


use rule figure as robustness with:
    input:
        events=f"{DATA}/ensemble/exponential-01-events.json",
        fronts=[f"{ROBUSTNESS_EVENT}{run}-front.json" for run in ("", "/exponential", "/distance")],
        maps=[f"{DATA}/robustness/{m}.csv" for m in ("exponential-map", "geometry", "distance")],
        edges=[f for setting in EDGES if "d_R" in setting for f in edges(setting, SIGMA_BARS)],
        reference_edges=edges("reference", SIGMA_BARS),
        others=of_ensemble("exponential", "events"),
        seeds=repeated([f"{DATA}/robustness/geometry-seeds.csv"]),
        **scripts_of("robustness"),
    output:
        results_of(
            "robustness",
            pictures=["exponential", "exponential-map", "geometry", "distance"],
            tables=["exponential-events", "exponential-map", "geometry", "distance"],
            own=OWN_RESULTS,
        ),
    log: f"{LOGS}/robustness.log"
