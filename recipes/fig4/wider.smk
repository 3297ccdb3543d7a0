# Figure 4 A-B: the fast-slow-fast event, and the same with a wider distribution of junction forces
# (runs/continuations.smk).
rule fig4_wider:
    input:
        fronts=[f"{DATA}/fast-slow-fast-front.json", f"{DATA}/fast-slow-fast/wider-front.json"],
        phi=[f"{DATA}/fast-slow-fast-phi.json", f"{DATA}/fast-slow-fast/wider-start-phi.json"],
        **content_of(
            records=[f"{DATA}/fast-slow-fast-record.h5", f"{DATA}/fast-slow-fast/wider-record.h5"],
        ),
        **script("recipes/fig4/wider.py"),
    output:
        claims=f"{DATA}/fig4/claims-AB.json",
        **picture(f"{RESULTS}/fig4/fig4AB"),
    log: f"{LOGS}/fig4-wider.log"
    message: "fig4: draw A-B, compare with the paper's claim"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/fig4 {output.claims} 2> {log}"
