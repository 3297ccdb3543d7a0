import tomllib

# What depends on choices that the paper leaves open (choices.toml). The loads with our choices are
# those of the ensemble, the edges on prepared interfaces those of Figure 4.
START = 0.17  # s; with half edge springs, the decaying law breaks junctions before 0.18 s
CHANGES = tomllib.loads(Path("recipes/choices/choices.toml").read_text(encoding="utf-8"))
CHOICES = {  # name: kind of load, parameters
    name: (kind, f"{SETTINGS[kind][0]} {change}".strip())
    for kind in ("load", "decaying")
    for name, change in CHANGES[kind].items()
}
CHOICE_EDGES = CHANGES["load"] | CHANGES["prepared"]
EDGES |= CHOICE_EDGES
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
        *(of for name in ("reference", *CHOICE_EDGES) for of in edges(name, CHANGES["sigma_bars"])),
        *(of for kind in OF_KIND for of in of_choice("ensemble", kind, kind)),
        *(of for name, (kind, _) in CHOICES.items() for of in of_choice("choices", name, kind)),
    ],
)
