#!/usr/bin/env python3
"""Table and claim of Figure 1 G: speeds.py RANGE.json LIMITS.json table.csv claims.json"""

import sys

import numpy as np

from claims.claim import write_claims
from claims.judge import judged
from data.records import report
from data.tables import write_table

LIMITS = (0.4 / 2, 0.17)  # mu_s/2 and mu_d of the reference parameters


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
            "speeds": len(mu),
            "tau/p at 0.1 mm/s and 1 m/s": [mu[0], mu[-1]],
            **case,
            "largest standard error": max(steady["mu_error"]),
            "tau/p at 1 nm/s (mu_s/2 = 0.2)": limits["mu"][0],
            "tau/p at 1 km/s (mu_d = 0.17)": limits["mu"][1],
        },
        note="The law itself is run, without the slider. Renewal theory is derived in"
        " docs/tests.md, 'Friction at constant speed'. The limits are read at speeds at which"
        " theory is within 1e-5 of them, and held to the same 1 %.",
    )


def rows(*reports):
    for steady in reports:
        yield from zip(steady["v"], steady["mu"], steady["mu_error"], steady["mu_theory"])


def main(steady, limits, table, claims):
    steady, limits = report(steady), report(limits)
    names = ["v [m/s]", "tau/p", "standard error", "renewal theory"]
    write_table(table, names, sorted(rows(steady, limits)))
    write_claims(claims, [claim_1G(steady, limits)])


if __name__ == "__main__":
    main(*sys.argv[1:])
