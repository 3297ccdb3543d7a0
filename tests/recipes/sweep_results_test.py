"""What a user's sweep gives: table, picture and summary, from made-up results
(recipes/sweeps/table.py, picture.py)."""

from types import SimpleNamespace
from unittest import mock

import matplotlib.image
import numpy as np
import pytest

from measure.tables import read_rows
from rupture.figures import figure
from sweeps.picture import as_typed, cells, draw, draw_line, edges, middle, space_labels
from sweeps.sweep import find
from sweeps.table import Column, columns_of, summary, write_csv


def made_up(**known):
    """A sweep."""
    empty = {"title": "A", "points": [], "columns": {}, "kept": [], "units": {}, "typed": {}}
    return SimpleNamespace(**empty | {"varied": [], "axis": "", "along_x": []} | known)


# --- tables -----------------------------------------------------------------------------------

COLUMNS = [
    Column("driving.V", "m/s", ["1e-4", "4e-4", "4e-4"]),
    Column("seed", "1", ["1", "1", "2"]),
    Column("speed of σ", "m/s", [0.1 + 0.2, None, 12]),
    Column("spanning", "", [True, None, False]),
    Column("sentence", "", ["", "restart: übel", ""]),
]


def test_a_table_has_units_in_its_headings(tmp_path):
    write_csv(tmp_path / "t.csv", COLUMNS)
    rows = read_rows(tmp_path / "t.csv")
    table = {name: [row[name] for row in rows] for name in rows[0]}
    assert list(table) == ["driving.V [m/s]", "seed", "speed of σ [m/s]", "spanning", "sentence"]
    assert [*table["speed of σ [m/s]"]] == ["0.30000000000000004", "", "12"]
    assert [*table["spanning"]] == ["true", "", "false"]


def test_texts_are_no_formulas_and_stay_in_one_line():
    formulas = ["=cmd|x!A0", "@SUM(1)", "-x", "-1+cmd|calc!A0", "+.5*A1", "-1 from A1"]
    others = ["-0.1", "+.5e-3", "-3 mm/s", "1+1", "a\x1b]0;", None, True]
    texts = ["-0.1", "+.5e-3", "-3 mm/s", "1+1", "a?]0;", "", "true"]
    assert Column("a", "", formulas).texts == [f"'{text}" for text in formulas]
    assert Column("a", "", others).texts == texts


def test_numbers_are_in_the_unit_of_their_column():
    values = [{"V": text, "law": "1mm", "mu": "0.1 from 0 to 1"} for text in ("1mm/s", "2e-3")]
    points = [SimpleNamespace(values=one) for one in values]
    sweep = made_up(points=points, units={"V": "m/s", "law": "", "mu": "1"}, kept=["r.h5"])
    V, law, mu, *_, kept, _ = columns_of(sweep, [one | {"r.h5": "store/r.h5"} for one in values])
    assert (V.texts, V.heading, law.texts) == (["0.001", "2e-3"], "V [m/s]", ["1mm", "1mm"])
    assert (mu.unit, mu.texts[0], kept.texts) == ("", "0.1 from 0 to 1", ["store/r.h5"] * 2)


REPORTS = {"front": {"v_c": [1.0, None, 3.0], "events": [{"t": 1}, {"t": 2}], "slow": None}}
QUANTITIES = [  # path, value
    ("front.v_c.-1", 3.0),
    ("front.v_c.9", None),
    ("front.v_c", [1.0, None, 3.0]),
    ("front.events.1.t", 2),
    ("front.slow.speed", None),
    ("other.F_T", None),
]


@pytest.mark.parametrize("path, value", QUANTITIES)
def test_a_quantity_is_a_place_in_a_report(path, value):
    assert find(REPORTS, path) == value


# --- what is said ------------------------------------------------------------------------------


SUMMARY = """\
A: 10 points: 2 done, 7 refused, 1 unfinished.
Refused:
  2 x worse
  1 x 0
  1 x 1
  1 x 2
  1 x 3
  and 1 other sentence; the table has all
Unfinished:
  1 x crash?
No point has a value for front.v_c.9 (v)."""


def test_summary():
    refused = [("refused", sentence) for sentence in (*"01234", "worse", "worse")]
    states = [("done", ""), *refused, ("unfinished", "crash\n"), ("done", "")]
    rows = [{"status": status, "sentence": sentence, "v": None} for status, sentence in states]
    sweep = made_up(columns={"v": "front.v_c.9"})
    assert "\n".join(summary(sweep, rows)) == SUMMARY
    rows[0]["v"] = 1.0
    assert summary(sweep, rows[:1]) == ["A: 1 point: 1 done."]
    assert "No point" not in "".join(summary(sweep, rows[1:3])), "they are refused"


