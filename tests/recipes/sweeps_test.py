"""Values in sweep files: lists, ranges and units; how points become jobs (recipes/chains)."""

import pytest

from chains.plan import batches_of
from rupture.units import in_si
from chains.values import values_of


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
    "number, jobs", [(0, 0), (1, 1), (24, 24), (64, 64), (65, 33), (859, 62), (60 * 64 + 1, 65)]
)
def test_every_point_is_in_one_batch_in_the_order_of_the_file(number, jobs):
    batches = batches_of(list(range(number)))
    assert sum(batches, []) == list(range(number))
    assert len(batches) == jobs
