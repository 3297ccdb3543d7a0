# Twenty more seeds: the reference slider continued from t = 0.6 s, between two spanning events, each
# time with other slipping times. The first spanning event after that still starts from the shared
# history and is left out; it renews all junctions. The two after it count: events with and without a
# slow stretch tend to alternate, so a third would favour one kind (recipes/ensemble/README.md).
SEEDS = [f"{seed:02d}" for seed in range(2, 22)]
SEEDS_FROM = 0.6  # [s]
SEEDS_UNTIL = 0.82  # [s]
SEED_CHECKPOINTS = [
    SEEDS_FROM + n * CHECKPOINT_EVERY
    for n in range(1, int((SEEDS_UNTIL - SEEDS_FROM) / CHECKPOINT_EVERY) + 1)
]


wildcard_constraints:
    seed=r"\d\d",


rule ensemble_run:
    input:
        h5=ancient(f"{DATA}/load-t{SEEDS_FROM:.9f}.h5"),
        sum=f"{DATA}/load-t{SEEDS_FROM:.9f}.h5.sum",
    output:
        h5=f"{DATA}/ensemble/run-{{seed}}.h5",
        sum=f"{DATA}/ensemble/run-{{seed}}.h5.sum",
        record=f"{DATA}/ensemble/run-{{seed}}-record.h5",
        record_sum=f"{DATA}/ensemble/run-{{seed}}-record.h5.sum",
        checkpoints=[f"{DATA}/ensemble/run-{{seed}}-t{t:.9f}.h5" for t in SEED_CHECKPOINTS],
        checkpoint_sums=[f"{DATA}/ensemble/run-{{seed}}-t{t:.9f}.h5.sum" for t in SEED_CHECKPOINTS],
    priority: 80  # long: first
    params:
        code=CODE,
    log:
        f"{LOGS}/ensemble/run-{{seed}}.log",
    message:
        "ensemble: run seed {wildcards.seed}"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum"
        " --seed $((10#{wildcards.seed})) --until {SEEDS_UNTIL}"
        " --checkpoint-every {CHECKPOINT_EVERY}"
        " --record {output.record} --record-every 1e-3 2> {log}"


rule ensemble_events:
    input:
        h5=ancient(f"{DATA}/ensemble/run-{{seed}}-record.h5"),
        sum=f"{DATA}/ensemble/run-{{seed}}-record.h5.sum",
    output:
        f"{DATA}/ensemble/run-{{seed}}-events.json",
    params:
        code=CODE,
    log:
        f"{LOGS}/ensemble/run-{{seed}}-events.log",
    message:
        "ensemble: find the events of seed {wildcards.seed}"
    shell:
        "{BIN}/analyze events {input.h5} --json > {output} 2> {log}"


rule ensemble_choice:
    input:
        events=[f"{DATA}/ensemble/run-{seed}-events.json" for seed in SEEDS],
        script="recipes/ensemble/choose.py",
        common=COMMON,
    output:
        f"{DATA}/ensemble/choice.json",
    log:
        f"{LOGS}/ensemble/choice.log",
    message:
        "ensemble: choose the first event of each seed that slows down"
    shell:
        "{PYTHON} {input.script} {CHECKPOINT_EVERY} {input.events} > {output} 2> {log}"


rule ensemble_event_start:
    input:
        choice=f"{DATA}/ensemble/choice.json",
        checkpoints=ancient(rules.ensemble_run.output.checkpoints),
        sums=rules.ensemble_run.output.checkpoint_sums,
    output:
        h5=f"{DATA}/ensemble/seed-{{seed}}.h5",
        sum=f"{DATA}/ensemble/seed-{{seed}}.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/ensemble/seed-{{seed}}-start.log",
    message:
        "ensemble: go to 0.5 ms before the event of seed {wildcards.seed}"
    shell:
        "{BIN}/restart"
        " {DATA}/ensemble/run-{wildcards.seed}-t$({VALUE} {input.choice} seed-{wildcards.seed}.from).h5"
        " -o {output.h5} --force --quiet --sum"
        " --until $({VALUE} {input.choice} seed-{wildcards.seed}.until) 2> {log}"


def seeds_with_event():
    """The seeds for which `rule ensemble_choice` has found an event; none before it has run."""
    choice = Path(f"{DATA}/ensemble/choice.json")
    if not choice.exists():
        return []
    return [seed for seed, start in json.loads(choice.read_text()).items() if start]


# The events {event} of the ensemble. Whoever uses them has a rule *_start that asks for
# ensemble_choice's output, so that this is known when it counts.
ENSEMBLE_EVENTS = [f"ensemble/{seed}" for seed in seeds_with_event()]
