# What hangs on choices that the model settles and the paper leaves open: one at a time is changed. The
# loads that are as settled are those of the ensemble. The chain of commands is in README.md.
CHOICE_SEEDS = range(FIRST_SEED, FIRST_SEED + 5)
CHOICES = {  # name: parameters of its loads
    "damping-half": "--set slider.damping=0.025",  # eta^2, so eta x 0.5
    "damping-twice": "--set slider.damping=0.4",
    "stiffness-initial": "--set junctions.k_ij_from=initial",
    "springs-linear": "--set slider.springs=linearised",
    "foundation-damped": "--set slider.foundation_damping=0.1",  # as the bulk
    "contact-lost": "--set junctions.without_contact=break",
    "decaying-exact": f"{SETTINGS['decaying'][0]} --set junctions.repin=exact",
}


def loads_of_choice(folder, name):
    return [f"{DATA}/{folder}/{name}-{seed}-events.json" for seed in CHOICE_SEEDS]


wildcard_constraints:
    choice="|".join(CHOICES),


use rule load as choices_load with:
    output: **recorded(f"{DATA}/choices/{{choice}}-{{seed}}")
    params:
        **run_with(
            f"--until {LOAD_UNTIL} {CROSSINGS}",
            changes=lambda wildcards: f"{CHOICES[wildcards.choice]}"
            f" --set numerics.seed={int(wildcards.seed)}",
            record_every="1e-3",
        ),
    log: f"{LOGS}/choices/{{choice}}-{{seed}}.log"
    message:
        f"choices: drive the slider to t = {LOAD_UNTIL} s, {{wildcards.choice}}-{{wildcards.seed}}"
        " (about a minute)"


use rule events as choices_events with:
    input:
        **content_of(h5=f"{DATA}/choices/{{choice}}-{{seed}}-record.h5"),
        script="recipes/ensemble/measure_events.py",
        conventions="recipes/common/events/conventions.py",
    output: f"{DATA}/choices/{{choice}}-{{seed}}-events.json"
    log: f"{LOGS}/choices/{{choice}}-{{seed}}-events.log"
    message: "choices: find the rupture events of {wildcards.choice}-{wildcards.seed}"


use rule figure as choices with:
    input:
        settled=[loads_of_choice("ensemble", name) for name in ("load", "decaying")],
        changed=[loads_of_choice("choices", name) for name in CHOICES],
        prepared=f"{DATA}/choices/choices.csv",
        **scripts_of("choices"),
    output: results_of("choices", pictures=["choices"], tables=["choices"], own=OWN_RESULTS)
    log: f"{LOGS}/choices.log"
