# Edges between types of fronts on prepared interfaces (maps/edges.py), by the name of a setting.
EDGES = {  # setting: options of `prepare`
    "reference": "",
    "no-slow-slip": "--set junctions.f_new=f_slip",
    "no-slip-force": "--set junctions.mu_d=0",
    **{
        f"d_R-{d}-um": "--set junctions.law=distance"
        f" --set junctions.d_R={d}um --set junctions.delta_d_R={0.3 * d:.2g}um"
        for d in (0.3, 1, 3, 10)
    },
}
EDGE_SIGMAS = ["0", "0.05", "0.1", "0.16", "0.2", "0.25", "0.285"]  # sigma_bar of claim edge


def edges(setting, sigmas, seeds=(1,)):
    return [f"edges/{setting}-{sigma}-{seed}.json" for sigma in sigmas for seed in seeds]


rule edges:
    input: **script("recipes/common/maps/edges.py")
    output: f"{DATA}/edges/{{setting}}-{{sigma}}-{{seed}}.json"
    log: f"{LOGS}/edges/{{setting}}-{{sigma}}-{{seed}}.log"
    params:
        code=CODE,
        folder=f"{DATA}/edges/{{setting}}-{{sigma}}-{{seed}}-scratch",
        options=lambda wildcards: EDGES[wildcards.setting],
    wildcard_constraints: setting=".+", sigma="[0-9.]+", seed="[0-9]+"
    message: "edges: bisect tau_bar_0 at sigma_bar = {wildcards.sigma}, {wildcards.setting}"
    shell:
        "{CALL} {input.script} {params.folder} {wildcards.sigma} {params.options}"
        " --set numerics.seed={wildcards.seed} > {output} 2> {log}"
