use rule load_once as figS1_unloaded with:
    output: **with_sums(h5=f"{DATA}/figS1/unloaded.h5")
    log: f"{LOGS}/figS1/unloaded.log"
    params: **run_with("--until 0")
    message: "figS1: find the equilibrium under the normal load"


figure(
    "figS1",
    tables=["stress"],
    events=["fast-slow-fast"],
    reads=["figS1/unloaded-stress.json", "fast-slow-fast-stress.json", "fast-slow-fast.h5"],
)
