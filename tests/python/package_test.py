"""`import rupture`: files, `.part` files, checksums, programs, and the examples in docstrings; h5py
and xarray, which need no package of ours."""

import doctest
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tomllib
from pathlib import Path

import h5py
import numpy as np
import pytest

import rupture
import rupture.files
import rupture.programs
from changes import change
from conftest import BIN, ROOT, SMALL, need_modules, started
from rupture.envelope import sealed_header

ORACLE = ROOT / "tests/support/checksum.py"
SCHEMAS = ROOT / "tests/compatibility"
SHIPPED = (ROOT / "checkpoints").glob("*.h5")
DIMENSIONS: dict = {
    "series": {"F_T": ("time",), "pinned": ("time", "x")},
    "ruptures": {"block": ("time",)},
    "crossings": {"levels": ("levels",), "pinned_below": ("time",)},
    "fields": {"step": ("time",), "u_z": ("time", "z", "x")},
}


def recomputed(path):
    """The content checksum by h5py alone."""
    return subprocess.check_output(["/usr/bin/python3", ORACLE, path], text=True).strip()


def killed(name, pieces):
    """The `.part` of a run of the small slider that was killed when its record had so many."""
    part = Path(f"{name}-record.h5.part")
    command = [str(BIN / "load"), f"--config={SMALL}", "-q", "-o", f"{name}.h5", "--until", "0.2"]
    record = ["--record", f"{name}-record.h5", "--record-every", "2e-6"]
    run = started([*command, *record, "--checkpoint-every", "1e-4"], part, pieces)
    with h5py.File(part, "r") as first:  # while it is written
        blocks, samples = first["parameters/slider/Nx"][()], first["series/time"].shape
        note = first.attrs["note"].decode()
    run.kill()
    run.wait()
    assert (blocks, samples) == (17, (0,)) and "rupture finish" in note
    return part


def fails(sentence, call, *arguments, **options):
    with pytest.raises(rupture.Failure, match=sentence):
        call(*arguments, **options)


def test_a_part_is_the_beginning_of_the_record(small):
    name = killed("part", 4)
    part, again, whole = rupture.open(name), rupture.open(name), small.record
    assert np.array_equal(part["tau"], again["tau"])
    shared = min(len(part.time), len(whole.time))
    assert shared > 100 and not part.finished and whole.finished
    for array in ("time", "tau", "pinned", "u_x"):
        assert np.array_equal(part[array][:shared], whole[array][:shared]), array
    assert part.units("tau") == "N"
    assert part.parameters == whole.parameters
    fails("cannot be verified: its run is still going on or was killed", rupture.verify, name)


@pytest.mark.parametrize(
    "edit, says",
    [
        ("element /series/time 7 NaN", "/series/time holds nan; only finite numbers"),
        ("element /series/time 7 0", "/series/time does not ascend"),
        ("element /series/pinned 0 65535", "/series/pinned holds 65535; expected 0 to"),
        ("element /ruptures/block 0 17", "/ruptures/block holds 17; expected 0 to 16"),
        ("put /parameters/slider/Nx 999999999", "/parameters/slider/Nx holds 999999999"),
        ("put /parameters/slider/Nx 18", "/run/event is .*17.; expected .*18."),
        ("without /parameters", "/parameters/slider/L is missing; expected float64"),
        ("attribute / schema_version 1", "it has schema 1; .* rupture 0.4.0 prints"),
        ("attribute / schema_version 4", "its attributes say .*4; .* use a newer"),
    ],
)
def test_what_contradicts_the_schema_is_refused(small, edit, says):
    change(Path("small-record.h5"), f"resealed {edit}")
    fails(f"^small-record.h5: {says}", lambda: dict(rupture.open("small-record.h5")))


