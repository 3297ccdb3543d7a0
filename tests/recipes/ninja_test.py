"""Recipes of chains, by Ninja: what is computed when something changes, fails, crashes or is
interrupted; and that commands typed by hand give the same files (recipes/chains)."""

import json
import os
import re
import shutil
import signal
import struct
import subprocess
from unittest.mock import Mock, patch

import pytest

from chains import digests, progress
from chains.selection import Chains
from conftest import BIN, ROOT, run
from reproduce.written import append_to
from stand_ins import WITHIN, Project, wait_for

FILES = {
    "figure.ini": "[figure]\nreads = measured\n",
    "runs.ini": "[chain]\nkeep = start.h5\n[commands]\nstart = prepare {values} -o start.h5\n"
    "[values]\ntau-bar = 0.1, 0.2\n",
    "measured.ini": "[chain]\npoints = runs\nbase = runs: start.h5\n[commands]\n"
    "stress = analyze stress {base}\n",
    "figure.py": '''"""A figure."""


def make(chains, results):
    """It shows a force."""
    for ending in ("png", "pdf"):
        forces = [p["stress"]["F_T"] for p in chains["measured"] if p.status == "done"]
        (results / f"tiny.{ending}").write_text(f"{forces} N")
    return []
''',
}
# Waits for long, or crashes, if there is a file that says so.
PREPARE = f"""[ ! -e ROOT/wait ] || {{ echo $$ >> ROOT/running; exec sleep 300; }}
[ ! -e ROOT/die ] || kill -9 $$
exec {BIN}/prepare "$@"
"""
RUNS, MEASURED, FIGURE = ["tiny/runs"] * 2, ["tiny/measured"] * 2, ["tiny"]


class Tiny(Project):
    """With a recipe of two chains: two runs, and what is measured of them."""

    def __init__(self, root):
        super().__init__(root)
        for name in ("load", "modify-phi", "restart", "analyze"):
            (self.bin / name).symlink_to(BIN / name)
        self.program("prepare", PREPARE.replace("ROOT", str(root)))
        for name, text in FILES.items():
            self.write(f"recipes/tiny/{name}", text)
        self.noted = 0

    def reproduce(self):
        return self.call("tiny", "--programs", "bin", "--cores", "2")

    def jobs(self):
        """Rules of the jobs that were noted since this was asked for."""
        path = self.root / "results/jobs.jsonl"
        lines = path.read_text().splitlines() if path.exists() else []
        new, self.noted = lines[self.noted :], len(lines)
        return sorted(json.loads(line)["rule"] for line in new)

    def computed(self):
        """By a call that succeeds. It says so if that is nothing."""
        done = self.reproduce()
        assert done.returncode == 0, done.stderr + done.stdout
        steps = re.findall(r"^\[.*\] \d+/\d+ (.*)", done.stdout, re.MULTILINE)
        assert ("Nothing to compute" in done.stdout) == (not steps), done.stdout
        return self.jobs()

    def replace(self, name, old, new):
        path = self.root / "recipes/tiny" / name
        assert old in path.read_text()
        path.write_text(path.read_text().replace(old, new))

    def stored(self, ending):
        return sorted((self.root / "results/data/points").glob(f"*{ending}"))


@pytest.fixture(name="tiny")
def tiny_project(tmp_path):
    return Tiny(tmp_path)


def test_what_is_stale_is_computed_and_nothing_else(tiny):
    assert tiny.computed() == sorted(RUNS + MEASURED + FIGURE)
    assert tiny.computed() == []
    picture = (tiny.root / "results/tiny/tiny.png").read_text()

    tiny.stored(".start.h5")[0].unlink()  # it comes out equal
    assert tiny.computed() == ["tiny/runs"]
    assert tiny.computed() == []
    assert (tiny.root / "results/tiny/tiny.png").read_text() == picture


@pytest.mark.parametrize(
    "name, old, new, computed",
    [
        ("measured.ini", "stress =", "; a sentence\nstress =", []),
        ("measured.ini", "{base}\n", "{base}\nphi = analyze phi {base}\n", MEASURED + FIGURE),
        ("runs.ini", "0.2", "0.2, 0.3", RUNS[:1] + MEASURED[:1] + FIGURE),
        ("runs.ini", "0.1, 0.2", "0.1", FIGURE),
        ("runs.ini", "[chain]", "[chain]\nmemory = 2 GB\nthreads = 2", []),
        ("figure.py", "A figure.", "Another figure.", []),
        ("figure.py", "    forces", "    # a comment\n        forces", []),
        ("figure.py", " N", " kN", FIGURE),
    ],
)
def test_a_change_computes_what_it_may_touch(tiny, name, old, new, computed):
    tiny.computed()
    tiny.replace(name, old, new)
    assert tiny.computed() == sorted(computed)
    assert tiny.computed() == []


