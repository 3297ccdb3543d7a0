"""Edges between types of fronts by bisection (maps.py), claim edge, and finer lattices; all made
up."""

from itertools import product

from pytest import mark

import maps
from conftest import approx
from convergence import continuum, lattice
from fig4.commands import apart
from measure.ways import PRIMARY
from measure.fronts import TYPES


class TestBisection:
    def test_finds_the_first_of_all(self):
        asked = []

        def is_so(number):
            asked.append(number)
            return number >= 7

        assert maps.first(is_so, 0, 100) == 7
        assert len(asked) <= 7  # 2^7 > 100
        assert maps.first(lambda number: True, 0, 100) == 1

    def test_an_edge_is_halfway_to_the_first_front_of_a_type(self, monkeypatch):
        """Arrested below 0.05, slow below 0.1 and, at the other thresholds, below 0.12 or 0.35:
        beyond where edges are sought first."""
        fast = {PRIMARY: 0.1, "c_s/10": 0.12, "c_s/5": 0.35}

        def kinds(_, steps):
            tau = steps * maps.STEP
            return {way: TYPES[(tau >= 0.05) + (tau >= x)] for way, x in fast.items()}

        monkeypatch.setattr(maps.Interfaces, "kinds_at", kinds)
        interfaces = maps.Interfaces("")
        for kind, way, x in (("slow", PRIMARY, 0.05), *(("fast", *one) for one in fast.items())):
            for near in (None, 0.02, x, 0.2):
                assert interfaces.edge(kind, way, near) == approx(x - maps.STEP / 2)


class TestClaim:
    def test_the_largest_difference_of_all_sigma_bar_counts(self):
        for last, expected in ((0.1005, 0.001), (0.0975, 0.002), (0.0985, 0.001)):
            with_slip = [{"way": {"slow": 0.04, "fast": x}} for x in (0.1, last)]
            without = [{"way": {"slow": x, "fast": 0.2}} for x in (0.101, 0.0995)]
            pairs = [*zip(with_slip, without)]
            of = [apart(pairs, "way", kind) for kind in ("slow", "fast")]
            assert of == approx([expected, 0.2 - min(last, 0.1)])


class TestLattice:
    def test_what_a_length_bears_is_kept(self):
        for N_x, N_z, N_s, r, stencil, dt in (
            (57, 31, 100, 1, 5, 2e-7),
            (225, 121, 26, 1 / 4, 17, 5e-8),
            (449, 241, 100, 1 / 8, 33, 1.25e-8),
        ):
            of = lattice.scaled(N_x, N_s)
            p_i, m = of["slider.F_N"] / N_x, of["slider.M"] / (N_x * N_z)
            assert (of["slider.Nx"], of["slider.Nz"], of["numerics.dt"]) == (N_x, N_z, approx(dt))
            assert (p_i, m) == (approx(1920 / 57 * r), approx(0.0756 / (57 * 31) * r**2))
            assert of["slider.damping"] * m == approx(0.1 * 0.0756 / (57 * 31))
            assert N_s * of["junctions.kappa"] * p_i == approx(39.2e9 * 100 * 1920 / 57 * r**2)
            slow_below = 0.05 * (of["slider.M"] / 0.0756) ** 0.5
            words = lattice.ways(N_x, of["slider.M"])[lattice.SCALED].split()
            assert words[:3] == ["--stencil", str(stencil), "--slow-below"]
            assert float(words[3]) == approx(slow_below)

    @mark.parametrize(
        "edges, limit, error",
        [
            ([0.18, 0.14, 0.12], 0.1, 0.0015),  # straight
            ([0.2, 0.14, 0.12, 0.11], 0.1, 0.0015),  # the three finest count
            ([0.2, 0.125, 0.10625], 0.0875, 0.039),  # order 2: far from the line before
            ([0.102, 0.1, 0.097], 0.094, 0.0057),  # no order: 1/2
            ([0.1, 0.1, 0.101], 0.102, 0.0035),
        ],
    )
    def test_the_limit_is_on_a_line(self, edges, limit, error):
        assert continuum.continuum(edges) == (limit, error)

    def test_what_becomes_of_the_map(self):
        def edges(setting, sigma):
            for r in (1, 1 / 2, 1 / 4):
                fast = 0.1 if sigma else round(0.1 + 0.1 * r, 3)
                yield {"slow": 0.05 if setting.startswith("reference") else fast, "fast": fast}

        places = product(continuum.SETTINGS, continuum.SIGMAS)
        of = {place: [*edges(*place)] for place in places}
        of["no-slow-slip", 0.285].append({"slow": 0.1, "fast": 0.2})
        found = continuum.by_front(of)
        names = ["lattice: slow fronts at sigma_bar 0", "lattice: shift by the width of phi"]
        band, phi = (continuum.measured(found)[name].split(", ")[0] for name in names)
        assert (band, phi) == ("remains", "need not remain")
        assert found["without slow slip", 0.285, "fast from"] == [0.1, 0.1, 0.1, 0.2]
        row = ["without slow slip", 0, "not arrested from", 0.2, 0.15, 0.125, "not computed"]
        assert next(continuum.rows(found)) == [*row, approx(0.1), approx(0.0015)]

    def test_edges_are_sought_from_where_the_coarser_ones_lead(self, monkeypatch):
        asked = []

        def edges_on(N_x, setting, sigma_bar, guesses):
            asked.append((N_x, approx(guesses["slow"]), guesses["fast"]))
            return {"slow": 0.1 + 5.6 / N_x, "fast": 0.2}

        monkeypatch.setattr(lattice, "edges_on", edges_on)
        lattice.edges_of("reference", 0)
        fine = [0.1 + 5.6 / N_x for N_x in (57, 113)]
        moved = fine[1] + (fine[1] - fine[0]) / 2
        assert asked == [(57, 0.1, 0.1), (113, fine[0], 0.2), (225, moved, 0.2)]
        assert len(lattice.edges_of("no-slow-slip", 0)) == 4
