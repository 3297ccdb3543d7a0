"""movie and watch: frames and formats; a run that is watched to its end."""

import shutil
import signal
import subprocess
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import rupture
from commands import refuses
from conftest import BIN, SMALL, draws, run, started
from rupture.tools.movie import SLOWEST, chosen_samples, front_at, values_of


def test_writes_as_many_frames_as_asked_for(small):
    draws("movie", "small-record.h5", "-o", "x.gif", "--frames", 3)
    with Image.open("x.gif") as film:
        assert film.n_frames == 3


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


def test_frames_are_even_and_in_the_window():
    time = np.arange(101.0)
    assert list(chosen_samples(time, (20, 60), 5)) == [20, 30, 40, 50, 60]
    assert len(chosen_samples(time, (20, 22), 50)) == 3


def test_fields_colour_the_slider_but_for_times_without_any(folder):
    fields = {"fields": 2e-4, "record_every": 1e-5, "until": 1e-3, "config": SMALL}
    record = rupture.run("load", output="f.h5", record="f-record.h5", **fields).record
    draws("movie", "f-record.h5", "-o", "f.gif", "--frames", 2)
    moved = np.diff(record["fields/u_x"][1:4:2].astype(float), axis=0)
    assert np.allclose(values_of(record, [2], "speed")[0], np.maximum(abs(moved) / 4e-7, SLOWEST))
    film = "movie f-record.h5 -o y.gif --from 0.25ms --to 0.35ms"
    sentence = "the record has no fields between 0.00025 s and 0.00035 s; choose a longer time"
    refuses(film, 1, sentence)


def test_the_front_is_that_of_the_event_that_began_last():
    first = {"t_front": [1.0, 2.0, None], "x": [0.0, 0.5, 1.0], "L": 1.0}
    second = {"t_front": [4.0, None, None], "x": [0.0, 0.5, 1.0], "L": 1.0}
    places = [front_at(time, [first, second]) for time in (0.5, 1.5, 3.0, 4.5)]
    np.testing.assert_equal(places, [np.nan, 0.0, 0.5, 0.0])


def start(name, until):
    command = [BIN / "load", "-q", "-o", f"{name}.h5", "--until", until, "--config", SMALL]
    record = ["--record", f"{name}-record.h5", "--record-every", "2e-5"]
    part = Path(f"{name}-record.h5.part")
    return started([*command, *record, "--checkpoint-every", "1e-2"], part)


def test_watch_follows_a_run_to_its_end(folder):
    with start("w", "0.2"):
        done = run("watch", "w-record.h5.part", "--every", "100ms")
    assert (done.returncode, done.stderr) == (0, "")
    *lines, last = done.stdout.splitlines()
    assert last == "finished"
    assert "t = 0.200000 s" in lines[-1]
    assert f"{len(rupture.open('w-record.h5').ruptures.time)} ruptures" in lines[-1]


def test_watch_says_that_a_run_was_killed(folder):
    with start("k", "100") as it:
        it.kill()
    sentence = "the run that wrote k-record.h5.part was killed; rupture finish..."
    refuses("watch k-record.h5.part", 1, sentence)
