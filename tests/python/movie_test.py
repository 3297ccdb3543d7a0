"""movie and watch: frames, formats and refusals; a run that is watched to its end."""

import os
import shutil
import signal
import subprocess
import unittest
from pathlib import Path

import numpy as np
import rupture
import small
from program import check_description, check_refusals, ran
from rupture.tools.movie import chosen_samples


class Movie(unittest.TestCase):
    def setUp(self):
        self.folder, self.result, _ = small.folder()

    def test_writes_as_many_frames_as_asked_for(self):
        from PIL import Image

        command = ("movie", "small-record.h5", "-o", "x.gif", "--frames", 3, "-f")
        self.assertEqual(ran(*command), (0, "", ""))
        with Image.open("x.gif") as film:
            self.assertEqual(film.n_frames, 3)

    @unittest.skipUnless(shutil.which("ffmpeg"), "ffmpeg is not installed")
    def test_writes_a_video(self):
        command = ("movie", "small-record.h5", "-o", "x.mp4", "--frames", 2, "--event", 0)
        self.assertEqual(ran(*command), (0, "", ""))
        self.assertEqual(Path("x.mp4").read_bytes()[4:8], b"ftyp")

    def test_interrupted_ends_by_the_signal_and_leaves_nothing(self):
        before = sorted(Path().iterdir())
        for number in (signal.SIGINT, signal.SIGTERM):
            command = [os.environ["RUPTURE_BIN"] + "/movie", "small-record.h5", "-o", "z.gif"]
            with subprocess.Popen(command, stderr=subprocess.PIPE) as it:
                while not list(Path().glob(".z.tmp.*")):
                    self.assertIsNone(it.poll())
                it.send_signal(number)
                self.assertEqual(it.communicate()[1], b"")
            self.assertEqual((it.returncode, sorted(Path().iterdir())), (-number, before))

    def test_frames_are_even_and_in_the_window(self):
        time = np.arange(101.0)
        self.assertEqual(list(chosen_samples(time, (20, 60), 5)), [20, 30, 40, 50, 60])
        self.assertEqual(len(chosen_samples(time, (20, 22), 50)), 3)

    def test_refuses(self):
        cases: list[tuple] = [
            (("small-record.h5", "-o", "y.avi"), 2, "has to end with .gif"),
            (("small.h5", "-o", "y.gif"), 1, "is a checkpoint"),
            (("small-record.h5", "-o", "y.gif", "--colour", "red"), 2, "invalid choice"),
            (("small-record.h5", "-o", "y.gif", "--event", 7), 2, "there is no event 7"),
        ]
        cases += [
            (("small-record.h5", "-o", "y.gif", "--frames", n), 2, "is no number of frames: give")
            for n in (0, -3, 1.5, "many")
        ]
        check_refusals(self, "movie", cases)

    def test_refuses_a_time_without_fields(self):
        fields = {"fields": 2e-4, "record_every": 1e-5, "until": 1e-3, "set": small.SMALL}
        rupture.run("load", output="f.h5", record="f-record.h5", force=True, **fields)
        window = ("--from", "0.25ms", "--to", "0.35ms")
        sentence = "the record has no fields between 0.00025 s and 0.00035 s; choose a longer time"
        check_refusals(self, "movie", [(("f-record.h5", "-o", "y.gif", *window), 1, sentence)])

    def test_says_why_ffmpeg_failed(self):
        Path("bin").mkdir()
        ffmpeg = Path("bin/ffmpeg")
        ffmpeg.write_text("#!/bin/sh\necho much >&2; echo no room >&2; exit 1\n")
        ffmpeg.chmod(0o755)
        env = os.environ | {"PATH": f"{self.folder}/bin:{os.environ['PATH']}"}
        sentence = "could not write y.mp4: ffmpeg: no room"
        case = (("small-record.h5", "-o", "y.mp4", "--frames", 9), 1, sentence)
        check_refusals(self, "movie", [case], env=env)

    def test_describes_itself(self):
        check_description(self, "movie")


class Watch(unittest.TestCase):
    def setUp(self):
        self.folder, self.result, _ = small.folder()

    def test_follows_a_run_to_its_end(self):
        load = os.environ["RUPTURE_BIN"] + "/load"
        settings = [f"--set={key}={value}" for key, value in small.SMALL.items()]
        record = ["--record", "w-record.h5", "--record-every", "2e-5", "--checkpoint-every", "1e-2"]
        with subprocess.Popen(
            [load, "-o", "w.h5", "--until", "0.2", "-q", *record, *settings]
        ) as it:
            while not (Path("w-record.h5.part").exists() or Path("w-record.h5").exists()):
                self.assertIn(it.poll(), (None, 0))
            code, text, error = ran("watch", "w-record.h5.part", "--every", "100ms")
        self.assertEqual((code, error), (0, ""))
        *lines, last = text.splitlines()
        self.assertEqual(last, "finished")
        self.assertIn("t = 0.200000 s", lines[-1])
        whole = rupture.open("w-record.h5")
        self.assertIn(f"{len(whole.ruptures.time)} ruptures", lines[-1])

    def test_says_that_a_run_was_killed(self):
        load = os.environ["RUPTURE_BIN"] + "/load"
        command = [load, "-o", "k.h5", "--until", "100", "-q", "--record", "k-record.h5"]
        with subprocess.Popen(command) as it:
            while not Path("k-record.h5.part").exists():
                self.assertIsNone(it.poll())
            it.kill()
        sentence = "no run writes k-record.h5.part any more, and it is not finished; rupture finish"
        check_refusals(self, "watch", [(("k-record.h5.part",), 1, sentence)])

    def test_refuses(self):
        cases = [
            ((), 2, "are required: RECORD"),
            (("none.h5.part",), 1, "none.h5.part does not exist"),
            (("small.h5",), 1, "is a checkpoint"),
            (("small-record.h5", "--every", "often"), 2, "is no time"),
            (("small-record.h5", "--every", 0), 2, "of at least 0.01 s and at most 86400 s"),
            (("small-record.h5", "--every", "1e999"), 2, "of at least 0.01 s and at most 86400 s"),
            (("",), 1, "'' names no file; give the .part of a run that writes a record"),
            ((".part",), 1, "'.part' names no file; give the .part of a run that writes a record"),
        ]
        check_refusals(self, "watch", cases)

    def test_describes_itself(self):
        check_description(self, "watch")


if __name__ == "__main__":
    unittest.main()
