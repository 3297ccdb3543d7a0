# The reference slider, loaded from t = 0 with a checkpoint every 0.05 s. Figures 1 and S1 show this
# run; with --from-scratch, the checkpoints in checkpoints/ come from it, too.
LOAD_UNTIL = 1.2  # s
CHECKPOINT_EVERY = 0.05  # s
LOADED = checkpoints_of(f"{DATA}/load", until=LOAD_UNTIL, every=CHECKPOINT_EVERY)


use rule load_recorded as load with:
    output: **recorded(f"{DATA}/load", checkpoints=LOADED)
    priority: 100  # long: first
    params:
        **run_with(
            f"--until {LOAD_UNTIL} --checkpoint-every {CHECKPOINT_EVERY}",
            record_every="1e-3",
        ),
    log: f"{LOGS}/load.log"
    message: f"load: drive the slider to t = {LOAD_UNTIL} s (6 million steps, about a minute)"


use rule analyze as events with:
    input: **content_of(h5=f"{DATA}/load-record.h5")
    output: f"{DATA}/events.json"
    params: **analysis("events")
    log: f"{LOGS}/events.log"
    message: "events: find the rupture events"
