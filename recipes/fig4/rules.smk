FIG4_SHOWN = ["fast-slow-fast", "second-slow"]
FIG4_MAP = ["map", "map-between", "map-boundary"]
# The map of front types: a grid with one seed, then places halfway between fast neighbours and
# others, then five seeds at all places next to another type. Each decides where the next is needed.
PLACES["fig4/between"] = ("between", "fig4/map")
PLACES["fig4/boundary"] = ("boundary", "fig4/map", "fig4/map-between")


# The runs of A-B are in runs/continuations.smk.
figure(
    "fig4",
    pictures=["fig4AB", "fig4C", "fig4D"],
    tables=["strength", "front-types", "thresholds", "edges"],
    events=FIG4_SHOWN,
    start=["fig4/between.csv"],
    refine=["fig4/boundary.csv"],
    reads=[
        *(f"{event}{run}-record.h5" for event in FIG4_SHOWN for run in ("", "/wider")),
        *(f"{event}{of}.json" for event in FIG4_SHOWN for of in ("-front", "/wider-front", "-strength")),
        *(f"{event}{state}-phi.json" for event in FIG4_SHOWN for state in ("", "/wider-start")),
        *(f"fig4/{part}.csv" for part in (*FIG4_MAP, "boundary", "strength", "strength-curves")),
        *(edge for setting in ("reference", "no-slow-slip") for edge in edges(setting, EDGE_SIGMAS)),
        *of_ensemble("load", "continued"),
    ],
)
