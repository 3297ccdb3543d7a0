# Figure 4. The chain of commands is in README.md.
FIG4_SHOWN = ["fast-slow-fast", "second-slow"]
FIG4_WIDER = [f"{event}{run}" for event in FIG4_SHOWN for run in ("", "/wider")]
FIG4_MAP = ["map", "map-between", "map-boundary"]


# The map of front types: a grid with one seed, then places halfway between fast neighbours and
# others, then five seeds at all places next to another type. Each decides where the next is needed.
STAGES["start"]["fig4"] = [
    f"{DATA}/fig4/between.csv",
    *[f"{DATA}/{event}.compared" for event in FIG4_SHOWN],
]


STAGES["refine"]["fig4"] = [f"{DATA}/fig4/boundary.csv"]


use rule places as fig4_between with:
    input:
        tables=f"{DATA}/fig4/map.csv",
        **places(),
    output: f"{DATA}/fig4/between.csv"
    params: which="between"
    log: f"{LOGS}/fig4/between.log"


use rule places as fig4_boundary with:
    input:
        tables=[f"{DATA}/fig4/{part}.csv" for part in ("map", "map-between")],
        **places(),
    output: f"{DATA}/fig4/boundary.csv"
    params: which="boundary"
    log: f"{LOGS}/fig4/boundary.log"


# A-B: events I and II, and the same with a wider distribution of junction forces
# (runs/continuations.smk). C: prepared interfaces of either shape, the strength of the shapes
# themselves, and the blocks of events I and II and of the ensemble. Edges of D by bisection.
use rule figure as fig4 with:
    input:
        fronts=[f"{DATA}/{run}-front.json" for run in FIG4_WIDER],
        phi=[f"{DATA}/{event}{state}-phi.json" for event in FIG4_SHOWN for state in ("", "/wider-start")],
        **content_of(records=[f"{DATA}/{run}-record.h5" for run in FIG4_WIDER]),
        tables=[f"{DATA}/fig4/{part}.csv" for part in (*FIG4_MAP, "boundary", "strength", "strength-curves")],
        strength=[f"{DATA}/{event}-strength.json" for event in FIG4_SHOWN],
        edges=[*edges("reference", EDGE_SIGMAS), *edges("no-slow-slip", EDGE_SIGMAS)],
        continued=of_ensemble("load", "continued"),
        **scripts_of("fig4"),
    output:
        results_of(
            "fig4",
            pictures=["fig4AB", "fig4C", "fig4D"],
            tables=["strength", "front-types", "thresholds", "edges"],
        ),
    log: f"{LOGS}/fig4.log"
