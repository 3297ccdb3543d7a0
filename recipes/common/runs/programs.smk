# The parts that rules have in common, written once: how a file follows content, a rule per program, and
# tables of what is run and measured in the same way (tables.smk has their rules). A row of a table:
#
#     RUNS["fig1/event"] = run("fast-slow-fast", "--for 0.005", record_every="1e-6")
#
# It continues fast-slow-fast.h5, and makes fig1/event-record.h5 and fig1/event-end.h5; with REPORTS,
# fig1/event-front.json follows. Everything else is a rule, in which a recipe states what differs:
#
#     use rule load_recorded as speeds_load with:
#         output: **recorded(f"{DATA}/speeds/load")  # h5, h5_sum, record, record_sum
#         log: f"{LOGS}/speeds/load.log"  # messages of the command
#         params: **run_with("--until 1.2", record_every="1e-4")
#
# with `message` as in any rule. Snakemake replaces a section as a whole, so `params` are given by the
# functions below, and the `shell` of a base rule is never replaced.
from collections import namedtuple

Figure = namedtuple("Figure", "inputs outputs")
FIGURES = {}  # recipe: its Figure
PLACES = {}  # table of places: which of map_points.py, tables
EVENTS_OF = {}  # folder: load, and by which rule one of its events is chosen (choose_events.py)
RUNS = {}  # recorded run: what run() says
REPORTS = {  # name: ending of the file that is measured, command of `analyze`
    "front": ("-record", "front --event 0"),
    "loading": ("-record", "loading"),
    "phi": ("", "phi"),
    "strength": ("", "strength"),
}


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


OWN_RESULTS = ("own.json",)


def in_data(names):
    """Their paths."""
    return [f"{DATA}/{name}" for name in names]


def figure(name, *, pictures=(), tables=(), own=(), events=(), start=(), refine=(), reads=(), **others):
    """The rule NAME, which makes all that a recipe makes of its inputs, with its scripts: claims,
    pictures (NAME if no others are listed), the tables behind them, and results of our own. In
    results/data are the `events` that it shows, what it needs before the rest is planned (STAGES), and
    what it `reads`, of which HDF5 counts by its content."""
    STAGES["start"][name] = in_data([*start, *(f"{event}.compared" for event in events)])
    STAGES["refine"][name] = in_data(refine)
    states = in_data(file for file in reads if file.endswith(".h5"))
    reports = in_data(file for file in reads if not file.endswith(".h5"))
    scripts = sorted(map(str, Path("recipes", name).glob("*.py")))
    files = [f"{picture}.{ending}" for picture in pictures or [name] for ending in ("png", "pdf")]
    files = ["claims.json", *files, *(f"{table}.csv" for table in tables), *own]
    FIGURES[name] = Figure(
        others | content_of(states=states) | {"reports": reports, "beside": scripts}
        | script(f"recipes/{name}/figure.py"),
        [f"{RESULTS}/{name}/{file}" for file in files],
    )


def run(start, options, changes="", record_every="1e-5"):
    """A row of RUNS: the checkpoint to continue, and the rest as for run_with()."""
    return {"start": start} | run_with(options, changes=changes, record_every=record_every)


def run_with(options, *, changes="", record_every="1e-5"):
    """Params of a run: how long, other parameters, and the time between samples [s]."""
    return {"code": CODE, "options": options, "changes": changes, "record_every": record_every}


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
