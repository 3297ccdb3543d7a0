"""--profile and sweeps take and refuse the same tables in CSV (docs/runs.md)."""

from pathlib import Path

import pytest

from commands import json_of, output_of, refuses
from rupture.errors import UsageError
from sweeps.values import rows_in

LOAD = "load --config small.ini -q -o a.h5 --profile p.csv"
TAKEN = [
    "x [mm],junctions.mu_s\n0,0.4\n140,0.8\n",  # plain
    "\ufeffx [mm],junctions.mu_s\r\n0,0.4\r\n140,0.8\r\n",  # windows with a byte order mark
    "x [mm],junctions.mu_s\r0,0.4\r140,0.8\r",  # old macintosh
    "x [mm],junctions.mu_s\n0,0.4\n140,0.8",  # no end of the last line
    '"x [mm]","junctions.mu_s"\n0,0.4\n"140","0.8"\n',  # quoted by R or pandas
    "x [mm], junctions.mu_s\n 0 ,\t0.4\n140 , 0.8\t\n",  # blanks
    ' "x [mm]" , "junctions.mu_s" \n0,0.4\n140,0.8\n',  # blanks around quotes
    '" x [mm]",junctions.mu_s\n"0 ",0.4\n140,0.8\n',  # blanks in quotes
    "x[mm],junctions.mu_s [1]\n0,0.4\n140,0.8\n",  # blanks in headings
    "x  [ mm ],junctions.mu_s\n0,0.4\n140,0.8\n",  # blanks in units
    'x [mm],junctions.mu_s,,\r\n0,0.4,,\r\n140,0.8\r\n,,,\r\n" ",\r\n',  # padded by Excel
    # comments
    '# measured\nx [mm],junctions.mu_s\n  # by "A, B"\n0,0.4\n#140,0.6\n140,0.8\n',
    '"# by A, B",,\nx [mm],junctions.mu_s\n0,0.4\n140,0.8\n',  # comments in quotes
    "\nx [mm],junctions.mu_s\n\n \n0,0.4\r\n\r\n140,0.8\n\n",  # empty lines
]
REFUSED = [  # the line that both name
    (3, "x [mm],junctions.mu_s\n0,0.4\n140\n"),  # too few cells
    (5, "x [mm],junctions.mu_s\r\n# 1\r\n\r\n0,0.4\r\n,0.8\r\n"),  # empty cell
    (2, "x [mm],junctions.mu_s\n0,0,4\n140,0,8\n"),  # too many cells
    (2, "x [mm],junctions.mu_s,\n0,0.4,1\n"),  # cell without heading
    (1, '"","x [mm]","junctions.mu_s"\n"1",0,0.4\n'),  # numbers of rows
    (1, "x [mm],[m]\n0,0.4\n"),  # unit without a name
    (1, "x [mm],x [m]\n0,0.4\n"),  # same heading twice
]


@pytest.mark.parametrize("text", TAKEN)
def test_the_same_in_many_forms(small_ini, text):
    Path("p.csv").write_bytes(text.encode())
    rows = [("0mm", "0.4"), ("140mm", "0.8")]
    assert rows_in(Path("p.csv")) == [{"x": x, "junctions.mu_s": mu_s} for x, mu_s in rows]
    output_of(LOAD)
    found = json_of("analyze show a.h5 --json")["parameters"]["junctions.mu_s"]
    assert found == pytest.approx([0.4 + 0.05 * i for i in range(9)])


@pytest.mark.parametrize("line, text", REFUSED)
def test_a_mistake_is_named_with_its_line(small_ini, line, text):
    Path("p.csv").write_bytes(text.encode())
    refuses(LOAD, 2, f"p.csv:{line}: ...")
    with pytest.raises(UsageError, match=rf"^p\.csv(, line {line})?: "):
        rows_in(Path("p.csv"))
