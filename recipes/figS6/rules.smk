# Figure S6: the decaying law. One file per part; each adds its claims to FIGS6_PARTS.
FIGS6_PARTS = []


include: "event.smk"
include: "map.smk"


use rule join_claims as figS6 with:
    input:
        parts=lambda wildcards: FIGS6_PARTS,
        **script("recipes/common/claims/merge_claims.py"),
    output: f"{RESULTS}/figS6/claims.json"
    log: f"{LOGS}/figS6.log"
    message: "figS6: join the claims of its parts"
