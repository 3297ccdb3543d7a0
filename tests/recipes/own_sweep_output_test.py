"""Tables and pictures of a user's sweep (common/sweeps/table.py, picture.py): made-up results."""

import csv
import io
import sys
import tempfile
import time
import unittest
from contextlib import redirect_stdout
from dataclasses import replace
from pathlib import Path
from unittest import mock

import h5py
import matplotlib.image
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "recipes/common")]

from sweeps.needs import Needs  # noqa: E402
from sweeps.picture import axis_of, draw, edges, limits, middle  # noqa: E402
from sweeps.report import picture, print_summary  # noqa: E402
from sweeps.sweep import Sweep  # noqa: E402
from sweeps.table import Column, write_csv, write_hdf5  # noqa: E402

COLUMNS = [
    Column("driving.V", "m/s", ["1e-4", "4e-4", "4e-4"]),
    Column("seed", "1", ["1", "1", "2"]),
    Column("speed of σ", "m/s", [0.1 + 0.2, None, 12]),
    Column("spanning", "", [True, None, False]),
    Column("sentence", "", ["", "restart: übel", ""]),
]


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)


class Tables(InFolder):
    def test_csv(self):
        write_csv(self.folder / "t.csv", COLUMNS)
        with open(self.folder / "t.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        headings = ["driving.V [m/s]", "seed", "speed of σ [m/s]", "spanning", "sentence"]
        self.assertEqual(rows[0], headings)
        self.assertEqual(rows[1], ["1e-4", "1", "0.30000000000000004", "true", ""])
        self.assertEqual(rows[2], ["4e-4", "1", "", "", "restart: übel"])

    def test_hdf5_has_what_the_csv_has(self):
        write_csv(self.folder / "t.csv", COLUMNS)
        write_hdf5(self.folder / "t.h5", "Title", COLUMNS)
        with open(self.folder / "t.csv", newline="", encoding="utf-8") as file:
            cells = list(zip(*list(csv.reader(file))[1:]))
        with h5py.File(self.folder / "t.h5") as file:
            self.assertEqual(set(file), {column.name for column in COLUMNS})
            for column, texts in zip(COLUMNS, cells):
                dataset = file[column.name]
                self.assertEqual(dataset.attrs["unit"], (column.unit or "1").encode())
                if column.unit:
                    numbers = [float(text) if text else np.nan for text in texts]
                    np.testing.assert_array_equal(dataset[()], numbers)
                else:
                    self.assertEqual(dataset.dtype.kind, "S")
                    self.assertEqual([text.decode() for text in dataset[()]], list(texts))

    def test_equal_tables_are_equal_bytes(self):
        for name in ("a", "b"):
            write_hdf5(self.folder / f"{name}.h5", "Title", COLUMNS)
            time.sleep(1.1)  # times in HDF5 are in seconds
        self.assertEqual(*((self.folder / f"{n}.h5").read_bytes() for n in ("a", "b")))

    def test_a_table_is_written_whole_or_not_at_all(self):
        write_hdf5(self.folder / "t.h5", "Title", COLUMNS)
        before = (self.folder / "t.h5").read_bytes()
        with self.assertRaises(ValueError):
            write_hdf5(self.folder / "t.h5", "Title", [*COLUMNS, Column("n", "m", ["text"])])
        self.assertEqual((self.folder / "t.h5").read_bytes(), before)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["t.h5"])


class Summary(unittest.TestCase):
    def said(self, *rows):
        table = [dict(zip(("status", "sentence", "v"), row)) for row in rows]
        with redirect_stdout(io.StringIO()) as output:
            print_summary(Sweep("A", [], {"v": "front.v_c.999"}, Needs(), [], {}), table, 0)
        return output.getvalue()

    def test_a_quantity_that_no_point_has(self):
        sentence = "No point has a value of front.v_c.999 (v)."
        self.assertIn(sentence, self.said(("done", "", None), ("failed", "x", None)))
        self.assertNotIn(sentence, self.said(("done", "", 1.0), ("done", "", None)))
        self.assertNotIn(sentence, self.said(("failed", "x", None)))

    def test_failures_of_all_points_are_said(self):
        self.assertIn("A: 2 points: 2 failed.", self.said(*[("failed", "x", None)] * 2))


