# Figure 5 B: driven at h = 0, fronts creep between two dynamic events, and stop with the driving.
#
# By hand, with build/release/bin on the PATH (the middle branch; the others are at 0.52-0.62 s):
#     load -o load.h5 --set driving.h=0 --until 0.65 --checkpoint-every 0.01 \
#         --record load-record.h5 --record-every 1e-3
#     restart load-t0.570000000.h5 -o stopped.h5 --set driving.V=0 --for 0.08 \
#         --record stopped-record.h5 --record-every 1e-3
FIG5_PARTS.append(f"{DATA}/fig5/claims-quasistatic.json")
QUASISTATIC_UNTIL = 0.65  # s; the second dynamic event is over by then
QUASISTATIC_EVERY = 0.01  # s
QUASISTATIC_LOADED = checkpoints_of(
    f"{DATA}/fig5/quasistatic-load", until=QUASISTATIC_UNTIL, every=QUASISTATIC_EVERY
)
QUASISTATIC_BRANCHES = range(9)  # at each tenth of the stretch
QUASISTATIC_MIDDLE = 4  # the one that decides, and that is shown until the next dynamic event


use rule load_recorded as quasistatic_load with:
    output: **recorded(f"{DATA}/fig5/quasistatic-load", checkpoints=QUASISTATIC_LOADED)
    priority: 90  # long: first
    params:
        **run_with(
            f"--until {QUASISTATIC_UNTIL} --checkpoint-every {QUASISTATIC_EVERY}",
            changes="--set driving.h=0",
            record_every="1e-3",
        ),
    log: f"{LOGS}/fig5/quasistatic-load.log"
    message: f"fig5: drive the slider at h = 0 to t = {QUASISTATIC_UNTIL} s"


rule quasistatic_stretch:
    input:
        **content_of(h5=f"{DATA}/fig5/quasistatic-load-record.h5"),
        **script("recipes/fig5/quasistatic_stretch.py"),
    output: f"{DATA}/fig5/quasistatic-stretch.json"
    log: f"{LOGS}/fig5/quasistatic-stretch.log"
    message: "fig5: find the quasi-static front"
    shell: "{PYTHON} {input.script} {input.h5} {QUASISTATIC_EVERY} > {output} 2> {log}"


rule quasistatic_stopped:
    input:
        stretch=f"{DATA}/fig5/quasistatic-stretch.json",
        **content_of(checkpoints=QUASISTATIC_LOADED),
    output: **recorded(f"{DATA}/fig5/quasistatic-stopped-{{n}}")
    params:
        code=CODE,
        duration=lambda wildcards: 0.08 if int(wildcards.n) == QUASISTATIC_MIDDLE else 0.02,
    wildcard_constraints: n=r"\d"
    log: f"{LOGS}/fig5/quasistatic-stopped-{{n}}.log"
    message: "fig5: stop the driving at branch {wildcards.n} of the quasi-static front"
    shell:
        "{BIN}/restart"
        " {DATA}/fig5/quasistatic-load-t$({VALUE} {input.stretch} branches.{wildcards.n}).h5"
        " -o {output.h5} --force --quiet --sum --set driving.V=0 --for {params.duration}"
        " --record {output.record} --record-every 1e-3 2> {log}"


# The same over seeds: other slipping times from shortly before the first dynamic event, which renews all
# junctions; the driving stopped when it is in the shown run.
QUASISTATIC_SEEDS_FROM = 0.48  # s
QUASISTATIC_SEEDS_STOP = 0.57  # s


use rule restart_recorded as quasistatic_seed with:
    input: **content_of(h5=f"{DATA}/fig5/quasistatic-load-t{QUASISTATIC_SEEDS_FROM:.9f}.h5")
    output: **recorded(f"{DATA}/fig5/seed-{{seed}}")
    params:
        **run_with(
            f"--seed $((10#{{seed}})) --until {QUASISTATIC_SEEDS_STOP}",
            record_every="1e-3",
        ),
    log: f"{LOGS}/fig5/seed-{{seed}}.log"
    message: "fig5: drive the slider at h = 0 with seed {wildcards.seed}"


use rule restart_recorded as quasistatic_seed_stopped with:
    input: **content_of(h5=f"{DATA}/fig5/seed-{{seed}}.h5")
    output: **recorded(f"{DATA}/fig5/seed-{{seed}}-stopped")
    params: **run_with("--for 0.02", changes="--set driving.V=0", record_every="1e-3")
    log: f"{LOGS}/fig5/seed-{{seed}}-stopped.log"
    message: "fig5: stop the driving with seed {wildcards.seed}"


rule quasistatic_seeds:
    input:
        **content_of(
            driven=[f"{DATA}/fig5/seed-{seed}-record.h5" for seed in SEEDS],
            stopped=[f"{DATA}/fig5/seed-{seed}-stopped-record.h5" for seed in SEEDS],
        ),
        **script("recipes/fig5/quasistatic_seeds.py"),
        stretch_script="recipes/fig5/quasistatic_stretch.py",
    output: f"{DATA}/fig5/quasistatic-seeds.json"
    params: seeds=SEEDS
    log: f"{LOGS}/fig5/quasistatic-seeds.log"
    message: "fig5: measure the quasi-static fronts of all seeds"
    shell: "{PYTHON} {input.script} {DATA}/fig5 {params.seeds} > {output} 2> {log}"


rule quasistatic:
    input:
        stretch=f"{DATA}/fig5/quasistatic-stretch.json",
        **content_of(
            load=f"{DATA}/fig5/quasistatic-load-record.h5",
            stopped=[
                f"{DATA}/fig5/quasistatic-stopped-{n}-record.h5"
                for n in QUASISTATIC_BRANCHES
            ],
        ),
        stretch_script="recipes/fig5/quasistatic_stretch.py",
        **script("recipes/fig5/quasistatic.py"),
    output:
        claims=f"{DATA}/fig5/claims-quasistatic.json",
        **picture(f"{RESULTS}/fig5/fig5B"),
        table=f"{RESULTS}/fig5/quasistatic-tip.csv",
        branches=f"{RESULTS}/fig5/quasistatic-branches.csv",
    log: f"{LOGS}/fig5/quasistatic.log"
    message: "fig5: draw the quasi-static front, compare with the paper's claim"
    shell: "{PYTHON} {input.script} {DATA}/fig5 {RESULTS}/fig5 2> {log}"
