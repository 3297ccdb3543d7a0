"""map: pictures of records, and the window that they show."""

import os
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

import rupture
from conftest import SMALL, draws
from rupture import plotting
from rupture.tools.map import LINE, Shown, draw_front_lines, slip_speed, spread


def test_draws_all_or_an_event_or_a_time(small):
    choices = (), ("--event", "first-spanning"), ("--from", "0.5ms", "--to", 1e-3)
    for number, choice in enumerate(choices):
        draws("map", "small-record.h5", "-o", f"map-{number}.png", *choice)
        with Image.open(f"map-{number}.png") as picture:
            assert (picture.format, picture.size) == ("PNG", (2000, 840))
    assert Path("map-0.png").read_bytes() != Path("map-1.png").read_bytes()


def test_draws_several_in_rows_and_says_where_they_come_from(small):
    both = "small-record.h5", "small-record.h5"
    draws("map", *both, "-o", "two.png", "--event", "first-spanning")
    draws("map", *both, "-o", "two.pdf")
    checksum = small.record.checksum
    with Image.open("two.png") as picture:
        assert picture.size == (2000, 1400)
        typed, *files = picture.text["Description"].splitlines()
    assert typed == "rupture map small-record.h5 small-record.h5 -o two.png --event first-spanning"
    assert files == 2 * [f"small-record.h5: content-sha256 {checksum}"]
    assert b"/Subject (rupture map small-record.h5 small" in Path("two.pdf").read_bytes()


def test_the_white_line_is_where_blocks_rupture_first():
    fraction = np.array([[1, 1, 1], [0, 1, 1], [0, 0, 1], [1, 0, 1], [0, 0, 1]], dtype=float)
    times, x = np.arange(5) * 1e-3, np.array([0, 0.5, 1])
    record = SimpleNamespace(time=times, x=x, pinned_fraction=fraction)
    for line, found in ((True, {0.7}), (False, set())):
        axes = plotting.pyplot_without_window().subplots()[1]
        plotting.draw_pinned(axes, record, 0.0, (0, 4), line)
        paths = [path for drawn in axes.collections[1:] for path in drawn.get_paths()]
        corners = [corner for path in paths for corner in path.vertices]
        assert {round(time, 3) for x, time in corners if x == 0} == found


def test_lines_of_fronts_are_those_of_the_reports(small):
    event = rupture.analyze("events", "small-record.h5")["events"][0]
    shown = 2 * [Shown("small-record.h5", small.record, [event], (0.0, 1e-3))]
    axes = plotting.pyplot_without_window().subplots()[1]
    front = rupture.analyze("front", "small-record.h5", event=0)
    expected = np.array(front["t_front"], dtype=float)
    last = (np.nanmax(expected) - 5e-5) * 1e3  # [ms], of the first record
    draw_front_lines(axes, shown, (0.0, 1e-4), (-1.0, last))
    for line, t_zero in zip(axes.lines, (0.0, 1e-4)):
        assert np.allclose(line.get_xdata(), np.array(front["x"]) / 0.14)
        times = (expected - t_zero) * 1e3
        times[times > last] = np.nan
        assert np.allclose(line.get_ydata(), times, equal_nan=True)
    assert np.isnan(axes.lines[0].get_ydata()).sum() > np.isnan(times).sum()
    assert [text.get_text() for text in axes.get_legend().get_texts()] == 2 * ["small-record.h5"]


def test_names_no_event_that_has_no_speed():
    axes = plotting.pyplot_without_window().subplots()[1]
    short = {"v_c": [None, None], "x": [0.0, 0.07], "L": 0.14, "c_s": 1000.0}
    long = short | {"v_c": [-3.0, 1200.0]}  # backwards, forwards
    looks = {0: ("event 0", "k", "o"), 1: ("event 1", "k", "o")}
    plotting.draw_front_speeds(axes, {0: short, 1: long}, looks)
    assert axes.get_legend_handles_labels()[1] == ["event 1"]
    np.testing.assert_equal(axes.lines[0].get_ydata(), [np.nan, 1200.0])


@pytest.mark.parametrize("places", [3 * [0.0] + 3 * [10.0], 200 * [9.5]])
def test_all_events_have_a_number_of_their_own(places):
    assert spread([2, 5, 9], 0, 10) == [2, 5, 9]
    heights = spread(places, 0, 10)
    assert 0 <= heights[0] and heights[-1] <= 10 and len(heights) == len(places)
    assert min(np.diff(heights)) > 9.99 * min(LINE, 1 / len(places))


def test_draws_a_record_without_events(folder):
    files = {"output": "still.h5", "record": "still-record.h5"}
    rupture.run("load", **files, until=2e-3, config=SMALL, set={"driving.V": 0})
    draws("map", "still-record.h5", "-o", "still.pdf")


@pytest.mark.parametrize("name", ["a$^$.h5", os.fsdecode(b"\xff.h5")])
def test_draws_with_any_name(small, name):
    Path(name).write_bytes(Path("small-record.h5").read_bytes())
    draws("map", name, "-o", "odd.png", "-f")
    Path(name).unlink()


def test_the_slip_speed_is_that_of_the_blocks(small):
    record = small.record
    rows = plotting.rows_in(record, 0.0, (0.2, 0.4))
    assert np.allclose(record.time[rows[[0, -1]]], (0.2e-3, 0.4e-3), rtol=1e-9)
    step = record.time[2] - record.time[0]
    speed = np.abs(record["u_x"][rows[2]] - record["u_x"][rows[0]]) / step
    assert np.allclose(slip_speed(record, rows)[1], speed, rtol=1e-9)
