"""What somebody has put into results/: nothing outside is read, published, replaced or deleted, no
program hangs, and each ends with sentences."""

import copy
import json
import os
import re
import shutil
import signal
from contextlib import suppress
from pathlib import Path

import pytest

from claims.claim import read_results
from claims.own_result import results_in
from conftest import ROOT
from fixture import SHARE, Project, spill
from report import page
from report.jobs import read_jobs
from report.written import seal
from reproduce import stamps
from rupture.commands.store import Store
from rupture.errors import Failure
from stand_ins import Project as Clone

SECRET = "a secret of the user"
OWN = {"id": "choices", "question": "Is it?", "measured": {"v [m/s]": 1.0}, "expected": {"v": "1"}}
NAMES: tuple = (
    "fig2/jobs.jsonl",
    "fig3/claims.json",
    "fig4/own.json",
    "figS1/figS1.png",
    "fig1/front.csv",
)
NAMES += ("index.html", "numbers.csv", "claims.png", "ro-crate-metadata.json")
SHAPES = {
    "pipe": lambda path, _: os.mkfifo(path),
    "folder": lambda path, _: (path / "theirs").mkdir(parents=True),
    "link to a file": lambda path, outside: path.symlink_to(outside),
    "link to nothing": lambda path, _: path.symlink_to("/nowhere"),
    "link to a device": lambda path, _: path.symlink_to("/dev/zero"),
    "empty": lambda path, _: path.write_bytes(b""),
    "huge": lambda path, _: os.truncate(path.open("wb").name, 2**40),
    "no text": lambda path, _: path.write_bytes(b"\xff\0\xfe{"),
    "no JSON": lambda path, _: path.write_bytes(b'{"schema": 2,\n'),
    "deep": lambda path, _: path.write_bytes(b"[" * 10**6),
    "zeros": lambda path, _: path.write_bytes(b"[1" + b"0" * 5000 + b"]"),
}


@pytest.fixture(autouse=True)
def within_a_minute():
    signal.alarm(60)
    yield
    signal.alarm(0)


@pytest.fixture(name="project", scope="module")
def project_with_results(tmp_path_factory):
    project = Project(tmp_path_factory.mktemp("sound") / "project")
    project.make_recipes()
    project.make_accounts()
    spill(project.results / "fig4/own.json", json.dumps([OWN]))
    project.seal()
    assert project.report().returncode == 0
    return project


@pytest.fixture(name="copied")
def copy_of_it(project, tmp_path):
    shutil.copytree(project.root, tmp_path / "project")
    copied = copy.copy(project)
    copied.root = tmp_path / "project"
    copied.results, copied.page = copied.root / "results", copied.root / "results/index.html"
    return copied


def delete(path):
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    path.unlink(missing_ok=True)


def plant(path, shape, outside):
    delete(path)
    path.parent.mkdir(exist_ok=True)
    SHAPES[shape](path, outside)


@pytest.mark.parametrize("shape", SHAPES)
def test_a_report_leaves_out_what_was_planted(copied, shape, tmp_path):
    spill(outside := tmp_path / "outside", SECRET)
    ours = NAMES if shape in ("empty", "huge", "no text", "no JSON", "deep", "zeros") else NAMES[:5]
    for name in ours:
        plant(copied.results / name, shape, outside)
    done = copied.report()
    assert (done.returncode, done.stderr.count("\n")) == (0, 5), done.stderr
    for name in NAMES[:5]:
        sentence = f"{name} is gone, or not as it was written: left out until ./reproduce.sh"
        assert sentence in done.stderr
        assert f'id="{name.split("/")[0]}"' not in copied.page.read_text()
    texts = (path.read_text() for path in map(copied.results.joinpath, NAMES[5:7] + NAMES[8:]))
    assert not any(SECRET in text for text in texts)
    assert outside.read_text() == SECRET