def test_damage_and_other_files_are_refused(small):
    whole = Path("small.h5").read_bytes()
    bad = Path("bad.h5")
    for where in (3, 30, 60, 300, 511, 600, len(whole) - 1):
        bad.write_bytes(whole[:where] + bytes([whole[where] ^ 1]) + whole[where + 1 :])
        fails("is damaged|is not a checkpoint or record", rupture.open, bad)
    bad.write_bytes(whole[:-1])
    fails("is damaged", rupture.open, bad)


@pytest.mark.parametrize("kind", ["record", "checkpoint", "part"])
def test_contains_what_iteration_gives_and_nothing_else(small, kind):
    file = rupture.open(killed("in", 2)) if kind == "part" else getattr(small, kind)
    listed = list(file)
    paths = [f"{file.home}/{name}" for name in listed]
    there = [path for path in paths if path in file.file]  # also with its group
    parameters = [f"parameters/{name.replace('.', '/')}" for name in file.parameters]
    odd = ["", ".", "junctions", "series", "provenance/0/tool", 3, None, *map("/{}".format, listed)]
    for name in [*listed, *paths, *parameters, *file.parameters, *odd]:
        assert (name in file) == (name in {*listed, *there}), name


@pytest.mark.parametrize("path", [*SCHEMAS.glob("schema-3/*.h5"), *SHIPPED], ids=str)
def test_verifies_files_of_schemas_2_and_3(path):
    with rupture.open(path) as file:
        assert rupture.verify(path) == file.checksum == recomputed(path)


@pytest.mark.parametrize("law", ["reference", "simplified", "decaying", "distance"])
def test_h5py_recomputes_the_checksum_under_each_law(law, folder):
    """All parameters of some laws, and all later ones, are away from their defaults; f_new only
    where the programs accept that."""
    known = json.loads(rupture.output_of("parameters", "--json"))["parameters"]
    earlier = rupture.open(SCHEMAS / "schema-3/reference.h5").parameters
    odd = {
        row["name"]: row.get("words", [0.01])[-1]
        for row in known
        if (len(row["laws"]) < 4 or row["name"] not in earlier)
        and (law in row["laws"] or row["name"] != "junctions.f_new")
    }
    for name, value in {"t_R": "3ms", "mu_new": "0.1", "d_R": "2um", "mu_s": "0.5"}.items():
        odd["junctions." + name] = f"{value} from 0 to 10mm"
    odd |= {"slider.load": "2 from 0 to 10mm", "junctions.law": law}
    made = rupture.run("load", output="x.h5", config=SMALL, set=odd)
    assert recomputed("x.h5") == made.checksum
    assert made.checkpoint.parameters["junctions.mu_s"] == [0.5, 0.5, *[0.4] * 15]


def test_a_content_that_is_not_as_stated_is_damaged(small):
    path = Path("changed.h5")
    shutil.copy("small.h5", path)
    with h5py.File(path, "r+") as file:
        file["state/u_x"][0, 0] += 1
    data = bytearray(path.read_bytes())
    data[:512] = sealed_header("rupture-checkpoint", memoryview(data))
    path.write_bytes(data)
    assert rupture.open(path).checksum == small.checksum
    fails("changed.h5: its content has the checksum", rupture.verify, path)


def test_names_that_a_file_lacks_and_closed_files(small):
    with rupture.open("small.h5") as closed:
        pass
    assert repr(closed) == "<rupture.Checkpoint 'small.h5': closed>"
    fails("^small.h5 was closed: open it again$", closed.get, "u_x")
    fails("has no u_y; did you mean u_[xz]?", rupture.open("small.h5").units, "u_y")
    assert small.record.get("fields/u_x", 5) == 5
    fails("has no ", small.record.dataset, "")
    fails("has no 3", lambda: small.record[3])
    fails("has no slider.l; did you mean slider.L?", lambda: small.record.parameters["slider.l"])
    listed = [line.split() for line in repr(small.record).splitlines()]
    samples = str(len(small.record.time))
    assert ["u_x", samples, "x", "17", "m"] in listed and ["F_T", samples, "N"] in listed


