# How fast blocks slip and fronts run (fronts.ini), and what the history of slip says about strength. The
# chains of commands are in README.md.
HISTORY_SEEDS = range(FIRST_SEED, FIRST_SEED + 5)
HISTORY_LOAD = f"{DATA}/speeds/load-{{seed}}"
HISTORY_STATES = checkpoints_of(HISTORY_LOAD, until=LOAD_UNTIL, every=CHECKPOINT_EVERY)


use rule load_recorded as speeds_load with:
    output: **recorded(HISTORY_LOAD, checkpoints=HISTORY_STATES)
    priority: 80  # long: before what is short
    params:
        **run_with(
            f"--until {LOAD_UNTIL} --checkpoint-every {CHECKPOINT_EVERY}",
            changes=lambda wildcards: f"--set numerics.seed={wildcards.seed}",
            record_every="1e-4",
        ),
    wildcard_constraints: seed="[0-9]{3}"
    log: f"{HISTORY_LOAD.replace(DATA, LOGS)}.log"
    message: f"speeds: drive the slider to t = {LOAD_UNTIL} s with seed {{wildcards.seed}} (about a minute)"


rule speeds_history:
    input:
        **content_of(record=f"{HISTORY_LOAD}-record.h5", checkpoints=HISTORY_STATES),
        **script("recipes/speeds/slip_history.py"),
    output: f"{HISTORY_LOAD}-history.json"
    params: code=CODE
    log: f"{HISTORY_LOAD.replace(DATA, LOGS)}-history.log"
    message: "speeds: measure slip and strength in the load with seed {wildcards.seed}"
    shell: "{PYTHON} {input.script} {input.record} {input.checkpoints} > {output} 2> {log}"


use rule figure as speeds with:
    input:
        fronts=f"{DATA}/speeds/fronts.csv",
        histories=[f"{DATA}/speeds/load-{seed}-history.json" for seed in HISTORY_SEEDS],
        expected="recipes/speeds/expectations.toml",
        **scripts_of("speeds"),
    output:
        results_of(
            "speeds", pictures=["speeds"], tables=["speeds", "transients", "gini"], own=OWN_RESULTS
        ),
    log: f"{LOGS}/speeds.log"
