"""What a user's sweep gives: table, picture and summary, from made-up results (chains/table.py,
chains/picture.py)."""

import time
from pathlib import Path
from unittest import mock

import h5py
import matplotlib.image
import numpy as np
import pytest

from chains.points import Point
from chains.picture import as_typed, cells, draw, draw_line, edges, label_of, middle
from chains.sweeps import Sweep
from chains.table import Column, columns_of, elements_of, measured
from chains.table import print_summary, write_csv, write_hdf5
from measure.tables import read_rows
from rupture.figures import figure, save

# --- tables -----------------------------------------------------------------------------------

COLUMNS = [
    Column("driving.V", "m/s", ["1e-4", "4e-4", "4e-4"]),
    Column("seed", "1", ["1", "1", "2"]),
    Column("speed of σ", "m/s", [0.1 + 0.2, None, 12]),
    Column("spanning", "", [True, None, False]),
    Column("sentence", "", ["", "restart: übel", ""]),
]


def test_hdf5_has_what_the_csv_has_and_is_written_whole_or_not_at_all(tmp_path):
    write_csv(tmp_path / "t.csv", COLUMNS)
    rows = read_rows(tmp_path / "t.csv")
    table = {name: [row[name] for row in rows] for name in rows[0]}
    assert list(table) == ["driving.V [m/s]", "seed", "speed of σ [m/s]", "spanning", "sentence"]
    assert [*table["speed of σ [m/s]"]] == ["0.30000000000000004", "", "12"]
    assert [*table["spanning"]] == ["true", "", "false"]
    write_hdf5(tmp_path / "t.h5", "Title", COLUMNS)
    with h5py.File(tmp_path / "t.h5") as file:
        assert {*file} == {column.name for column in COLUMNS}
        assert file.attrs["title"] == b"Title"
        for column, texts in zip(COLUMNS, table.values()):
            data = file[column.name]
            assert data.attrs["unit"] == (column.unit or "1").encode()
            if column.unit:
                numbers = [float(text or "nan") for text in texts]
                np.testing.assert_array_equal(data[()], numbers)
            else:
                assert data.dtype.kind == "S"
                assert [text.decode() for text in data[()]] == [*texts]
    before = (tmp_path / "t.h5").read_bytes()
    time.sleep(1.1)  # times in HDF5 are in seconds
    write_hdf5(tmp_path / "t.h5", "Title", COLUMNS)
    with pytest.raises(ValueError):
        write_hdf5(tmp_path / "t.h5", "Other", [*COLUMNS, Column("n", "m", ["text"])])
    assert (tmp_path / "t.h5").read_bytes() == before
    assert len([*tmp_path.iterdir()]) == 2


def test_texts_are_no_formulas_and_stay_in_one_line():
    cells = ["=cmd|x!A0", "@SUM(1)", "-x", "-0.1", "a\x1b]0;", None, True]
    texts = ["'=cmd|x!A0", "'@SUM(1)", "'-x", "-0.1", "a?]0;", "", "true"]
    assert Column("a", "", cells).texts == texts


def test_numbers_are_in_the_unit_of_their_column():
    values = [{"V": text, "law": "1mm", "tau": "0.1"} for text in ("1mm/s", "2e-3")]
    points = [Point(None, each) for each in values]
    units = {"V": "m/s", "law": "", "tau": "1", "is": "1"}
    sweep = Sweep("A", points, {"is": "tau > 0"}, [], units, "a.ini")
    V, law, tau, *_, is_so, _ = columns_of(sweep, [each | {"is": True} for each in values])
    assert (V.texts, V.heading, law.texts) == (["0.001", "2e-3"], "V [m/s]", ["1mm", "1mm"])
    assert (tau.unit, is_so.unit, is_so.texts) == ("1", "", ["true", "true"])


REPORTS = {"front": {"v_c": [1.0, None, 3.0], "events": [{"t": 1}, {"t": 2}], "F_T": 960.0}}
QUANTITIES = [  # text, value
    ("front.v_c.-1", 3.0),
    ("front.v_c.9", None),
    ("front.v_c", [1.0, None, 3.0]),
    ("front.events.*.t", [1, 2]),
    ("front.events", [None, None]),
    ("[[1] for e in front.events]", [None, None]),
    ("front.F_T / 1920", 0.5),
    ("front.F_T / 1920 > V", False),
    ("[2 * v for v in known(front.v_c)]", [2.0, 6.0]),
    ("front.v_c[1] + 1", None),
    ("front.v_c[9] + 1", None),
]


@pytest.mark.parametrize("text, value", QUANTITIES)
def test_a_quantity_is_a_number_a_list_or_an_expression(text, value):
    point = mock.Mock(names={"front", "V"}, known=({"V": 1.0} | REPORTS).__getitem__)
    assert measured(point, {"status": "done", "reports": REPORTS}, text) == value
    assert measured(point, {"status": "failed", "reports": {}}, text) is None


