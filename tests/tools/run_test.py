"""load, restart, finish and modify-phi: what files and summaries of several commands have in
common, and what --dry-run foresees. The rest is in tables/."""

import json
import os
import signal
import subprocess
from pathlib import Path

import h5py
import numpy as np
import pytest

from commands import checksum_of, files, json_of, lines_of, output_of, refuses, run
from conftest import BIN, started, stopped

pytestmark = pytest.mark.usefixtures("small_ini")


def dataset(name, path):
    with h5py.File(name) as file:
        return file[path][()]


# --- restart


def test_records_of_the_halves_are_that_of_the_whole():
    """Both halves have a sample of the step between them, amid the rupture of block 5."""
    how = "--record-every 2e-5 --fields 4e-5 --crossings 0.7,0.2 --record"
    output_of("prepare --config small.ini --set driving.V=0 --tau-bar 0.6 --sigma-bar 0.2 -o p.h5")
    output_of(f"restart p.h5 -o whole.h5 --set driving.V=1 --until 1e-4 {how} whole-r.h5")
    output_of(f"restart p.h5 -o half.h5 --set driving.V=1 --until 5.5e-5 {how} r1.h5")
    output_of(f"restart half.h5 -o end.h5 --until 1e-4 {how} r2.h5")
    assert checksum_of("end.h5") == checksum_of("whole.h5")
    records = ("whole-r.h5", "r1.h5", "r2.h5")
    series = [f"/series/{name}" for name in ("time", "x_drive", "F_T", "pinned", "p", "tau", "u_x")]
    for path in (*series, "/fields/time", "/fields/u_x", "/fields/u_z"):
        whole, first, second = (dataset(record, path) for record in records)
        assert len(whole) == (6 if path in series else 4)
        assert np.array_equal(first[-1], second[0]), path
        assert np.array_equal(np.concatenate([first[:-1], second[1:]]), whole), path
    for name in ("u_x", "u_z"):
        state = np.float32(dataset("end.h5", f"/state/{name}"))
        assert np.array_equal(dataset("r2.h5", f"/fields/{name}")[-1], state)
    for level in ("0.2", "0.3", "0.7"):
        whole, first, second = (
            json_of(f"analyze front {record} --json --ruptured-below {level}")["t_rupture"]
            for record in records
        )
        assert all(a is None or b is None for a, b in zip(first, second)), level
        assert [b if a is None else a for a, b in zip(first, second)] == whole
        assert whole[5] is not None
        assert (first[5] is None) == (level == "0.2")
        before = json_of(f"analyze front r2.h5 --json --ruptured-below {level}")["t_before"]
        assert [t is not None for t in before] == [t is not None for t in first]


@pytest.mark.parametrize(
    "condition, is_true",
    [
        ("F_T>0.6 kN", lambda of: of("F_T") > 600),
        ("t >= 1 or tau[4] >= 30", lambda of: of("tau")[:, 4] >= 30),
        ("time>1 and F_T<1 or u_x[0] > 50um", lambda of: of("u_x")[:, 0] > 5e-5),
        ("pinned_fraction[4] < 0.3 and x_drive > -1", lambda of: of("pinned")[:, 4] < 30),
        ("t > 0.3ms and p[7] <= 220", lambda of: (of("p")[:, 7] <= 220) & (of("time") > 3e-4)),
    ],
)
def test_a_condition_ends_the_run_at_the_first_sample_of_which_it_is_true(condition, is_true):
    load = "load --config small.ini -q -o a.h5 -f --record r.h5 --record-every 1e-5 --until"
    output_of(f"{load} 4e-4")
    with h5py.File("r.h5") as file:
        whole = {name: values[()] for name, values in file["series"].items()}
    first = int(np.argmax(is_true(whole.get)))
    assert json.loads(output_of([*load.split(), condition, "--json"]))["ending"] == "condition"
    assert first > 0
    for name in whole.keys() - {"x"}:
        assert np.array_equal(dataset("r.h5", f"/series/{name}"), whole[name][: first + 1]), name


def test_samples_are_dense_while_an_event_is_under_way():
    """From each rupture on for 5 t_R, here 0.1 ms, at the multiples of 2 us; fields as well."""
    output_of(
        "load --config small.ini -o a.h5 --until 1.6e-3 --set junctions.t_R=2e-5 --record r.h5"
        " --record-every 4e-4 --fields 8e-4 --record-every-in-events 2e-6"
    )
    ruptures = dataset("r.h5", "/ruptures/step")
    dense = [n for n in range(0, 8001, 10) if ((n >= ruptures) & (n <= ruptures + 500)).any()]
    assert 0 < len(dense) < 700
    for path, regular in (("/series/step", 2000), ("/fields/step", 4000)):
        steps = sorted({*dense, *range(0, 8001, regular)})
        assert dataset("r.h5", path).tolist() == steps


