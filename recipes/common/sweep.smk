# Sweeps (sweeps.py): recipes/NAME/SWEEP.ini becomes the table results/data/NAME/SWEEP.csv. Of a user's
# own sweep (--config sweep=FILE), only the points are made here: its table is written even if a point
# cannot be computed (recipes/sweep/).
from common.sweeps import is_sweep, read_sweep

SWEEPS = {
    f"{path.parent.name}/{path.stem}": read_sweep(path)
    for path in sorted(Path("recipes").glob("*/*.ini"))
    if is_sweep(path)
}
OWN = read_sweep(config["sweep"]) if "sweep" in config else None
ALL_SWEEPS = [*([OWN] if OWN else []), *SWEEPS.values()]
POINTS = {point.id: point for sweep in ALL_SWEEPS for point in sweep.points}
NEEDS = {point.id: sweep.needs for sweep in reversed(ALL_SWEEPS) for point in sweep.points}


def files_of(sweep):
    return [f"{DATA}/points/{point.id}.json" for point in sweep.points]


def base_of(point):
    """What the point starts from. One that the recipes make counts by content (Snakefile)."""
    if point.base.startswith(f"{DATA}/"):
        return [ancient(point.base), f"{point.base}.sum"]
    return [point.base] if point.base else []


def values_of(point):
    return ", ".join(f"{name} {value}" for name, value in point.values.items())


rule point:
    input:
        base=lambda wildcards: base_of(POINTS[wildcards.id]),
        script="recipes/common/point.py",
    output:
        f"{DATA}/points/{{id}}.json",
    params:
        code=CODE,
        commands=lambda wildcards: [
            f"{name}={line}" for name, line in POINTS[wildcards.id].commands.items()
        ],
        base=lambda wildcards: shlex.quote(POINTS[wildcards.id].base),  # also if there is none
    wildcard_constraints:
        id="[0-9a-f]{16}",
    threads: lambda wildcards: NEEDS[wildcards.id].threads
    resources:
        runtime=lambda wildcards: NEEDS[wildcards.id].minutes,
        mem_mb=lambda wildcards: NEEDS[wildcards.id].megabytes,
        values=lambda wildcards: values_of(POINTS[wildcards.id]),  # not among the params: any sweep's
    log:
        f"{LOGS}/points/{{id}}.log",
    message:
        "point: {resources.values}"
    shell:
        "{PYTHON} {input.script} {BIN} {output} {params.base} {params.commands:q} 2> {log}"


rule table:
    input:
        points=lambda wildcards: files_of(SWEEPS[wildcards.sweep]),
        sweep="recipes/{sweep}.ini",
        script="recipes/common/collect.py",
        common=COMMON,
    output:
        f"{DATA}/{{sweep}}.csv",
    wildcard_constraints:
        sweep="|".join(SWEEPS) or "none",
    log:
        f"{LOGS}/{{sweep}}.log",
    message:
        "{wildcards.sweep}: collect the points"
    shell:
        "{PYTHON} {input.script} {input.sweep} {DATA}/points {output} 2> {log}"


rule sweep:
    input:
        files_of(OWN) if OWN else [],
