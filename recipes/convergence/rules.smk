import shutil

# Convergence with the time step and the lattice. It decides nothing, and `all` leaves it out.
CONVERGENCE_STEPS = ["1e-7", "5e-8"]  # beside the unchanged 2e-7 s
CONVERGENCE_EVENTS = ["fast-slow-fast", "second-slow", "fast-only"]  # I, II, III


STAGES["start"]["convergence"] = [f"{DATA}/{event}.compared" for event in CONVERGENCE_EVENTS]


use rule restart_recorded as convergence_event with:
    input: **content_of(h5=f"{DATA}/{{event}}.h5")
    output: **recorded(f"{DATA}/convergence/{{event}}-{{dt}}")
    params:
        **run_with(
            f"--for {DURATION}",
            changes=lambda wildcards: f"--set numerics.dt={wildcards.dt}",
        ),
    wildcard_constraints: dt="|".join(CONVERGENCE_STEPS)
    log: f"{LOGS}/convergence/{{event}}-{{dt}}.log"
    message: "convergence: run {wildcards.event} with a time step of {wildcards.dt} s"


# The slider of event I is let go: without load, foundation, drive and junctions its blocks swing freely.
# The first step takes it to forces that are those of the free blocks.
LET_GO = (
    "--set slider.F_N=1e-9 --set slider.foundation=1e-15 --set driving.K=0 --set junctions.kappa=1e-15"
)
FREE_STEPS = 2000  # of 0.2 us


use rule restart as convergence_free_start with:
    input: **content_of(h5=f"{DATA}/fast-slow-fast.h5")
    output: **with_sums(h5=f"{DATA}/convergence/free-start.h5")
    params: **run_with("--for 2e-7", changes=LET_GO)
    log: f"{LOGS}/convergence/free-start.log"
    message: "convergence: let the slider go"


use rule restart as convergence_free_end with:
    input: **content_of(h5=f"{DATA}/convergence/free-start.h5")
    output: **with_sums(h5=f"{DATA}/convergence/free-end.h5")
    params: **run_with(f"--for {FREE_STEPS * 2e-7:.9g}")
    log: f"{LOGS}/convergence/free-end.log"
    message: "convergence: run its free blocks"


rule convergence_lammps:
    input:
        **content_of(
            start=f"{DATA}/convergence/free-start.h5", end=f"{DATA}/convergence/free-end.h5"
        ),
        bulk="benchmarks/lammps/bulk.in",
        compare="benchmarks/lammps/compare.in",
        **script("recipes/convergence/lammps.py"),
    output: f"{DATA}/convergence/lammps.json"
    params: lmp=shutil.which("lmp") or ""
    log: f"{LOGS}/convergence/lammps.log"
    message: "convergence: run them in LAMMPS"
    shell:
        "{PYTHON} {input.script} '{params.lmp}' {input.bulk} {input.compare} {input.start} {input.end}"
        " > {output} 2> {log}"


use rule figure as convergence with:
    input:
        lammps=f"{DATA}/convergence/lammps.json",
        tables=[
            f"{DATA}/convergence/{sweep}.csv"
            for sweep in ("time-step", "lattice-113", "lattice-225")
        ],
        fronts=[f"{DATA}/{event}-front.json" for event in CONVERGENCE_EVENTS],
        finer=[
            f"{DATA}/convergence/{event}-{dt}-front.json"
            for event in CONVERGENCE_EVENTS
            for dt in CONVERGENCE_STEPS
        ],
        **scripts_of("convergence"),
    output:
        results_of(
            "convergence", pictures=["convergence"], tables=["convergence"], own=OWN_RESULTS
        ),
    log: f"{LOGS}/convergence.log"