SPANNING = (
    "load --config small.ini -q -o a.h5 --set driving.V=0.05 --set junctions.t_R=5e-5 --until 9e-3"
    " --fields 3e-4 --checkpoint-every 7e-5 --record"
)
SERIES = [f"/series/{name}" for name in ("time", "step", "x_drive", "F_T", "pinned", "p", "tau")]


def test_samples_are_dense_in_those_events_alone_that_span():
    """Two events of this run arrest, and one begins just before its end."""
    output_of(f"{SPANNING} all.h5 --record-every-in-events 5e-6")
    output_of(f"{SPANNING} none.h5 --force")
    output_of(f"{SPANNING} r.h5 --force --record-every-in-spanning-events 5e-6")
    types, kept = [], set(dataset("none.h5", "/series/step"))
    for event in json_of("analyze events all.h5 --json")["events"]:
        types.append(event["type"])
        if event["type"] not in ("arrested", None):
            first, last = round(event["t_start"] / 2e-7), round(event["t_end"] / 2e-7) + 1250
            kept.update(n for n in range(0, 45000, 25) if first <= n <= last)
    assert types == ["fast", "fast", "arrested", "fast", "fast", "arrested", None]
    is_kept = np.isin(dataset("all.h5", "/series/step"), list(kept))
    for path in SERIES:
        assert np.array_equal(dataset("r.h5", path), dataset("all.h5", path)[is_kept]), path
    for path in ("/fields/step", "/fields/u_x", "/fields/u_z", "/ruptures/step"):
        assert np.array_equal(dataset("r.h5", path), dataset("none.h5", path)), path


@pytest.mark.parametrize("pieces, ending", enumerate([signal.SIGKILL, signal.SIGTERM] * 2, 2))
def test_samples_that_wait_for_the_end_of_their_event_survive_that_of_the_run(pieces, ending):
    output_of(f"{SPANNING} begin.h5".replace("9e-3", "2.95e-3"))
    restart = "restart a.h5 -q -o b.h5 --until 3.7e-3 --checkpoint-every 2e-5 --record"
    dense = "--record-every-in-spanning-events 5e-6"
    output_of(f"{restart} coarse.h5")
    output_of(f"{restart} whole.h5 --force {dense}")
    for path in Path().glob("b*.h5"):
        path.unlink()
    tool, *words = f"{restart} r.h5 {dense}".split()
    part = Path("r.h5.part")
    process = started([BIN / tool, *words], part, 5 * pieces, stderr=subprocess.DEVNULL)
    process.send_signal(ending)
    assert process.wait() == -ending
    output_of("finish r.h5.part -q -o now.h5")
    now, whole, coarse = (dataset(f"{name}.h5", SERIES[1]) for name in ("now", "whole", "coarse"))
    assert set(coarse[coarse <= now[-1]]) <= set(now) <= set(whole)
    same = np.isin(whole, now)
    assert np.array_equal(dataset("now.h5", SERIES[-1]), dataset("whole.h5", SERIES[-1])[same])
    resumed = run([tool, *words, "--resume"])
    assert (resumed.code, resumed.err) == (0, "")
    assert checksum_of("r.h5") == checksum_of("whole.h5")


def test_the_driving_force_stays_constant_at_rest():
    output_of("load --config small.ini --set driving.V=0.05 -o a.h5 --until 5e-4")
    output_of("restart a.h5 -o rest.h5 --set driving.V=0 --for 2e-2")
    output_of("restart rest.h5 -o b.h5 --for 1e-3 --record r.h5")
    F_T = json_of("analyze loading r.h5 --json")["F_T"]
    assert F_T[0] > 10
    assert F_T == pytest.approx([F_T[0]] * len(F_T), rel=1e-9)


def test_until_quiet_waits_for_the_pinned_fraction_that_was_asked_for():
    output_of("prepare --tau-bar 0.21 --sigma-bar 0.285 -o a.h5")  # not all break at once
    command = "restart a.h5 -f -o b.h5 --record r.h5 --crossings 0.2 --until-quiet --json -q"

    def arrival():
        return json_of("analyze front r.h5 --json --ruptured-below 0.2")["t_rupture"][-1]

    end = json_of(command)["time"]
    assert arrival() is None
    later = json_of(f"{command} --arrived-below 0.2")
    assert later["ending"] == "spanned"
    assert end < arrival() >= later["time"] - 2e-5


