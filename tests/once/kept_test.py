"""Which files stay, which go and are made again, and what is found in the store."""

import json
import os
import shutil
from contextlib import suppress
from glob import glob
from pathlib import Path

import pytest

from rupture import once
from rupture.commands.store import head
from rupture.errors import Failure, MachineFailure
from rupture.once import each, keep, run

pytest_plugins = "laboratory"


def front(start="a.h5", line="load -o a.h5", words="", keep=()):
    return run(f"analyze front {run(line, keep)[start]} {words}")


def listed(lab):
    """Unlike Path.glob, this passes over a folder that another thread deletes meanwhile."""
    return sorted(glob("*/*", root_dir=lab.store / "now", include_hidden=True))


def files_of(lab):
    """Those that are there at one moment while a call needs them: between two listings that agree,
    for files come and go in other threads."""
    before, after = None, listed(lab)
    while before != after:
        before, after = after, listed(lab)
    return after


# --- files that go


def test_files_go_with_the_call_and_are_made_again(lab):
    front()
    assert len(files_of(lab)) == 1
    lab.call()
    assert files_of(lab) == []
    assert front(words="--x 1").read == "<load -o a.h5>"
    assert lab.ran() == [
        "load -o a.h5",
        "analyze front a.h5",
        "load -o a.h5",
        "analyze front a.h5 --x 1",
    ]


@pytest.mark.parametrize(
    "keep_it",
    [lambda: run("load -o a.h5", keep=["a.h5"]), lambda: keep(run("load -o a.h5")["a.h5"])],
)
def test_a_file_may_be_kept_later(lab, keep_it):
    front()
    keep_it()
    lab.call()
    front(words="--x 1")
    assert lab.ran().count("load -o a.h5") == 1


def test_a_point_takes_what_it_named_with_it(lab):
    def point(n):
        assert front(line=f"load --seed {n} -o a.h5").read
        return len(files_of(lab))

    outside = open(run("load -o a.h5")["a.h5"]).read()
    assert [most for _, most in each(point, range(6))] <= [4] * 6  # two at a time, and one outside
    assert (outside, len(files_of(lab))) == ("load -o a.h5", 1)


def test_what_is_named_outside_is_made_once_for_all_points(lab):
    shared = run("load -o a.h5")["a.h5"]
    each(lambda n: run(f"analyze front {shared} --x {n}"), range(4))
    assert lab.ran().count("load -o a.h5") == 1

    def point(n):
        inside = run("load --seed 2 -o a.h5")["a.h5"]
        each(lambda m: run(f"analyze front {inside} --x {n}{m}"), range(4))

    each(point, range(1))
    assert lab.ran().count("load --seed 2 -o a.h5") == 1
    assert len(files_of(lab)) == 1  # that of outside


def test_a_file_stays_while_it_is_read(lab):
    def point(n):
        words = "--sleep 0" if n else "--sleep 0.4"  # the first reads when the other is done
        return run(f"analyze front {words} {run('load --sleep 0.1 -o a.h5')['a.h5']}").read

    assert [read for _, read in each(point, range(2))] == ["<load --sleep 0.1 -o a.h5>"] * 2
    assert lab.ran().count("load --sleep 0.1 -o a.h5") == 1


def test_a_cap_lets_files_go_earlier_but_none_that_is_read(lab):
    lab.call(cap=1)
    first = run("load -o a.h5")["a.h5"]
    assert Path(first).read_text() == "load -o a.h5"  # as long as it was opened
    after = run(f"restart {run('load --seed 2 -o a.h5')['a.h5']} -o b.h5")["b.h5"]
    assert front(line=f"restart {after} -o a.h5").read.count("restart") == 2
    assert files_of(lab) == [f"{first.work.own}/a.h5"]
    run(f"analyze phi {after}")
    ran = lab.ran()
    assert [ran.count(line) for line in ("load -o a.h5", "restart a.h5 -o b.h5")] == [1, 2]


def test_a_file_leaves_its_point_with_who_opens_it(lab):
    [(_, made)] = each(lambda n: run("load -o a.h5")["a.h5"], [1])
    assert open(made).read() == "load -o a.h5"
    assert len(files_of(lab)) == 1


# --- what is found in the store


def exchange(path):
    path.write_bytes(path.read_bytes().replace(b"load", b"LOAD"))


def link(path):
    shutil.move(path, path.with_name("elsewhere"))
    path.symlink_to("elsewhere")


def pipe(path):
    path.unlink()
    os.mkfifo(path)


def endless(path):
    path.unlink()
    path.symlink_to("/dev/zero")


def forge(path, body=b'"command": 1}'):
    """With the digest of what has another form."""
    path.write_bytes(head(path.stem, body) + body)


HUGE = f'"command": "", "build": null, "started": 1, "seconds": {10**400}, "status": "done",'


WAYS = [
    exchange,
    link,
    pipe,
    endless,
    forge,
    lambda path: forge(path, f'{HUGE} "report": {{"read": ""}}}}'.encode()),
    Path.unlink,
    lambda path: path.write_bytes(b""),
    lambda path: os.truncate(path, 9),
    lambda path: os.truncate(path, 2**29),
]


