# The parts that rules have in common, written once: how a file follows content, and a rule per program.
# A recipe says what differs:
#
#     use rule restart_recorded as fig1_event with:
#         input: **content_of(h5=f"{DATA}/fast-slow-fast.h5")  # h5 (ancient), h5_sum
#         output: **recorded(f"{DATA}/fig1/event")  # h5, h5_sum, record, record_sum
#         params: **run_with("--for 0.005", record_every="1e-6")
#
# with `log` and `message` as in any rule. Snakemake replaces a section as a whole, so `params` are given
# by the functions below, and the `shell` of a base rule is never replaced.


def sums_of(paths):
    return f"{paths}.sum" if isinstance(paths, str) else [f"{path}.sum" for path in paths]


def with_sums(**files):
    """Outputs: files, or lists of them, each with the checksum of its content."""
    return files | {f"{name}_sum": sums_of(paths) for name, paths in files.items()}


def content_of(**files):
    """Inputs that count by their content."""
    return with_sums(**files) | {name: ancient(paths) for name, paths in files.items()}


def recorded(run, **files):
    """Outputs: the last checkpoint of a run, its record, and other files."""
    return with_sums(h5=f"{run}.h5", record=f"{run}-record.h5", **files)


def checkpoints_of(run, *, until, every, start=0):
    """The checkpoints that a run with --checkpoint-every writes: at the multiples after `start`."""
    first, last = (int(t / every + 1e-9) for t in (start, until))
    return [f"{run}-t{n * every:.9f}.h5" for n in range(first + 1, last + 1)]


def script(path):
    """Inputs: a script, and what scripts share."""
    return {"script": path, "common": COMMON}


def scripts_of(name):
    """Inputs of rule `figure`: the scripts of a recipe, and what scripts share."""
    scripts = sorted(map(str, Path("recipes", name).glob("*.py")))
    return {"script": f"recipes/{name}/figure.py", "beside": scripts, "common": COMMON}


def results_of(name, *, pictures=(), tables=(), own=()):
    """Outputs of rule `figure`: claims, pictures, the tables behind them, and results of our own."""
    files = [f"{picture}.{ending}" for picture in pictures for ending in ("png", "pdf")]
    files += [*(f"{table}.csv" for table in tables), *own, "claims.json"]
    return [f"{RESULTS}/{name}/{file}" for file in files]


def events_of(run):
    return {"events": f"{run}-events.json"} | script("recipes/common/events/choose_events.py")


def places():
    return script("recipes/common/maps/map_points.py")


OWN_RESULTS = ("own.json", "summary.txt")


def run_with(options, *, changes="", record_every="1e-5"):
    """Params of a run: how long, other parameters, and the time between samples [s]."""
    return {"code": CODE, "options": options, "changes": changes, "record_every": record_every}


def analysis(command):
    return {"code": CODE, "analysis": command}


def event_of(run, name=""):
    """Params of restart_before_event: where the run's checkpoints are, the event's key in the choice."""
    return {"code": CODE, "run": run, "event": f"{name}." if name else ""}


rule load_once:
    shell:
        "{BIN}/load -o {output.h5} --force --quiet --sum {params.changes} {params.options} 2> {log}"


rule load_recorded:
    shell:
        "{BIN}/load -o {output.h5} --force --quiet --sum {params.changes} {params.options}"
        " --record {output.record} --record-every {params.record_every} 2> {log}"


rule restart:
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum"
        " {params.changes} {params.options} 2> {log}"


rule restart_recorded:
    shell:
        "{BIN}/restart {input.h5} -o {output.h5} --force --quiet --sum"
        " {params.changes} {params.options}"
        " --record {output.record} --record-every {params.record_every} 2> {log}"


# From the last checkpoint before an event to 0.5 ms before it; choose_events.py writes such a choice.
rule restart_before_event:
    shell:
        "{BIN}/restart {params.run}-t$({VALUE} {input.choice} {params.event}from).h5"
        " -o {output.h5} --force --quiet --sum"
        " --until $({VALUE} {input.choice} {params.event}until) 2> {log}"


rule analyze:
    shell: "{BIN}/analyze {params.analysis} {input.h5} --json > {output} 2> {log}"


rule choose:
    message: "{rule}: choose the events to be shown"
    shell: "{PYTHON} {input.script} {params.by} {input.events} {CHECKPOINT_EVERY} > {output} 2> {log}"


# Where a map of front types needs more points (map_points.py).
rule places:
    message: "{rule}: find the places of a map that need more points"
    shell: "{PYTHON} {input.script} {params.which} {input.tables} {output} 2> {log}"


# All that a recipe makes of what was run and measured.
rule figure:
    message: "{rule}: draw, compare with the claims"
    shell: "{PYTHON} recipes/common/pictures/make.py {input.script} 2> {log}"
