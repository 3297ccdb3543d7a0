"""Files that are missing, foreign, damaged, changed by other programs or in contradiction with
themselves: runs the rows of files.txt."""

import functools
import re
import shutil
from pathlib import Path

import h5py
import pytest

from changes import change
from commands import SANITIZED, output_of, refuses, run
from conftest import ROOT
from table_test import choices_in, filled

LATTICE = (
    "--set slider.L=0.04 --set slider.H=0.03 --set slider.Nx=5 --set slider.Nz=4"
    " --set driving.h=0.01 --set driving.V=1e-3 --set junctions.N_s=3 --set slider.E=7.5e8"
    " --set numerics.dt=1e-5"
)
DEADLY = (
    "the HDF5 library crashes when it reads the file (Segmentation fault), so the file is"
    " damaged or malicious; copy it again or recreate it"
)
# A run that has got to this step.
RUN = (
    "put /state/step 1234567 ; put /state/drive/origin_step 1000 ; put /run/first_step 7 ;"
    " put /run/last_break 7 ; put /run/ruptures 7 ; put /run/last_rupture 0.5 ; put /run/event"
    " [-1.0,0.25,0.5,-1.0,-1.0]"
)


def checkpoint(options, *changes):
    """good.h5, of 5 x 4 blocks."""
    output_of(f"load -o start.h5 -q {LATTICE} {options}")
    output_of("restart start.h5 -o good.h5 --for 0 -q")
    change("good.h5", f"content {' ; '.join([RUN, *changes])}")


