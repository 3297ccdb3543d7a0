"""Figure S3: prepared interfaces before their trigger region is depinned, 100 steps later, and just
after depinning it; then the front that this starts."""

from functools import cache
from itertools import product
from types import SimpleNamespace

import numpy as np
from rupture.once import run
from rupture.reports import values

from claims.samples import Samples, every
from measure.fronts import type_on_map
from paper import MU_D, MU_S

TAU_BARS, SIGMA_BARS = (0.2, 0.3), (0, 0.2)
X_TRIGGER, TAU_BAR_TRIGGER = 0.0225, 0.3  # [m], [1]


def interface(tau_bar, sigma_bar):
    prestress = f"--tau-bar {tau_bar} --sigma-bar {sigma_bar}"
    pinned = run(f"prepare {prestress} --no-trigger -o pinned.h5")["pinned.h5"]
    later = run(f"restart {pinned} -o later.h5 --for 2e-5")["later.h5"]
    depinned = run(f"prepare {prestress} -o depinned.h5")["depinned.h5"]
    event = run(
        f"restart {depinned} -o end.h5 --until-quiet --record record.h5 --record-every 1e-3"
    )
    return SimpleNamespace(
        tau_bar=tau_bar,
        before=run(f"analyze stress {pinned}"),
        later=run(f"analyze stress {later}"),
        depinned=run(f"analyze stress {depinned}"),
        front=run(f"analyze front {event['record.h5']}"),
    )


@cache
def interfaces():
    """{(tau_bar_0, sigma_bar): what was found there}"""
    return every(interface, [*product(TAU_BARS, SIGMA_BARS)], "interfaces")


# --- what claims measure -----------------------------------------------------------------------


def prescribed(x, tau_bar):
    """tau_0/p of each block: mu_d + tau_bar_0 (mu_s - mu_d)."""
    in_trigger_region = np.array(x) < X_TRIGGER - 1e-9
    return MU_D + np.where(in_trigger_region, TAU_BAR_TRIGGER, tau_bar) * (MU_S - MU_D)


def ratio(stress):
    return np.array(stress.tau) / np.array(stress.p)


def deviation(found, wanted):
    return float(np.abs(found / wanted - 1).max())


def deviations(of):
    """Largest relative deviations of one interface from what was prescribed."""
    wanted = prescribed(of.before.x, of.tau_bar)
    beyond = np.array(of.before.x) > X_TRIGGER - 1e-9
    return {
        "before depinning": deviation(ratio(of.before), wanted),
        "100 steps later, not depinned": deviation(ratio(of.later), wanted),
        "just depinned, from mu_d in the trigger region": deviation(  # slipping: they carry f_slip
            ratio(of.depinned), np.where(beyond, wanted, MU_D)
        ),
        "p from F_N/N_x": deviation(np.array(of.before.p), of.before.F_N / len(of.before.p)),
    }


def all_interfaces():
    return Samples({"": [*interfaces().values()]})


def prestress(interfaces, _):
    """S3"""
    found = [deviations(of) for of in interfaces]
    largest = {name: max(of[name] for of in found) for name in found[0]}
    return {
        "prepared interfaces": len(found),
        "largest relative deviation": max(largest.values()),
        **{f"largest relative deviation, {name}": of for name, of in largest.items()},
    }


def force_drop(of):
    """The friction that depinning takes from the trigger region [N]."""
    inside = np.array(of.before.x) < X_TRIGGER - 1e-9
    before, after = (np.array(stress.tau)[inside].sum() for stress in (of.before, of.depinned))
    return float(before - after)


def trigger(interfaces, _):
    """S3-trigger"""
    drops = [force_drop(of) for of in interfaces]
    return {
        "force drop [N]": drops[0],
        "largest relative difference": max(drops) / min(drops) - 1,
    }


def each_interface():
    return Samples({f"tau_bar_0 {t:g}, sigma_bar {s:g}": of for (t, s), of in interfaces().items()})


def front(of, _):
    """S3-types: speeds beyond the trigger region."""
    beyond = np.array(of.front.x) > of.front.criteria.skip_below_x
    return {
        "type": type_on_map(of.front.type),
        "speed [m/s]": np.nanmedian(values(of.front.v_c)[beyond]),
    }
