# Claim Geo: does the order of regions in Figure 4 D survive other lengths and nucleation energies?
ROBUSTNESS_PARTS.append(f"{DATA}/robustness/claims-Geo.json")


STAGES["refine"]["robustness"] = [f"{DATA}/robustness/geometry-boundary.csv"]


rule robustness_boundary:
    input:
        grid=f"{DATA}/robustness/geometry.csv",
        **script("recipes/common/maps/map_points.py"),
    output: f"{DATA}/robustness/geometry-boundary.csv"
    log: f"{LOGS}/robustness/geometry-boundary.log"
    message: "robustness: find the places next to another front type"
    shell: "{PYTHON} {input.script} variants {input.grid} {output} 2> {log}"


rule robustness_Geo:
    input:
        table=f"{DATA}/robustness/geometry.csv",
        seeds=of_ensemble([f"{DATA}/robustness/geometry-seeds.csv"]),
        **script("recipes/robustness/geometry.py"),
    output:
        claims=f"{DATA}/robustness/claims-Geo.json",
        **picture(f"{RESULTS}/robustness/geometry"),
        table=f"{RESULTS}/robustness/geometry.csv",
    log: f"{LOGS}/robustness/Geo.log"
    message: "robustness: draw the maps of other geometries, compare with the claim"
    shell:
        "{PYTHON} {input.script} {DATA} {RESULTS}/robustness {input.table} {input.seeds} 2> {log}"