def write_checkpoint():
    """Every other of three junctions is slipping."""
    slipping = [n for n in range(15) if (n // 3 + n) % 2 == 0]
    elements = [f"element /state/junctions/slipping {n} 1" for n in slipping]
    elements += [f"element /state/junctions/repin_time {n} 0.1" for n in slipping]
    checkpoint("--set junctions.f_new=f_slip", *elements)


def write_springs():
    """Springs 0, 2 and 4 are slipping, spring 1 has never broken."""
    times = enumerate([0.1, 0.0, -0.2, -0.3, 0.4])
    elements = [f"element /state/junctions/slow_until {n} {time}" for n, time in times]
    elements += [f"element /state/junctions/slipping {n} 1" for n in (0, 2, 4)]
    checkpoint("--set junctions.law=simplified", *elements)


def write_record():
    """Five samples, a rupture at the first and one at the last step, a crossing, fields."""
    output_of(
        f"load -o start.h5 -q {LATTICE} --until 4e-3 --record good.h5 --record-every 1e-3"
        " --crossings 0.2,0.5 --fields 4e-3"
    )
    pinned = [f"element /series/pinned {n} {2 + (n // 5 + n) % 2}" for n in range(25)]
    change("good.h5", f"content {' ; '.join(pinned)}")
    change(
        "good.h5",
        "content put /series/x_drive [0.0,1e-6,2e-6,3e-6,4e-6] ; put /ruptures/step [0,400] ;"
        " put /ruptures/time [0.0,0.004] ; put /ruptures/block [0,4] ; put /crossings/step [300] ;"
        " put /crossings/time [0.003] ; put /crossings/block [1] ;"
        " put /crossings/pinned_below [0.5]",
    )


BUILD = re.findall(r"rupture (\S+),", run("load --version").out)[0]
WRITERS = {"CHECKPOINT": write_checkpoint, "SPRINGS": write_springs, "RECORD": write_record}


def rows():
    sentences: dict = {}
    lines = re.sub(r"\\\n *", "", Path(__file__).with_name("files.txt").read_text())
    for line in re.findall(r"^[^#\s].*(?:\n    .*)*", lines, re.M):
        line = " ".join(line.split())
        if line.startswith("== "):
            _, good, readers = line.split(" ", 2)
        elif found := re.match("([A-Z_0-9]+) = (.*)", line):
            sentences[found[1]] = found[2]
        else:
            line, said = line.split(" =>")
            said = said.strip()
            said = [sentences.get(one, one) for one in said.split(" seal: ")]
            for made, chosen in choices_in(line):
                says = [filled(one, chosen) for one in said]
                yield pytest.param(good, readers.split(", "), made, *says[:1], says[-1], id=made)


@functools.cache
def good_file(good):
    """Its bytes, once it is made."""
    WRITERS[good]()
    assert run("analyze verify good.h5").code == 0
    return Path("good.h5").read_bytes()


CHANGED = (
    "x.h5 was changed after rupture sealed it, but can be read: if somebody edited or repacked it,"
    " rupture seal x.h5 -o NEW.h5 seals it again; otherwise it is damaged: copy it again or"
    " recreate it"
)
WORDS = {  # of verify, by what it says
    "does not exist|machine lacks": "unchecked",
    "is a folder|is not a reg|is not a checkpoint|is empty;|without rupture's|this version reads|which reads": "not ours",
    CHANGED[:30]: "changed",
}


def expect_said(command, sentence):
    code = 3 if command.startswith("seal") and "machine lacks" in sentence else 1
    assert refuses(command, code, sentence).out == ""


def expect_verdict(sentence):
    """In the list of verify, and in its refusal."""
    done = refuses("analyze verify x.h5", 1, sentence)
    found = (word for said, word in WORDS.items() if re.search(said, done.err))
    word = next(found, "damaged")
    assert done.out.startswith(f"{word}  x.h5") and f"\n1 {word}\n" in done.out


@pytest.mark.parametrize("good, readers, changes, says, of_seal", rows())
def test_row(folder, good, readers, changes, says, of_seal):
    data, path = good_file(good), Path("x.h5")
    Path("good.h5").write_bytes(data)
    path.write_bytes(data)
    sizes = {"WHOLE": len(data), "HALF": len(data) // 2, "LESS": len(data) - 1, "BUILD": BUILD}
    for name, value in sizes.items():
        changes, says, of_seal = (
            text.replace(name, str(value)) for text in (changes, says, of_seal)
        )
    change(path, changes)
    for reader in readers:
        expect_said(f"{reader} x.h5", "...x.h5: ..." if reader.startswith("xdmf") else says)
    if "was changed by another" in says:
        expect_verdict(CHANGED if of_seal == "sealed" else of_seal)
    elif not path.is_dir():
        expect_verdict(says)
    if of_seal == "sealed":
        output_of("seal x.h5 -o new.h5")
        output_of("analyze verify new.h5")
    else:
        expect_said("seal x.h5 -o new.h5", of_seal)


OF_CHECKPOINTS = "restart --for 1e-5 -o out.h5, modify-phi -o out.h5, analyze stress, analyze phi"
OF_RECORDS = "analyze events, analyze front, analyze classify, analyze slip --x 0, analyze loading"


@pytest.mark.parametrize(
    "good, readers, sentence",
    [
        ("CHECKPOINT", OF_RECORDS, "is a checkpoint; expected a record"),
        ("RECORD", OF_CHECKPOINTS, "is a record; expected a checkpoint"),
    ],
)
def test_the_other_kind_is_refused(folder, good, readers, sentence):
    Path("x.h5").write_bytes(good_file(good))
    for reader in readers.split(", "):
        expect_said(f"{reader} x.h5", f"x.h5 {sentence}")
    expect_said("seal x.h5 -o new.h5", "x.h5 is as rupture sealed it: there is nothing to do")
    missing = "x.h5/y.h5 does not exist; give the path of a checkpoint or record"
    refuses("analyze stress x.h5/y.h5", 1, missing)


@pytest.mark.parametrize("change_of_byte", ["14004 2", "7655 128", "10172 2", "19276 2"])
@pytest.mark.parametrize("name", ["e.h5", f"{60 * 'e'}.h5", f"{157 * 'e'}.h5"])
def test_what_crashes_the_library_is_one_sentence(folder, name, change_of_byte):
    """Each makes libhdf5 1.10.8 read beyond its memory. What is there depends on the name, too."""
    shutil.copyfile(ROOT / "tests/compatibility/schema-3/reference.h5", name)
    change(name, f"resealed_byte {change_of_byte}")
    done = run(f"analyze verify {name}")
    assert done.code == 1 and done.out.startswith(f"damaged  {name}: ")
    if h5py.version.hdf5_version_tuple[1] == 10 and not SANITIZED:
        assert done.err == f"analyze: {name}: {DEADLY}\n"