def test_lists_have_a_table_of_their_own_with_a_row_for_each_element():
    columns = [
        Column("V", "m/s", ["1", "2"]),
        Column("status", "", ["done", "done"]),
        Column("a", "s", [[1, None], None]),
        Column("b", "1", [[3, 4, 5], [6]]),
        Column("d", "1", [[9], 8]),
        Column("c", "1", [7, 8]),
        Column("point", "", ["p", "q"]),
    ]
    expected = {
        "V": ["1", "1", "1", "2"],
        "point": ["p", "p", "p", "q"],
        "element": [0, 1, 2, 0],
        "a": [1, None, None, None],
        "b": [3, 4, 5, 6],
        "d": [9, None, None, None],
    }
    assert {column.name: column.cells for column in elements_of(columns)} == expected
    assert elements_of([column for column in columns if not column.has_lists]) == []


# --- what is said ------------------------------------------------------------------------------


SUMMARY = """
A?[2J: 10 points: 2 done, 7 failed, 1 unfinished.
Computed now: 4; already done: 5.
Failed:
  2 x worse
  1 x 0
  1 x 1
  1 x 2
  1 x 3
  and 1 other sentence; the table has all
Unfinished:
  1 x crash
No point has a value for front.v_c.9 (v).
"""


def test_summary(capsys):
    failed = [("failed", sentence) for sentence in (*"01234", "worse", "worse")]
    states = [("done", ""), *failed, ("unfinished", "crash"), ("done", "")]
    table = [{"status": status, "sentence": sentence, "v": None} for status, sentence in states]
    sweep = Sweep("A\x1b[2J", [], {"v": "front.v_c.9"}, [], {}, "a.ini")
    assert (print_summary(sweep, table, 5), capsys.readouterr().out) == (1, SUMMARY)
    table[0]["v"] = 1.0
    assert print_summary(sweep, table[:1], 0) == 0
    assert "1 point: 1 done." in (said := capsys.readouterr().out) and "No point" not in said
    print_summary(sweep, table[1:3], 0)
    assert "No point" not in capsys.readouterr().out, "they have failed"


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
    return Sweep("$^$", [], names, varied, {}, "a.ini"), columns


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


def test_a_dash_and_a_note_where_there_is_no_value(folder):
    for name, first in (("a", 1.0), ("b", None)):
        draw(name, *sweep_of(LAWS, MEASURED | {SPEED: [first, 2.0, 3.0, None]}, THREE_DONE))
    assert share("b.png", BLACK) > share("a.png", BLACK)


@pytest.mark.parametrize(
    "error, why", [(ValueError("no\nmore"), "no"), (MemoryError(), "MemoryError")]
)
def test_what_cannot_be_drawn_is_one_line_and_leaves_no_file(folder, error, why):
    Path("a.png").write_text("half")
    with mock.patch("chains.picture.draw_columns", side_effect=error):
        said = draw("a", *sweep_of({V: ["1", "2"]}, *TWO))
    assert (said, [*folder.iterdir()]) == (f"No picture: {why}", [])


def test_a_picture_is_written_whole_or_not_at_all(tmp_path):
    def half(path, **_):
        Path(path).write_text("half")
        raise KeyboardInterrupt

    (picture := tmp_path / "a.png").write_text("former")
    with pytest.raises(KeyboardInterrupt):
        save(mock.Mock(savefig=half), tmp_path / "a")
    assert ([*tmp_path.iterdir()], picture.read_text()) == ([picture], "former")


def test_other_numbers_of_values_have_no_picture_and_a_former_one_goes(folder):
    Path("a.png").write_text("former")
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
    assert middle(numbers, np.array([True, True, True, True, False])) == 2.0
    texts = Column("a", "", ["fast", "b", "arrested", "a", "arrested", None])
    assert texts.categories == ["arrested", "fast", "b", "a"]
    assert middle(texts, np.full(6, True)) == 0


@pytest.mark.parametrize(
    "name, symbol, label",
    [
        ("t_R", "t_R", "$t_{R}$ [ms]"),
        ("mu_new", "mu_new", r"$\mu_\mathrm{new}$ [ms]"),
        ("d", "delta t_R", r"$\delta t_{R}$ [ms]"),
        ("tau-bar", "", r"$\bar{\tau}_{0}$ [ms]"),
        ("a$", "k_f/k", r"a\$ [ms]"),
    ],
)
def test_axes_have_symbols_and_the_units_that_were_typed(name, symbol, label):
    sweep = Sweep("A", [], {}, [name], {}, "a.ini", "log", {name: symbol}, {name: "ms"})
    column = as_typed(Column(name, "s", ["0.001", "0.0023", None]), sweep)
    assert (label_of(column), column.cells) == (label, [1.0, 2.3, None])
    assert column.scale == "log"


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
    grid = cells(linear, Column("b", "1", [1, 1, 2]), lambda here: np.flatnonzero(here)[0])
    np.testing.assert_array_equal(grid.filled(np.nan), [[0, 1, np.nan], [np.nan, np.nan, 2]])
    _, axes = figure()
    draw_line(axes, log, Column("b", "1", [None, 2.0, None]), np.array([True, True, False]))
    np.testing.assert_allclose(axes.get_xlim(), [10**-0.1, 10**2.1])
