"""The paper's numbers, in one place. What is measured is compared with them, in claims, in pictures
and to choose the event most like the paper's. No simulation reads them, and no measurement except
L_0, a factor common to all points of Figure 3 D."""

# Table S1: friction at which a pinned junction breaks, and of a slipping one
MU_S, MU_D = 0.4, 0.17

# Fig. 2 and the text on it: a fast-slow-fast event
FAST = 1 / 3  # speed of the front before its slow stretch [c_s]
SLOW = 1 / 100  # along it [c_s]
TRANSITIONS = (0.4, 0.6)  # from fast to slow, and back [L]
SLOW_FOR = 1e-3  # duration of the slow front [s]

# Discussion, of the experiments of its ref. 20
FAST_SLIP_SPEED = 0.1  # [m/s]

# Fig. 3 D and the SI, on slow fronts
L_0 = 7e-3  # decay length of the shear force ahead of them [m]

# SI, on the speed of slow slip
COEFFICIENT = 4.2  # Eq. S1: that speed [tau_slip/(k_i <t_R>)]
NET_SLIP = 8.5  # [f_slip/k_ij]
ALL_PINNED = 2.0  # when all junctions are pinned again [<t_R>]
