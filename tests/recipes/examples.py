"""Made-up samples for each row of claims.toml: those for which the claim holds, changes just within
the bounds of each condition, and just beyond them. The bounds are those of docs/claims.md and of
the paper.

A change is {"part.entry": value}; of a list, {"part.3": value}. `Instead` is another sample."""

from math import nan
from types import SimpleNamespace

from measure.ways import WAYS, PRIMARY, ON_MAP


class Instead(SimpleNamespace):
    """In place of all of a sample."""


class Example:
    """`around` has changes of one entry: {its name: (values within, values beyond)}."""

    def __init__(self, sample, around=None, within=(), beyond=()):
        rows = [(name, *values) for name, values in (around or {}).items()]
        self.sample = sample
        self.within = [{name: x} for name, near, _ in rows for x in near] + [*within]
        self.beyond = [{name: x} for name, _, far in rows for x in far] + [*beyond]


L, C_S = 0.14, 968.0


def by_way(report):
    return {PRIMARY: report}


def event(spanning, drop, reaches):
    """For 1D: whether it spans, its drop of F_T, whether the leading edge ruptures."""
    line = {"t_rupture": [0.0, 1.0 if reaches else None], "spanning": spanning}
    return line | {"F_T_before": 100.0 + drop, "F_T_after": 100.0}


def load(*events):
    return by_way([e | {"t_start": float(n), "is_over": True} for n, e in enumerate(events)])


EARLY, LARGE = event(False, 1, False), event(True, 10, True)
WORDS: dict = {"fast_slow_fast": True, "L": L, "t_rupture": [0.0, 0.1, 0.2, 1.0, 2.0, 2.1, 2.2]}
WORDS["in_words"] = {"x_from": 0.07, "x_to": 0.0938, "t_from": 1.0, "t_to": 2.0}
WORDS["in_words"] |= {"fast_before": 300.0}
FAST_SLOW_FAST = Example(by_way([WORDS]), {"primary.0.fast_slow_fast": ([], [False])})
SLOW: dict = {"x_from": 0.07, "x_to": 0.098, "duration": 1e-3, "slowest": 9.68}
SLOW["fast_before"] = C_S / 3
FRONT: dict = {"type": "slow", "c_s": C_S, "L": L, "slow": SLOW}
SLIPS = {"fast_slip": 1.0, "slow_slip": 1.0, "slow_r_squared": 0.96, "slow_rms": 0.02}
# A block that ruptures at 1 ms and slips 10 um until 1.1 ms, rests, and slips 20 um slowly.
COURSE: dict = {"t_rupture": 1e-3, "t_arrest": 1.1e-3, "fast_slip": 1e-5, "slow_slip": 2e-5}
COURSE["time"] = [0.9e-3, 1.0e-3, 1.1e-3, 1.2e-3, 1.3e-3, 3e-3]
COURSE["slip"] = [0.0, 0.6e-5, 1e-5, 1e-5, 1.2e-5, 3e-5]
LINE: dict = {"x": [0.01, 0.02, 0.03, 0.04], "t_rupture": [0.0, 1e-3, 2e-3, 3e-3], "L": L}
SIMPLIFIED: dict = {"type": "slow", "slow": {"fast_before": 100.0, "speed": 10.0}}
SIMPLIFIED["slow"]["duration"] = 0.5e-3
NEIGHBOURS = {"per_block": {"x": [0.0, 2.5e-3], "speed": [1, 1.2]}}
STEADY = {"mu": [0.2, 0.19, 0.18], "mu_theory": [0.2, 0.19, 0.18], "mu_error": [0.0]}
FIT: dict = {"slope": 1.0, "r_squared": 0.95, "exponent": 1.0, "largest": 0.0, "offset": 0.0}
FIT |= {"x": [1.0, 2.0], "y": [1.0, 2.0]}
FITS: dict = {"full": FIT | {"slope": 1.8}, "simplified": FIT | {"slope": 1.5}}
FITS |= {f"{model}, unscaled": FIT | {"r_squared": 0.7} for model in [*FITS]}
FITS |= {f"{model}, faster": FIT for model in ("full", "simplified")}
# Blocks 9 to 22 rupture after the branch at block 8, block 23 before it, and none beyond.
ARRESTED: dict = {"type": "arrested", "L": L, "t_rupture": [None] * 9 + [1.0] * 14 + [None] * 34}
ARRESTED["t_before"] = [0.5] * 9 + [None] * 14 + [0.5] + [None] * 33
ARRESTED["t_rupture"][24:29] = [1.0] * 5  # on to block 28
METHODS = dict.fromkeys(
    (PRIMARY, "5 blocks ahead", "8 blocks ahead", "without the block at the tip", "fall to 1/e")
)
MEANS = {"phi": {"mean": [1.0, -2.0]}, "phi_wider": {"mean": [1.0, -2.0]}}
MEANS_DIFFER: dict = {
    "phi_wider.mean.0": ([], [1.0 - 1.1e-12]),
    "phi_wider.mean.1": ([-2.0 - 1.9e-12], [-2.0 - 2.1e-12]),
}
NET_SLIP = "net_slip_over_f_slip_per_k_ij"
OTHERS_OF_SLIP = {"slip_after_two_t_R_over_f_slip_per_k_ij": 0.0, "quiet_after_over_t_R": 0.0}
OTHERS_OF_TIME = {"duration_over_t_R_deviation": 0.0, "slip_at_return_over_f_slip_per_k_ij": 0.0}
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


