# Claim Geo: does the order of regions in Figure 4 D survive other lengths and nucleation energies?
ROBUSTNESS_PARTS.append(f"{DATA}/robustness/claims-Geo.json")


rule robustness_Geo:
    input:
        table=f"{DATA}/robustness/geometry.csv",
        **script("recipes/robustness/geometry.py"),
    output:
        claims=f"{DATA}/robustness/claims-Geo.json",
        **picture(f"{RESULTS}/robustness/geometry"),
        table=f"{RESULTS}/robustness/geometry.csv",
    log: f"{LOGS}/robustness/Geo.log"
    message: "robustness: draw the maps of other geometries, compare with the claim"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/robustness 2> {log}"
