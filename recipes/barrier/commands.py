"""Fronts on prepared interfaces that meet a patch of stronger junctions, 1 to 8 blocks from
x = 70 mm on, with slow slip and without."""

from functools import cache
from itertools import product

from rupture.once import run

from claims.samples import every
from maps import COARSE, start_of

FIRST = 28  # block of the patch, at 70 mm
PLAIN = (0.4, 1)  # mu_s and width of no patch
FRONTS = {0.06: "arrested", 0.1: "slow", 0.15: "fast", 0.3: "very fast"}  # plain, with slow slip
F_NEW = ("zero", "f_slip")  # with slow slip, without
STRENGTHS, WIDTHS = (0.45, 0.5, 0.6, 0.7, 0.8, 1), (1, 2, 4, 8)  # mu_s, blocks


def front_at(tau_bar, strength, width, f_new):
    """The prestress is the same inside: restart, not prepare, changes the strength."""
    prestress = f"--tau-bar {tau_bar} --sigma-bar 0.1 --set junctions.f_new={f_new}"
    start = start_of(prestress)
    patch = f"junctions.mu_s={strength} from 70mm to {70 + 2.5 * (width - 1):g}mm"
    line = f"restart {start} --set '{patch}' -o end.h5 --until-quiet {COARSE}"
    return run(f"analyze front {run(line)['record.h5']}")


@cache
def places():
    """{(tau_bar_0, mu_s, width): (front with slow slip, without)}"""
    patches = [*product(FRONTS, STRENGTHS, WIDTHS), *((tau_bar, *PLAIN) for tau_bar in FRONTS)]
    found = every(front_at, [(*at, f_new) for at in patches for f_new in F_NEW], "fronts")
    return {at: tuple(found[*at, f_new] for f_new in F_NEW) for at in patches}
