# Figure S1: normal and friction forces along the interface, unloaded and before an event. See
# README.md.
FIGS1_STATES = {
    "unloaded": f"{DATA}/figS1/unloaded.h5",
    "before-event": f"{DATA}/fast-slow-fast.h5",
}


STAGES["start"]["figS1"] = [f"{DATA}/fast-slow-fast.compared"]


use rule load_once as figS1_unloaded with:
    output: **with_sums(h5=f"{DATA}/figS1/unloaded.h5")
    params: **run_with("--until 0")
    log: f"{LOGS}/figS1/unloaded.log"
    message: "figS1: find the equilibrium under the normal load"


use rule analyze as figS1_stress with:
    input: unpack(lambda wildcards: content_of(h5=FIGS1_STATES[wildcards.state]))
    output: f"{DATA}/figS1/{{state}}-stress.json"
    params: **analysis("stress")
    wildcard_constraints: state="|".join(FIGS1_STATES)
    log: f"{LOGS}/figS1/{{state}}-stress.log"
    message: "figS1: read the forces on the interface ({wildcards.state})"


use rule figure as figS1 with:
    input:
        stress=[f"{DATA}/figS1/{state}-stress.json" for state in FIGS1_STATES],
        **content_of(checkpoint=f"{DATA}/fast-slow-fast.h5"),
        **scripts_of("figS1"),
    output: results_of("figS1", pictures=["figS1"], tables=["stress"])
    log: f"{LOGS}/figS1.log"
