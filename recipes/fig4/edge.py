"""Where fronts on prepared interfaces become fast, with slow slip and without: claim 4D-edge."""

from claims.claim import Number
from claims.judge import judged
from measure.tables import write_table
from measure.conventions import PRIMARY

COLUMNS = ("with slow slip: slow from tau_bar_0", "fast from", "without: not arrested from")


def edges_of(points):
    """[(sigma_bar, edges with slow slip, edges without)] under each convention."""
    with_slip, without = (
        {p["sigma-bar"]: p["edges"] for p in points if p["variant"] == name}
        for name in ("reference", "no slow slip")
    )
    return [(sigma, with_slip[sigma], without[sigma]) for sigma in with_slip]


def cases(edges):
    """{convention: case}: between the edges of fast fronts with slow slip and of arrested ones
    without it."""
    return {
        name: {
            "largest difference of the edges": max(
                abs(with_slip[name]["fast"] - without[name]["slow"])
                for _, with_slip, without in edges
            )
        }
        for name in edges[0][1]
    }


def rows(edges):
    for sigma, with_slip, without in edges:
        found = with_slip[PRIMARY]
        yield sigma, found["slow"], found["fast"], without[PRIMARY]["slow"]


def make(points, results):
    edges = edges_of(points)
    write_table(results / "edges.csv", ("sigma_bar", *COLUMNS), rows(edges))
    others = cases(edges)
    shown = others.pop(PRIMARY)
    (difference,) = shown
    measured = shown | {
        "largest difference under other conventions": max(c[difference] for c in others.values()),
        "largest change of the edge of fast fronts by slow slip": max(
            abs(of[name]["fast"] - without[name]["fast"]) for _, of, without in edges for name in of
        ),
    }
    at_zero = edges[0][1][PRIMARY]
    return [
        judged("4D-edge", measured, shown, others=others),
        *(
            Number(f"tau_bar_0 from which fronts are {kind}, sigma_bar = 0", None, at_zero[kind])
            for kind in ("slow", "fast")
        ),
    ]
