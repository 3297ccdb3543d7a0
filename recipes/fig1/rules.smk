FIG1 = f"{DATA}/fig1"

# One junction per block, which carries the normal force of a reference junction (F_N/57/100), under
# a small stiff slider without prestress: tau/p = 0 is tau-bar = -mu_d/(mu_s - mu_d).
FIG1_JUNCTION = (
    "--tau-bar -0.7391304347826086 --x-trigger 0 --no-trigger --set junctions.N_s=1"
    " --set slider.Nx=3 --set slider.Nz=3 --set slider.L=5e-3 --set slider.H=5e-3"
    " --set driving.h=2.5e-3 --set slider.F_N=1.01052631578947"
)
FIG1_SLIPPING = ["0.002000000", "0.004600000"]  # s; all three junctions slip then
FIG1_SPEEDS = {
    "range": "--v-from 1e-4 --v-to 1 --points 17",
    "limits": "--v-from 1e-9 --v-to 1e3 --points 2",
}
RUNS["fig1/event"] = run("fast-slow-fast", "--for 0.005", record_every="1e-6")


rule fig1_junctions:
    output: **with_sums(h5=f"{FIG1}/junctions.h5")
    log: f"{LOGS}/fig1/junctions.log"
    params: code=CODE
    message: "fig1: prepare blocks with one junction each"
    shell: "{BIN}/prepare {FIG1_JUNCTION} -o {output.h5} --force --quiet --sum 2> {log}"


use rule restart_recorded as fig1_pull with:
    input: **content_of(h5=f"{FIG1}/junctions.h5")
    output:
        **recorded(
            f"{FIG1}/pulled",
            slipping=[f"{FIG1}/pulled-t{time}.h5" for time in FIG1_SLIPPING],
        ),
    log: f"{LOGS}/fig1/pulled.log"
    params:
        **run_with(
            f"--for 6e-3 --checkpoint-at {' '.join(FIG1_SLIPPING)}",
            changes="--set driving.V=1e-3",
            record_every="2e-7",
        ),
    message: "fig1: pull the blocks at 1 mm/s, and record every step"


rule fig1_steady:
    output: f"{FIG1}/steady-{{speeds}}.json"
    log: f"{LOGS}/fig1/steady-{{speeds}}.log"
    params: code=CODE, speeds=lambda wildcards: FIG1_SPEEDS[wildcards.speeds]
    wildcard_constraints: speeds="|".join(FIG1_SPEEDS)
    message: "fig1: slide a block at constant speeds ({params.speeds})"
    shell:
        "{BIN}/analyze steady-state {params.speeds} --steps-per-cycle 20000 --json"
        " > {output} 2> {log}"


figure(
    "fig1",
    tables=["loading", "events", "block", "junction", "steady-state"],
    events=["fast-slow-fast"],
    reads=[
        *("ensemble/load-01-loading.json", "ensemble/load-01-events.json"),
        *("fig1/event-front.json", "fig1/event-record.h5", "fig1/junctions.h5", "fig1/pulled-record.h5"),
        *(f"fig1/pulled-t{time}.h5" for time in FIG1_SLIPPING),
        *(f"fig1/steady-{speeds}.json" for speeds in FIG1_SPEEDS),
        *of_ensemble("load", "events", "continued"),
    ],
)
