# What recipes have put into the tables of programs.smk, a rule for each table.
def names(table):
    """Of its rows, for a wildcard."""
    return "|".join(map(re.escape, table))


use rule restart_recorded as recorded_run with:
    input: unpack(lambda wildcards: content_of(h5=f"{DATA}/{RUNS[wildcards.run]['start']}.h5"))
    output: **with_sums(h5=f"{DATA}/{{run}}-end.h5", record=f"{DATA}/{{run}}-record.h5")
    log: f"{LOGS}/{{run}}-end.log"
    params: **{name: lambda wildcards, name=name: RUNS[wildcards.run][name] for name in run_with("")}
    wildcard_constraints: run=names(RUNS)
    message: "{wildcards.run}: restart {input.h5} {params.changes} {params.options}"


rule analysis:
    input:
        unpack(lambda wildcards: content_of(h5=f"{DATA}/{wildcards.of}{REPORTS[wildcards.report][0]}.h5")),
    output: f"{DATA}/{{of}}-{{report}}.json"
    log: f"{LOGS}/{{of}}-{{report}}.log"
    params: code=CODE, analysis=lambda wildcards: REPORTS[wildcards.report][1]
    wildcard_constraints: report=names(REPORTS)
    message: "{wildcards.of}: analyze {params.analysis}"
    shell: "{BIN}/analyze {params.analysis} {input.h5} --json > {output} 2> {log}"


def load_of(wildcards):
    """From which the event to be shown comes."""
    return f"{DATA}/ensemble/{EVENTS_OF[wildcards.folder][0]}"


rule choose:
    input:
        events=lambda wildcards: f"{load_of(wildcards)}-events.json",
        **script("recipes/common/events/choose_events.py"),
    output: f"{DATA}/{{folder}}/choice.json"
    log: f"{LOGS}/{{folder}}/choice.log"
    params: by=lambda wildcards: EVENTS_OF[wildcards.folder][1]
    wildcard_constraints: folder=names(EVENTS_OF)
    message: "{wildcards.folder}: choose the events to show"
    shell: "{CALL} {input.script} {params.by} {input.events} {CHECKPOINT_EVERY} > {output} 2> {log}"


use rule restart_before_event as before_event with:
    input:
        unpack(lambda wildcards: content_of(checkpoints=checkpoints_of_load(load_of(wildcards)))),
        choice=f"{DATA}/{{folder}}/choice.json",
    output: **with_sums(h5=f"{DATA}/{{folder}}/before.h5")
    log: f"{LOGS}/{{folder}}/before.log"
    params: **event_of(load_of)
    wildcard_constraints: folder=names(EVENTS_OF)
    message: "{wildcards.folder}: run to 0.5 ms before the event"


# Where a map of front types needs more points (map_points.py).
rule places:
    input:
        tables=lambda wildcards: [f"{DATA}/{table}.csv" for table in PLACES[wildcards.places][1:]],
        **script("recipes/common/maps/map_points.py"),
    output: f"{DATA}/{{places}}.csv"
    log: f"{LOGS}/{{places}}.log"
    params: which=lambda wildcards: PLACES[wildcards.places][0]
    wildcard_constraints: places=names(PLACES)
    message: "{wildcards.places}: find the places of a map that need more points"
    shell: "{CALL} {input.script} {params.which} {input.tables} {output} 2> {log}"


for recipe, made in FIGURES.items():
    rule:
        name: recipe
        input: **made.inputs
        output: made.outputs
        log: f"{LOGS}/{recipe}.log"
        params: code=CODE
        message: "{rule}: draw, and judge the claims"
        shell: "{PYTHON} recipes/common/pictures/make.py {input.script} 2> {log}"
