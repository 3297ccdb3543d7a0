"""Values in files of sweeps: lists, ranges, units, arithmetic, tables, and their combinations
(recipes/sweeps/values.py)."""

import time

import pytest

from rupture.errors import UsageError
from rupture.units import in_si
from sweeps.values import LIMIT, calculated, combined, rows_in, values_of


@pytest.mark.parametrize(
    "text, expected",
    [
        ("0 to 0.4 by 0.1", "0 0.1 0.2 0.3 0.4"),
        ("0 to 0.3 by 0.1", "0 0.1 0.2 0.3"),  # 0.3/0.1 is below 3
        ("0 to 0.3 in 4", "0 0.1 0.2 0.3"),
        ("5 to 1 by -2", "5 3 1"),
        ("1e-3, 0.002,bell", "1e-3 0.002 bell"),
        ("1 to 3 ms", "1ms 2ms 3ms"),
        ("1um to 3µm by 1μm", "1μm 2μm 3μm"),
    ],
)
def test_lists_and_ranges(text, expected):
    assert values_of(text) == expected.split()


def test_values_along_x_are_no_ranges():
    one = "0.5 from 70mm to 84mm"
    assert values_of(one) == [one]
    assert values_of(f"{one}, 0.6 from 0mm to 7mm and {one}") == [
        one,
        f"0.6 from 0mm to 7mm and {one}",
    ]


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
    "is unclear: 0 needs a unit, too; decimals have a point$": ["0,4mm/s"],
    "is unclear: 0.1 needs a unit, too": ["0.1, 4 mm/s", "0.1,4 mm/s", "2mm/s, 0.1, 4 mm/s"],
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
        ("-.5e1", -5, ""),
        ("75.6g", 0.0756, "kg"),
        ("4kN/m", 4000, "N/m"),
        ("0.3µm", 0.3e-6, "m"),
        ("1mm", 1e-3, "m"),
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


# --- arithmetic, and all points ------------------------------------------------------------------


@pytest.mark.parametrize(
    "text, value",
    [
        ("1 + 2 * {x}", "7"),
        ("-{x} ** 2 / 2", "-4.5"),
        ("{m} ** 2", "4"),
        ("sqrt(({x} + 1) * 4) - 1e-3", "3.999"),
        ("0.3 * {t}", "0.0006"),
        ("{t}", "2ms"),
        (
            "0.1 * {x} from {x} to 84mm and 1 from 0 to 1mm",
            "0.3 from 3 to 84mm and 1 from 0 to 1mm",
        ),
        ("{y} * 2", "6"),
    ],
)
def test_arithmetic_of_numbers(text, value):
    others = {"y": "1 * {x}", "x": "3", "m": "-2", "t": "2ms", "w": "word"}
    assert calculated({"a": text} | others)["a"] == value


REFUSED = {  # no finite real number, or no arithmetic; none of them takes time
    "{x} / 0": "division",
    "{x} ** {x} ** {x} ** {x} ** {x}": "not a finite real number",
    "({x} - 10) ** 0.5": "not a finite real number",
    "sqrt(({x} - 10) ** 0.5)": "not a finite real number",
    "sqrt({x} - 10)": "not a finite real number",
    "{x} * ...": "it may have",
    "{x} * 1e308 * 10": "not a finite real number",
    "{x} +": "no formula",
    "{x} // 2": "it may have",
    "sqrt({x}, 2)": "it may have",
    "__import__('os') * {x}": "it may have",
    f"{'-' * 150}{{x}} +": "no formula",
    f"{'(' * 95}{{x}}{')' * 95}{{x}}": "",
    f"{'1' * 150}x * {{x}}": "it may have",
    "{w} * 2": "'word' is no number",
    "{a} + 1": "cannot depend on itself",
    "{z} + 1": "there is no value 'z'",
}


@pytest.mark.parametrize("text", REFUSED)
def test_other_formulas_are_refused_at_once(text):
    with pytest.raises(ValueError, match=REFUSED[text]):
        print(calculated({"a": text, "x": "3", "w": "word"}))


LONG = ["1" * 201, f"1 {'to ' * 100}2", f"0.5 {'from ' * 60}", "{x} from {x} to {x}"]


@pytest.mark.parametrize("text", LONG)
def test_long_values_are_refused_at_once(text):
    with pytest.raises(UsageError, match="longer than 200 letters"):
        print(calculated({"a": values_of(text)[0], "x": "1" * 100}))


def test_many_blanks_take_no_time(folder):
    blanks, begun = " " * 100_000, time.process_time()
    assert values_of(f"1,{blanks}2") == ["1", "2"]
    (folder / "p.csv").write_text(f"a{blanks}b\n1\n")
    with pytest.raises(UsageError, match="p.csv, line 1: .*longer than 200 letters"):
        rows_in(folder / "p.csv")
    assert time.process_time() - begun < 1


def in_short(points):
    return ["".join(sum(values.items(), ())) for values in points]


@pytest.mark.parametrize(
    "lists, points",
    [
        ({"values": {"a": ["1", "2"], "b": ["3", "4"]}}, "a1b3 a1b4 a2b3 a2b4"),
        ({"values": {"c": ["2 * {a}"], "a": ["1", "3"]}}, "c2a1 c6a3"),
        (
            {"values": {"a": ["1"], "b": ["2"]}, "variant X": {"a": ["5"]}, "variant Y": {}},
            "variantXa5b2 variantYa1b2",
        ),
    ],
)
def test_every_combination_is_a_point_and_the_last_name_varies_fastest(lists, points):
    assert in_short(combined(lists, [{}])) == points.split()


TABLES = [  # a table (csv_test.py has more), and its points with two seeds
    ("a, b\n1, 2\n3,4\n", "seed1a1b2 seed2a1b2 seed1a3b4 seed2a3b4"),
    (
        "driving.V [mm/s],status,v [m/s]\n0.4,done,2\n",
        "seed1driving.V0.4mm/s seed2driving.V0.4mm/s",
    ),
    ('a\n"x ""y"" z"\n', 'seed1ax_"y"_z seed2ax_"y"_z'),
]


@pytest.mark.parametrize("text, points", TABLES)
def test_points_of_a_table(folder, text, points):
    (folder / "p.csv").write_text(text)
    found = in_short(combined({"values": {"seed": ["1", "2"]}}, rows_in(folder / "p.csv")))
    assert [one.replace(" ", "_") for one in found] == points.split()


WRONG_TABLES = [  # csv_test.py has more
    (b"a\n\xff\n", "p.csv: it is not UTF-8 text"),
    *(
        (f"a\n1{c}2\n".encode(), "p.csv, line .*control character")
        for c in "\0\x1b\x85\u2028\u202e"
    ),
    ("a\x1b\n1\n".encode(), "p.csv, line 1: there is a control character, U.001B"),
    (b"a\n" + b"1" * 201, "p.csv, line 2: .*longer than 200 letters"),
]


@pytest.mark.parametrize("content, sentence", WRONG_TABLES)
def test_wrong_tables_of_points(folder, content, sentence):
    (folder / "p.csv").write_bytes(content)
    with pytest.raises(UsageError, match=sentence):
        rows_in(folder / "p.csv")


def test_too_many_points_are_refused_before_they_are_made():
    many = [str(n) for n in range(LIMIT)]
    with pytest.raises(UsageError, match="10,000,000,000 points; at most 100,000"):
        list(combined({"values": {"a": many, "b": many}}, [{}]))
