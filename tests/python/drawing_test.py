"""map, movie and xdmf: pictures and the window that they show, films, packages that are missing,
and files that appear whole or not at all. What they refuse is in tools/tables/drawing.txt."""

import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from unittest import mock

import numpy as np
import pytest
from PIL import Image

import rupture
from commands import refuses
from conftest import BIN, SMALL, draws, run, started
from progress_test import on_terminal
from rupture import plotting
from rupture.replacing import replacing
from rupture.tools.command_line import CLEAR, Failure
from rupture.tools.map import LINE, Shown, draw_front_lines, figure_of, gaps_of, patches_of
from rupture.tools.map import slip_speed, spread
from rupture.tools.movie import SLOWEST, chosen_samples, front_at, speeds_of
from rupture.tools.output import EXISTS, complete


def test_draws_an_event_or_a_time(small):
    choices = ("--event", "first-spanning"), ("--from", "0.5ms", "--to", 1e-3)
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
        typed, *files = picture.info["Description"].splitlines()
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


# Block 0 is pinned again before block 1 ruptures; block 2 ruptures soon after that.
LATER = np.array([[1, 1, 1], [0, 1, 1], [0.6, 1, 1], [0.1, 1, 1], [0, 0.1, 1], [0, 0, 0.1]])


def test_fronts_that_break_again_are_not_joined():
    times, x = np.arange(6) * 1e-3, np.array([0, 0.5, 1])
    record = SimpleNamespace(time=times, x=x, pinned_fraction=LATER, path=Path("r.h5"))
    axes = plotting.pyplot_without_window().subplots()[1]
    front = {"x": x, "L": 1.0, "t_front": [0.7e-3, 3.7e-3, 4.7e-3]}
    with mock.patch("rupture.tools.map.fronts_of", return_value=([], {0: front})):
        draw_front_lines(axes, [Shown("r.h5", record, [], ())], [0.0], [(0, 5)])
    np.testing.assert_allclose(axes.lines[0].get_ydata(), [0.7, np.nan, 3.7, 4.7])
    assert gaps_of(record, np.array([0.7e-3, 0.9e-3, np.nan])) == []
    plotting.draw_pinned(axes, record, 0.0, (0, 5))
    paths = [path for drawn in axes.collections[1:] for path in drawn.get_paths()]
    places = np.concatenate([path.vertices for path in paths])
    beside = (places[:, 0] > 0) & (places[:, 0] < 0.5)
    assert not ((places[:, 1] > 1.4) & (places[:, 1] < 2.6) & beside).any()


def test_rows_have_their_own_times_and_patches(small):
    patch = {"junctions.mu_s": "0.5 from 70mm to 80mm", "junctions.t_R": [1e-4, *16 * [2e-4]]}
    files = {"output": "b.h5", "record": "b-r.h5"}
    other = rupture.run("restart", "small.h5", **files, for_=0.01, set=patch).record
    windows = (0, 0.002), (0.002, 0.012)
    shown = map(Shown, ("small-record.h5", "b-r.h5"), (small.record, other), ([], []), windows)
    axes = figure_of([*shown], since_event=False).axes
    assert [axes[row].get_ylim() for row in (0, 3)] == [(0, 2), (2, 12)]
    assert [len(axes[row].lines) for row in (0, 3)] == [0, 6]
    strips = [strip for panel in axes[:6] for strip in panel.child_axes]
    assert [strip.get_title("left") for strip in strips] == [
        r"$\mu_{s}$, junctions.mu_s: 0.4 to 0.5",
        "$t_{R}$, junctions.t_R: 0.0001 to 0.0002 s",
    ]
    np.testing.assert_array_equal(strips[1].lines[0].get_ydata(), [1e-4, *16 * [2e-4]])


def test_patches_are_marked_where_they_and_slopes_begin_and_end():
    values = {"flat": 3, "slope": [0, 0, 1, 2, 3, 3], "patch": [0, 0, 0, 0, 7, 0]}
    record = SimpleNamespace(x=np.arange(6.0), parameters=values)
    assert patches_of(record) == {"slope": [0.3, 0.7], "patch": [0.7, 0.9]}


def test_lines_of_fronts_are_those_of_the_reports(small):
    event = rupture.analyze("events", "small-record.h5")["events"][0]
    shown = 2 * [Shown("small-record.h5", small.record, [event], (0.0, 1e-3))]
    axes = plotting.pyplot_without_window().subplots()[1]
    front = rupture.analyze("front", "small-record.h5", event=0)
    expected = np.array(front["t_front"], dtype=float)
    last = (np.nanmax(expected) - 5e-5) * 1e3  # [ms], of the first record
    draw_front_lines(axes, shown, (0.0, 1e-4), 2 * [(-1.0, last)])
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


@pytest.mark.skipif(not shutil.which("ffmpeg"), reason="ffmpeg is not installed")
def test_writes_a_video(small):
    draws("movie", "small-record.h5", "-o", "x.mp4", "--frames", 2, "--event", 0)
    assert Path("x.mp4").read_bytes()[4:8] == b"ftyp"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGUSR2])
def test_interrupted_ends_by_the_signal_and_leaves_nothing(small, number):
    before = sorted(Path().iterdir())
    command = [str(BIN / "movie"), "small-record.h5", "-o", "z.gif"]
    with subprocess.Popen(command, stderr=subprocess.PIPE) as it:
        while not list(Path().glob(".z.tmp.*")):
            assert it.poll() is None
        it.send_signal(number)
        assert it.communicate()[1] == b""
    assert (it.returncode, sorted(Path().iterdir())) == (-number, before)


