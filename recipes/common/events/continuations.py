"""How an event is continued, as data: what the chains (ensemble/branches.ini) and those that
read their reports have in common."""

LEAD = 0.5e-3  # from here to the first rupture of the event [s]
DURATION = 0.01  # of a continuation [s]

BRANCHES = {"0.14": 8, "0.2": 11, "0.25": 14}  # front at [L]: the block that then ruptures
OWN_BLOCK = "own"  # the block 0.06 L before the event's transition
CONTINUATIONS = {  # from a branch on
    "stopped": "--set driving.V=0",
    "no-slow-slip": "--set driving.V=0 --set junctions.f_new=f_slip",
    "t_R-half": "--set driving.V=0 --set junctions.t_R=1e-3 --set junctions.delta_t_R=0.3e-3",
    "t_R-double": "--set driving.V=0 --set junctions.t_R=4e-3 --set junctions.delta_t_R=1.2e-3",
    "distance": "--set junctions.law=distance",
}
SLIPS = ["stopped", "t_R-half", "t_R-double"]  # of which the slip of a block is measured
WIDER = "--shape uniform --x-from 0.035"  # phi beyond 0.25 L, options of `modify-phi`
