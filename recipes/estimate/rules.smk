# The SI's arithmetic of slow slip: relaxation of one block. See README.md.
ESTIMATES = {
    "reference": f"{DATA}/fast-slow-fast.h5",
    "unbreakable": f"{DATA}/estimate/unbreakable.h5",
}


STAGES["start"]["estimate"] = [f"{DATA}/fast-slow-fast.compared"]


# A force 600 times f_slip is out of reach in the relaxation.
use rule load_once as estimate_unbreakable with:
    output: **with_sums(h5=f"{DATA}/estimate/unbreakable.h5")
    params: **run_with("--until 0", changes="--set junctions.mu_s=100")
    log: f"{LOGS}/estimate/unbreakable.log"
    message: "estimate: a slider whose junctions do not break again"


use rule analyze as estimate_relaxation with:
    input: unpack(lambda wildcards: content_of(h5=ESTIMATES[wildcards.junctions]))
    output: f"{DATA}/estimate/{{junctions}}.json"
    params: **analysis("estimate --ensemble 1000")
    wildcard_constraints: junctions="|".join(ESTIMATES)
    log: f"{LOGS}/estimate/{{junctions}}-relaxation.log"
    message: "estimate: relax one block ({wildcards.junctions})"


use rule figure as estimate with:
    input:
        reports=[f"{DATA}/estimate/{junctions}.json" for junctions in ESTIMATES],
        **scripts_of("estimate"),
    output: results_of("estimate", pictures=["estimate"], tables=["relaxation", "blocks"])
    log: f"{LOGS}/estimate.log"
