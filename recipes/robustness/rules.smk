# Robustness of the results: exponential slipping times, other lengths and nucleation energies (does the
# order of regions in Figure 4 D survive?), and the distance law, a question of our own: are there slow
# fronts without a time scale? See README.md.
ROBUSTNESS_EVENT = f"{DATA}/fast-slow-fast"
PLACES["robustness/geometry-boundary"] = ("variants", "robustness/geometry")


figure(
    "robustness",
    pictures=["exponential", "exponential-map", "geometry", "distance"],
    tables=["exponential-events", "exponential-map", "geometry", "distance"],
    own=OWN_RESULTS,
    events=["fast-slow-fast"],
    refine=[f"{DATA}/robustness/geometry-boundary.csv"],
    load=f"{DATA}/ensemble/exponential-01-events.json",
    fronts=[f"{ROBUSTNESS_EVENT}{run}-front.json" for run in ("", "/exponential", "/distance")],
    maps=[f"{DATA}/robustness/{m}.csv" for m in ("exponential-map", "geometry", "distance")],
    edges=[f for setting in EDGES if "d_R" in setting for f in edges(setting, SIGMA_BARS)],
    reference_edges=edges("reference", SIGMA_BARS),
    others=of_ensemble("exponential", "events"),
    seeds=repeated([f"{DATA}/robustness/geometry-seeds.csv"]),
)
