# Beside Figure 3 D: the decay length l_0 ahead of slow fronts, for the seed that is shown and for
# others. decay_length.py says how it is measured.
L0_SEEDS = range(1, 6)
L0_REPORTS = [f"{DATA}/fig3/l0-seed-{seed}.json" for seed in L0_SEEDS]
FIG3_PARTS += [f"{DATA}/fig3/claims-l0.json"]


rule fig3_l0_seed:
    input:
        script="recipes/fig3/decay_length_seed.py",
        shared=[
            f"recipes/{name}.py"
            for name in ("fig3/decay_length", "common/events/conventions", "common/maps/front_map")
        ],
    output: f"{DATA}/fig3/l0-seed-{{seed}}.json"
    priority: 80  # long: before what is short
    params: code=CODE, folder=f"{DATA}/fig3/l0-seed-{{seed}}-scratch"
    wildcard_constraints: seed="|".join(map(str, L0_SEEDS))
    log: f"{LOGS}/fig3-l0-seed-{{seed}}.log"
    message: "fig3: run slow fronts with seed {wildcards.seed}, fit the decay length ahead of them"
    shell: "{PYTHON} {input.script} {BIN} {wildcards.seed} {params.folder} > {output} 2> {log}"


rule fig3_l0:
    input:
        measure="recipes/fig3/decay_length.py",
        shown=L0_REPORTS[0],
        others=of_ensemble(L0_REPORTS[1:]),
        **script("recipes/fig3/decay_length_figure.py"),
    output:
        claims=f"{DATA}/fig3/claims-l0.json",
        **picture(f"{RESULTS}/fig3/fig3-l0"),
        table=f"{RESULTS}/fig3/decay-length.csv",
    log: f"{LOGS}/fig3-l0.log"
    message: "fig3: draw the shear force ahead of slow fronts, compare the decay length"
    shell:
        "{PYTHON} {input.script} {RESULTS}/fig3 {output.claims} {input.shown} {input.others}"
        " 2> {log}"
