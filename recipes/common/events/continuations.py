"""How an event is continued, as data: for the shown events by rules (runs/continuations.smk), for
those of the ensemble by a script (ensemble/continue_events.py)."""

LEAD = 0.5e-3  # from here to the first rupture of the event [s]
DURATION = 0.01  # of a continuation [s]

BRANCHES = {  # front at [L]: the block that then ruptures, its x [m]
    "0.14": (8, 0.02),
    "0.2": (11, 0.0275),
    "0.25": (14, 0.035),
}
SLIP_X = 0.0476  # [m], 0.34 L: the block that Figure 3 C shows
OWN_BLOCK, BEFORE_TRANSITION = "own", 0.06  # the block so far before the event's transition [L]
CONTINUATIONS = {  # from a branch on
    "stopped": "--set driving.V=0",
    "no-slow-slip": "--set driving.V=0 --set junctions.f_new=f_slip",
    "t_R-half": "--set driving.V=0 --set junctions.t_R=1e-3 --set junctions.delta_t_R=0.3e-3",
    "t_R-double": "--set driving.V=0 --set junctions.t_R=4e-3 --set junctions.delta_t_R=1.2e-3",
    "distance": "--set junctions.law=distance",
}
SLIPS = ["stopped", "t_R-half", "t_R-double"]  # of which the slip of a block is measured
# The simplified law without slow slip. It ends once nothing has broken for 12 ms, so that a record
# holds one event only.
WITHOUT_SLOW_SLIP = "--until-quiet 0.012 --for 0.05 --set junctions.v_slow=0"
WIDER = "--shape uniform --x-from 0.035"  # phi beyond 0.25 L, options of `modify-phi`