# --- pictures ---------------------------------------------------------------------------------

SPEED, TYPE, V, W = ("speed", "m/s"), ("type", ""), ("V", "m/s"), ("W", "1")
MEASURED = {SPEED: [1.0, 2.0, 3.0, None], TYPE: ["slow", "fast", "slow", None]}
THREE_DONE = ["done", "done", "done", "failed"]


def sweep_of(values, results, status):
    """{(name, unit): cells} of values and quantities."""
    measured = values | results
    columns = [Column(name, unit, cells) for (name, unit), cells in measured.items()]
    columns.append(Column("status", "", status))
    varied = [name for (name, _), cells in values.items() if len(set(cells)) > 1]
    names = {name: name for name, _ in results}
    return made_up(title="$^$", columns=names, varied=varied), columns


SEEDS = {V: ["1", "1", "2", "2"], ("seed", "1"): ["1", "2", "1", "2"]}
LAWS = {V: ["1", "1", "2", "2"], ("law", ""): ["a", "b", "a", "b"]}
TWO = {SPEED: [1.0, 2.0]}, ["done", "done"]
NONE = {SPEED: [None, None], TYPE: [None, None]}, ["failed", "failed"]
DOLLARS = {("V $_{$", "m/s"): ["1", "2"]}, {(r"$\frac{$", "1"): [1.0, 2.0]}, TWO[1]
LINE, CROSS, SLOW, FAST = (0, 114, 178), (213, 94, 0), (140, 192, 227), (224, 127, 74)
HATCHED, BLACK = (217, 217, 217), (0, 0, 0)
DRAWN = [  # values, quantities, status; colours with the least share of pixels that they have
    (SEEDS, MEASURED, THREE_DONE, {LINE: 0.001, CROSS: 0.00002}),
    (LAWS, MEASURED, THREE_DONE, {SLOW: 0.05, FAST: 0.03, HATCHED: 0.03}),
    ({V: ["1", "2"]}, *NONE, {}),
    ({V: ["1", "2"], W: ["3", "4"]}, *NONE, {HATCHED: 0.03}),
    (*DOLLARS, {}),
]


def share(picture, colour):
    """Fraction of the pixels that have this colour."""
    pixels = matplotlib.image.imread(picture)[:, :, :3]
    return np.mean(np.all(np.abs(pixels - np.array(colour) / 255) < 0.02, axis=2))


@pytest.mark.parametrize("values, results, status, least", DRAWN)
def test_pictures_of_one_value_with_seeds_and_of_two(folder, values, results, status, least):
    assert draw("a", *sweep_of(values, results, status)) == ""
    assert {*folder.iterdir()} == {folder / "a.png", folder / "a.pdf"}
    assert all(share("a.png", colour) > limit for colour, limit in least.items())


def test_strips_show_what_varies_along_x(folder):
    row = {"name": "junctions.f_new", "symbol": "f_new", "unit": "", "words": ["zero", "f_slip"]}
    sweep, columns = sweep_of({V: ["1", "2"]}, *TWO)
    sweep.along_x = [(row, [([0, 0.14], [0, 0]), ([0.07, 0.084], [1, 1])])]
    with mock.patch("sweeps.picture.save") as saved:
        assert draw("a", sweep, columns) == ""
    strip, panel = saved.call_args[0][0].axes
    assert strip.get_title("left") == "$f_{new}$, junctions.f_new: zero to f_slip"
    assert strip.get_xlim() == (0, 0.14)
    assert strip.get_position().height < panel.get_position().height / 3


def test_a_dash_and_a_note_where_there_is_no_value(folder):
    for name, first in (("a", 1.0), ("b", None)):
        draw(name, *sweep_of(LAWS, MEASURED | {SPEED: [first, 2.0, 3.0, None]}, THREE_DONE))
    assert share("b.png", BLACK) > share("a.png", BLACK)


@pytest.mark.parametrize(
    "error, why", [(ValueError("no\nmore"), "no"), (MemoryError(), "MemoryError")]
)
def test_what_cannot_be_drawn_is_one_line(folder, error, why):
    with mock.patch("sweeps.picture.draw_columns", side_effect=error):
        said = draw("a", *sweep_of({V: ["1", "2"]}, *TWO))
    assert (said, [*folder.iterdir()]) == (f"No picture: {why}", [])


