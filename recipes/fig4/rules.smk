# Figure 4: A-B in wider.smk, C-D here. The chain of commands is in README.md.
FIG4_PARTS = [f"{DATA}/fig4/claims-{part}.json" for part in ("AB", "4C", "4D")]
FIG4_SHOWN = ["fast-slow-fast", "second-slow"]


include: "wider.smk"


# The map of front types: a grid with one seed, then places halfway between fast neighbours and
# others, then five seeds at all places next to another type. Each decides where the next is needed.
STAGES["start"]["fig4"] = [
    f"{DATA}/fig4/between.csv",
    *[f"{DATA}/{event}.compared" for event in FIG4_SHOWN],
]


STAGES["refine"]["fig4"] = [f"{DATA}/fig4/boundary.csv"]


rule fig4_between:
    input:
        grid=f"{DATA}/fig4/map.csv",
        **script("recipes/common/maps/map_points.py"),
    output: f"{DATA}/fig4/between.csv"
    log: f"{LOGS}/fig4/between.log"
    message: "fig4: find where the front type changes"
    shell: "{PYTHON} {input.script} between {input.grid} {output} 2> {log}"


rule fig4_boundary:
    input:
        grid=f"{DATA}/fig4/map.csv",
        between=f"{DATA}/fig4/map-between.csv",
        **script("recipes/common/maps/map_points.py"),
    output: f"{DATA}/fig4/boundary.csv"
    log: f"{LOGS}/fig4/boundary.log"
    message: "fig4: find the places next to another front type"
    shell: "{PYTHON} {input.script} boundary {input.grid} {input.between} {output} 2> {log}"


rule fig4_map:
    input:
        tables=[f"{DATA}/fig4/{part}.csv" for part in ("map", "map-between", "map-boundary")],
        boundary=f"{DATA}/fig4/boundary.csv",
        **script("recipes/fig4/map.py"),
    output:
        claims=f"{DATA}/fig4/claims-4D.json",
        **picture(f"{RESULTS}/fig4/fig4D"),
        table=f"{RESULTS}/fig4/front-types.csv",
        thresholds=f"{RESULTS}/fig4/thresholds.csv",
    log: f"{LOGS}/fig4/map.log"
    message: "fig4: draw D, compare with the paper's claim"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/fig4 2> {log}"


# Prepared interfaces of either shape, the strength of the shapes themselves, and the blocks of
# events I and II and of the ensemble.


rule fig4_strength:
    input:
        prepared=f"{DATA}/fig4/strength.csv",
        curves=f"{DATA}/fig4/strength-curves.csv",
        map=[f"{DATA}/fig4/{part}.csv" for part in ("map", "map-between", "map-boundary", "boundary")],
        events=[f"{DATA}/{event}-strength.json" for event in FIG4_SHOWN],
        fronts=[f"{DATA}/{event}-front.json" for event in FIG4_SHOWN],
        repeated=of_ensemble(f"{DATA}/ensemble/{load}-continued.json" for load in REFERENCE_LOADS),
        **script("recipes/fig4/strength.py"),
    output:
        claims=f"{DATA}/fig4/claims-4C.json",
        **picture(f"{RESULTS}/fig4/fig4C"),
        table=f"{RESULTS}/fig4/strength.csv",
    log: f"{LOGS}/fig4/strength.log"
    message: "fig4: draw C, compare with the paper's claim"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/fig4 {input.repeated} 2> {log}"


use rule join_claims as fig4 with:
    input:
        parts=FIG4_PARTS,
        **script("recipes/common/claims/merge_claims.py"),
    output: f"{RESULTS}/fig4/claims.json"
    log: f"{LOGS}/fig4.log"
    message: "fig4: join the claims of its parts"
