# A force 600 times f_slip is out of reach in the relaxation.
use rule load_once as estimate_unbreakable with:
    output: **with_sums(h5=f"{DATA}/estimate/unbreakable.h5")
    log: f"{LOGS}/estimate/unbreakable.log"
    params: **run_with("--until 0", changes="--set junctions.mu_s=100")
    message: "estimate: a slider whose junctions do not break again"


figure(
    "estimate",
    tables=["relaxation", "blocks"],
    events=["fast-slow-fast"],
    reads=["fast-slow-fast-estimate.json", "estimate/unbreakable-estimate.json"],
)
