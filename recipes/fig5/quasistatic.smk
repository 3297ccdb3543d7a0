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
QUASISTATIC_LOADED = [
    f"{DATA}/fig5/quasistatic-load-t{n * QUASISTATIC_EVERY:.9f}.h5"
    for n in range(1, round(QUASISTATIC_UNTIL / QUASISTATIC_EVERY) + 1)
]
QUASISTATIC_BRANCHES = range(9)  # at each tenth of the stretch
QUASISTATIC_MIDDLE = 4  # the one that decides, and that is shown until the next dynamic event


rule quasistatic_load:
    output:
        record=f"{DATA}/fig5/quasistatic-load-record.h5",
        sum=f"{DATA}/fig5/quasistatic-load-record.h5.sum",
        checkpoints=QUASISTATIC_LOADED,
        checkpoint_sums=[f"{path}.sum" for path in QUASISTATIC_LOADED],
        last=f"{DATA}/fig5/quasistatic-load.h5",
        last_sum=f"{DATA}/fig5/quasistatic-load.h5.sum",
    priority: 90  # long: first
    params:
        code=CODE,
    log:
        f"{LOGS}/fig5/quasistatic-load.log",
    message:
        f"fig5: drive the slider at h = 0 to t = {QUASISTATIC_UNTIL} s"
    shell:
        "{BIN}/load -o {output.last} --force --quiet --sum --set driving.h=0"
        " --until {QUASISTATIC_UNTIL} --checkpoint-every {QUASISTATIC_EVERY}"
        " --record {output.record} --record-every 1e-3 2> {log}"


rule quasistatic_stretch:
    input:
        h5=ancient(f"{DATA}/fig5/quasistatic-load-record.h5"),
        sum=f"{DATA}/fig5/quasistatic-load-record.h5.sum",
        script="recipes/fig5/quasistatic_stretch.py",
        common=COMMON,
    output:
        f"{DATA}/fig5/quasistatic-stretch.json",
    log:
        f"{LOGS}/fig5/quasistatic-stretch.log",
    message:
        "fig5: find the quasi-static front"
    shell:
        "{PYTHON} {input.script} {input.h5} {QUASISTATIC_EVERY} > {output} 2> {log}"


rule quasistatic_stopped:
    input:
        stretch=f"{DATA}/fig5/quasistatic-stretch.json",
        checkpoints=ancient(QUASISTATIC_LOADED),
        sums=[f"{path}.sum" for path in QUASISTATIC_LOADED],
    output:
        h5=f"{DATA}/fig5/quasistatic-stopped-{{n}}.h5",
        sum=f"{DATA}/fig5/quasistatic-stopped-{{n}}.h5.sum",
        record=f"{DATA}/fig5/quasistatic-stopped-{{n}}-record.h5",
        record_sum=f"{DATA}/fig5/quasistatic-stopped-{{n}}-record.h5.sum",
    params:
        code=CODE,
        duration=lambda wildcards: 0.08 if int(wildcards.n) == QUASISTATIC_MIDDLE else 0.02,
    wildcard_constraints:
        n=r"\d",
    log:
        f"{LOGS}/fig5/quasistatic-stopped-{{n}}.log",
    message:
        "fig5: stop the driving at branch {wildcards.n} of the quasi-static front"
    shell:
        "{BIN}/restart"
        " {DATA}/fig5/quasistatic-load-t$({VALUE} {input.stretch} branches.{wildcards.n}).h5"
        " -o {output.h5} --force --quiet --sum --set driving.V=0 --for {params.duration}"
        " --record {output.record} --record-every 1e-3 2> {log}"


# The same over seeds: other slipping times from shortly before the first dynamic event, which renews all
# junctions; the driving stopped when it is in the shown run.
QUASISTATIC_SEEDS_FROM = 0.48  # s
QUASISTATIC_SEEDS_STOP = 0.57  # s