PLANTED = (
    [  # what ./reproduce.sh finds, its shape, the exit codes of `report` and `clean`, a sentence
        ("results", "empty", 1, 0, "results"),
        ("results", "pipe", 1, 0, "results"),
        ("results", "link to nothing", 1, 0, "results"),
        ("results/fig3", "link to nothing", 1, 0, "results/fig3 is a link, which is not followed"),
        (
            "results/fig3/claims.json",
            "link to a device",
            1,
            0,
            "claims.json is a link, which is not",
        ),
        ("results/store/now", "link to nothing", 0, 1, "results/store/now is a link"),
        ("results/store/rupture-store", "pipe", 0, 0, ""),
        *(
            ("results/rupture-results", shape, 1, 0, "results.rupture-results")
            for shape in ("pipe", "folder", "huge")
        ),
        ("results/rupture-results", "no text", 1, 0, "results is of another version (.+): move it"),
        ("results/rupture-results", "link to a file", 1, 0, "results/rupture-results is a link"),
    ]
)


@pytest.fixture(name="clone", scope="module")
def clone_with_results(project, tmp_path_factory):
    clone = Clone(tmp_path_factory.mktemp("planted"))
    for name in ("docs", "checkpoints"):
        (clone.root / name).symlink_to(ROOT / name)
    return clone


@pytest.mark.parametrize("name, shape, of_report, of_clean, sentence", PLANTED)
def test_a_command_ends_with_a_sentence(
    clone, project, tmp_path, name, shape, of_report, of_clean, sentence
):
    spill(outside := tmp_path / "outside", SECRET)
    results = clone.root / "results"
    delete(results)
    delete(clone.root / "build")
    shutil.copytree(project.results, results)
    spill(
        results / "store/rupture-store", "Results of rupture, layout 1. All of it may be deleted.\n"
    )
    spill(results / "mine", SECRET)
    plant(clone.root / name, shape, outside)
    for command, code in (("report", of_report), ("clean", of_clean)):
        done = clone.call(command)
        assert (done.returncode, "Traceback" in done.stderr) == (code, False), done.stderr
        assert not code or re.fullmatch(f"reproduce.sh: .*{sentence}.*\n", done.stderr)
    assert outside.read_text() == SECRET
    assert name == "results" or (results / "mine").read_text() == SECRET


EVALUATED = "axes.prop_cycle: not a cycle\n"  # Matplotlib warns of what it reads
CACHED = ".cache/rupture/matplotlib"


@pytest.mark.parametrize(
    "home, cache, made",
    [
        ("home", None, f"home/{CACHED}"),
        ("home", "relative", f"home/{CACHED}"),
        ("home", "apart", "apart/rupture/matplotlib"),
        ("/dev/null", None, None),  # a temporary folder
    ],
)
def test_matplotlib_reads_nothing_that_was_planted(clone, tmp_path, monkeypatch, home, cache, made):
    folders = [tmp_path / name for name in ("home", "home/.cache", "apart", "temporary")]
    for folder in folders:
        folder.mkdir()
    planted = "build/cache/matplotlib/stylelib/a.mplstyle"
    clone.write(planted, EVALUATED)
    others = {"PYTHONPATH": "recipes:python"}
    others |= {"HOME": str(tmp_path / home), "TMPDIR": str(folders[-1]), "MPLCONFIGDIR": "nothing"}
    if cache:
        others["XDG_CACHE_HOME"] = str(tmp_path / cache) if cache == "apart" else cache
    shown = ["import os", "from reproduce.project import *", "use_own_environment()"]
    shown += ["import matplotlib.style", "print(os.environ['MPLCONFIGDIR'])"]
    monkeypatch.setattr(clone, "environment", clone.environment | others)
    done = clone.call("-P", "-c", "\n".join(shown), command="/usr/bin/python3")
    assert (done.returncode, "a.mplstyle" in done.stderr) == (0, False), done.stderr
    if made:
        assert done.stdout.strip() == str(tmp_path / made)
        assert (tmp_path / made).stat().st_mode & 0o777 == 0o700
    else:
        assert done.stdout.startswith(f"{folders[-1]}/rupture-")
    assert [*folders[-1].iterdir()] == []


# --- with the right checksums


