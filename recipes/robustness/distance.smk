# The distance law, a question of our own: are there slow fronts without a time scale?
rule robustness_distance:
    input:
        table=f"{DATA}/robustness/distance.csv",
        unmodified=f"{ROBUSTNESS_EVENT}-front.json",
        continued=f"{ROBUSTNESS_EVENT}/distance-front.json",
        **script("recipes/robustness/distance.py"),
    output:
        own=f"{RESULTS}/robustness/own.json",
        summary=f"{RESULTS}/robustness/summary.txt",
        **picture(f"{RESULTS}/robustness/distance"),
        table=f"{RESULTS}/robustness/distance.csv",
    log: f"{LOGS}/robustness/distance.log"
    message: "robustness: draw the fronts under the distance law"
    shell:
        "{PYTHON} {input.script} {DATA} {input.unmodified} {input.continued}"
        " {RESULTS}/robustness 2> {log}"
