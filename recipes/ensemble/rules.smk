# The loads and their events are in runs/ensemble.smk.
figure(
    "ensemble",
    pictures=["ensemble", "alternation"],
    tables=["events"],
    own=OWN_RESULTS,
    reads=[
        *(f"ensemble/{load}-events.json" for load in LOADS),
        *(f"ensemble/{load}-continued.json" for load in CONTINUED_LOADS),
        *(f"ensemble/h0-{FIRST_SEED + n}.json" for n in range(20)),
    ],
)
