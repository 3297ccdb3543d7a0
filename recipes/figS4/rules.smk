# Figure S4: Figure 4 A-B with the distributions of junction forces. See README.md.
FIGS4_STATES = ["second-slow", "second-slow/wider-start"]
FIGS4_RECORDS = ["second-slow", "second-slow/wider"]


STAGES["start"]["figS4"] = [f"{DATA}/second-slow.compared"]


use rule figure as figS4 with:
    input:
        **content_of(
            checkpoints=[f"{DATA}/{state}.h5" for state in FIGS4_STATES],
            records=[f"{DATA}/{run}-record.h5" for run in FIGS4_RECORDS],
        ),
        phi=[f"{DATA}/{state}-phi.json" for state in FIGS4_STATES],
        fronts=[f"{DATA}/{run}-front.json" for run in FIGS4_RECORDS],
        **scripts_of("figS4"),
    output: results_of("figS4", pictures=["figS4"], tables=["phi"])
    log: f"{LOGS}/figS4.log"
