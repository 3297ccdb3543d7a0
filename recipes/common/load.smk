# The reference slider, loaded from t = 0 with a checkpoint every 0.05 s. Figures 1 and S1 show this
# run; with --from-scratch, the checkpoints in checkpoints/ come from it, too.
LOAD_UNTIL = 1.2  # s
CHECKPOINT_EVERY = 0.05  # s
LOADED = [
    f"{DATA}/load-t{n * CHECKPOINT_EVERY:.9f}.h5"
    for n in range(1, round(LOAD_UNTIL / CHECKPOINT_EVERY) + 1)
]


rule load:
    output:
        record=f"{DATA}/load-record.h5",
        sum=f"{DATA}/load-record.h5.sum",
        checkpoints=LOADED,
        checkpoint_sums=[f"{path}.sum" for path in LOADED],
        last=f"{DATA}/load.h5",
        last_sum=f"{DATA}/load.h5.sum",
    priority: 100  # long: first
    params:
        code=CODE,
    log:
        f"{LOGS}/load.log",
    message:
        f"load: drive the slider to t = {LOAD_UNTIL} s (6 million steps, about a minute)"
    shell:
        "{BIN}/load -o {output.last} --force --quiet --sum --until {LOAD_UNTIL}"
        " --checkpoint-every {CHECKPOINT_EVERY}"
        " --record {output.record} --record-every 1e-3 2> {log}"


rule events:
    input:
        h5=ancient(f"{DATA}/load-record.h5"),
        sum=f"{DATA}/load-record.h5.sum",
    output:
        f"{DATA}/events.json",
    params:
        code=CODE,
    log:
        f"{LOGS}/events.log",
    message:
        "events: find the rupture events"
    shell:
        "{BIN}/analyze events {input.h5} --json > {output} 2> {log}"