rule quasistatic_seed:
    input:
        h5=ancient(f"{DATA}/fig5/quasistatic-load-t{QUASISTATIC_SEEDS_FROM:.9f}.h5"),
        sum=f"{DATA}/fig5/quasistatic-load-t{QUASISTATIC_SEEDS_FROM:.9f}.h5.sum",
    output:
        h5=f"{DATA}/fig5/seed-{{seed}}.h5",
        sum=f"{DATA}/fig5/seed-{{seed}}.h5.sum",
        record=f"{DATA}/fig5/seed-{{seed}}-record.h5",
        record_sum=f"{DATA}/fig5/seed-{{seed}}-record.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/fig5/seed-{{seed}}.log",
    message:
        "fig5: drive the slider at h = 0 with seed {wildcards.seed}"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum"
        " --seed $((10#{wildcards.seed})) --until {QUASISTATIC_SEEDS_STOP}"
        " --record {output.record} --record-every 1e-3 2> {log}"


rule quasistatic_seed_stopped:
    input:
        h5=ancient(f"{DATA}/fig5/seed-{{seed}}.h5"),
        sum=f"{DATA}/fig5/seed-{{seed}}.h5.sum",
    output:
        h5=f"{DATA}/fig5/seed-{{seed}}-stopped.h5",
        sum=f"{DATA}/fig5/seed-{{seed}}-stopped.h5.sum",
        record=f"{DATA}/fig5/seed-{{seed}}-stopped-record.h5",
        record_sum=f"{DATA}/fig5/seed-{{seed}}-stopped-record.h5.sum",
    params:
        code=CODE,
    log:
        f"{LOGS}/fig5/seed-{{seed}}-stopped.log",
    message:
        "fig5: stop the driving with seed {wildcards.seed}"
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum --set driving.V=0"
        " --for 0.02 --record {output.record} --record-every 1e-3 2> {log}"


rule quasistatic_seeds:
    input:
        driven=ancient([f"{DATA}/fig5/seed-{seed}-record.h5" for seed in SEEDS]),
        driven_sums=[f"{DATA}/fig5/seed-{seed}-record.h5.sum" for seed in SEEDS],
        stopped=ancient([f"{DATA}/fig5/seed-{seed}-stopped-record.h5" for seed in SEEDS]),
        stopped_sums=[f"{DATA}/fig5/seed-{seed}-stopped-record.h5.sum" for seed in SEEDS],
        script="recipes/fig5/quasistatic_seeds.py",
        stretch_script="recipes/fig5/quasistatic_stretch.py",
        common=COMMON,
    output:
        f"{DATA}/fig5/quasistatic-seeds.json",
    params:
        seeds=SEEDS,
    log:
        f"{LOGS}/fig5/quasistatic-seeds.log",
    message:
        "fig5: measure the quasi-static fronts of all seeds"
    shell:
        "{PYTHON} {input.script} {DATA}/fig5 {params.seeds} > {output} 2> {log}"


rule quasistatic:
    input:
        stretch=f"{DATA}/fig5/quasistatic-stretch.json",
        load=ancient(f"{DATA}/fig5/quasistatic-load-record.h5"),
        load_sum=f"{DATA}/fig5/quasistatic-load-record.h5.sum",
        stopped=ancient(
            [f"{DATA}/fig5/quasistatic-stopped-{n}-record.h5" for n in QUASISTATIC_BRANCHES]
        ),
        sums=[f"{DATA}/fig5/quasistatic-stopped-{n}-record.h5.sum" for n in QUASISTATIC_BRANCHES],
        stretch_script="recipes/fig5/quasistatic_stretch.py",
        script="recipes/fig5/quasistatic.py",
        common=COMMON,
    output:
        claims=f"{DATA}/fig5/claims-quasistatic.json",
        png=f"{RESULTS}/fig5/fig5B.png",
        pdf=f"{RESULTS}/fig5/fig5B.pdf",
        table=f"{RESULTS}/fig5/quasistatic-tip.csv",
        branches=f"{RESULTS}/fig5/quasistatic-branches.csv",
    log:
        f"{LOGS}/fig5/quasistatic.log",
    message:
        "fig5: draw the quasi-static front, compare with the paper's claim"
    shell:
        "{PYTHON} {input.script} {DATA}/fig5 {RESULTS}/fig5 2> {log}"
