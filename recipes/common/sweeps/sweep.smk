# Sweeps (sweep.py): recipes/NAME/SWEEP.ini becomes the table results/data/NAME/SWEEP.csv. Decision 11 explains what a job computes and makes.
from runs.written import note
from sweeps.points import PointStore
from sweeps.sweep import BATCHES_OF_MANY, batches_of, read_sweep

# A recipe reads the tables of its own sweeps only, so those of recipes that are not asked for need no look.
SWEEPS = {
    f"{path.parent.name}/{path.stem}": read_sweep(path)
    for path in sorted(Path("recipes").glob("*/*.ini"))
    if path.parent.name in (ASKED or RECIPES) and path.with_name("rules.smk").exists()
}
SWEEPS |= {
    f"{name}-seed-{seed}": read_sweep(sweep.files[0], seed)
    for name, sweep in SWEEPS.items()
    for seed in sweep.seeds
}

BATCHES = {
    f"{name}-{number:04d}": (name, batch)
    for name, sweep in SWEEPS.items()
    for number, batch in enumerate(
        batches_of(list({point.id: point for point in sweep.points}.values()), most=BATCHES_OF_MANY), 1
    )
}
POINTS = f"{DATA}/points"

# A result that was deleted, damaged, or replaced by that of other programs is computed again.
STORE = PointStore(POINTS, CODE)
for batch, (_, points) in BATCHES.items():
    note(RESULTS, *(STORE.path(point) for point in points))
    path = Path(f"{DATA}/batches/{batch}.sum")
    if path.exists() and STORE.unfinished(points):
        path.unlink()


def tables_of_seeds(name):
    """The same sweep with other seeds."""
    return [f"{table}.csv" for table in SWEEPS if table.startswith(f"{name}-seed-")]


def words_of(name):
    """As scripts read it: the file, and the seed if the sweep is repeated with another one."""
    return shlex.join([SWEEPS[name].files[0], SWEEPS[name].seed])


def of_batch(get):
    """An input or parameter of the rule batch: get(name of its sweep, its points)."""
    return lambda wildcards: get(*BATCHES[wildcards.batch])


def base_of(_, batch):
    """The checkpoint its points start from. One that the recipes make counts by content (Snakefile)."""
    base = batch[0].base
    if base.startswith(f"{DATA}/"):
        return [ancient(base), f"{base}.sum"]
    return [base] if base else []


def described(name, batch):
    if len(batch) > 1:
        return f"{name}: {len(batch)} points"
    return "point: " + ", ".join(f"{name} {value}" for name, value in batch[0].values.items())


rule batch:
    input:
        base=of_batch(base_of),
        script="recipes/common/sweeps/points.py",
    output: f"{DATA}/batches/{{batch}}.sum"
    params:
        code=CODE,
        sweep=of_batch(lambda name, _: words_of(name)),
        ids=of_batch(lambda _, batch: [point.id for point in batch]),
    threads: of_batch(lambda name, _: SWEEPS[name].threads)
    resources:
        mem_mb=of_batch(lambda name, _: SWEEPS[name].megabytes),
        points=of_batch(described),  # message
    log: f"{LOGS}/batches/{{batch}}.log"
    message: "{resources.points}"
    shell:
        "{PYTHON} {input.script} {BIN} {params.sweep} {POINTS} {params.code} {output} {params.ids}"
        " 2> {log}"


rule table:
    input:
        points=lambda wildcards: [
            f"{DATA}/batches/{batch}.sum" for batch, (of, _) in BATCHES.items() if of == wildcards.sweep
        ],
        sweep=lambda wildcards: SWEEPS[wildcards.sweep].files,
        **script("recipes/common/sweeps/collect.py"),
    output: f"{DATA}/{{sweep}}.csv"
    params: sweep=lambda wildcards: words_of(wildcards.sweep), code=CODE
    wildcard_constraints: sweep="|".join(SWEEPS) or "none"
    log: f"{LOGS}/{{sweep}}.log"
    message: "{wildcards.sweep}: collect the points"
    shell: "{CALL} {input.script} {params.sweep} {POINTS} {params.code} {output} 2> {log}"
