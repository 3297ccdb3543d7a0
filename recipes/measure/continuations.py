"""How an event is continued, as data: what the chains (ensemble/branches.ini) and those that
read their reports have in common."""

LEAD = 0.5e-3  # from here to the first rupture of the event [s]

BRANCHES = {"0.14": 8, "0.2": 11, "0.25": 14}  # front at [L]: the block that then ruptures
OWN_BLOCK = "own"  # the block 0.06 L before the event's transition
SLIPS = ["stopped", "t_R-half", "t_R-double"]  # of which the slip of a block is measured