QUIET: dict = {"no_slow_slip.primary": ARRESTED | {"t_rupture": [None] * 57}}
QUIET["no_slow_slip.primary"]["type"] = "none"


def first_events(begins, ends):
    """Runs whose first events begin and end at one place or the other [L], half of them each: drawn
    runs have medians from one to the other. All later events begin and end elsewhere."""

    def words(begin, end):
        stretch = PAPERS | {"x_from": begin * L, "x_to": end * L}
        return {"fast_slow_fast": True, "L": L, "c_s": C_S, "in_words": stretch}

    first = [words(begins[n % 2], ends[n // 2 % 2]) for n in range(20)]
    other = words(0.1, 0.2) | {"fast_slow_fast": False}
    return [by_way([other, event, words(0.8, 0.9)]) for event in first]


def front(kind, **ways):
    return {"types": dict.fromkeys(ON_MAP, kind) | ways}


def map_of(*kinds, sigma=0.0):
    """A map with fronts of these types at rising tau_bar_0."""
    return {(n / 10, sigma): {1: front(kind)} for n, kind in enumerate(kinds)}


IN_ORDER = map_of("arrested", "slow", "fast")
TWO_TYPES, TURNED = map_of("arrested", "fast", "fast"), map_of("slow", "arrested", "fast")
ORDER = Example(IN_ORDER, beyond=[Instead(sample=of) for of in (TWO_TYPES, TURNED)])


def slow_range(slow, fast=2):
    return map_of(*["slow"] * slow, *["fast"] * fast)


def lengths(l_0, **others):
    return {"l_0": METHODS | {PRIMARY: l_0} | others, "profiles": 1}


def bands(width):
    """The band, and the reference's."""
    return [by_way({"slow": 0.1, "fast": 0.1 + w}) for w in (width, 0.06)]


# x [m] of a block in the trigger region and of one beyond; tau-bar 0.3 and 0.2, p = 1.
PRESTRESS = [0.17 + 0.23 * tau_bar for tau_bar in (0.3, 0.2)]


def stress(tau):
    return {"x": [0.02, 0.0225], "p": [1.0, 1.0], "tau": tau, "F_N": 2.0}


INTERFACE: dict = {"tau_bar": 0.2, "before": stress(PRESTRESS), "later": stress(PRESTRESS)}
INTERFACE["depinned"] = stress([0.17, PRESTRESS[1]])
UP = 1 + 1.1e-9
# p is that of F_N = 4; its centroid moves by F_T h/F_N = 0.14 m/4 times the moved force.
FORCES: dict = {"x": [0.0, 0.07, 0.14], "p": [1.0, 2.0, 1.0], "F_T": 8.0, "F_N": 4.0}
FORCES |= {"tau": [-2.0, 0.0, 2.0]}
MOVED = FORCES | {"p": [0.9, 2.0, 1.1]}

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
            "fronts": by_way({"x": [0.07] * 29, "L": L, "t_rupture": [9.0] * 28 + [2e-3]}),
            "peaks": {
                "t_peak": [9.0] * 28 + [2e-3],
                "before": [9.0] * 28 + [0.2],
                "at_peak": [0.0] * 28 + [0.3],
                "after": [9.0] * 28 + [0.1],
            },
        },
        {
            "peaks.t_peak.28": ([2.099e-3, 1.901e-3], [2.101e-3, 1.899e-3]),
            "fronts.primary.t_rupture.28": ([], [None]),  # it does not rupture
            "peaks.before.28": ([], [0.3]),  # friction does not rise
            "peaks.after.28": ([], [0.3, None]),  # nor fall again; it has lost contact
        },
    ),
    "1F": Example(
        {"deviation": 1e-12, "breaks_beyond_f_thres": True, "latest_repinning": 0}
        | {"junctions": 3, "breaks": 6, "repinnings": 6, "moves_forwards": True},
        {
            "deviation": ([], [1.1e-12]),
            "breaks_beyond_f_thres": ([], [False]),
            "latest_repinning": ([], [1]),
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
        by_way([FRONT | {"in_words": PAPERS}]),
        {f"primary.0.in_words.{name}": values for name, values in AROUND.items()}
        | {"primary.0.type": (["fast"], ["arrested"]), "primary.0.in_words": ([], [None])},
    ),
    "2B": Example(
        by_way([FRONT | {"type": "fast"}]), {"primary.0.type": ([], ["slow", "arrested"])}
    ),
    "2C": Example(
        by_way([FRONT]),  # 28 m/s on average: c_s/35
        {
            "primary.0.type": (["fast"], ["arrested"]),
            "primary.0.slow": ([], [None]),
            "primary.0.slow.fast_before": ([C_S / 5.9, C_S / 1.51], [C_S / 6.1, C_S / 1.49]),
            "primary.0.slow.slowest": ([C_S / 199, C_S / 51], [C_S / 201, C_S / 49]),
            "primary.0.slow.x_to": (
                [0.07 + C_S * 1e-3 / 69, 0.07 + C_S * 1e-3 / 17.6],
                [0.07 + C_S * 1e-3 / 71, 0.07 + C_S * 1e-3 / 17.4],
            ),
            "primary.0.slow.duration": ([], [0.0]),
            "primary.0.slow.x_from": ([], [None]),
        },
    ),
    "first-event": Example(
        first_events((0.36, 0.44), (0.56, 0.64)),
        within=[
            Instead(sample=first_events((0.36, 0.4), (0.6, 0.64))),
            Instead(sample=first_events((0.4, 0.44), (0.56, 0.6))),
            Instead(sample=first_events((0.33, 0.47), (0.53, 0.67))),
        ],
        beyond=[
            Instead(sample=first_events((0.36, 0.39), (0.56, 0.64))),
            Instead(sample=first_events((0.41, 0.44), (0.56, 0.64))),
            Instead(sample=first_events((0.36, 0.44), (0.56, 0.59))),
            Instead(sample=first_events((0.36, 0.44), (0.61, 0.64))),
            Instead(sample=first_events((0.32, 0.48), (0.56, 0.64))),
            Instead(sample=first_events((0.36, 0.44), (0.52, 0.68))),
        ],
    ),
    "3A": Example(
        {"stopped": by_way({"fast_slow_fast": True, "type": "slow", "in_words": None, "L": L})},
        {"stopped.primary.fast_slow_fast": ([], [False])},
    ),
    "3B": Example(
        {
            "no_slow_slip": by_way(ARRESTED),
            "fronts": by_way({"in_words": {"x_from": 0.07}}),  # block 28
            "block": 8,
        },
        {
            "fronts.primary.in_words.x_from": ([0.0561, 0.0839], [0.0559, 0.0841, None]),
            "no_slow_slip.primary.type": ([], ["slow", "fast"]),
            # It stops at a block that does not rupture, whatever ruptures beyond.
            "no_slow_slip.primary.t_rupture.22": ([], [None]),
            "no_slow_slip.primary.t_rupture.24": ([None], []),
            "no_slow_slip.primary.t_rupture.40": ([1.0], []),
        },
        # Nothing ruptures: it has arrested at block 8, 0.02 m.
        within=[QUIET | {"fronts.primary.in_words.x_from": 0.0339}],
        beyond=[QUIET, QUIET | {"fronts.primary.in_words.x_from": 0.0341}],
    ),
    "no-crossing": Example(
        {
            "no_slow_slip": by_way({"type": "arrested"}),
            "stopped": by_way({"type": "slow"}),
        },
        {
            "no_slow_slip.primary.type": (["none"], ["slow", "fast"]),
            "stopped.primary.type": (["arrested", None], []),
        },
    ),
    "dose": Example(
        {
            name: by_way({"type": "slow", "L": L, "in_words": {"slowest": v, "x_to": 0.5 * L}})
            for name, v in (("half", 20.0), ("stopped", 10.0), ("double", 5.0))
        },
        {
            "half.primary.in_words.slowest": ([13.4, 29.9], [13.3, 30.1, None]),
            "double.primary.in_words.slowest": ([7.49, 3.34], [7.51, 3.32, None]),
            "half.primary.in_words.x_to": ([0.401 * L, 0.599 * L], [0.399 * L, 0.601 * L]),
            "double.primary.in_words.x_to": ([0.401 * L, 0.599 * L], [0.399 * L, 0.601 * L]),
            "stopped.primary.in_words": ([], [None]),
        },
        within=[{"half.primary.in_words.x_to": 0.41 * L, "double.primary.in_words.x_to": 0.59 * L}],
    ),
    "3C": Example(
        [SLIPS] * 3,  # for <t_R> as it is, half and double
        {
            "1.fast_slip": ([1.099], [1.101]),
            "2.fast_slip": ([0.91], [0.9]),
            "0.slow_r_squared": ([0.95], [0.949]),
            "1.slow_r_squared": ([], [0.949]),
            "2.slow_r_squared": ([], [None]),
            "0.fast_slip": ([], [None]),
        },
    ),
    "3C-begin": Example(
        [COURSE],  # half of the fast slip at the rupture, 0.2 ms of arrest
        {
            "0.t_rupture": ([1.099e-3, 0.901e-3], [1.101e-3, 0.899e-3]),
            "0.time.4": ([2.099e-3], [2.101e-3]),
            "0.slip.3": ([1.099e-5], []),
            "0.fast_slip": ([], [None]),  # it never stops
        },
        within=[{"0.time.4": 1.1201e-3, "0.time.3": 1.11e-3}],
        beyond=[
            {"0.time.4": 1.1199e-3, "0.time.3": 1.11e-3},
            {"0.slip.3": 1.101e-5, "0.time.3": 1.11e-3},
        ],
    ),
    "3C-inset": Example(
        {"fits": by_way(FIT), "varied": [], "event": FIT},
        {
            "fits.primary.slope": ([0.75, 1.25], [0.749, 1.251, None]),
            "fits.primary.exponent": ([0.901, 1.099], [0.899, 1.101, None]),
            "fits.primary.r_squared": ([], [0.949]),
        },
    ),
    "3C-neighbours": Example(
        {"rows": by_way([{"variant": "reference"} | NEIGHBOURS])},
        {
            "rows.primary.0.per_block.speed.1": ([], [1.201, 0.0]),
            "rows.primary.0.variant": ([], ["t_R"]),
        },
    ),
    "3D": Example(
        by_way(FITS),
        {
            "primary.full.exponent": ([0.901, 1.099], [0.899, 1.101, None]),
            "primary.simplified.exponent": ([0.901, 1.099], [0.899, 1.101, None]),
            "primary.full.r_squared": ([], [0.949]),
            "primary.simplified.r_squared": ([], [0.949, nan]),
            "primary.full.slope": ([1.202], [1.802, 1.198]),
        },
    ),
    "3D-collapse": Example(
        by_way(FITS),
        {
            "primary.full.exponent": ([1.5], []),
            "primary.full.r_squared": ([], [0.949]),
            "primary.simplified.r_squared": ([], [0.949, nan]),
            "primary.full.slope": ([1.202], [1.802, 1.198]),
            "primary.full, unscaled.r_squared": ([0.949], [0.951, 0.95]),
            "primary.simplified, unscaled.r_squared": ([0.949], [0.951]),
        },
    ),
    "3D-length": Example(
        [lengths(7e-3)],
        {"0.l_0.primary": ([5.251e-3, 8.749e-3], [5.249e-3, 8.751e-3, None])},
    ),
    "3D-stiffness": Example(
        [lengths(x) for x in (None, None, 6e-3, 7e-3, 8e-3)],
        {"3.l_0.primary": ([], [6e-3, 5e-3, None]), "4.l_0.primary": ([], [7e-3])},
    ),
    "no-slip-force": Example(
        {
            "fronts": [front(kind) for kind in ("arrested", "fast", "slow")],
            "bands": [bands(0.0029), bands(0.0)],
        },
        {
            "bands.1.0.primary.fast": ([0.1029], [0.1031]),
            "fronts.0": ([], [front("slow")]),  # none is arrested
            "fronts.1": ([], [front("slow")]),  # none is fast
        },
    ),
    "4AB": Example(
        {"fronts": by_way({"type": "slow"}), "wider": by_way({"type": "fast"})} | MEANS,
        MEANS_DIFFER | {"wider.primary.type": ([], ["slow"])},
    ),
    "4C": Example(
        {"deviation": 0.02, "near": 0.9, "on_map": 0.71, "over_events": by_way([3, 0.71])},
        {
            "deviation": ([], [0.0201]),
            "near": ([], [0.89]),
            "on_map": ([], [0.709, None]),
            "over_events.primary.1": ([], [0.709]),
        },
    ),
    "4C-stress": Example(
        {
            "fronts": by_way(
                {
                    "c_s": C_S,
                    "criteria": {"slow_below": 1 / 20},
                    "x": [0.02, 0.03, 0.04, 0.05, 0.06],  # the first is in the loading zone
                    "v_c": [C_S / 21, C_S / 21, C_S / 19, C_S / 19, -C_S / 19],
                }
            ),
            "strength": {"tau_bar_0": [9.0, 0.29, 0.35, 0.35, 9.0]},
        },
        {"strength.tau_bar_0.1": ([0.349], [0.35])},
    ),
    "4D": ORDER,
    "4D-edge": Example(
        # with slow slip, and without, at two sigma_bar
        [[dict.fromkeys(WAYS, {"slow": x, "fast": 0.1}) for x in (0.05, 0.1)]] * 2,
        {"0.1.primary.slow": ([0.0981, 0.1019], [0.0979, 0.1021])},
    ),
    "5A": Example(
        {
            "fronts": by_way(LINE | {"in_words": {"duration": 0.8e-3}}),
            # 9 s come before the stop
            "undriven": by_way({"t_rupture": [0.0, 9.0, 2e-3, 3e-3], "type": "slow"}),
            "stop": 1.5e-3,
        },
        {
            "undriven.primary.t_rupture.3": ([3.0399e-3], [3.0401e-3, None]),
            "undriven.primary.t_rupture.2": ([], [1.9599e-3]),
            "stop": ([], [0.5e-3]),
        },
    ),
    "5B": Example(
        {"advance": {"c_s": C_S, "stopped": 2, "driven": 3}, "stretch": {"speed": 0.967}},
        {"stretch.speed": ([], [0.969]), "advance.stopped": ([], [3])},
    ),
    "no-slip-force-driven": Example(
        {
            "events": by_way(
                [
                    {"spanning": False, "c_s": C_S, "in_words": {"fast_before": C_S}},
                    {"spanning": True, "c_s": C_S, "in_words": None},
                    {"spanning": True, "c_s": C_S, "in_words": {"fast_before": C_S / 10.1}},
                ]
            ),
            "stretch": {"speed": 0.967},
        },
        {
            "events.primary.2.in_words.fast_before": ([None], [C_S / 9.9]),
            "events.primary.2.spanning": ([False], []),
            "stretch.speed": ([], [0.969, None]),
        },
        beyond=[{"events.primary.1.spanning": False, "events.primary.2.spanning": False}],
    ),
    "S1": Example(
        {"unloaded": FORCES, "before": MOVED, "h": 1.75e-3},  # the centroid moves by 3.5 mm
        {
            "h": ([1.75e-3 / 1.009, 1.75e-3 / 0.991], [1.75e-3 / 1.011, 1.75e-3 / 0.989]),
            "unloaded.p.0": ([1 + 1.2e-9], [1 + 1.4e-9]),  # not symmetric: the mean is 4/3
            "unloaded.p.1": ([2 + 3.9e-9], [2 + 4.1e-9]),  # the sum is another one
            "unloaded.tau.1": ([0.9e-9], [1.1e-9]),
        },
    ),
    "S2": Example(
        [by_way(SIMPLIFIED), by_way({"type": "arrested", "slow": None})],
        {"1.primary.slow": ([], [{"speed": 1.0}])},
    ),
    "S3": Example(
        [INTERFACE] * 2,
        {
            "0.before.tau.1": ([], [PRESTRESS[1] * UP]),
            "0.later.tau.0": ([PRESTRESS[0] * (1 + 0.9e-9)], [PRESTRESS[0] * UP]),
            "0.depinned.tau.0": ([], [0.17 * UP]),
            "0.depinned.tau.1": ([], [PRESTRESS[1] * UP]),
            "0.before.F_N": ([], [2 * UP]),
        },
    ),
    "S3-trigger": Example(
        [INTERFACE] * 2,
        {
            "1.depinned.tau.0": ([0.17 + 6e-11], [0.17 + 8e-11]),
            "0.before.tau.0": ([], [PRESTRESS[0] + 8e-11]),
            "1.depinned.tau.1": ([9.0], []),
        },
    ),
    "S4": Example(
        MEANS | {"uniform": {"p": 0.011, "blocks": 1, "distance": 0.0}},
        MEANS_DIFFER | {"uniform.p": ([], [0.01])},
    ),
    "S4-begin": Example(
        {
            "fronts": by_way(
                {
                    "x": [0.02, 0.03, 0.034, 0.035],  # 0.25 L is 0.035
                    "L": L,
                    "t_rupture": [1e-3, 2e-3, 3e-3, 4e-3],
                    "in_words": {"duration": 1e-3},
                }
            ),
            "wider": by_way({"t_rupture": [None, 2e-3, 3e-3, 9.0], "type": "fast"}),
            "block": 0,
        },
        {
            "wider.primary.t_rupture.1": ([], [2.051e-3]),
            "wider.primary.t_rupture.2": ([2.951e-3, 3.049e-3], [2.949e-3, 3.051e-3, None]),
        },
    ),
    "S5": Example(
        # 1 - sqrt(3) 0.1 and 1 - sqrt(3) 0.2 of the uniform shape
        [
            {"sigma_bar": [0.1, 0.2], "mu_bar": of, "quadrature": of}
            for of in ([0.8267949192431123, 0.6535898384862245], [0.9, 0.8])
        ],
        {
            "0.mu_bar.1": ([0.6535898384862245 + 0.9e-6], [0.6535898384862245 + 1.1e-6]),
            "0.quadrature.1": ([], [0.6535898384862245 - 1.1e-6]),
            "1.quadrature.0": ([], [0.9 + 1.1e-6]),
        },
        beyond=[
            {"1.mu_bar": [0.8, 0.8], "1.quadrature": [0.8, 0.8]},
            {"0.mu_bar.1": 0.6536, "0.quadrature.1": 0.6536},
        ],
    ),
    "S6A": FAST_SLOW_FAST,
    "S6B": ORDER,
    "S6B-range": Example(
        (slow_range(3), slow_range(2)),
        beyond=[Instead(sample=(slow_range(2), slow_range(2)))]
        + [Instead(sample=(slow_range(1), slow_range(2)))],
    ),
    "SI-slip": Example(
        {"reference": {NET_SLIP: 8.5} | OTHERS_OF_SLIP, "unbreakable": {NET_SLIP: 5.187}},
        {
            f"reference.{NET_SLIP}": ([8.1, 8.9], [8.09, 8.91]),
            f"unbreakable.{NET_SLIP}": ([], [5.186, 5.188]),
        },
    ),
    "SI-time": Example(
        {"reference": {"duration_over_t_R": 2.0} | OTHERS_OF_TIME},
        {"reference.duration_over_t_R": ([1.6, 2.4], [1.59, 2.41])},
    ),
    "exponential-event": FAST_SLOW_FAST,
    "exponential-map": Example(
        IN_ORDER,
        beyond=[
            Instead(sample=map_of(*kinds))
            for kinds in (
                ("slow", "slow", "fast"),
                ("arrested", "arrested", "fast"),
                ("arrested", "slow", "slow"),
                ("arrested", "slow", "fast", "slow"),
            )
        ],
    ),
    "geometry": Example(
        {"one": IN_ORDER, "other": IN_ORDER},
        beyond=[Instead(sample={"one": IN_ORDER, "other": of}) for of in (TWO_TYPES, TURNED)],
    ),
}