def test_what_is_damaged_or_edited_is_computed_again(tiny):
    tiny.computed()
    for path, text in zip(tiny.stored(".json"), ("{", '{"status": "done"}')):
        good = path.read_text()
        path.write_text(text)
        assert len(set(tiny.computed()) - {"tiny"}) == 1
        assert path.read_text() == good
    (tiny.root / "results/tiny/claims.json").unlink()
    assert tiny.computed() == FIGURE


def test_other_programs_count_and_dates_and_the_folder_do_not(tiny, tmp_path_factory):
    tiny.computed()
    elsewhere = tmp_path_factory.mktemp("elsewhere") / "copy of it"
    shutil.copytree(tiny.root, elsewhere, copy_function=shutil.copyfile, symlinks=True)
    copy = Tiny.__new__(Tiny)
    copy.root, copy.bin, copy.environment = elsewhere, tiny.bin, tiny.environment
    copy.noted = tiny.noted
    (elsewhere / "reproduce.sh").chmod(0o755)
    done = copy.call("tiny", "--programs", str(tiny.bin))
    assert (done.returncode, done.stderr) == (0, "")
    assert set(copy.jobs()) <= {"tiny"}
    tiny.append("bin/prepare")
    assert tiny.computed() == RUNS


def test_what_starts_from_another_file_or_is_judged_otherwise_is_made_again(tiny):
    shutil.copytree(ROOT / "checkpoints", tiny.root / "checkpoints")
    base = tiny.root / "checkpoints/fast-only.h5"
    tiny.replace(
        "measured.ini", "points = runs\nbase = runs: start.h5", "base = ../../" + base.name
    )
    tiny.replace("measured.ini", base.name, f"checkpoints/{base.name}")
    assert tiny.computed() == ["tiny", "tiny/measured"]
    tiny.append("recipes/claims/claim.py")  # a comment
    assert tiny.computed() == []
    for name in ("claims/claim.py", "claims/claims.toml"):
        path = tiny.root / "recipes" / name
        path.write_text(path.read_text() + '\nX = "1"\n')
        assert tiny.computed() == FIGURE
    shutil.copyfile(base.with_name("second-slow.h5"), base)
    done = tiny.reproduce()
    assert "1 of 1 points failed: checkpoints/fast-only.h5 is not in" in done.stdout
    assert tiny.jobs() == ["tiny", "tiny/measured"]


def test_what_describes_the_results_is_written_again_when_that_may_differ(tiny):
    def written():
        tiny.computed()
        return (tiny.root / "results/ro-crate-metadata.json").stat().st_mtime_ns

    first = written()
    assert written() == first
    tiny.append("recipes/tiny/README.md")
    second = written()
    assert second > first
    (tiny.root / "results/tiny/claims.json").unlink()
    assert written() > second


def test_what_was_run_is_noted_for_the_report(tiny):
    tiny.computed()
    last = json.loads((tiny.root / "results/jobs.jsonl").read_text().splitlines()[-1])
    assert last["rule"] == "tiny" and "results/tiny/claims.json" in last["output"]
    assert "recipes/tiny/figure.py" in last["command"]
    crate = json.loads((tiny.root / "results/ro-crate-metadata.json").read_text())
    [run_of_tiny] = [each for each in crate["@graph"] if each["@id"] == "#run-tiny"]
    assert run_of_tiny["startTime"] <= run_of_tiny["endTime"]


def test_a_failed_point_is_a_result_and_its_sentence_is_said(tiny):
    tiny.replace("runs.ini", "0.1, 0.2", "0.1, 9")
    done = tiny.reproduce()
    assert done.returncode == 0, done.stderr
    assert re.search("measured: 1 of 2 points failed: prepare: .*tau", done.stdout)
    assert tiny.jobs() == sorted(RUNS + MEASURED + FIGURE)
    assert tiny.computed() == []
    statuses = [json.loads(path.read_text())["status"] for path in tiny.stored(".json")]
    assert sorted(statuses) == ["done", "done", "failed", "failed"]


