"""map: pictures of records, the window that they show, and refusals."""

import os
import struct
import unittest
from pathlib import Path

import numpy as np
import rupture
import small
from program import check_description, check_refusals, ran
from rupture import plotting
from rupture.tools.map import slip_speed


def size_of_png(path):
    data = Path(path).read_bytes()
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    return struct.unpack(">II", data[16:24])


class Map(unittest.TestCase):
    def setUp(self):
        self.folder, self.result, _ = small.folder()

    def test_draws_all_or_an_event_or_a_time(self):
        for number, choice in enumerate(
            [(), ("--event", "first-spanning"), ("--from", "0.5ms", "--to", 1e-3)]
        ):
            name = f"map-{number}.png"
            self.assertEqual(ran("map", "small-record.h5", "-o", name, *choice), (0, "", ""))
            self.assertEqual(size_of_png(name), (2000, 840))
        self.assertNotEqual(Path("map-0.png").read_bytes(), Path("map-1.png").read_bytes())

    def test_names_no_event_that_has_no_speed(self):
        axes = plotting.pyplot_without_window().subplots()[1]
        short = {"v_c": [None, None], "x": [0.0, 0.07], "L": 0.14, "c_s": 1000.0}
        long = short | {"v_c": [None, 1200.0]}
        looks = {0: ("event 0", "k", "o"), 1: ("event 1", "k", "o")}
        plotting.draw_front_speeds(axes, {0: short, 1: long}, looks)
        self.assertEqual(axes.get_legend_handles_labels()[1], ["event 1"])

    def test_draws_a_record_without_events(self):
        rupture.run("load", output="still.h5", record="still-record.h5", until=2e-3, set=QUIET)
        self.assertEqual(ran("map", "still-record.h5", "-o", "still.pdf"), (0, "", ""))

    def test_refuses(self):
        Path("there.png").write_text("kept")
        to = ("-o", "x.png")
        cases = [
            ((), 2, "are required: RECORD"),
            (("none.h5", *to), 1, "none.h5 does not exist"),
            (("small.h5", *to), 1, "is a checkpoint; give a record"),
            (("small-record.h5", "-o", "x.gif"), 2, "has to end with .png"),
            (("small-record.h5", "-o", "no/x.png"), 1, "the folder no does not exist"),
            (("small-record.h5", "-o", "there.png"), 1, "there.png exists"),
            (("small-record.h5", *to, "--event", 9), 2, "there is no event 9"),
            (("small-record.h5", *to, "--from", "5 parsec"), 2, "is no time"),
            (("small-record.h5", *to, "--from", 3), 2, "--from 3 is outside the record, which"),
        ]
        check_refusals(self, "map", cases)
        self.assertEqual(Path("there.png").read_text(), "kept")

    def test_refuses_times_and_events_that_make_no_sense(self):
        record = ("small-record.h5", "-o", "x.png")
        cases = [
            ((*record, "--event", 0, "--to", 1), 2, "--event and --from or --to exclude each"),
            ((*record, "--event", -1), 2, "'-1' is no number of an event: give a whole number"),
            ((*record, "--event", 1.5), 2, "'1.5' is no number of an event: give a whole number"),
            ((*record, "--from=-1"), 2, "give a finite time of at least 0 s"),
            ((*record, "--from", "1e999"), 2, "give a finite time of at least 0 s"),
            ((*record, "--from", "1.2.3"), 2, "'1.2.3' is no time, such as 0.8"),
            ((*record, "--from", "2ms", "--to", "1ms"), 2, "window is empty: --to is before"),
            ((*record, "--to", 0), 2, "fewer than two samples lie between 0 s and 0 s: give a"),
            ((*record, "--to", 1, "--to", 2), 2, "--to: is given more than once"),
        ]
        check_refusals(self, "map", cases)

    def test_draws_with_any_name_and_any_backend(self):
        for name in ("a$b^c.h5", os.fsdecode(b"\xff.h5")):
            Path(name).write_bytes(Path("small-record.h5").read_bytes())
            env = os.environ | {"MPLBACKEND": "QtAgg", "QT_QPA_PLATFORM": "none"}
            self.assertEqual(ran("map", name, "-o", "odd.png", "-f", env=env), (0, "", ""))
            Path(name).unlink()
        env = os.environ | {"MPLBACKEND": "none"}
        cases = [(("small-record.h5", "-o", "x.png"), 1, "refuses its settings: Key backend")]
        check_refusals(self, "map", cases, env=env)

    def test_describes_itself(self):
        check_description(self, "map")

    def test_the_slip_speed_is_that_of_the_blocks(self):
        record = self.result.record
        rows = plotting.rows_in(record, 0.0, (0.2, 0.4))
        ends = record.time[rows[[0, -1]]]
        self.assertTrue(np.allclose(ends, (0.2e-3, 0.4e-3), rtol=1e-9), ends)
        step = record.time[2] - record.time[0]
        speed = np.abs(record["u_x"][rows[2]] - record["u_x"][rows[0]]) / step
        self.assertTrue(np.allclose(slip_speed(record, rows)[1], speed, rtol=1e-9))


QUIET = small.SMALL | {"driving.V": 0}

if __name__ == "__main__":
    unittest.main()