def test_errors_are_failures_whatever_was_given(folder):
    fails("^None is not the name of a file: expected str, .*; give the path", rupture.open, None)
    null = "(embedded null byte|stat: embedded null character in path); give the path"
    fails(f"^'a.x00b' is not the name of a file: {null}", rupture.open, "a\0b")
    fails("^program  not found", rupture.run, "", output="x.h5")
    fails("^load cannot be started: embedded null byte; check", rupture.run, "load", output="a\0b")
    many = {"junctions.mu_s": np.full(65536, 1 / 3)}
    fails("too long.* values with --profile$", rupture.run, "load", output="x.h5", set=many)
    fails("^set must be a dict, .*'b=1'", rupture.run, "load", output="x.h5", set="b=1")
    fails("^analyze events prints no report", rupture.analyze, "events", help=True)
    fails("not exist", rupture.analyze, "events", "\udcff.h5")
    assert repr(rupture.Result("none.h5", None)) == "<rupture.Result 'none.h5': not there>"


def test_sets_values_along_x_parts_and_what_parameters_returned(folder):
    odd: dict = {
        "junctions.mu_s": np.linspace(0.4, 0.5, 17),
        "junctions.t_R": [1e-4, "3e-4 from 0 to 20mm", "4e-4 from 20mm to 50mm"],
        "junctions.f_new": ["f_slip from 0 to 10mm", "f_slip from 130mm to 140mm"],
    }
    made = rupture.run("load", output="x.h5", config=SMALL, set=odd).checkpoint
    found = made.parameters
    assert found["junctions.mu_s"] == odd["junctions.mu_s"].tolist()
    assert found["junctions.t_R"] == 3 * [3e-4] + 3 * [4e-4] + 11 * [1e-4]
    assert found["junctions.f_new"] == 2 * ["f_slip"] + 13 * ["zero"] + 2 * ["f_slip"]
    again = rupture.run("load", output="again.h5", set=found)
    assert again.checksum == made.checksum
    shape = {name: found[name] for name in ("slider.H", "slider.Nx", "slider.Nz", "driving.h")}
    levels = np.array([0.05, *16 * [0.1]]), "0.05,16x0.1"
    sums = [
        rupture.run("prepare", output="p.h5", set=shape, tau_bar=level, force=True).checksum
        for level in levels
    ]
    assert sums[0] == sums[1]


@pytest.mark.parametrize("send", [os.kill, os.killpg])  # as notebooks and terminals do
def test_an_interrupted_run_says_where_it_goes_on(folder, send):
    options = {"output": "x.h5", "record": "r.h5", "config": str(SMALL), "until": 0.2}
    options |= {"record_every": 2e-6, "resume": True}  # there is nothing to resume from at first
    command = [sys.executable, "-c", f"import rupture; rupture.run('load', **{options})"]
    run = started(command, Path("r.h5.part"), 2, stderr=subprocess.PIPE, process_group=0)
    send(run.pid, signal.SIGINT)
    said = run.communicate()[1].decode().splitlines()[-1]
    sentence = "KeyboardInterrupt: load: interrupted, and saved as {}; with resume=True it goes on"
    (saved,) = Path().glob("x-t*.h5")
    assert said.startswith(sentence.format(saved))
    subprocess.run(command, check=True)
    assert rupture.open("x.h5").time == pytest.approx(0.2)


def test_pandas_holds_the_arrays(small):
    need_modules("pandas")
    record, checkpoint = small.record, small.checkpoint
    table, place = record.to_dataframe(), (record.time[5], record.x[3])
    assert table.loc[place, "tau"] == record["tau"][5, 3]
    assert table.loc[place, "F_T"] == record["F_T"][5]
    where = (checkpoint.z[2], checkpoint.x[4])
    assert checkpoint.to_dataframe().loc[where, "u_z"] == checkpoint["u_z"][2, 4]


