"""Edges between types of fronts on finer lattices (lattice.py), and what they become in the
continuum by the rule in README.md."""

from itertools import product

from rupture.figures import BLACK, BLUE, VERMILION

from convergence.lattice import PER_LENGTH, STEP, spacing

LATTICES = (57, 113, 225, 449)  # blocks along x
SETTINGS = {  # for readers
    "no-slow-slip": "without slow slip",
    "no-slow-slip-half": "without slow slip, half edge springs",
    "reference": "with slow slip",
    "reference-half": "with slow slip, half edge springs",
    "no-slow-slip-per-length": f"without slow slip, {PER_LENGTH}",
}
OFF, OFF_HALF, ON, *_ = SETTINGS.values()
SIGMAS = {0: BLACK, 0.1: BLUE, 0.285: VERMILION}
KINDS = {"not arrested from": "slow", "fast from": "fast"}
COLUMNS = ["interfaces", "sigma_bar", "front", *LATTICES, "continuum", "error"]
ORDERS = (2, 0.5)  # most and least


def by_front(edges):
    """{(interfaces, sigma_bar, front): edges on the lattices from coarse to fine}"""
    return {
        (words, sigma, front): [edge[kind] for edge in edges[name, sigma]]
        for (name, words), sigma, (front, kind) in product(SETTINGS.items(), SIGMAS, KINDS.items())
    }


def continuum(edges, step=STEP):
    """The limit of edges on three or more lattices whose spacing halves, and its error."""
    before, last = edges[-2] - edges[-3], edges[-1] - edges[-2]
    line, line_before = edges[-1] + last, edges[-2] + before
    low, high = (2**-order for order in ORDERS)
    ratio = min(max(last / before, low), high) if before else high
    richardson = edges[-1] + last * ratio / (1 - ratio)
    error = max(abs(line - line_before), abs(line - richardson)) + 1.5 * step
    return round(line, 4), round(error, 4)


def compared(high, low):
    """How far two edges are apart, and whether still so in the continuum."""
    found = [a - b for a, b in zip(high, low)]
    limit, error = continuum(found, 2 * STEP)
    fate = "remains" if limit > error else "need not remain"
    return f"{fate}, {limit:.3f} +- {error:.3f} ({found[0]:.3f} on the paper's lattice)"


def measured(edges):
    """The limits of all edges, and what becomes of the paper's map."""
    limits = {
        f"lattice, {name}, sigma_bar {sigma:g}: {front}, and its error": [*continuum(found)]
        for (name, sigma, front), found in edges.items()
    }
    arrested, fast = KINDS
    bands = {
        f"lattice: slow fronts at sigma_bar {sigma:g}": compared(
            edges[ON, sigma, fast], edges[ON, sigma, arrested]
        )
        for sigma in SIGMAS
    }
    phi = compared(edges[OFF, min(SIGMAS), arrested], edges[OFF, max(SIGMAS), arrested])
    return limits | bands | {"lattice: shift by the width of phi": phi}


def rows(edges):
    for key, found in edges.items():
        missing = ["not computed"] * (len(LATTICES) - len(found))
        yield [*key, *found, *missing, *continuum(found)]


def draw(panels, edges):
    for axes, interfaces in zip(panels, (OFF, OFF_HALF, ON)):
        for (sigma, colour), (front, marker) in product(SIGMAS.items(), zip(KINDS, "o^")):
            found, look = edges[interfaces, sigma, front], {"color": colour, "markersize": 3.5}
            x = [spacing(N_x) for N_x in LATTICES[: len(found)]]
            label = rf"$\bar\sigma$ = {sigma:g}" if marker == "o" else None
            axes.plot(x, found, marker, label=label, **look)
            limit, error = continuum(found)
            axes.errorbar(0, limit, error, fmt=marker, capsize=2, **look)
            axes.plot([0, x[-1]], [limit, found[-1]], ":", linewidth=0.8, **look)
        axes.set(xlabel="spacing/paper's spacing", xlim=(-0.06, 1.06), ylim=(0, 0.24))
        axes.set_title(interfaces.replace(", ", ",\n"))
    panels[0].set_ylabel(r"$\bar\tau_0$")
    panels[0].legend(loc="lower right")
