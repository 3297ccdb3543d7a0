"""Table and claim of Figure 1 G."""

import numpy as np

from claims.judge import judged
from claims.paper import MU_D, MU_S
from measure.tables import write_table

LIMITS = (MU_S / 2, MU_D)


def claim_1G(steady, limits):
    mu, theory = np.array(steady["mu"]), np.array(steady["mu_theory"])
    off = np.abs(mu / theory - 1)
    off_limits = [abs(mu / limit - 1) for mu, limit in zip(limits["mu"], LIMITS)]
    case = {
        "largest change to the next speed": np.diff(mu).max(),
        "largest deviation from renewal theory": off.max(),
        "largest deviation from the limits": max(off_limits),
    }
    return judged(
        "1G",
        shown=case,
        measured={
            "tau/p at 0.1 mm/s and 1 m/s": [mu[0], mu[-1]],
            **case,
            "largest standard error": max(steady["mu_error"]),
        },
        note="The law itself is run, without the slider. Renewal theory is derived in"
        " docs/tests.md, 'Friction at constant speed'. The limits are read at speeds at which"
        " theory is within 1e-5 of them, and judged with the same 1 %.",
    )


def make(chains, results):
    [point] = chains["steady"]
    steady, limits = point["range"], point["limits"]
    names = ["v [m/s]", "tau/p", "standard error", "renewal theory"]
    columns = (steady[name] + limits[name] for name in ("v", "mu", "mu_error", "mu_theory"))
    write_table(results / "steady-state.csv", names, sorted(zip(*columns)))
    return [claim_1G(steady, limits)]