@pytest.mark.filterwarnings("error")
def test_xarray_alone_finds_dimensions_positions_and_units(folder):
    need_modules("xarray", "h5netcdf")
    import xarray

    times = {"until": 4e-4, "record_every": 2e-5, "crossings": 0.5, "fields": 1e-4}
    record = rupture.run("load", output="x.h5", record="r.h5", config=SMALL, **times).record
    assert recomputed("r.h5") == record.checksum
    page = (ROOT / "docs/schema.md").read_text(encoding="utf-8")
    script = re.split("```(?:python)?\n", page.split("\n#### Labels\n")[1])[1]
    said = subprocess.check_output([sys.executable, "-B", "-c", script, "r.h5"], text=True)
    assert said == f"Frozen({{'time': 21, 'x': 17}}) N\n{record['tau'][-1, 2]}\n"
    for group, dimensions in DIMENSIONS.items():
        with xarray.open_dataset("r.h5", group=group, engine="h5netcdf") as found:
            assert {name: found[name].dims for name in dimensions} == dimensions
            for name, array in found.variables.items():
                assert np.allclose(array, record[f"{group}/{name}"], rtol=0, atol=0)
                assert array.attrs["units"] == record.units(f"{group}/{name}")
                assert len(array.attrs["long_name"]) > 3
            for name in {"x", "z"} & {*found.sizes}:
                assert np.allclose(found[name], getattr(record, name))


def test_programs_have_the_version_of_the_package():
    package = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert rupture.__version__ == package["version"]


def test_a_result_has_the_files_of_its_run_and_is_an_input(small):
    rupture.run("load", output="small-t1.h5", config=SMALL, seed=2)  # another one's
    made = rupture.run("modify-phi", small.checkpoint, output="small-t2.h5", shape="uniform")
    assert made.checkpoints == [] and made.checkpoint.provenance[-1]["tool"] == "modify-phi"
    shutil.copy("small-record.h5", "small-t3.h5")
    Path("small-t4.h5").touch()
    names = [path.name for path in small.checkpoints]
    assert names[0] == "small-t0.000500000.h5"
    assert len(names) == 4
    assert small.checksum == rupture.verify("small.h5")
    for name in ("small", *(name.removesuffix(".h5") for name in names)):
        shutil.move(f"{name}.h5", f"{name}.h5".replace("small", "a[1]"))
    assert len(rupture.Result("a[1].h5", None).checkpoints) == 4


def test_a_refusal_is_its_sentence(small, monkeypatch):
    fails("^load: small.h5 exists", rupture.run, "load", output="small.h5", until=0.001)
    monkeypatch.setenv("RUPTURE_BIN", "/nowhere")
    fails("RUPTURE_BIN=/nowhere", rupture.run, "load", output="other.h5")


def test_arrays_odd_names_and_options_given_anyway(small):
    times = {"until": np.float64(1e-4), "checkpoint_at": np.array([2e-5, 4e-5])}
    made = rupture.run("load", output="-x.h5", record="-r.h5", config=SMALL, quiet=True, **times)
    assert len(made.checkpoints) == 2
    assert rupture.analyze("events", made.record, json=True)["events"] == []
    path = rupture.run("map", "-r.h5", output="map.png")
    assert (path, path.read_bytes()[1:4]) == (Path("map.png"), b"PNG")
    after = rupture.run("restart", "-x.h5", output="after.h5", for_=1e-5)
    assert rupture.verify(after.checkpoint) == after.checksum
    assert rupture.analyze("diff", *made.checkpoints)["differences"]  # exit code 1


@pytest.mark.parametrize("module", [rupture.files, rupture.programs])
def test_the_examples_in_docstrings_give_what_they_say(module, small):
    need_modules("pandas")
    names = {"rupture": rupture, "checkpoint": rupture.open("small.h5")}
    names["record"] = rupture.open("small-record.h5")
    found = doctest.testmod(module, extraglobs=names, optionflags=doctest.ELLIPSIS)
    assert found.attempted and not found.failed