@pytest.mark.parametrize("change", WAYS)
@pytest.mark.parametrize("pattern, again", [("*.a.h5", "made again"), ("*.json", "done again")])
def test_what_is_not_as_it_was_written_is_made_again_with_a_sentence(
    lab, capfd, change, pattern, again
):
    first = front(keep=["a.h5"])
    lab.call()
    for path in lab.store.glob(f"??/{pattern}"):
        change(path)
    assert front(keep=["a.h5"]) == first
    assert front(words="--x 1", keep=["a.h5"]).read == first.read
    said = capfd.readouterr().err.splitlines()
    count = 0 if change is Path.unlink else len(lab.stored(pattern)) - (again[0] == "d")
    assert [line.split(": it is ")[1] for line in said] == [again] * count
    lab.call()
    front(words="--x 2", keep=["a.h5"])
    assert len(lab.ran()) == (5 if again[0] == "m" else 6)
    assert capfd.readouterr().err == ""


def change_known(path, others):
    """With its digest; what shall be None goes."""
    known = json.loads(path.read_bytes()) | {"digest": None} | others
    known = {name: value for name, value in known.items() if value is not None}
    forge(path, json.dumps(known | {"build": None})[1:].encode())


@pytest.mark.parametrize(
    "program, others",
    [
        ("analyze", {"report": None, "kept": {}}),
        ("load", {"report": {}, "kept": None, "checksums": None}),
        ("analyze", {"started": -(10**18)}),
        ("load", {"started": 10**12}),
    ],
)
def test_a_result_that_the_command_cannot_have_is_none(lab, capfd, program, others):
    first = front(keep=["a.h5"])
    lab.call()
    for name, text in lab.stored("*.json").items():
        if json.loads(text)["command"].startswith(program):
            change_known(lab.store / name[:2] / name, others)
    with suppress(once.Unknown):
        lab.call(dry_run=True)
        str(front(words="--x 1" if program == "load" else "", keep=["a.h5"]))
    assert "it is done again" in capfd.readouterr().err
    lab.call()
    assert front(keep=["a.h5"]) == first
    assert front(words="--x 1", keep=["a.h5"]).read == first.read
    assert len(lab.ran()) == 4


def test_nothing_outside_is_deleted_whatever_a_result_says_of_its_files(lab):
    outside = lab.write("outside", "mine")
    front(keep=["a.h5"])
    lab.call()
    for path in lab.store.glob("??/*.a.h5"):
        path.unlink()
        own = path.name.removesuffix("a.h5")
        path.with_name(own).mkdir()
        result = path.with_name(f"{own}json")
        change_known(result, {"kept": {"/../../../outside": ""}})
    front(words="--x 1", keep=["a.h5"])
    assert outside.read_text() == "mine"


def test_a_result_of_another_command_is_none(lab):
    front()
    mine, other = lab.store.glob("??/*.json")
    shutil.copy(mine, other)
    lab.call()
    assert front().said == "analyze front a.h5"


def test_a_folder_that_is_no_store_is_left_alone(lab):
    lab.write("papers/thesis.tex", "")
    with pytest.raises(Failure, match="papers has other files"):
        once.use(store="papers")
    assert os.listdir("papers") == ["thesis.tex"]
    lab.write("store/rupture-store", "Results of rupture, layout 9.\n")
    with pytest.raises(Failure, match="another version"):
        lab.call()


def test_a_link_inside_is_refused_a_store_may_be_one(lab):
    shutil.move(lab.store, "elsewhere")
    os.symlink("elsewhere", lab.store)
    once.finish()
    os.mkfifo("elsewhere/now")
    lab.call()
    os.mkdir("target")
    os.symlink("../target", "elsewhere/ab")
    with pytest.raises(Failure, match="ab is a link"):
        lab.call()


# --- the disk


def no_room(*_, **__):
    raise OSError(28, "No space left on device")


@pytest.mark.parametrize("name, of", [("fsync", "a.h5"), ("mkdir", "now"), ("replace", "a.h5")])
def test_a_full_disk_is_named_and_the_next_call_goes_on(lab, monkeypatch, name, of):
    with monkeypatch.context() as patched:
        patched.setattr(os, name, no_room)
        with pytest.raises(
            MachineFailure, match=f"cannot write {lab.store}/.*{of}.*: No space left"
        ):
            front(keep=["a.h5"])
    lab.call()
    assert front(keep=["a.h5"]).read == "<load -o a.h5>"


def test_nothing_has_its_name_before_it_is_on_the_disk(lab, monkeypatch):
    synced: set = set()
    real = {name: getattr(os, name) for name in ("fsync", "replace")}

    def fsync(number):
        synced.add(os.fstat(number).st_ino)
        real["fsync"](number)

    def replace(part, place):
        assert os.stat(part).st_ino in synced, place
        real["replace"](part, place)

    monkeypatch.setattr(os, "fsync", fsync)
    monkeypatch.setattr(os, "replace", replace)
    front(keep=["a.h5"])
    assert len(synced) == 3


def test_without_links_files_are_copied(lab, monkeypatch):
    monkeypatch.setattr(os, "symlink", no_room)
    monkeypatch.setattr(os, "link", no_room)
    assert front(keep=["a.h5"]).read == "<load -o a.h5>"
    assert [*lab.stored("*.a.h5").values()] == [b"load -o a.h5"]