# --- --dry-run


@pytest.mark.parametrize(
    "options",
    [
        "--checkpoint-every 5e-6 --until 1e-5",
        "--record r.h5 --record-every 2e-6 --until 2e-4",
        "--record r.h5 --fields 2e-6 --until 2e-4",
        "--record r.h5 --fields 1e-3 --record-every-in-events 2e-6 --until 3e-3 --config small.ini",
    ],
)
def test_disk_and_time_are_foreseen(options):
    before = files()
    foreseen = json_of(f"load -o a.h5 {options} --dry-run --json")
    assert files() == before
    assert foreseen["time"] == foreseen["steps"] * foreseen["time_per_step"] > 0
    output_of(f"load -q -o a.h5 {options}")
    disk = sum(len(data) for name, data in files().items() if name not in before)
    assert disk <= foreseen["disk"] == pytest.approx(disk, rel=0.15)


def test_the_time_is_that_of_the_processor():
    load = f"{BIN}/load --config small.ini -o a.h5 --until 1e-4 --dry-run --json"
    crowd = "for n in 1 2 3 4; do while :; do :; done & done; "
    bash = ["/usr/bin/taskset", "-c", f"{min(os.sched_getaffinity(0))}", "/bin/bash", "-c"]
    scripts = (load, f"{crowd} {load}; kill $(jobs -p)")
    alone, crowded = (json_of([*bash, script])["time_per_step"] for script in scripts)
    assert crowded < 2 * alone


# --- --json


def summary_of(command):
    """The object that a command prints; its text goes to standard error."""
    done = run(f"{command} --json")
    assert (done.code, len(lines_of(done.out))) == (0, 1), done.err
    assert "wrote " in done.err
    return json.loads(done.out)


def test_the_summary_of_modify_phi_has_what_analyze_finds():
    output_of("prepare --tau-bar 0.2 --sigma-bar 0.1 --no-trigger -o a.h5")
    summary = summary_of("modify-phi a.h5 -o b.h5 --sigma-bar 0.3 --x-to 20mm")
    before, after = (json_of(f"analyze phi {file} --json") for file in ("a.h5", "b.h5"))
    assert summary.pop("largest_change") < 1e-9
    assert summary == {
        "x": before["x"],
        "slipping": before["slipping"],
        "sigma_bar_before": before["sigma_bar"],
        "sigma_bar_after": after["sigma_bar"],
        "changed": 9,
        "impossible": [],
        "files": [{"path": "b.h5", "holds": "checkpoint", "checksum": checksum_of("b.h5")}],
    }


def names_in(value, prefix):
    """As in analyze quantities: keys joined by dots, * for an index."""
    if isinstance(value, dict):
        return {name for key in value for name in names_in(value[key], f"{prefix}.{key}")}
    return names_in(value[0], f"{prefix}.*") if isinstance(value, list) else {prefix}


def test_summaries_have_the_fields_that_analyze_quantities_lists():
    listed = {quantity["name"] for quantity in json_of("analyze quantities --json")["summaries"]}
    for command in (
        "load --config small.ini -o a.h5 --until 4e-4",
        "restart a.h5 -o b.h5 --for 1e-5",
        "prepare --tau-bar 0.2 --tau-bar-trigger 0.9 --no-trigger -o c.h5",
        "modify-phi c.h5 -o d.h5 --sigma-bar 0.2",
    ):
        tool = command.split()[0]
        of_tool = {name for name in listed if name.startswith(f"{tool}.")}
        assert names_in(summary_of(command), tool) == of_tool


# --- finish


def test_finish_takes_another_name_while_the_run_goes_on_undisturbed():
    command = "load --config small.ini -o a.h5 --until 0.02 -q --record r.h5 --record-every 2e-6"
    part, (tool, *words) = Path("r.h5.part"), command.split()
    process = started([BIN / tool, *words], part, pieces=3)
    sentence = "a run is writing r.h5.part and will write ./r.h5 when it ends: give another output"
    with stopped(process):
        refuses("finish r.h5.part -o ./r.h5", 1, sentence)
        output_of("finish r.h5.part -o now.h5")
    assert process.wait() == 0
    output_of("analyze verify r.h5")
    for path in ("/series/time", "/series/tau", "/series/pinned"):
        now, whole = dataset("now.h5", path), dataset("r.h5", path)
        assert 0 < len(now) < len(whole)
        assert np.array_equal(now, whole[: len(now)])
