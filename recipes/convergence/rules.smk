import shutil

CONVERGENCE_RUNS = {
    f"convergence/{event}-{dt}": run(event, f"--for {DURATION}", f"--set numerics.dt={dt}")
    for event in EVENTS
    for dt in ("1e-7", "5e-8")  # beside the unchanged 2e-7 s
}
RUNS |= CONVERGENCE_RUNS


# The slider of event I is released: without load, foundation, drive and junctions its blocks oscillate freely.
# The first step takes it to forces that are those of the free blocks.
LET_GO = (
    "--set slider.F_N=1e-9 --set slider.foundation=1e-15 --set driving.K=0 --set junctions.kappa=1e-15"
)
FREE = {"": "", "-both": " --set slider.edge_springs=half --set slider.damping_along=spring"}
for name, change in FREE.items():
    RUNS[f"convergence/let-go{name}"] = run("fast-slow-fast", "--for 2e-7", LET_GO + change)
    RUNS[f"convergence/free{name}"] = run(f"convergence/let-go{name}-end", "--for 0.0004")


rule convergence_lammps:
    input:
        **content_of(
            start=f"{DATA}/convergence/let-go{{of}}-end.h5",
            end=f"{DATA}/convergence/free{{of}}-end.h5",
        ),
        bulk="benchmarks/lammps/bulk.in",
        compare="benchmarks/lammps/compare.in",
        **script("recipes/convergence/lammps.py"),
    output: f"{DATA}/convergence/lammps{{of}}.json"
    log: f"{LOGS}/convergence/lammps{{of}}.log"
    wildcard_constraints: of="|".join(FREE)
    params: lmp=shutil.which("lmp") or ""  # :q would leave out an empty word
    message: "convergence: run the free blocks in LAMMPS"
    shell:
        "{CALL} {input.script} '{params.lmp}' {input.bulk} {input.compare} {input.start} {input.end}"
        " > {output} 2> {log}"


# Edges on finer lattices. On 449 x 241 blocks, four core-hours are enough only where nothing creeps.
NO_SLOW_SLIP, HALF = EDGES["no-slow-slip"], "--set slider.edge_springs=half"
LATTICE_EDGES = {  # setting: options of `prepare`, blocks along x
    "reference": ("", [57, 113, 225]),
    "reference-half": (HALF, [57, 113, 225]),
    "no-slow-slip": (NO_SLOW_SLIP, [57, 113, 225, 449]),
    "no-slow-slip-half": (f"{NO_SLOW_SLIP} {HALF}", [57, 113, 225]),
    "no-slow-slip-per-length": (NO_SLOW_SLIP, [57, 113, 225]),
}


def junctions_per_block(setting, N_x):
    return 104 * 56 // (int(N_x) - 1) if setting.endswith("-per-length") else 100


rule convergence_edges:
    input:
        coarser=lambda wildcards: [
            f"{DATA}/convergence/{wildcards.setting}-{wildcards.sigma}-{N_x}.json"
            for N_x in LATTICE_EDGES[wildcards.setting][1]
            if N_x < int(wildcards.N_x)
        ],
        **script("recipes/convergence/lattice.py"),
    output: f"{DATA}/convergence/{{setting}}-{{sigma}}-{{N_x}}.json"
    log: f"{LOGS}/convergence/{{setting}}-{{sigma}}-{{N_x}}.log"
    params:
        code=CODE,
        folder=f"{DATA}/convergence/{{setting}}-{{sigma}}-{{N_x}}-scratch",
        N_s=lambda wildcards: junctions_per_block(wildcards.setting, wildcards.N_x),
        options=lambda wildcards: LATTICE_EDGES[wildcards.setting][0],
    wildcard_constraints: setting="|".join(LATTICE_EDGES), sigma="[0-9.]+", N_x="[0-9]+"
    priority: 10  # long, and finer ones wait for it
    message: "convergence: bisect tau_bar_0, {wildcards.setting}-{wildcards.sigma}-{wildcards.N_x}"
    shell:
        "{CALL} {input.script} {params.folder} {wildcards.N_x} {params.N_s} {wildcards.sigma}"
        " '{params.options}' {input.coarser} > {output} 2> {log}"


figure(
    "convergence",
    tables=["convergence", "edges"],
    own=OWN_RESULTS,
    events=EVENTS,
    reads=[
        "convergence/time-step.csv",
        *(f"convergence/lammps{name}.json" for name in FREE),
        *(
            f"convergence/{setting}-{sigma}-{N_x}.json"
            for setting, (_, lattices) in LATTICE_EDGES.items()
            for sigma in ("0", "0.1", "0.285")
            for N_x in lattices
        ),
        *(f"{event}-front.json" for event in EVENTS),
        *(f"{run}-front.json" for run in CONVERGENCE_RUNS),
    ],
)
