"""Made-up reports for each row of claims.toml: those for which the claim holds, changes just within
the bounds of each condition, and just beyond them. The bounds are those of docs/claims.md and of
the paper.

A change is {"report.entry": value}; of a list, {"report.entry.3": value}."""


class Example:
    """`around` has changes of one entry: {its name: (values within, values beyond)}."""

    def __init__(self, reports, around=None, within=(), beyond=()):
        rows = [(name, *values) for name, values in (around or {}).items()]
        self.reports = reports
        self.within = [{name: x} for name, near, _ in rows for x in near] + [*within]
        self.beyond = [{name: x} for name, _, far in rows for x in far] + [*beyond]


L, C_S = 0.14, 968.0


def event(spanning, drop, reaches):
    """For 1D: whether it spans, its drop of F_T, whether the leading edge ruptures."""
    line = {"t_rupture": [0.0, 1.0 if reaches else None], "spanning": spanning}
    return line | {"F_T_before": 100.0 + drop, "F_T_after": 100.0}


def load(*events):
    found = [e | {"t_start": float(n), "is_over": True} for n, e in enumerate(events)]
    return {"measured": {"events": found}}


EARLY, LARGE = event(False, 1, False), event(True, 10, True)
WORDS: dict = {"fast_slow_fast": True, "L": L, "t_rupture": [0.0, 0.1, 0.2, 1.0, 2.0, 2.1, 2.2]}
WORDS["in_words"] = {"x_from": 0.07, "x_to": 0.0938, "t_from": 1.0, "t_to": 2.0}
WORDS["in_words"] |= {"fast_before": 300.0}
FAST_SLOW_FAST = Example({"event": WORDS}, {"event.fast_slow_fast": ([], [False])})
SLOW: dict = {"x_from": 0.07, "x_to": 0.098, "duration": 1e-3, "slowest": 9.68}
SLOW["fast_before"] = C_S / 3
FRONT: dict = {"type": "slow", "c_s": C_S, "L": L, "slow": SLOW}
SLIPS = {"fast_slip": 1.0, "slow_slip": 1.0, "slow_r_squared": 0.96, "slow_rms": 0.02}
# A block that ruptures at 1 ms and slips 10 um until 1.1 ms, rests, and slips 20 um slowly.
COURSE: dict = {"t_rupture": 1e-3, "t_arrest": 1.1e-3, "fast_slip": 1e-5, "slow_slip": 2e-5}
COURSE["time"] = [0.9e-3, 1.0e-3, 1.1e-3, 1.2e-3, 1.3e-3, 3e-3]
COURSE["slip"] = [0.0, 0.6e-5, 1e-5, 1e-5, 1.2e-5, 3e-5]
LINE: dict = {"t_rupture": [0.0, 1e-3, 2e-3, 3e-3], "in_words": {"duration": 1e-3}}
NUMBERS = {"types": 3, "out_of_order": 0}
OUT_OF_ORDER: dict = {"order.types": ([], [2, None]), "order.out_of_order": ([], [1])}
SIMPLIFIED: dict = {"type": "slow", "t_start": 1.0, "t_end": 2.0}
SIMPLIFIED["slow"] = {"fast_before": 100.0, "speed": 10.0, "duration": 0.5e-3}
GATHERING: dict = {"deviation": {"largest": 0.02}, "shown": {"near": 0.9}}
GATHERING |= {"on_map": {"share": 0.71}, "over_events": {"share": 0.71}}
STEADY = {"mu": [0.2, 0.19, 0.18], "mu_theory": [0.2, 0.19, 0.18]}
SLOPES = {"r_squared_full": 0.95, "r_squared_simplified": 0.95, "difference": 0.2}
SLOPES |= {"exponent_full": 1.0, "exponent_simplified": 1.0}
MEANS = {"phi": {"mean": [1.0, -2.0]}, "phi_wider": {"mean": [1.0, -2.0]}}
MEANS_DIFFER: dict = {
    "phi_wider.mean.0": ([], [1.0 - 1.1e-12]),
    "phi_wider.mean.1": ([-2.0 - 1.9e-12], [-2.0 - 2.1e-12]),
}
PRESTRESSED = ("before", "later", "depinned", "p")
CURVES = ("uniform_closed", "uniform_quadrature", "bell_quadrature")
NET_SLIP = "net_slip_over_f_slip_per_k_ij"
SLIP_AFTER_TWO_T_R = "slip_after_two_t_R_over_f_slip_per_k_ij"
# For 2A-numbers: the paper's event, and values just within and beyond the bounds.
PAPERS = {"x_from": 0.4 * L, "x_to": 0.6 * L, "duration": 1e-3}
PAPERS |= {"fast_before": C_S / 3, "slowest": C_S / 100}
AROUND: dict[str, tuple] = {
    "x_from": ([0.301 * L, 0.499 * L], [0.299 * L, 0.501 * L]),
    "x_to": ([0.501 * L, 0.699 * L], [0.499 * L, 0.701 * L]),
    "duration": ([0.51e-3, 1.99e-3], [0.49e-3, 2.01e-3]),
    "fast_before": ([C_S / 5.9, C_S / 1.51], [C_S / 6.1, C_S / 1.49, None]),
    "slowest": ([C_S / 199, C_S / 51], [C_S / 201, C_S / 49]),
}