def test_a_crash_is_said_and_the_same_command_goes_on(tiny):
    tiny.write("die")
    done = tiny.reproduce()
    assert done.returncode == 1
    assert "Failed: tiny/runs: tau-bar 0.1\n  to make: results/data/points/" in done.stderr
    assert "'prepare --tau-bar 0.1 -o start.h5' ended with -9" in done.stderr
    assert done.stderr.endswith("say why (log: build/log/recipes.log)\n")
    (tiny.root / "die").unlink()
    assert tiny.computed() == sorted(RUNS + MEASURED + FIGURE)


def is_running(number):
    try:
        return " Z " not in open(f"/proc/{number}/stat", encoding="utf-8").read()
    except OSError:
        return False


@pytest.mark.parametrize("which, code", [(signal.SIGINT, 130), (signal.SIGKILL, -9)])
def test_an_interrupted_run_leaves_nothing_running_and_goes_on(tiny, which, code):
    tiny.write("wait")
    process = tiny.start("tiny", "--programs", "bin", "--cores", "2")
    wait_for(lambda: (tiny.root / "running").exists() and tiny_numbers(tiny)[1:])
    process.send_signal(which)
    assert process.wait(WITHIN) == code
    wait_for(lambda: not any(map(is_running, tiny_numbers(tiny))))
    (tiny.root / "wait").unlink()
    assert tiny.computed() == sorted(RUNS + MEASURED + FIGURE)


def tiny_numbers(tiny):
    return (tiny.root / "running").read_text().split()


def test_a_wrong_name_is_said_before_anything_runs(tiny):
    tiny.replace("measured.ini", "{base}\n", "{bas}\n")
    done = tiny.reproduce()
    assert (done.returncode, tiny.jobs()) == (2, [])
    sentence = (
        "recipes/tiny/measured.ini, line 5: 'bas': there is no 'bas'; there are start, stress"
    )
    assert sentence in done.stderr


LINKED = (
    "jobs.jsonl",
    *(f"data/{n}" for n in ("plan/.ninja_log", "points/x.todo", "digests/load", "spare/x")),
)


@pytest.mark.parametrize("name", LINKED)
def test_a_link_in_the_place_of_what_it_writes_is_refused(tiny, name):
    link = tiny.write(f"results/{name}")
    link.unlink()
    link.symlink_to(tiny.root / "theirs")
    done = tiny.reproduce()
    assert (done.returncode, done.stderr.count("\n")) == (1, 1)
    assert f"results/{name} is a link, which is not followed" in done.stderr
    with pytest.raises(OSError):
        append_to(link)
    assert not (tiny.root / "theirs").exists()


def test_clean_deletes_what_it_made_and_nothing_else(tiny):
    tiny.computed()
    own = tiny.write("results/data/points/mine.json", "{}")
    tiny.call("clean")
    left = [path for path in (tiny.root / "results").rglob("*") if path.is_file()]
    assert left == [own]


def test_the_crate_knows_the_jobs_and_checksums(tiny):
    tiny.computed()
    crate = json.loads((tiny.root / "results/ro-crate-metadata.json").read_text())
    by_id = {each["@id"]: each for each in crate["@graph"]}
    (start, other) = [path.name for path in tiny.stored(".start.h5")]
    assert {each["@id"] for each in by_id["#run-tiny"]["object"]} == {
        f"data/points/{name}" for name in (start, other)
    }
    (checksum,) = run("analyze", "checksum", tiny.stored(".start.h5")[0]).stdout.split()[:1]
    assert by_id[f"data/points/{start}"]["identifier"] == f"content-sha256:{checksum}"


def test_a_dry_run_prints_all_commands_and_writes_nothing(tiny):
    done = tiny.call("tiny", "--dry-run")
    assert done.returncode == 0, done.stderr
    start, stress, other, *_ = re.split("\n\n", done.stdout)
    assert start == "# tiny/runs: tau-bar 0.1\nrupture prepare --tau-bar 0.1 -o start.h5"
    assert other.startswith("# tiny/runs: tau-bar 0.2\nrupture prepare --tau-bar 0.2")
    assert re.fullmatch(
        "# tiny/measured: tau-bar 0.1\n# start.h5 is results/data/points/[0-9a-f]{16}.start.h5\n"
        "rupture analyze stress start.h5",
        stress,
    )
    assert not (tiny.root / "results").exists()


NINJA = """[1/4] a: x 1
[2/4] plan what follows from these
FAILED: results/1.json results/2.json
sh -c 'a'
first
{many}
last
[3/4] b
  1 of 2 points failed
ninja: error: no
ninja: build stopped: subcommand failed.
"""


