# The runs of A-C are in runs/continuations.smk.
FIG3_RUNS = ["stopped", "no-slow-slip", "t_R-half", "t_R-double"]
FIG3_SHOWN = ("fast-slow-fast", "second-slow")  # I, II
FIG3_SWEEPS = ["slow_slip", "slow_slip_event", "front_speed", "no_slip_force"]
FIG3_OF_SEEDS = ["slow_slip", "front_speed", "front_speed_widths", "no_slip_force"]
L0_SEEDS = range(1, 6)  # the first is shown
L0_REPORTS = [f"fig3/l0-seed-{seed}.json" for seed in L0_SEEDS]


rule fig3_l0_seed:
    input:
        script="recipes/fig3/decay_length.py",
        shared=[
            *("python/rupture/files.py", "python/rupture/programs.py"),
            "recipes/common/events/conventions.py",
        ],
    output: f"{DATA}/fig3/l0-seed-{{seed}}.json"
    log: f"{LOGS}/fig3/l0-seed-{{seed}}.log"
    priority: 80  # long: before what is short
    params: code=CODE, folder=f"{DATA}/fig3/l0-seed-{{seed}}-scratch"
    wildcard_constraints: seed="|".join(map(str, L0_SEEDS))
    message: "fig3: run slow fronts with seed {wildcards.seed}, and fit the decay length ahead of them"
    shell: "{CALL} {input.script} {wildcards.seed} {params.folder} > {output} 2> {log}"


figure(
    "fig3",
    pictures=["fig3", "fig3-l0", "fig3C-inset", "fig3D"],
    tables=["slip", "decay-length", "slow-slip-speed", "front-speed", "no-slip-force"],
    events=FIG3_SHOWN,
    reads=[
        *(f"{event}/{run}-front.json" for event in FIG3_SHOWN for run in FIG3_RUNS),
        *(f"{event}/{run}-record.h5" for event in FIG3_SHOWN for run in (*FIG3_RUNS, "every-step")),
        *(f"{event}-front.json" for event in FIG3_SHOWN),
        *of_ensemble("load", "continued"),
        *(f"fig3/{sweep}.csv" for sweep in FIG3_SWEEPS),
        *repeated(["fig3/front_speed_widths.csv"]),
        *repeated(table for sweep in FIG3_OF_SEEDS for table in tables_of_seeds(f"fig3/{sweep}")),
        *(edge for setting in ("reference", "no-slip-force") for edge in edges(setting, SIGMA_BARS)),
        *repeated(edges("no-slip-force", SIGMA_BARS, range(2, 6))),
        *(L0_REPORTS[0], *repeated(L0_REPORTS[1:])),
    ],
)