EXAMPLES = {
    "1D": Example(
        load(EARLY, *[LARGE] * 5),
        within=[
            load(EARLY, *[LARGE] * 5, event(False, 1, True)),  # a later one may reach the edge
            load(EARLY, *[LARGE] * 5, event(False, 4.9, False)),  # less than half the largest
        ],
        beyond=[
            load(event(False, 1, True), *[LARGE] * 5),
            load(EARLY, *[LARGE] * 5, event(False, 5, False)),  # half the largest is large
            load(EARLY, *[LARGE] * 4, event(True, 4, True)),  # four large drops
        ],
    ),
    "1E": Example(
        {
            "front": {"x": [0.07] * 29, "L": L, "t_rupture": [9.0] * 28 + [2e-3]},
            "peaks": {
                "t_peak": [9.0] * 28 + [2e-3],
                "before": [9.0] * 28 + [0.2],
                "at_peak": [0.0] * 28 + [0.3],
                "after": [9.0] * 28 + [0.1],
            },
        },
        {
            "peaks.t_peak.28": ([2.099e-3, 1.901e-3], [2.101e-3, 1.899e-3]),
            "front.t_rupture.28": ([], [None]),  # it does not rupture
            "peaks.before.28": ([], [0.3]),  # friction does not rise
            "peaks.after.28": ([], [0.3, None]),  # nor fall again; it has lost contact
        },
    ),
    "1F": Example(
        {"law": {"deviation": 1e-12, "breaks_beyond_f_thres": True, "latest_repinning": 0}},
        {
            "law.deviation": ([], [1.1e-12]),
            "law.breaks_beyond_f_thres": ([], [False]),
            "law.latest_repinning": ([], [1]),
        },
    ),
    "1G": Example(
        {"range": STEADY, "limits": {"mu": [0.2, 0.17]}},
        {
            "range.mu.0": ([0.2019], [0.2021]),
            "limits.mu.0": ([0.2019], [0.2021]),
            "limits.mu.1": ([0.1684], [0.1682]),
        },
        beyond=[{"range.mu": [0.2, 0.19, 0.19], "range.mu_theory": [0.2, 0.19, 0.19]}],
    ),
    "2A": FAST_SLOW_FAST,
    "2A-numbers": Example(
        {"event": FRONT | {"in_words": PAPERS}},
        {f"event.in_words.{name}": values for name, values in AROUND.items()}
        | {"event.type": (["fast"], ["arrested"]), "event.in_words": ([], [None])},
    ),
    "2B": Example({"event": FRONT | {"type": "fast"}}, {"event.type": ([], ["slow", "arrested"])}),
    "2C": Example(
        {"event": FRONT},  # 28 m/s on average: c_s/35
        {
            "event.type": (["fast"], ["arrested"]),
            "event.slow": ([], [None]),
            "event.slow.fast_before": ([C_S / 5.9, C_S / 1.51], [C_S / 6.1, C_S / 1.49]),
            "event.slow.slowest": ([C_S / 199, C_S / 51], [C_S / 201, C_S / 49]),
            "event.slow.x_to": (
                [0.07 + C_S * 1e-3 / 69, 0.07 + C_S * 1e-3 / 17.6],
                [0.07 + C_S * 1e-3 / 71, 0.07 + C_S * 1e-3 / 17.4],
            ),
            "event.slow.duration": ([], [0.0]),
            "event.slow.x_from": ([], [None]),
        },
    ),
    "3A": Example(
        {"front_stopped": {"fast_slow_fast": True}},
        {"front_stopped.fast_slow_fast": ([], [False]), "front_stopped": ([], [None])},
    ),
    "3B": Example(
        {"front_no_slow_slip": {"x_arrest": 0.07, "L": L}, "front": {"in_words": {"x_from": 0.07}}},
        {
            "front_no_slow_slip.x_arrest": ([0.0561, 0.0839], [0.0559, 0.0841, None]),
            "front.in_words.x_from": ([], [None]),
            "front_no_slow_slip": ([], [None]),
        },
    ),
    "3C": Example(
        {f"own_slip_{run}": SLIPS for run in ("stopped", "half", "double")},
        {
            "own_slip_half.fast_slip": ([1.099], [1.101]),
            "own_slip_double.fast_slip": ([0.91], [0.9]),
            "own_slip_stopped.slow_r_squared": ([0.95], [0.949]),
            "own_slip_half.slow_r_squared": ([], [0.949]),
            "own_slip_double.slow_r_squared": ([], [None]),
            "own_slip_double": ([], [None]),
        },
    ),
    "3C-begin": Example(
        {"own_slip_stopped": COURSE},  # half of the fast slip at the rupture, 0.2 ms of arrest
        {
            "own_slip_stopped.t_rupture": ([1.099e-3, 0.901e-3], [1.101e-3, 0.899e-3]),
            "own_slip_stopped.time.4": ([2.099e-3], [2.101e-3]),
            "own_slip_stopped.slip.3": ([1.099e-5], []),
            "own_slip_stopped.fast_slip": ([], [None]),  # it never stops
        },
        within=[{"own_slip_stopped.time.4": 1.1201e-3, "own_slip_stopped.time.3": 1.11e-3}],
        beyond=[
            {"own_slip_stopped.time.4": 1.1199e-3, "own_slip_stopped.time.3": 1.11e-3},
            {"own_slip_stopped.slip.3": 1.101e-5, "own_slip_stopped.time.3": 1.11e-3},
        ],
    ),
    "3C-inset": Example(
        {"slope": {"slope": 1.0, "r_squared": 0.95, "exponent": 1.0}},
        {
            "slope.slope": ([0.75, 1.25], [0.749, 1.251, None]),
            "slope.exponent": ([0.901, 1.099], [0.899, 1.101, None]),
            "slope.r_squared": ([], [0.949]),
        },
    ),
    "3C-neighbours": Example(
        {"neighbours": {"largest": 1.2}}, {"neighbours.largest": ([], [1.201, None])}
    ),
    "3D": Example(
        {"scaling": SLOPES},
        {
            "scaling.exponent_full": ([0.901, 1.099], [0.899, 1.101, None]),
            "scaling.exponent_simplified": ([0.901, 1.099], [0.899, 1.101, None]),
            "scaling.r_squared_full": ([], [0.949]),
            "scaling.r_squared_simplified": ([], [0.949, None]),
            "scaling.difference": ([], [0.201]),
        },
    ),
    "3D-length": Example(
        {"lengths": {"l_0": 7e-3}},
        {"lengths.l_0": ([5.251e-3, 8.749e-3], [5.249e-3, 8.751e-3, None])},
    ),
    "3D-stiffness": Example(
        {"by_stiffness": {"fronts": 3, "least_step": 1e-6, "l_0": [7e-3]}},
        {"by_stiffness.fronts": ([], [2]), "by_stiffness.least_step": ([], [0.0, -1e-6, None])},
    ),
    "no-slip-force": Example(
        {"no_slow": {"widest": 0.049, "arrested": 1, "slow": 0, "fast": 1}},
        {
            "no_slow.slow": ([3], []),  # a band that the grid has met by chance
            "no_slow.widest": ([], [0.05]),
            "no_slow.arrested": ([], [0]),
            "no_slow.fast": ([], [0]),
        },
    ),
    "4AB": Example(
        {"front": {"type": "slow"}, "front_wider": {"type": "fast"}} | MEANS,
        MEANS_DIFFER
        | {
            "front.type": ([], ["fast"]),
            "front_wider.type": ([], ["slow"]),
            "front_wider": ([], [None]),
        },
    ),
    "4C": Example(
        GATHERING,
        {
            "deviation.largest": ([], [0.0201]),
            "shown.near": ([], [0.89]),
            "on_map.share": ([], [0.709, None]),
            "over_events.share": ([], [0.709]),
        },
    ),
    "4C-stress": Example(
        {
            "front": {
                "c_s": C_S,
                "x": [0.02, 0.03, 0.04, 0.05, 0.06],  # the first is in the loading zone
                "v_c": [C_S / 21, C_S / 21, C_S / 19, C_S / 19, -C_S / 19],
            },
            "strength": {"tau_bar_0": [9.0, 0.29, 0.35, 0.35, 9.0]},
        },
        {"strength.tau_bar_0.1": ([0.349], [0.35]), "front.v_c.1": ([], [None])},
    ),
    "4D": Example({"order": NUMBERS}, OUT_OF_ORDER),
    "4D-edge": Example(
        {"edge": {"difference": 0.002, "change": 1.0}}, {"edge.difference": ([], [0.0021])}
    ),
    "5A": Example(
        {
            "front": LINE | {"in_words": {"duration": 0.8e-3}},
            "front_undriven": {"t_rupture": [0.0, 9.0, 2e-3, 3e-3]},  # 9 s come before the stop
            "amid": 1.5e-3,
        },
        {
            "front_undriven.t_rupture.3": ([3.0399e-3], [3.0401e-3, None]),
            "front_undriven.t_rupture.2": ([], [1.9599e-3]),
            "amid": ([], [0.5e-3]),
        },
    ),
    "5B": Example(
        {"advance": {"c_s": C_S, "stopped": 2, "driven": 3}, "stretch": {"speed": 0.967}},
        {"stretch.speed": ([], [0.969]), "advance.stopped": ([], [3])},
    ),
    "no-slip-force-driven": Example(
        {
            "measured": {
                "events": [
                    {"spanning": False, "c_s": C_S, "in_words": {"fast_before": C_S}},
                    {"spanning": True, "c_s": C_S, "in_words": None},
                    {"spanning": True, "c_s": C_S, "in_words": {"fast_before": C_S / 10.1}},
                ]
            },
            "stretch": {"speed": 0.967},
        },
        {
            "measured.events.2.in_words.fast_before": ([None], [C_S / 9.9]),
            "measured.events.2.spanning": ([False], []),
            "stretch.speed": ([], [0.969, None]),
        },
        beyond=[{"measured.events.1.spanning": False, "measured.events.2.spanning": False}],
    ),
    "S1": Example(
        {"symmetry": {"of_p": 1e-9, "of_tau": 1e-9, "sum_of_p": 1e-9, "over_lever": 1.0}},
        {
            "symmetry.over_lever": ([0.991, 1.009], [0.989, 1.011]),
            "symmetry.of_p": ([], [1.1e-9]),
            "symmetry.of_tau": ([], [1.1e-9]),
            "symmetry.sum_of_p": ([], [1.1e-9]),
        },
    ),
    "S2": Example(
        {
            "event": SIMPLIFIED,
            "measured": {"events": [SIMPLIFIED | {"t_start": 5.0, "t_end": 6.0}, SIMPLIFIED]},
            "front_without": {"type": "arrested", "slow": None},
        },
        {
            "measured.events.1.type": ([], ["arrested"]),
            "measured.events.1.slow.fast_before": ([], [99.0, None]),
            "measured.events.1.slow.duration": ([], [0.49e-3]),
            "measured.events": ([], [[]]),
            "front_without.slow": ([], [{"speed": 1.0}]),
        },
    ),
    "S3": Example(
        {"deviation": dict.fromkeys(PRESTRESSED, 1e-9)},
        {f"deviation.{name}": ([], [1.1e-9]) for name in PRESTRESSED},
    ),
    "S3-trigger": Example(
        {"deviation": {"force_drop": 9.0, "force_drops_differ": 1e-9}},
        {"deviation.force_drops_differ": ([], [1.1e-9])},
    ),
    "S4": Example(MEANS | {"widened": {"p": 0.011}}, MEANS_DIFFER | {"widened.p": ([], [0.01])}),
    "S4-begin": Example(
        {
            "front": {
                "x": [0.02, 0.03, 0.034, 0.035],  # 0.25 L is 0.035
                "L": L,
                "t_rupture": [1e-3, 2e-3, 3e-3, 4e-3],
                "in_words": {"duration": 1e-3},
            },
            "front_wider": {"t_rupture": [None, 2e-3, 3e-3, 9.0]},
            "block": 0,
        },
        {
            "front_wider.t_rupture.1": ([], [2.051e-3]),
            "front_wider.t_rupture.2": ([2.951e-3, 3.049e-3], [2.949e-3, 3.051e-3, None]),
        },
    ),
    "S5": Example(
        {"deviation": dict.fromkeys(CURVES, 1e-6) | {"falls": True}},
        {f"deviation.{name}": ([], [1.1e-6]) for name in CURVES}
        | {"deviation.falls": ([], [False])},
    ),
    "S6A": FAST_SLOW_FAST,
    "S6B": Example({"order": NUMBERS}, OUT_OF_ORDER),
    "S6B-range": Example(
        {"order": {"slow_range": 0.08}, "reference": {"slow_range": 0.07}},
        {"order.slow_range": ([], [0.07, 0.06, None])},
    ),
    "SI-slip": Example(
        {"reference": {SLIP_AFTER_TWO_T_R: 0.0, NET_SLIP: 8.5}, "unbreakable": {NET_SLIP: 5.187}},
        {
            f"reference.{NET_SLIP}": ([8.1, 8.9], [8.09, 8.91]),
            f"unbreakable.{NET_SLIP}": ([], [5.186, 5.188]),
        },
    ),
    "SI-time": Example(
        {"reference": {"duration_over_t_R": 2.0}},
        {"reference.duration_over_t_R": ([1.6, 2.4], [1.59, 2.41])},
    ),
    "exponential-event": FAST_SLOW_FAST,
    "exponential-map": Example(
        {"counts": {"arrested": 1, "slow": 1, "fast": 1, "out_of_order": 0}},
        {f"counts.{kind}": ([], [0]) for kind in ("arrested", "slow", "fast")}
        | {"counts.out_of_order": ([], [1])},
    ),
    "geometry": Example({"order": NUMBERS}, OUT_OF_ORDER),
}
