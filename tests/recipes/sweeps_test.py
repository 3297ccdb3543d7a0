"""Values in sweep files, their products, and tables of points (recipes/chains)."""

import re

import pytest

from chains.check import check
from chains.selection import Chains
from rupture.errors import UsageError
from chains.plan import batches_of
from rupture.units import in_si
from chains.values import values_of

COMMANDS = "[commands]\nstart = prepare {values} -o start.h5\n"


@pytest.fixture
def read(tmp_path):
    """The points of a file with this text."""

    def read(text, name="sweep"):
        path = tmp_path / f"{name}.ini"
        path.write_text(text, encoding="utf-8")
        chains = Chains()
        check(chains, chains.load(path))
        return chains.points(chains.load(path))

    return read


@pytest.mark.parametrize(
    "text, expected",
    [
        ("0 to 0.4 by 0.1", "0 0.1 0.2 0.3 0.4"),
        ("0 to 0.3 by 0.1", "0 0.1 0.2 0.3"),  # 0.3/0.1 is below 3
        ("0 to 0.3 in 4", "0 0.1 0.2 0.3"),
        ("5 to 1 by -2", "5 3 1"),
        ("2 to 2 in 1", "2"),
        ("1 to 3", "1 2 3"),
        ("0 to 1 by 0.4", "0 0.4 0.8"),
        ("1e-3, 0.002,bell", "1e-3 0.002 bell"),
        ("1mm/s, 2e-3", "1mm/s 2e-3"),
        ("0, 1mm/s,2mm/s", "0 1mm/s 2mm/s"),
        ("1 to 3 ms", "1ms 2ms 3ms"),
        ("0 to 2mm/s by 1 mm/s", "0mm/s 1mm/s 2mm/s"),
        ("1um to 3µm by 1μm", "1μm 2μm 3μm"),
    ],
)
def test_lists_and_ranges(text, expected):
    assert values_of(text) == expected.split()


WRONG_LISTS = {
    "no values: the step": ["0 to 1 by 0", "0 to 1 by -1", "0 to 1 in 0", "1 to -1e300 by 1e-300"],
    "more than 100,000 values": ["0 to 1 in 1e300", "1 to 1e7", "1 to 1e300 by 1e-300"],
    "'x' is not a number": ["0 to x by 1"],
    "'inf' is not a number": ["1 to inf"],
    "'nan' is not a number": ["0 to 1 by nan"],
    "must be finite": ["0 to 1 in 1e400", "-1e308 to 1e308"],
    "must be whole": ["0 to 1 in 2.5"],
    "give its step": ["0.1 to 0.5", "1 to 2.5", "1.5 to 3 ms"],
    "the same unit": ["1ms to 2s by 1ms", "1ms to 2ms in 3ms"],
    "has an empty value": ["1,,2", ""],
    "is unclear: write 0.4mm/s, or 0mm/s, 4mm/s$": ["0,4mm/s"],
    "is unclear: write 0.1mm/s, 4 mm/s$": ["0.1, 4 mm/s", "0.1,4 mm/s"],
}


@pytest.mark.parametrize("sentence", WRONG_LISTS)
def test_wrong_lists_and_ranges(sentence):
    for text in WRONG_LISTS[sentence]:
        with pytest.raises(ValueError, match=f"'{text}'.*{sentence}"):
            values_of(text)


@pytest.mark.parametrize(
    "text, number, unit",
    [
        ("10ms", 0.01, "s"),
        ("0.8 s", 0.8, "s"),
        ("-.5e1", -5, ""),
        ("3GPa", 3e9, "Pa"),
        ("75.6g", 0.0756, "kg"),
        ("1kg", 1, "kg"),
        ("4kN/m", 4000, "N/m"),
        ("0.3µm", 0.3e-6, "m"),
        ("1mm", 1e-3, "m"),
        ("1m", 1, "m"),
        ("2mm/s", 0.002, "m/s"),
        ("1e999", float("inf"), ""),
        ("1e99999999ms", float("inf"), "s"),
    ],
)
def test_numbers_with_units(text, number, unit):
    assert in_si(text) == (number, unit)


@pytest.mark.parametrize(
    "text", ["1k", "1 1", "10Ms", "nan", "1mmm", "1 kHz", "N/m^2", "", "1e-400", "1e-323ms"]
)
def test_no_numbers(text):
    with pytest.raises(ValueError, match="is not a number"):
        in_si(text)


@pytest.mark.parametrize(
    "text, expected",
    [
        ("a = 1, 2\nb = 3, 4", "a1b3 a1b4 a2b3 a2b4"),  # the last one varies fastest
        ("c = sqrt({b})\nb = {a} ** 2 * 4\na = 1, 3", "c2b4a1 c6b36a3"),
        ("a = -2\nb = {a} ** 2", "a-2b4"),
        ("a = 2ms\nb = 0.3 * {a}", "a2msb0.0006"),
        ("a = 4 kN/m\nb = {a} / 2", "a4_kN/mb2000"),
        ("a = 1, 2  # both\n", "a1 a2"),
        # variants replace common values
        (
            "a = 1\nb = 2\n[variant X]\na = 5, 6\n[variant Y]\nb = 7",
            "variantXa5b2 variantXa6b2 variantYa1b7",
        ),
    ],
)
def test_every_combination_is_a_point(read, text, expected):
    points = read(f"[sweep]\n{COMMANDS}[values]\n{text}")
    found = ["".join(sum(point.values.items(), ())).replace(" ", "_") for point in points]
    assert found == expected.split()


