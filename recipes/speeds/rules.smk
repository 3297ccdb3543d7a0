FINE_LOAD = f"{DATA}/speeds/load-{{seed}}"
FINE_STATES = checkpoints_of(FINE_LOAD, until=LOAD_UNTIL, every=CHECKPOINT_EVERY)


use rule load_recorded as speeds_load with:
    output: **recorded(FINE_LOAD, checkpoints=FINE_STATES)
    log: f"{LOGS}/speeds/load-{{seed}}.log"
    priority: 80  # long: before what is short
    params:
        **run_with(
            f"--until {LOAD_UNTIL} --checkpoint-every {CHECKPOINT_EVERY}",
            changes=lambda wildcards: f"--set numerics.seed={wildcards.seed}",
            record_every="1e-4",
        ),
    message: "speeds: drive the slider with seed {wildcards.seed} (about a minute)"


rule speeds_history:
    input:
        **content_of(record=f"{FINE_LOAD}-record.h5", checkpoints=FINE_STATES),
        **script("recipes/speeds/slip_history.py"),
    output: f"{FINE_LOAD}-history.json"
    log: f"{LOGS}/speeds/load-{{seed}}-history.log"
    params: code=CODE
    message: "speeds: measure slip and strength in the load with seed {wildcards.seed}"
    shell: "{CALL} {input.script} {input.record} {input.checkpoints} > {output} 2> {log}"


figure(
    "speeds",
    tables=["speeds", "transients", "gini"],
    own=OWN_RESULTS,
    expected="recipes/speeds/expectations.toml",
    reads=["speeds/fronts.csv", *(f"speeds/load-{FIRST_SEED + n}-history.json" for n in range(5))],
)