def test_other_numbers_of_values_have_no_picture(folder):
    said = draw("a", *sweep_of({name: ["1", "2"] for name in (V, W, ("c", "1"))}, *TWO))
    assert said.startswith("No picture: 3 values vary (seeds do not count); pictures are ")
    assert not [*folder.iterdir()]


def test_a_logarithmic_axis_where_positive_numbers_span_decades_or_are_geometric():
    def scale(*cells, unit="1"):
        return Column("a", unit, [*cells]).scale

    assert scale("1", "100") == scale(None, 1, 200) == "log"
    assert scale("0.1", "0.4", "1.6") == "log"
    assert scale("1", "2", "3", "4") == scale("10", "11", "12") == "linear"
    assert scale("1", "99") == scale("0", "100") == scale("-1", "-100") == "linear"
    assert scale("1", "100", unit="") == "linear"


def test_medians_and_most_frequent_texts_in_the_order_of_fronts():
    numbers = Column("a", "1", [1.0, None, 2.0, 9.0, 0.0])
    assert middle(numbers, [0, 1, 2, 3]) == 2.0
    texts = Column("a", "", ["fast", "b", "arrested", "a", "arrested", None])
    assert texts.categories == ["arrested", "fast", "b", "a"]
    assert middle(texts, [*range(6)]) == 0


def test_axes_have_the_names_and_units_that_were_typed():
    column = Column("a$", "s", ["0.001", "0.0023", None])
    column = as_typed(column, made_up(typed={"a$": "ms"}, axis="log"))
    assert (column.heading, column.cells, column.scale) == ("a$ [ms]", [1.0, 2.3, None], "log")


def test_the_median_breaks_where_there_is_no_value():
    _, axes = figure()
    x, y = Column("a", "1", [1, 2, 3, 3]), Column("b", "1", [1.0, None, 3.0, 5.0])
    draw_line(axes, x, y, np.array([True] * 4))
    np.testing.assert_array_equal(axes.lines[1].get_ydata(), [1.0, np.nan, 4.0])


CROWDED = [  # values along x
    Column("a", "1", [*np.linspace(1, 1.5, 9), 1000], axis="log"),
    Column("a", "", [f"a long name {n}" for n in range(12)]),
    Column("a", "1", [1e5 + n for n in range(20)]),
]


@pytest.mark.parametrize("x", CROWDED, ids=["log", "names", "linear"])
def test_labels_of_ticks_do_not_overlap(x):
    fig, axes = figure()
    draw_line(axes, x, Column("b", "1", [1.0] * len(x.cells)), np.array([True] * len(x.cells)))
    space_labels(fig)
    fig.draw_without_rendering()
    boxes = [one.get_window_extent() for one in axes.get_xticklabels() if one.get_text()]
    boxes.sort(key=lambda box: box.x0)
    assert len(boxes) > 1
    assert all(a.x1 < b.x0 for a, b in zip(boxes, boxes[1:]))


def test_a_band_from_quartile_to_quartile():
    _, axes = figure()
    x, y = Column("a", "1", [1, 1, 1, 2]), Column("b", "1", [1.0, 2.0, 4.0, None])
    draw_line(axes, x, y, np.array([True] * 4))
    low, high = axes.collections[0].get_paths()[0].get_extents().intervaly
    assert (low, high, axes.lines[1].get_ydata()[0]) == (1.5, 3.0, 2.0)


def test_cells_and_margins_are_as_the_axis_shows_them():
    linear = Column("a", "1", [1, 2, 5])
    np.testing.assert_allclose(edges(linear), [0.5, 1.5, 3.5, 6.5])
    log = Column("a", "1", [1, 10, 100])
    np.testing.assert_allclose(edges(log), np.sqrt([0.1, 10, 1000, 1e5]))
    grid = cells(linear, Column("b", "1", [1, 1, 2]), lambda here: here[0])
    np.testing.assert_array_equal(grid.filled(np.nan), [[0, 1, np.nan], [np.nan, np.nan, 2]])
    _, axes = figure()
    draw_line(axes, log, Column("b", "1", [None, 2.0, None]), np.array([True, True, False]))
    np.testing.assert_allclose(axes.get_xlim(), [10**-0.1, 10**2.1])
