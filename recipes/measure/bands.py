"""Bands of slow fronts whose edges edges.py has bisected, beside those of the reference."""

from measure.conventions import PRIMARY


def bands_of(changed, reference):
    """{sigma_bar: (edges of the changed interfaces, edges of the reference)} of points."""
    edges = {point["sigma-bar"]: point["edges"] for point in reference}
    return {p["sigma-bar"]: (p["edges"], edges[p["sigma-bar"]]) for p in changed}


def width(edges, convention=PRIMARY):
    """The width of the band in tau_bar_0."""
    return edges[convention]["fast"] - edges[convention]["slow"]
