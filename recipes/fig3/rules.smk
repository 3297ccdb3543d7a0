# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

# Figure 3. A-C here: events I and II restarted under other conditions
# (runs/continuations.smk). Each other part of Figure 3 has a file of its own beside this
# one, which adds the claims it writes to FIG3_PARTS. See README.md.
FIG3_RUNS = ["stopped", "no-slow-slip", "t_R-half", "t_R-double"]
FIG3_EVENTS = [f"{DATA}/{event}" for event in ("fast-slow-fast", "second-slow")]  # I, II
FIG3_PARTS = [f"{DATA}/fig3/claims-ABC.json"]


STAGES["start"]["fig3"] = [f"{event}.compared" for event in FIG3_EVENTS]


rule fig3_ABC:
    input:
        fronts=[f"{event}/{run}-front.json" for event in FIG3_EVENTS for run in FIG3_RUNS],
        **content_of(
            records=[f"{event}/{run}-record.h5" for event in FIG3_EVENTS for run in FIG3_RUNS]
        ),
        slips=[f"{event}/{run}-slip.json" for event in FIG3_EVENTS for run in SLIPS],
        unmodified=[f"{event}-front.json" for event in FIG3_EVENTS],
        continued=of_ensemble(f"{DATA}/ensemble/{load}-continued.json" for load in REFERENCE_LOADS),
        **script("recipes/fig3/figure.py"),
    output:
        claims=f"{DATA}/fig3/claims-ABC.json",
        **picture(f"{RESULTS}/fig3/fig3"),
        table=f"{RESULTS}/fig3/slip.csv",
    log: f"{LOGS}/fig3.log"
    message: "fig3: draw A-C, compare with the paper's claims"
    shell: "{PYTHON} {input.script} {DATA} {RESULTS}/fig3 {output.claims} {input.continued} 2> {log}"


# Slow slip behind the slow fronts of sweeps over prepared interfaces, in several windows. What the script
# imports is named one by one: this is long, and does not depend on how claims are judged.
WINDOWS_OF = ["slow_slip", "front_speed", "front_speed_phi", "front_speed_widths"]


def windows(sweep):
    return f"{DATA}/fig3/{sweep}-windows.json"


def windows_of_seeds(*sweeps):
    """Those of the other seeds."""
    tables = [table for sweep in sweeps for table in tables_of_seeds(f"fig3/{sweep}")]
    return of_ensemble(table.replace(".csv", "-windows.json") for table in tables)


# Tables first, by a call of their own: one that comes out equal asks for no new measurement.
STAGES["start"]["fig3"] += [
    path.replace("-windows.json", ".csv")
    for path in (
        *map(windows, ("slow_slip", "front_speed", "front_speed_phi")),
        *of_ensemble([windows("front_speed_widths")]),
        *windows_of_seeds(*WINDOWS_OF),
    )
]


rule fig3_windows:
    input:
        table=f"{DATA}/fig3/{{table}}.csv",
        script="recipes/fig3/measure_slow_slip.py",
        shared=[
            f"recipes/{name}.py"
            for name in (
                "fig3/slow_fronts", "data/tables", "events/conventions", "maps/front_map", "sweeps/point"
            )
        ],
    output: f"{DATA}/fig3/{{table}}-windows.json"
    priority: 60  # long: before what is short
    params: code=CODE
    wildcard_constraints: table=f"({'|'.join(WINDOWS_OF)})(-seed-[0-9]+)?"
    log: f"{LOGS}/fig3-{{table}}-windows.log"
    message: "fig3: measure the slow slip of {wildcards.table} in several windows (a minute or two)"
    shell: "{PYTHON} {input.script} {BIN} {input.table} {POINTS} {output} 2> {log}"


for part in sorted(set(Path("recipes/fig3").glob("*.smk")) - {Path("recipes/fig3/rules.smk")}):
    include: part.name


use rule join_claims as fig3 with:
    input:
        parts=FIG3_PARTS,
        **script("recipes/claims/merge_claims.py"),
    output: f"{RESULTS}/fig3/claims.json"
    log: f"{LOGS}/fig3-claims.log"
    message: "fig3: join the claims"