class Pictures(InFolder):
    SPEED = ("speed", "m/s")
    TYPE = ("type", "")

    def sweep(self, values, results, status):
        """{(name, unit): cells} of values and quantities."""
        measured = values | results
        columns = [Column(name, unit, cells) for (name, unit), cells in measured.items()]
        columns.append(Column("status", "", status))
        varied = [name for (name, _), cells in values.items() if len(set(cells)) > 1]
        names = {name: name for name, _ in results}
        return Sweep("A sweep", [], names, Needs(), varied, {}), columns

    def draw(self, values, results, status):
        stem = self.folder / "picture"
        return draw(stem, *self.sweep(values, results, status)), Path(f"{stem}.png")

    def colours(self, png, *rgb):
        """The share of pixels of a colour."""
        pixels = matplotlib.image.imread(png)[:, :, :3]
        return np.mean(np.all(np.abs(pixels - np.array(rgb) / 255) < 0.02, axis=2))

    def test_one_value_with_seeds(self):
        values = {("V", "m/s"): ["1", "1", "2", "2"], ("seed", "1"): ["1", "2", "1", "2"]}
        results = {self.SPEED: [1.0, 2.0, 3.0, None], self.TYPE: ["slow", "fast", "slow", None]}
        said, png = self.draw(values, results, ["done", "done", "done", "failed"])
        self.assertEqual(said, "")
        self.assertTrue(png.with_suffix(".pdf").exists())
        self.assertGreater(self.colours(png, 0, 114, 178), 0.001, "line and dots")
        self.assertGreater(self.colours(png, 213, 94, 0), 0.00002, "crosses of failed points")

    def test_two_values(self):
        values = {("V", "m/s"): ["1", "1", "2", "2"], ("law", ""): ["a", "b", "a", "b"]}
        results = {self.SPEED: [1.0, 2.0, 3.0, None], self.TYPE: ["slow", "fast", "slow", None]}
        said, png = self.draw(values, results, ["done", "done", "done", "failed"])
        self.assertEqual(said, "")
        self.assertGreater(self.colours(png, 245, 215, 110), 0.05, "slow")
        self.assertGreater(self.colours(png, 232, 153, 122), 0.03, "fast")
        self.assertGreater(self.colours(png, 217, 217, 217), 0.03, "failed")

    def test_nothing_but_failures_is_drawn_too(self):
        for values in ({("V", "1"): ["1", "2"]}, {("V", "1"): ["1", "2"], ("W", "1"): ["3", "4"]}):
            results = {self.SPEED: [None, None], self.TYPE: [None, None]}
            said, png = self.draw(values, results, ["failed", "failed"])
            self.assertEqual((said, png.exists()), ("", True))

    def test_a_dollar_sign_begins_no_formula(self):
        values = {("V $_{$", "m/s"): ["1", "2"]}
        sweep, columns = self.sweep(values, {(r"$\frac{$", "1"): [1.0, 2.0]}, ["done"] * 2)
        said = draw(self.folder / "picture", replace(sweep, title="$^$"), columns)
        self.assertEqual(said, "")

    def test_what_cannot_be_drawn_is_one_line_and_leaves_no_file(self):
        values, results = {("V", "1"): ["1", "2"]}, {self.SPEED: [1.0, 2.0]}
        stem = self.folder / "picture"
        for error, why in ((ValueError("no\nmore"), "no"), (MemoryError(), "MemoryError")):
            Path(f"{stem}.png").write_text("half")
            with mock.patch("sweeps.report.draw", side_effect=error):
                said = picture(stem, *self.sweep(values, results, ["done"] * 2))
            self.assertEqual((said, [*self.folder.iterdir()]), (f"No picture: {why}", []))

    def test_other_numbers_of_values_have_no_picture_and_a_former_one_goes(self):
        values = {(name, "1"): ["1", "2"] for name in "ab"}
        self.draw(values, {self.SPEED: [1.0, 2.0]}, ["done", "done"])
        said, png = self.draw(
            values | {("c", "1"): ["1", "2"]}, {self.SPEED: [1.0, 2.0]}, ["done"] * 2
        )
        self.assertEqual(said, "No picture: 3 values vary; pictures are drawn of one or two.")
        self.assertFalse(png.exists())

    def test_a_logarithmic_axis_where_positive_numbers_span_two_decades(self):
        def scale(*cells):
            return axis_of(Column("a", "1", list(cells))).scale

        self.assertEqual(
            [scale("1", "99"), scale("1", "100"), scale(None, 1, 200)], ["linear", "log", "log"]
        )
        self.assertEqual([scale("0", "100"), scale("-1", "-100")], ["linear", "linear"])
        self.assertEqual(axis_of(Column("a", "", ["1", "100"])).scale, "linear")

    def test_medians_and_most_frequent_texts(self):
        numbers = axis_of(Column("a", "1", [1.0, None, 2.0, 9.0]))
        self.assertEqual(middle(numbers, numbers.positions), 2.0)
        texts = axis_of(Column("a", "", ["x", "y", "y", None]))
        self.assertEqual(texts.categories[int(middle(texts, texts.positions))], "y")

    def test_types_of_fronts_are_in_order(self):
        texts = axis_of(Column("a", "", ["fast", "b", "arrested", "a", None]))
        self.assertEqual(texts.categories, ["arrested", "fast", "b", "a"])

    def test_cells_meet_halfway_as_the_axis_shows_it(self):
        linear = axis_of(Column("a", "1", [1, 2, 4]))
        np.testing.assert_allclose(edges(linear, linear.positions), [0.5, 1.5, 3, 5])
        log = axis_of(Column("a", "1", [1, 10, 100]))
        np.testing.assert_allclose(edges(log, log.positions), np.sqrt([0.1, 10, 1000, 1e5]))
        np.testing.assert_allclose(limits(log), [10**-0.1, 10**2.1])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
