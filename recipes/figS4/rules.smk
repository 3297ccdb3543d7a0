# Figure S4: Figure 4 A-B with the distributions of junction forces. See README.md.
FIGS4_STATES = ["second-slow", "second-slow/wider-start"]
FIGS4_RECORDS = ["second-slow", "second-slow/wider"]


figure(
    "figS4",
    tables=["phi"],
    events=["second-slow"],
    **content_of(
        checkpoints=[f"{DATA}/{state}.h5" for state in FIGS4_STATES],
        records=[f"{DATA}/{run}-record.h5" for run in FIGS4_RECORDS],
    ),
    phi=[f"{DATA}/{state}-phi.json" for state in FIGS4_STATES],
    fronts=[f"{DATA}/{run}-front.json" for run in FIGS4_RECORDS],
)
