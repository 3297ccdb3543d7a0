"""--profile and sweeps take and refuse the same tables (csv.txt)."""

import json
import re
from pathlib import Path

import pytest

from commands import json_of, output_of, refuses
from rupture.errors import UsageError
from sweeps.values import rows_in

LINE = re.compile(r'(\w+) (?:(\d+) )?(".*")')
CASES = LINE.findall(Path(__file__).with_name("csv.txt").read_text(encoding="utf-8"))


@pytest.mark.parametrize("line, text", [case[1:] for case in CASES], ids=[c[0] for c in CASES])
def test_both_readers(small_ini, line, text):
    Path("p.csv").write_bytes(json.loads(text).encode())
    load = "load --config small.ini -q -o a.h5 --profile p.csv"
    if line:
        refuses(load, 2, f"p.csv:{line}: ...")
        with pytest.raises(UsageError, match=rf"^p\.csv(, line {line})?: "):
            rows_in(Path("p.csv"))
        return
    rows = [("0mm", "0.4"), ("140mm", "0.8")]
    assert rows_in(Path("p.csv")) == [{"x": x, "junctions.mu_s": mu_s} for x, mu_s in rows]
    output_of(load)
    found = json_of("analyze show a.h5 --json")["parameters"]["junctions.mu_s"]
    assert found == pytest.approx([0.4 + 0.05 * i for i in range(9)])
