# Twenty more seeds: the reference slider continued from t = 0.6 s, between two spanning events, each
# time with other slipping times. The first spanning event after that still starts from the shared
# history and is left out; it renews all junctions. The two after it count: events with and without a
# slow stretch tend to alternate, so a third would favour one kind (recipes/ensemble/README.md).
SEEDS = [f"{seed:02d}" for seed in range(2, 22)]
SEEDS_FROM = 0.6  # [s]
SEEDS_UNTIL = 0.82  # [s]
SEED_CHECKPOINTS = checkpoints_of(
    f"{DATA}/ensemble/run-{{seed}}",
    start=SEEDS_FROM,
    until=SEEDS_UNTIL,
    every=CHECKPOINT_EVERY,
)


wildcard_constraints: seed=r"\d\d"


use rule restart_recorded as ensemble_run with:
    input: **content_of(h5=f"{DATA}/load-t{SEEDS_FROM:.9f}.h5")
    output: **recorded(f"{DATA}/ensemble/run-{{seed}}", checkpoints=SEED_CHECKPOINTS)
    priority: 80  # long: first
    params:
        **run_with(
            f"--seed $((10#{{seed}})) --until {SEEDS_UNTIL} --checkpoint-every {CHECKPOINT_EVERY}",
            record_every="1e-3",
        ),
    log: f"{LOGS}/ensemble/run-{{seed}}.log"
    message: "ensemble: run seed {wildcards.seed}"


use rule analyze as ensemble_events with:
    input: **content_of(h5=f"{DATA}/ensemble/run-{{seed}}-record.h5")
    output: f"{DATA}/ensemble/run-{{seed}}-events.json"
    params: **analysis("events")
    log: f"{LOGS}/ensemble/run-{{seed}}-events.log"
    message: "ensemble: find the events of seed {wildcards.seed}"


rule ensemble_choice:
    input:
        events=[f"{DATA}/ensemble/run-{seed}-events.json" for seed in SEEDS],
        **script("recipes/ensemble/choose.py"),
    output: f"{DATA}/ensemble/choice.json"
    log: f"{LOGS}/ensemble/choice.log"
    message: "ensemble: choose the first event of each seed that slows down"
    shell: "{PYTHON} {input.script} {CHECKPOINT_EVERY} {input.events} > {output} 2> {log}"


use rule restart_before_event as ensemble_event_start with:
    input:
        choice=f"{DATA}/ensemble/choice.json",
        **content_of(checkpoints=SEED_CHECKPOINTS),
    output: **with_sums(h5=f"{DATA}/ensemble/seed-{{seed}}.h5")
    params: **event_of(f"{DATA}/ensemble/run-{{seed}}", "seed-{seed}")
    log: f"{LOGS}/ensemble/seed-{{seed}}-start.log"
    message: "ensemble: go to 0.5 ms before the event of seed {wildcards.seed}"


def seeds_with_event():
    """The seeds for which `rule ensemble_choice` has found an event; none before it has run."""
    choice = Path(f"{DATA}/ensemble/choice.json")
    if not choice.exists():
        return []
    return [seed for seed, start in json.loads(choice.read_text()).items() if start]


# The events {event} of the ensemble. Whoever uses them has a rule *_start that asks for
# ensemble_choice's output, so that this is known when it counts.
ENSEMBLE_EVENTS = [f"ensemble/{seed}" for seed in seeds_with_event()]