@pytest.mark.parametrize("at", ["touch: real(*words, **named); kill()", "unlink: kill()"])
def test_a_signal_at_the_moment_of_a_call_leaves_no_file(folder, at):
    call, body = at.split(": ")
    code = f"""
import os, signal
from pathlib import Path
from rupture import replacing
signal.signal(signal.SIGUSR2, replacing.end_by_signal)
kill = lambda: os.kill(os.getpid(), signal.SIGUSR2)
real = Path.{call}
def {call}(*words, **named):
    Path.{call} = real
    {body}
Path.{call} = {call}
with replacing.temporary_for(Path("z.gif")):
    pass
"""
    ended = subprocess.run([sys.executable, "-c", code], check=False)
    assert (ended.returncode, list(Path().glob(".z.tmp.*"))) == (-signal.SIGUSR2, [])


def test_frames_are_even_and_in_the_window():
    time = np.arange(101.0)
    assert list(chosen_samples(time, (20, 60), 5)) == [20, 30, 40, 50, 60]
    assert len(chosen_samples(time, (20, 22), 50)) == 3


def test_fields_colour_the_slider_but_for_times_without_any(folder):
    fields = {"fields": 2e-4, "record_every": 1e-5, "until": 1e-3, "config": SMALL}
    record = rupture.run("load", output="f.h5", record="f-record.h5", **fields).record
    draws("movie", "f-record.h5", "-o", "f.gif", "--frames", 2)
    moved = np.diff(record["fields/u_x"][1:4:2].astype(float), axis=0)
    assert np.allclose(speeds_of(record, [2]), np.maximum(abs(moved) / 4e-7, SLOWEST))
    film = "movie f-record.h5 -o y.gif --from 0.25ms --to 0.35ms"
    sentence = "the record has no fields between 0.00025 s and 0.00035 s; choose a longer time"
    refuses(film, 1, sentence)


def test_the_front_is_that_of_the_event_that_began_last():
    first = {"t_front": [1.0, 2.0, None], "x": [0.0, 0.5, 1.0], "L": 1.0}
    second = {"t_front": [4.0, None, None], "x": [0.0, 0.5, 1.0], "L": 1.0}
    places = [front_at(time, [first, second]) for time in (0.5, 1.5, 3.0, 4.5)]
    np.testing.assert_equal(places, [np.nan, 0.0, 0.5, 0.0])


def test_draws_a_record_that_is_growing(folder):
    part = Path("g-record.h5.part")
    command = [BIN / "load", "-q", "--config", SMALL, "--until", "100", "-o", "g.h5"]
    with started([*command, "--record", "g-record.h5", "--record-every", "2e-5"], part) as it:
        try:
            draws("map", part, "-o", "late.svg")
            assert it.poll() is None
        finally:
            it.kill()
    assert "Marks at the right: an event begins." in Path("late.svg").read_text()


@pytest.fixture
def without_h5py(folder):
    """The environment of a machine that lacks it."""
    Path("h5py.py").write_text("raise ModuleNotFoundError(name='h5py')\n")
    return os.environ | {"PYTHONPATH": os.pathsep.join([str(folder), os.environ["PYTHONPATH"]])}


@pytest.mark.parametrize("name", ["map", "movie", "xdmf"])
def test_packages_that_are_missing_are_named(without_h5py, name):
    sentence = "h5py is not installed; install it, on Debian with apt-get install python3-h5py"
    refuses(f"{name} --help", 1, sentence, env=without_h5py)


def test_the_package_runs_programs_without_h5py(without_h5py):
    run_it = "import rupture, rupture.errors; print(rupture.__version__)"
    for command in (("/usr/bin/python3", "-c", run_it), ("reproduce", "--version")):
        done = run(*command, env=without_h5py)
        assert (done.returncode, done.stderr) == (0, ""), done.stderr
    with pytest.raises(AttributeError, match="has no attribute 'nix'"):
        getattr(rupture, "nix")


def test_all_streams_may_be_closed(small):
    command = f"{BIN}/xdmf small.h5 -o closed.xdmf <&- >&- 2>&-"
    assert [run("bash", "-c", command).returncode for _ in range(2)] == [3, 1]
    assert Path("closed.xdmf").read_text().startswith("<?xml")


def test_films_have_the_frames_that_were_asked_for_and_show_their_progress(small):
    film = "movie small-record.h5 -o x.gif -f --frames 2"
    shown = [CLEAR.removeprefix("\r") + what for what in ("front 1 of 1", "frame 2 of 2")]
    assert {*shown} <= {*on_terminal(film, 80)}
    with Image.open("x.gif") as pictures:
        assert pictures.n_frames == 2
    assert on_terminal(f"{film} --quiet", 80) == [""]


def test_a_file_that_appears_meanwhile_is_kept_and_ours_is_deleted(folder):
    with pytest.raises(Failure) as failure, complete("new", False) as temporary:
        temporary.write_text("ours")
        Path("new").write_text("theirs")
    assert [(path.name, path.read_text()) for path in folder.iterdir()] == [("new", "theirs")]
    assert f"{failure.value}" == f"new {EXISTS}"


def test_a_link_is_replaced_and_one_in_the_place_of_the_temporary_file_not_followed(folder):
    Path("theirs").write_text("theirs")
    for name in (".x.tmp.0", "x"):
        Path(name).symlink_to("theirs")
    with mock.patch("secrets.token_hex", return_value="0"):
        with pytest.raises(FileExistsError), replacing("x"):
            pass
    with replacing("x") as temporary:
        temporary.write_text("ours")
    assert Path(".x.tmp.0").is_symlink() and not Path("x").is_symlink()
    assert Path("theirs").read_text() == "theirs"
