# Loads. Those with seed 1, from t = 0, are shown: load-01, the reference slider, in Figure 1, the others in
# Figures S2 and S6 and robustness; with --from-scratch, the checkpoints in checkpoints/ come from load-01,
# too. Those with other seeds are independent: claims are judged on them.
LOAD_UNTIL = 1.2  # s
CHECKPOINT_EVERY = 0.05  # s
BEFORE_FIRST_BREAK = 0.18  # s; the decaying law's is at 0.1845 s, that of the others at 0.1895 s
CROSSINGS = "--crossings 0.2,0.5"  # options of a run whose record holds enough for all conventions
SETTINGS = {  # name: parameters, independent runs
    "load": ("", 20),
    "simplified": ("--set junctions.law=simplified --set junctions.v_slow=1.5e-3", 0),  # a seed draws nothing
    "decaying": (
        "--set junctions.law=decaying --set junctions.kappa=54.1e9"
        " --set junctions.mu_d=0.28 --set junctions.mu_new=0.196",
        10,
    ),
    "exponential": ("--set junctions.slipping_times=exponential", 10),
}
FIRST_SEED = 201
LOADS_OF = {
    setting: [f"{setting}-{FIRST_SEED + n}" for n in range(count)] or [f"{setting}-01"]
    for setting, (_, count) in SETTINGS.items()
}
LOADS = sorted({load for loads in LOADS_OF.values() for load in loads} | {f"{s}-01" for s in SETTINGS})
REFERENCE_LOADS = LOADS_OF["load"]
SHOWN_LOAD = f"{DATA}/ensemble/load-01"


LOADING = f"--until {LOAD_UNTIL} --checkpoint-every {CHECKPOINT_EVERY} {CROSSINGS}"
SHARED = f"-t{BEFORE_FIRST_BREAK:.9f}.h5"  # ending of the checkpoint that loads of a kind share


def checkpoints_of_load(run):
    """Those that every load of the ensemble has."""
    return checkpoints_of(run, until=LOAD_UNTIL, every=CHECKPOINT_EVERY, start=BEFORE_FIRST_BREAK)


wildcard_constraints:
    load="(ensemble|choices)/[a-z-]+[0-9]+",
    setting="|".join(SETTINGS),


# The first load of each kind, with seed 1.
use rule load_recorded as load with:
    output:
        **recorded(
            f"{DATA}/ensemble/{{setting}}-01",
            checkpoints=checkpoints_of(
                f"{DATA}/ensemble/{{setting}}-01", until=LOAD_UNTIL, every=CHECKPOINT_EVERY
            ),
            shared=f"{DATA}/ensemble/{{setting}}-01{SHARED}",
        ),
    log: f"{LOGS}/ensemble/{{setting}}-01.log"
    priority: 110  # long, and the others wait for it: first
    params:
        **run_with(
            f"{LOADING} --checkpoint-at {BEFORE_FIRST_BREAK}",
            changes=lambda wildcards: SETTINGS[wildcards.setting][0],
            record_every="1e-3",
        ),
    message:
        f"load: drive the slider to t = {LOAD_UNTIL} s, {{wildcards.setting}}-01 (about a minute)"


# A seed draws slipping times and nothing else: until the first draw, loads of a kind are one state.
rule nothing_drawn:
    input:
        **content_of(h5=f"{DATA}/{{state}}.h5"),
        script="recipes/ensemble/nothing_drawn.py",
    output: touch(f"{DATA}/{{state}}.undrawn")
    log: f"{LOGS}/{{state}}.undrawn.log"
    params: code=CODE
    message: "{wildcards.state}: check that no slipping time has been drawn yet"
    shell: "{PYTHON} {input.script} {input.h5} 2> {log}"


# The others: as the first one until then, then with their own seed.
use rule restart_recorded as load_of_seed with:
    input:
        **content_of(h5=f"{DATA}/ensemble/{{setting}}-01{SHARED}"),
        undrawn=f"{DATA}/ensemble/{{setting}}-01{SHARED}".replace(".h5", ".undrawn"),
    output:
        **recorded(
            f"{DATA}/ensemble/{{setting}}-{{seed}}",
            checkpoints=checkpoints_of_load(f"{DATA}/ensemble/{{setting}}-{{seed}}"),
        ),
    log: f"{LOGS}/ensemble/{{setting}}-{{seed}}.log"
    priority: 100  # long: before what is short
    params:
        **run_with(
            LOADING,
            changes=lambda wildcards: f"--set numerics.seed={int(wildcards.seed)}",
            record_every="1e-3",
        ),
    wildcard_constraints: seed="[0-9]{3}"
    message:
        f"load: drive the slider to t = {LOAD_UNTIL} s, {{wildcards.setting}}-{{wildcards.seed}}"
        " (about a minute)"


rule events:
    input:
        **content_of(h5=f"{DATA}/{{load}}-record.h5"),
        script="recipes/ensemble/measure_events.py",
        shared=[
            *(f"recipes/common/events/{name}.py" for name in ("conventions", "fronts")),
            "python/rupture/programs.py",
        ],
    output: f"{DATA}/{{load}}-events.json"
    log: f"{LOGS}/{{load}}-events.log"
    params: code=CODE
    message: "events: find the rupture events of {wildcards.load}, under each convention"
    shell: "{CALL} {input.script} {input.h5} > {output} 2> {log}"


# The events of a load under the changes that figures make: Figures 3 A-C, 4 A-B and 5 A for every
# fast-slow-fast event of the reference slider, Figure S2 for the fast-slow ones with the simplified law.
# A checkpoint holds its parameters, so that an event continues with the choice of its load (recipes/choices).
CONTINUED_LOADS = [*LOADS_OF["load"], *LOADS_OF["simplified"]]


rule continued:
    input:
        events=f"{DATA}/{{load}}-events.json",
        **content_of(checkpoints=checkpoints_of_load(f"{DATA}/{{load}}")),
        script=lambda wildcards: "recipes/ensemble/without_slow_slip.py"
        if "simplified" in wildcards.load
        else "recipes/ensemble/continue_events.py",
        shared=[
            "recipes/ensemble/workshop.py",
            *("python/rupture/files.py", "python/rupture/programs.py"),
            *(
                f"recipes/common/events/{name}.py"
                for name in ("choose_events", "conventions", "continuations", "fronts", "slip")
            ),
        ],
    output: f"{DATA}/{{load}}-continued.json"
    log: f"{LOGS}/{{load}}-continued.log"
    priority: 80  # long: before what is short
    params: code=CODE, run=f"{DATA}/{{load}}", crossings=CROSSINGS
    message: "continued: continue the events of {wildcards.load} with changes"
    shell:
        "{CALL} {input.script} {params.run} {CHECKPOINT_EVERY} {params.crossings:q}"
        " > {output} 2> {log}"


def repeated(names):
    """What a recipe reads besides its own case: with the recipe `ensemble`, or where no recipes are
    named, all; without it, what is there already."""
    everything = not ASKED or "ensemble" in ASKED
    return [name for name in names if everything or Path(DATA, name).exists()]


def of_ensemble(setting, *kinds):
    """The same of the loads of a kind."""
    return repeated(f"ensemble/{load}-{kind}.json" for load in LOADS_OF[setting] for kind in kinds)
