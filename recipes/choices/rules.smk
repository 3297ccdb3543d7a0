# What depends on choices that the paper leaves open. The loads with our choices are
# those of the ensemble. The chain of commands is in README.md.
START = 0.17  # s; with half edge springs, the decaying law breaks junctions before 0.18 s
BOTH = "--set slider.edge_springs=half --set slider.damping_along=spring"
CHOICES = {  # name: kind of load, parameters
    "damping-half": ("load", "--set slider.damping=0.025"),  # eta^2, so eta x 0.5
    "damping-twice": ("load", "--set slider.damping=0.4"),
    "stiffness-initial": ("load", "--set junctions.k_ij_from=initial"),
    "springs-linear": ("load", "--set slider.springs=linearised"),
    "foundation-damped": ("load", "--set slider.foundation_damping=0.1"),  # as the bulk
    "contact-lost": ("load", "--set junctions.without_contact=break"),
    "edge-springs-half": ("load", "--set slider.edge_springs=half"),
    "damping-along-spring": ("load", "--set slider.damping_along=spring"),
    "both": ("load", BOTH),
    "decaying-exact": ("decaying", f"{SETTINGS['decaying'][0]} --set junctions.repin=exact"),
    "decaying-both": ("decaying", f"{SETTINGS['decaying'][0]} {BOTH}"),
}
OF_KIND = {"load": ("events", "continued"), "decaying": ("events",)}  # what there is of each load


def of_choice(folder, name, kind):
    """As many loads as there are as settled."""
    seeds = range(FIRST_SEED, FIRST_SEED + SETTINGS[kind][1])
    return [f"{folder}/{name}-{n}-{what}.json" for n in seeds for what in OF_KIND[kind]]


wildcard_constraints:
    choice="|".join(CHOICES),


use rule load_once as choices_start with:
    output: **with_sums(h5=f"{DATA}/choices/{{choice}}-start.h5")
    log: f"{LOGS}/choices/{{choice}}-start.log"
    priority: 110  # the loads wait for it
    params: **run_with(f"--until {START}", changes=lambda wildcards: CHOICES[wildcards.choice][1])
    message: f"choices: drive the slider to t = {START} s, {{wildcards.choice}}"


use rule load_of_seed as choices_load with:
    input:
        **content_of(h5=f"{DATA}/choices/{{choice}}-start.h5"),
        undrawn=f"{DATA}/choices/{{choice}}-start.undrawn",
    output:
        **recorded(
            f"{DATA}/choices/{{choice}}-{{seed}}",
            checkpoints=checkpoints_of_load(f"{DATA}/choices/{{choice}}-{{seed}}"),
        ),
    log: f"{LOGS}/choices/{{choice}}-{{seed}}.log"
    message: "choices: load {wildcards.choice}-{wildcards.seed} (about a minute)"


figure(
    "choices",
    tables=["choices"],
    own=OWN_RESULTS,
    reads=[
        "choices/choices.csv",
        *(of for kind in OF_KIND for of in of_choice("ensemble", kind, kind)),
        *(of for name, (kind, _) in CHOICES.items() for of in of_choice("choices", name, kind)),
    ],
)
