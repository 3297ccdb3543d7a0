"""Bands of slow fronts whose edges edges.py has bisected, beside those of the reference."""

from data.records import report
from events.conventions import PRIMARY

SIGMA_BARS = ("0", "0.1")


def bands_of(data, setting, seed=1):
    """{sigma_bar: (edges with a setting of runs/edges.smk, edges of the reference)}"""
    return {
        sigma: [
            report(data / f"edges/{run}.json")
            for run in (f"{setting}-{sigma}-{seed}", f"reference-{sigma}-1")
        ]
        for sigma in SIGMA_BARS
    }


def width(edges, convention=PRIMARY):
    """The width of the band in tau_bar_0."""
    return edges[convention]["fast"] - edges[convention]["slow"]
