# Independent loads (runs/ensemble.smk), all their events, and each fast-slow-fast one continued in other
# ways. The chain of commands is in README.md.
figure(
    "ensemble",
    pictures=["ensemble", "alternation"],
    tables=["events"],
    own=OWN_RESULTS,
    found=[f"{DATA}/ensemble/{load}-events.json" for load in LOADS],
    continued=[f"{DATA}/ensemble/{load}-continued.json" for load in CONTINUED_LOADS],
    quasistatic=[f"{DATA}/ensemble/h0-{FIRST_SEED + n}.json" for n in range(20)],
    products=[of_ensemble(setting, "product") for setting in ("load", "decaying", "exponential")],
)
