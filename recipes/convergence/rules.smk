# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

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


rule convergence:
    input:
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
        **script("recipes/convergence/figure.py"),
    output:
        claims=f"{RESULTS}/convergence/claims.json",
        own=f"{RESULTS}/convergence/own.json",
        summary=f"{RESULTS}/convergence/summary.txt",
        **picture(f"{RESULTS}/convergence/convergence"),
        table=f"{RESULTS}/convergence/convergence.csv",
    log: f"{LOGS}/convergence.log"
    message: "convergence: draw, list what changes with time step and lattice"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/convergence 2> {log}"