def test_only_modules_of_ours_are_parsed(tmp_path):
    spill(tmp_path / "a.py", "def (:")
    assert len(stamps.content_of(tmp_path / "a.py", None)) == 16
    os.mkfifo(tmp_path / "b.py")
    with pytest.raises(Failure, match="b.py: not a regular file"):
        stamps.content_of(tmp_path / "b.py", None)


def test_results_made_from_nothing_are_not_up_to_date(copied, tmp_path, monkeypatch):
    monkeypatch.chdir(copied.root)
    store = Store(tmp_path / "store")
    for files in (["recipes/fig2/commands.py"], []):
        stamps.save("fig2", stamps.described(files, store), [], store)
        assert stamps.is_current("fig2", True, store) == bool(files)


VALUES: tuple = (
    None,
    True,
    -1,
    1e400,
    10**400,
    "<script>$\\frac{",
    "../../outside",
    "/etc/passwd",
)
VALUES += ([], {}, [[{}]], {"../x": 1}, {"at_least": "1/0"})
UNSEEN = "\x1b]52;c;aQ==\x07\x1b[2J\u202e\ud800"  # a terminal does it, and no file can have it
SEEN = re.compile(r"[\0-\x09\x0b-\x1f\u202e\ud800]")
VALUES += (UNSEEN, {UNSEEN: UNSEEN}, json.loads("[" * 700 + "]" * 700))


def changed(document):
    """The document, each with another value in one of its places."""
    if isinstance(document, dict):
        places: list = [*document]
    else:
        places = [*range(len(document))] if isinstance(document, list) else []
    for place in places:
        for value in VALUES:
            yield (other := copy.copy(document)).__setitem__(place, value) or other
        for part in changed(document[place]):
            yield (other := copy.copy(document)).__setitem__(place, part) or other
        if isinstance(document, dict):
            yield {name: one for name, one in document.items() if name != place}


def documents(results):
    """(name, reader, text of a document) of a changed one."""
    whole = json.loads((results / "fig2/claims.json").read_text())
    for one in changed(whole | {"claims": whole["claims"][:1], "builds": [["a", 1]]}):
        yield "claims.json", lambda folder: read_results(folder / "claims.json"), json.dumps(one)
    for one in changed([OWN]):
        yield "own.json", results_in, json.dumps(one)
    for job in read_jobs(results / "fig2"):
        for one in changed(job):
            yield "jobs.jsonl", read_jobs, json.dumps(one) + "\n"


def test_other_types_and_values_are_refused_or_shown_as_text(copied, monkeypatch):
    monkeypatch.setattr(page, "glance_picture", lambda *_: None)
    monkeypatch.setattr(page, "with_results", lambda _: ["fig2"])
    shown = 0
    for name, reader, text in documents(copied.results):
        path = copied.results / "fig2" / name
        before = path.read_text() if path.exists() else "[]"
        path.write_text(text)
        with suppress(Failure):
            reader(path.parent)
            seal(copied.results, path)
            html = page.render(page.contents(copied.root, ""))
            assert "<script" not in html and not re.search(r"(href|src)=.(\.\.|/)", html)
            assert not SEEN.search(html)
            shown += 1
        path.write_text(before)
    assert shown > 20


@pytest.mark.parametrize("name", [b"\xff", b"\x1b[2J", "\u202e".encode()])
def test_a_name_that_nobody_could_have_given_is_none_of_ours(copied, name):
    planted = Path(copied.results, "sweeps", os.fsdecode(name), "z.ini")
    spill(planted, SECRET)
    seal(copied.results, planted)
    assert copied.report().returncode == 0
    assert "sweeps" not in (copied.results / "ro-crate-metadata.json").read_text()


def test_texts_in_the_picture_of_all_claims_are_texts(copied):
    path = copied.results / "fig2/claims.json"
    content = json.loads(path.read_text())
    for claim in content["claims"]:
        claim["shares"] = [SHARE, SHARE | {"way": "$\\frac{"}]
    path.write_text(json.dumps(content))
    seal(copied.results, path)
    assert copied.report().returncode == 0