def test_points_from_a_table(read, tmp_path):
    text = f"[sweep]\npoints = ../points.csv\n{COMMANDS}[values]\nseed = 1, 2"
    (tmp_path / "x").mkdir()
    table = tmp_path / "points.csv"
    for content in (b"a, b\n1, 2\n3,4\n", b"\xef\xbb\xbfa,b\r\n1,2\r\n\r\n3,4\r\n"):
        table.write_bytes(content)
        found = [tuple(p.values.values()) for p in read(text, "x/sweep")]
        assert found == [("1", "1", "2"), ("2", "1", "2"), ("1", "3", "4"), ("2", "3", "4")]
        assert list(read(text, "x/sweep")[0].values) == ["seed", "a", "b"]
    table.write_text("driving.V [mm/s],variant,status,v [m/s],type\n0.4,x,done,2,slow\n")
    values = {"seed": "1", "driving.V": "0.4mm/s", "variant": "x"}
    assert read(text, "x/sweep")[0].values == values


@pytest.mark.parametrize(
    "content, sentence",
    [
        (b"a,b\n0.1\n", "points.csv, line 2: it needs as many cells as the first line"),
        (b"a,b\n0.1,1\n\n0.2,1,5\n", "points.csv, line 4: it needs as many cells"),
        (b"a,a [m]\n0.1,1\n", "points.csv: each column needs a heading of its own"),
        (b"a,\n0.1,1\n", "points.csv: each column needs a heading of its own"),
        (b"a\n\xff\n", "points.csv is not a CSV table in UTF-8"),
    ],
)
def test_wrong_tables_of_points(read, tmp_path, content, sentence):
    (tmp_path / "points.csv").write_bytes(content)
    with pytest.raises(UsageError, match=sentence):
        read(f"[sweep]\npoints = points.csv\n{COMMANDS}")


WHOLE = f"[sweep]\n{COMMANDS}"


@pytest.mark.parametrize(
    "text, sentence",
    [
        ("", "no section .commands."),
        *((f"{WHOLE}x = load {{{n}}}\n", f"there is no '{n[:6]}'") for n in ("o", "values.x")),
        *((f"{WHOLE}[values]\na = {n}\n", "depend on itself") for n in ("{a}", "{a}.real")),
        *(  # no finite real number
            (f"{WHOLE}[values]\nb = 9\na = {text}", re.escape(f"'{text}' "))
            for text in ("{z} + 1", "__import__('os') * {b}", "1 / 0 * {b}", "{b} +", "{b} + x")
            + ("{b}**{b}**{b}**{b}", "sqrt({b} - 10)", "({b} - 10) ** 0.5", "{b} * 1e308 * 10")
        ),
        (f"{WHOLE}[values]\na = 1 to 1e5\nb = 1 to 1e5", "10,000,000,000 points; at most 100,000"),
        (f"{WHOLE}[values]\na\n", r"line 5: expected NAME = VALUE or .SECTION. \(got 'a'\)"),
        (f"{WHOLE}[values]\na = 1\na = 2\n", "'a' in section 'values' already exists"),
        (f"{WHOLE}[values]\n[values]\n", "section 'values' already exists"),
        (f"{WHOLE}[DEFAULT]\na = 1\n", "no section 'DEFAULT'"),
        ("[sweep]\nprepare =\n[quantities]\na = b\n", "older form.*prepare = prepare {values} -o"),
        ("[sweep]\nload = --until 1\n", "older form.*load = load --until 0.5 {values} -o"),
        ("[sweep]\nbase = b.h5\nrestart = --for 1\n", "older form.*restart = restart {base}"),
        (f"{WHOLE}[analyze]\nfront = --x 1\n", "older form.*front = analyze front record.h5"),
        (f"{WHOLE}[table]\na = b.c\n", "'table' belongs to an older form.*.quantities."),
        *(
            (f"[sweep]\n{need}\n{COMMANDS}", f"'{need}' is not understood: give a")
            for need in ("memory = 10", "memory = 0 MB", "memory = 2 kg", "memory = .")
            + ("threads = 0", "threads = 1.5")
        ),
    ],
)
def test_what_is_wrong_is_said_with_the_file(read, text, sentence):
    with pytest.raises(UsageError, match=f"sweep.ini[:,] .*{sentence}"):
        read(text)


@pytest.mark.parametrize(
    "number, jobs", [(0, 0), (1, 1), (24, 24), (64, 64), (65, 33), (859, 62), (60 * 64 + 1, 65)]
)
def test_every_point_is_in_one_batch_in_the_order_of_the_file(number, jobs):
    batches = batches_of(list(range(number)))
    assert sum(batches, []) == list(range(number))
    assert len(batches) == jobs
