"""What decides a verdict is frozen: its digest, and the seeds and places that follow from it."""

from hashlib import sha256

from pytest import fixture, mark, raises
from rupture.errors import Failure

from claims import freeze

FILES = {
    "recipes/frozen.toml": 'D = ""\n[shifts]\n"fig4 tau_bar" = 0\n"fig4 sigma_bar" = 0\n',
    "recipes/claims.toml": "[fig3.3B]\n# a remark\nlimit = 0.1\n",
    "recipes/measure/slip.py": '"""Slip."""\n\nWIDTH = 2  # blocks\n\n\ndef f():\n    """It."""\n'
    '    return "# kept"\n',
    "src/analysis/front.cpp": "// A front.\nint stencil = 5;\n",
    "README.md": "Nothing.\n",
}


@fixture
def root(tmp_path):
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


def edit(root, name, old, new):
    assert old in (text := (root / name).read_text())
    (root / name).write_text(text.replace(old, new))


@mark.parametrize(
    "name, old, new, counts",
    [
        ("recipes/claims.toml", "0.1", "0.2", True),
        ("recipes/claims.toml", "a remark", "another", False),
        ("recipes/measure/slip.py", "= 2", "= 3", True),
        ("recipes/measure/slip.py", "# kept", "# other", True),
        ("recipes/measure/slip.py", "blocks", "of a block", False),
        ("recipes/measure/slip.py", '"""It."""', '"""It\n\n    in words."""', False),
        ("recipes/measure/slip.py", "def f():", "\n\ndef f():", False),
        ("recipes/measure/slip.py", '"""It."""', '"""It."""; return 1', True),
        ("src/analysis/front.cpp", "5", "7", True),
        ("src/analysis/front.cpp", "A front", "The front", False),
        ("README.md", "Nothing", "Something", False),
    ],
)
def test_what_decides_a_verdict_changes_the_digest_and_what_is_said_about_it_does_not(
    name, old, new, counts, root
):
    before = freeze.files_of(root)
    freeze.main(["--write"], root)
    assert not [*freeze.problems(root)]
    edit(root, name, old, new)
    assert (freeze.digest_of(freeze.files_of(root)) != freeze.digest_of(before)) == counts
    assert [of.split(" ")[0] for of in freeze.problems(root)] == [name] * counts


def test_a_new_name_and_a_file_that_is_gone_are_noticed(root):
    freeze.main(["--write"], root)
    (root / "src/analysis/front.cpp").rename(root / "src/analysis/fronts.cpp")
    assert [of.split(" ")[0] for of in freeze.problems(root)] == [
        "src/analysis/front.cpp",
        "src/analysis/fronts.cpp",
    ]


def test_a_change_has_a_reason_and_the_readme_names_its_rows(root, capsys):
    freeze.main(["--write"], root)
    edit(root, "src/analysis/front.cpp", "5", "7")
    change = '{reason = "a fault", rows = ["3B"]}'
    edit(root, "recipes/frozen.toml", "[files]", f'"src/analysis/front.cpp" = {change}\n[files]')
    assert freeze.main([], root) == 1
    assert "README.md does not say: Changed since the freeze: 3B." in capsys.readouterr().err
    edit(root, "README.md", "Nothing.", "Changed since the freeze: 3B.")
    assert freeze.main([], root) == 0


@mark.parametrize(
    "old, new",
    [("seeds = [", "seeds = [7, "), (", ", ".0, "), ('sigma_bar" = 0.', 'sigma_bar" = 1.')],
)
def test_seeds_and_places_that_do_not_follow_are_noticed(old, new, root):
    freeze.main(["--write"], root)
    edit(root, "recipes/frozen.toml", old, new)
    assert "not those that follow from D" in next(freeze.problems(root))


def test_a_version_is_frozen_once(root):
    freeze.main(["--write"], root)
    with raises(Failure, match="frozen already"):
        freeze.main(["--write"], root)


def number(text):
    return int.from_bytes(sha256(text.encode()).digest(), "big")


def test_seeds_and_places_follow_from_the_digest():
    """Of a digest by which the first seeds include none that was used: the numbers themselves."""
    found = freeze.derived("D", ["fig4 tau_bar", "fig4 sigma_bar"])
    assert found["seeds"] == [number(f"D seeds {n}") % 10**6 for n in range(1, 21)]
    assert found["prepared"] == [number(f"D seeds {n}") % 10**6 for n in range(21, 26)]
    shifts = found["shifts"]
    assert abs(shifts["fig4 tau_bar"] + 0.5 - number("D fig4 tau_bar 1") / 2**256) < 1e-6
    assert abs(shifts["fig4 sigma_bar"] - number("D fig4 sigma_bar 1") / 2**256) < 1e-6


def test_seeds_of_earlier_rounds_and_repeated_ones_are_left_out(monkeypatch):
    earlier = [0, 1, 20, 201, 220, 401, 440, 501, 520, 701, 712]
    fresh = [21, 200, 441, 700, 713, *range(1000, 1020)]
    drawn = [*earlier, *fresh[:5], *fresh]
    monkeypatch.setattr(freeze, "numbers", lambda *_: iter(of + 10**6 for of in drawn))
    assert freeze.seeds("D") == fresh
