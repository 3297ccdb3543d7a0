"""Bands of slow fronts whose edges edges.py has bisected, beside those of the reference."""

from events.conventions import PRIMARY


def bands_of(points, variant, seed=1):
    """{sigma_bar: (edges of a variant, edges of the reference)}, of a chain with both."""
    of_variant, reference = (
        {p["sigma-bar"]: p["edges"] for p in points if (p["variant"], p["numerics.seed"]) == which}
        for which in ((variant, seed), ("reference", 1))
    )
    return {sigma: (edges, reference[sigma]) for sigma, edges in of_variant.items()}


def width(edges, convention=PRIMARY):
    """The width of the band in tau_bar_0."""
    return edges[convention]["fast"] - edges[convention]["slow"]
