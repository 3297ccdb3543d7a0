# The ensemble over seeds (runs/ensemble.smk): how typical the events are that the figures show. The
# chain of commands is in README.md.
ENSEMBLE_RUNS = ["stopped", "no-slow-slip", "wider", "undriven"]
ENSEMBLE_MEASURED = ["fast-slow-fast", *ENSEMBLE_EVENTS]


STAGES["start"]["ensemble"] = [
    f"{DATA}/ensemble/choice.json",
    f"{DATA}/fast-slow-fast.compared",
]


rule ensemble:
    input:
        choice=f"{DATA}/ensemble/choice.json",
        events=[f"{DATA}/ensemble/run-{seed}-events.json" for seed in SEEDS],
        fronts=[f"{DATA}/{event}-front.json" for event in ENSEMBLE_MEASURED],
        continued=[
            f"{DATA}/{event}/{run}-front.json"
            for event in ENSEMBLE_MEASURED
            for run in ENSEMBLE_RUNS
        ],
        slips=[f"{DATA}/{event}/{run}-slip.json" for event in ENSEMBLE_MEASURED for run in SLIPS],
        phi=[
            f"{DATA}/{event}{state}-phi.json"
            for event in ENSEMBLE_MEASURED
            for state in ("", "/wider-start")
        ],
        quasistatic=f"{DATA}/fig5/quasistatic-seeds.json",
        quasistatic_shown=f"{DATA}/fig5/claims-quasistatic.json",
        **script("recipes/ensemble/figure.py"),
    output:
        claims=f"{RESULTS}/ensemble/claims.json",
        ensemble=f"{RESULTS}/ensemble/ensemble.json",
        table=f"{RESULTS}/ensemble/ensemble.csv",
        events=f"{RESULTS}/ensemble/events.csv",
        **picture(f"{RESULTS}/ensemble/ensemble"),
        summary=f"{RESULTS}/ensemble/summary.txt",
    log: f"{LOGS}/ensemble.log"
    message: "ensemble: draw, compare the shown event with the others"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/ensemble {input.events} 2> {log}"
