PLACES["robustness/geometry-boundary"] = ("variants", "robustness/geometry")


figure(
    "robustness",
    pictures=["exponential", "exponential-map", "geometry", "distance"],
    tables=["exponential-events", "exponential-map", "geometry", "distance"],
    own=OWN_RESULTS,
    events=["fast-slow-fast"],
    refine=["robustness/geometry-boundary.csv"],
    reads=[
        "ensemble/exponential-01-events.json",
        *(f"fast-slow-fast{run}-front.json" for run in ("", "/distance")),
        *(f"robustness/{m}.csv" for m in ("exponential-map", "geometry", "distance")),
        *(edge for setting in EDGES if "d_R" in setting for edge in edges(setting, SIGMA_BARS)),
        *edges("reference", SIGMA_BARS),
        *of_ensemble("exponential", "events"),
        *repeated(["robustness/geometry-seeds.csv"]),
    ],
)
