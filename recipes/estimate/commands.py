"""The SI's arithmetic of slow slip: relaxations of a block."""

from functools import cache
from types import SimpleNamespace

from rupture.once import run

from claims.samples import Samples, every
from events import shipped

SLIP = "over_f_slip_per_k_ij"


def relaxation(seed):
    """The relaxation of another block, with slipping times of its own."""
    report = run(f"analyze estimate {shipped('fast-slow-fast')} --seed {seed} --ensemble 2")
    return report.relaxation


@cache
def estimates():
    """A force 600 times f_slip is out of reach in the relaxation."""
    unbreakable = run("load -o unbreakable.h5 --until 0 --set junctions.mu_s=100")["unbreakable.h5"]
    return SimpleNamespace(
        reference=run(f"analyze estimate {shipped('fast-slow-fast')} --ensemble 1000"),
        unbreakable=run(f"analyze estimate {unbreakable} --ensemble 1000"),
        relaxations=[*every(relaxation, [(n,) for n in range(1, 51)], "relaxations").values()],
    )


def net_slip(estimate):
    return estimate[f"net_slip_{SLIP}"]


def both():
    return Samples({"": estimates()})


def slip(of, _):
    """SI-slip"""
    return {
        "net slip [f_slip/k_ij]": net_slip(of.reference),
        "net slip without re-breaking [f_slip/k_ij]": net_slip(of.unbreakable),
        "slip until 2<t_R> [f_slip/k_ij]": of.reference[f"slip_after_two_t_R_{SLIP}"],
        "none slips any more after [<t_R>]": of.reference.quiet_after_over_t_R,
    }


def duration(of, _):
    """SI-time"""
    return {
        "all junctions have been pinned once after [<t_R>]": of.reference.duration_over_t_R,
        "with standard deviation [<t_R>]": of.reference.duration_over_t_R_deviation,
        "slip until then [f_slip/k_ij]": of.reference[f"slip_at_return_{SLIP}"],
    }