def test_what_ninja_says_is_said_in_our_words(capsys, folder):
    lines = NINJA.format(many="\n".join(["more"] * 40)).splitlines()
    with patch("time.monotonic", Mock(side_effect=[0, 5, 12, 30])):
        assert progress.follow(iter(lines))
    said = capsys.readouterr()
    assert said.out.splitlines() == [
        "[   5 s] 1/4 a: x 1",
        "[  30 s, about 6 s left] 3/4 b",
        "    1 of 2 points failed",
    ]
    failed, making, *more, last, error = said.err.strip().splitlines()
    assert (failed, making) == (
        "Failed: plan what follows from these",
        "  to make: results/1.json",
    )
    assert set(more) == {"  more"} and len(more) == 29
    assert (last, error) == ("  last", "ninja: error: no")
    assert not progress.follow(iter(["ninja: no work to do."]))


# --- by hand -----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["figS3/profiles", "figS1/forces", "estimate/estimate"])
def test_commands_typed_by_hand_give_the_same_files(folder, name):
    chains = Chains()
    point = chains.points(chains.load(ROOT / f"recipes/{name}.ini"))[-1]
    path = {"PATH": f"{BIN}:{os.environ['PATH']}"}
    by_hand = folder / "by-hand"
    by_hand.mkdir()
    for place in (folder, by_hand):
        shutil.copytree(ROOT / "checkpoints", place / "checkpoints")
    typed = "\n".join(point.commands.values())
    subprocess.run(["bash", "-ec", typed], cwd=by_hand, env=os.environ | path, check=True)

    (folder / "results/data/digests").mkdir(parents=True)
    (folder / "results/data/points").mkdir()
    work = {"chain": name, "described": "", "works": [point.work | {"path": str(point.path)}]}
    (folder / point.path.with_suffix(".todo")).write_text(json.dumps(work))
    paths = f"{ROOT}/recipes:{ROOT}/python"
    todo = point.path.with_suffix(".todo")
    command = ["python3", "-S", "-P", "-m", "chains.point", str(todo)]
    subprocess.run(command, env=os.environ | {"PYTHONPATH": paths}, check=True)
    checksums = json.loads(point.path.read_text())["checksums"]
    assert len(checksums) == len(list(by_hand.glob("*.h5")))
    for file, checksum in checksums.items():
        assert run("analyze", "checksum", by_hand / file).stdout.split()[0] == checksum


# --- programs as digests -----------------------------------------------------------------------


def changed(content, section, folder):
    """The digest of a program one of whose sections has another byte in its middle."""
    (start,) = struct.unpack_from("<Q", content, 40)
    size, count, of_names = struct.unpack_from("<3H", content, 58)
    headers = [struct.unpack_from("<2I4Q", content, start + n * size) for n in range(count)]
    names = content[headers[of_names][4] :]
    [(place, length)] = [h[4:6] for h in headers if names[h[0] :].startswith(section + b"\0")]
    at = place + length // 2
    path = folder / section.decode()
    path.write_bytes(content[:at] + bytes([content[at] ^ 1]) + content[at + 1 :])
    return digests.digest_of_program(path)


def test_a_program_is_what_it_computes_with_and_not_its_version(tmp_path):
    content = (BIN / "restart").read_bytes()
    known = digests.digest_of_program(BIN / "restart")
    assert changed(content, b".rupture_version", tmp_path) == known
    assert changed(content, b".note.gnu.build-id", tmp_path) == known
    for section in (b".text", b".rodata", b".data"):
        assert changed(content, section, tmp_path) != known
    assert digests.digest_of_program(BIN / "analyze") != known


def test_a_script_is_its_code_and_that_of_what_it_imports(tmp_path):
    def known(text):
        path = tmp_path / "script.py"
        path.write_text(text)
        return digests.digest_of_scripts(path)

    (tmp_path / "beside.py").write_text("A = 1\n")
    first = known("import beside\nB = 2\n")
    assert known('"""What it does."""\nimport beside\n\nB = 2  # [m]\n') != known("B = 2\n")
    assert known("import beside\nB = 3\n") != first
    (tmp_path / "beside.py").write_text("A = 1  # a comment\n")
    assert known("import beside\nB = 2  # another\n") == first
    (tmp_path / "beside.py").write_text("A = 2\n")
    assert known("import beside\nB = 2\n") != first
