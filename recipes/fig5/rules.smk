# The runs of A are in runs/continuations.smk.
QUASISTATIC_UNTIL = 0.65  # s; the second dynamic event is over by then
QUASISTATIC_EVERY = 0.01  # s
QUASISTATIC_LOADED = checkpoints_of(
    f"{DATA}/fig5/quasistatic-load", until=QUASISTATIC_UNTIL, every=QUASISTATIC_EVERY
)
QUASISTATIC_BRANCHES = range(9)  # at each tenth of the stretch
QUASISTATIC_MIDDLE = 4  # the one that decides, and that is shown until the next dynamic event


use rule load_recorded as quasistatic_load with:
    output: **recorded(f"{DATA}/fig5/quasistatic-load", checkpoints=QUASISTATIC_LOADED)
    log: f"{LOGS}/fig5/quasistatic-load.log"
    priority: 110  # long, and the other seeds wait for it: first
    params:
        **run_with(
            f"--until {QUASISTATIC_UNTIL} --checkpoint-every {QUASISTATIC_EVERY}",
            changes="--set driving.h=0",
            record_every="1e-3",
        ),
    message: f"fig5: drive the slider at h = 0 to t = {QUASISTATIC_UNTIL} s"


rule quasistatic_stretch:
    input:
        **content_of(h5=f"{DATA}/fig5/quasistatic-load-record.h5"),
        **script("recipes/fig5/quasistatic_stretch.py"),
    output: f"{DATA}/fig5/quasistatic-stretch.json"
    log: f"{LOGS}/fig5/quasistatic-stretch.log"
    message: "fig5: find the quasi-static front"
    shell: "{CALL} {input.script} {input.h5} {QUASISTATIC_EVERY} > {output} 2> {log}"


rule quasistatic_stopped:
    input:
        stretch=f"{DATA}/fig5/quasistatic-stretch.json",
        **content_of(checkpoints=QUASISTATIC_LOADED),
    output: **recorded(f"{DATA}/fig5/quasistatic-stopped-{{n}}")
    log: f"{LOGS}/fig5/quasistatic-stopped-{{n}}.log"
    params:
        code=CODE,
        duration=lambda wildcards: 0.08 if int(wildcards.n) == QUASISTATIC_MIDDLE else 0.02,
    wildcard_constraints: n=r"\d"
    message: "fig5: stop the driving at branch {wildcards.n} of the quasi-static front"
    shell:
        "{BIN}/restart"
        " {DATA}/fig5/quasistatic-load-t$({VALUE} {input.stretch} branches.{wildcards.n}).h5"
        " -o {output.h5} --force --quiet --sum --set driving.V=0 --for {params.duration}"
        " --record {output.record} --record-every 1e-3 2> {log}"


# The same over seeds. All share what happens before the first junction breaks, at 0.0378 s.
H0_SEEDS = [str(FIRST_SEED + n) for n in range(20)]
H0_UNTIL = 0.75  # s; the second dynamic event of each is over by then
H0_SHARED = f"{DATA}/fig5/quasistatic-load-t0.030000000"


rule quasistatic_seed:
    input:
        **content_of(h5=f"{H0_SHARED}.h5"),
        undrawn=f"{H0_SHARED}.undrawn",
        script="recipes/fig5/quasistatic_seed.py",
        shared=[
            "recipes/fig5/quasistatic_stretch.py",
            *("python/rupture/files.py", "python/rupture/programs.py"),
        ],
    output: f"{DATA}/ensemble/h0-{{seed}}.json"
    log: f"{LOGS}/ensemble/h0-{{seed}}.log"
    params: code=CODE, folder=f"{DATA}/ensemble/h0-{{seed}}-scratch"
    priority: 90  # long: first
    wildcard_constraints: seed="|".join(H0_SEEDS)
    message: "fig5: drive the slider at h = 0 with seed {wildcards.seed}, and stop the driving"
    shell:
        "{CALL} {input.script} {input.h5} {wildcards.seed} {H0_UNTIL} {QUASISTATIC_EVERY}"
        " {params.folder} > {output} 2> {log}"


figure(
    "fig5",
    pictures=["fig5A", "fig5B"],
    tables=["rupture-lines", "quasistatic-tip", "quasistatic-branches"],
    events=["fast-slow-fast"],
    reads=[
        *(f"fast-slow-fast{run}-{of}" for run in ("", "/undriven") for of in ("front.json", "record.h5")),
        *of_ensemble("load", "continued"),
        *("fig5/quasistatic-load-record.h5", "fig5/quasistatic-stretch.json"),
        *(f"fig5/quasistatic-stopped-{n}-record.h5" for n in QUASISTATIC_BRANCHES),
        *repeated(f"ensemble/h0-{seed}.json" for seed in H0_SEEDS),
    ],
)
