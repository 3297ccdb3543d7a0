# Figure S6 B: the map of front types under the decaying law. A grid with one seed decides where
# five are needed.
FIGS6_PARTS.append(f"{DATA}/figS6/claims-map.json")


STAGES["start"]["figS6"] = [f"{DATA}/figS6/boundary.csv"]


rule figS6_boundary:
    input:
        grid=f"{DATA}/figS6/map.csv",
        **script("recipes/common/maps/map_points.py"),
    output: f"{DATA}/figS6/boundary.csv"
    log: f"{LOGS}/figS6/boundary.log"
    message: "figS6: find the places next to another front type"
    shell: "{PYTHON} {input.script} boundary {input.grid} {output} 2> {log}"


rule figS6_map:
    input:
        tables=[f"{DATA}/figS6/{part}.csv" for part in ("map", "map-boundary")],
        boundary=f"{DATA}/figS6/boundary.csv",
        **script("recipes/figS6/map.py"),
    output:
        claims=f"{DATA}/figS6/claims-map.json",
        **picture(f"{RESULTS}/figS6/figS6B"),
        table=f"{RESULTS}/figS6/front-types.csv",
        thresholds=f"{RESULTS}/figS6/thresholds.csv",
    log: f"{LOGS}/figS6/map.log"
    message: "figS6: draw the map, compare with the paper's claim"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/figS6 2> {log}"
