"""./reproduce.sh itself: its command line, where it runs, and which tests it calls slow."""

import os
import re
import signal
import subprocess
from unittest.mock import Mock, patch

import pytest

import reproduce.project
from conftest import ROOT
from rupture import programs
from rupture.commands import machine
from rupture.errors import Failure
from report.written import MARKER
from reproduce.processes import Processes, open_lock, take_lock
from stand_ins import Project

REFUSED = [  # a command line, and the sentence
    ("sweep", "'sweep' needs one file, as in .*$"),
    ("sweep a.ini --from-scratch", "--from-scratch is for figures; .*$"),
    ("--dry-run all", "--dry-run is for figures and for sweep$"),
    ("fig3 --cores 0", "argument --cores: must be a whole number, 1 or more"),
    ("fig3 --from", "unrecognized arguments: --from"),
    (
        "fig3 --profile slurm",
        "unrecognized arguments: --profile( slurm)?; see ./reproduce.sh --help$",
    ),
    ("fig3 --programs /nope", "argument --programs: the programs are not in '/nope': there is no"),
    ("fig33", "there is no figure or command 'fig33': did you mean 'fig3'\\?$"),
    ("xyz", "there is no figure or command 'xyz': see ./reproduce.sh list$"),
    ("xyz fig33 test nope", "there is no figure or command 'xyz': see ./reproduce.sh list$"),
    ("test fig3", "'test' cannot be combined with other commands or figures$"),
]


@pytest.fixture(name="project")
def copied_project(tmp_path):
    return Project(tmp_path / "me/clone")


@pytest.fixture(name="unchanged", scope="module")
def project_in_which_nothing_is_written(tmp_path_factory):
    project = Project(tmp_path_factory.mktemp("unchanged"))
    project.program("load", "")
    return project


@pytest.mark.parametrize("words, sentence", REFUSED)
def test_wrong_calls_are_usage_errors_of_one_sentence(unchanged, words, sentence):
    done = unchanged.call(*words.split())
    assert (done.returncode, done.stdout) == (2, "")
    end = "" if sentence[-1] == "$" else ".*; see ./reproduce.sh --help\n$"
    assert re.match(f"reproduce.sh: {sentence}{end}", done.stderr)


def test_help_and_list_make_nothing(project):
    before = sorted(project.root.iterdir())
    done = project.call("fig3", "-h")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("usage: ./reproduce.sh COMMAND")
    assert project.call("help").stdout == done.stdout
    assert re.fullmatch(r"./reproduce.sh \(rupture .+\)\n", project.call("--version").stdout)
    done = project.call()
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("usage: ./reproduce.sh COMMAND")
    names = re.findall(r"^  (\S+) ", project.call("list").stdout, re.M)
    assert names[:3] == ["fig1", "fig2", "fig3"]
    project.call("nope")
    assert sorted(project.root.iterdir()) == before


def test_modules_and_programs_elsewhere_are_not_taken_for_ours(project):
    others = project.root / "../../lib/python3/dist-packages"
    for name in ("data", "queue", "sweeps", others / "argparse", others / "rupture/__init__"):
        project.write(f"{name}.py", "raise RuntimeError\n")
    assert project.call("list").returncode == 0
    project.program("../../../libexec/rupture/analyze", "")
    project.write("CMakeLists.txt")  # it is a clone, without a build
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(programs, "PACKAGE", project.root / "python/rupture")
        patched.delenv("RUPTURE_BIN")
        patched.setenv("PATH", "")
        with pytest.raises(Failure, match="program analyze not found: neither built"):
            programs.path_of("analyze")


def test_a_folder_without_links_has_results_within(folder, monkeypatch):
    monkeypatch.setattr("pathlib.Path.symlink_to", Mock(side_effect=PermissionError(1, "no")))
    monkeypatch.setattr(reproduce.project, "WORK", folder)
    monkeypatch.setattr(reproduce.project, "ROOT", folder / ".rupture")
    for _ in range(2):
        reproduce.project.enter_root()
        assert [one.name for one in (folder / ".rupture").iterdir()] == ["results"]


@pytest.mark.parametrize(
    "planted, link, sentence",
    [
        ("python/json.py", None, "cannot be written .File exists."),
        ("results", None, "cannot be written .File exists."),
        ("build", None, "build cannot be written .Not a directory."),
        ("results", ".rupture", ".rupture is a link"),
        ("results", ".rupture/build/log/recipes.log", ".rupture/build/log/recipes.log is a link"),
    ],
)
def test_a_prepared_folder_runs_nothing_and_keeps_its_files(project, planted, link, sentence):
    project.environment = os.environ | {"RUPTURE_WORK": f"{project.root}/work"}
    path = project.write(f"work/{'other' if link else '.rupture'}/{planted}")
    if link:
        (project.root / "work" / link).parent.mkdir(parents=True, exist_ok=True)
        (project.root / "work" / link).symlink_to(path.parent)
    for command in ("clean", "report"):
        done = project.call(command)
        assert (done.returncode, done.stdout, done.stderr.count("\n")) == (1, "", 1)
        assert re.search(sentence, done.stderr)
    assert path.exists()


def test_a_colon_would_make_two_folders_of_modules(tmp_path):
    done = Project(tmp_path / "x:y").call("list")
    assert (done.returncode, done.stdout) == (1, "") and "has a colon; rename it" in done.stderr


LIST, FIRST = f"results/{MARKER.name}", MARKER.layout


def ours(names):
    return "".join(f"-  {name}\n" for name in names.split())


CACHE = "\nCMAKE_PROJECT_NAME:STATIC=rupture\n"


def test_clean_deletes_what_was_written_here_and_names_the_rest(project):
    root = project.root
    for name in "disk/a results/a results/x/y results/mine mine build/other/o".split():
        project.write(name)
    project.write("results/you\x1b\udcff")
    project.write("build/release/CMakeCache.txt", CACHE)
    for name in ("results/empty", "build/empty"):
        (root / name).mkdir()
    (root / "results/disk").symlink_to("../disk")
    (root / "results/link").symlink_to("../mine")
    listed = "a x/y disk/a link ../mine /etc/hostname"
    project.write(LIST, f"{FIRST}{ours(listed)}-  \n-  .\nbut this was not writ")
    deleted, _, *left = project.call("clean").stdout.splitlines()
    assert deleted == "Deleted 2 files in results/, build/release/."
    kept = ["results/disk -> ../disk", "results/link -> ../mine", "results/mine"]
    assert left == [f"  {name}" for name in (*kept, "results/you??", "build/other/o")]
    for name in ("disk/a", "mine", *(one.split()[0] for one in kept)):
        assert (root / name).exists()
    assert not (root / "results/x").exists()
    assert (root / "results/empty").exists() and (root / "build/empty").exists()


def test_results_of_an_earlier_version_are_refused_and_go_with_clean(project):
    project.write("results/a")
    mine = project.write("results/mine")
    project.write("results/.rupture-files", "a\n../results/mine\n/etc/hostname\n")
    done = project.call("report")
    assert (done.returncode, done.stderr.count("\n")) == (1, 1)
    assert "results is of an earlier version: ./reproduce.sh clean deletes its files" in done.stderr
    assert project.call("clean").stdout.startswith("Deleted 1 file in results/.\n")
    assert [*(project.root / "results").iterdir()] == [mine]


def test_a_lock_that_was_deleted_is_not_taken(folder):
    first, second = open_lock(), open_lock()
    assert take_lock(first) and not take_lock(second)
    os.unlink("build/.lock")  # by `clean`, before its end
    os.close(first)
    assert not take_lock(second)
    assert take_lock(open_lock())


def test_the_second_signal_ends_a_program_that_is_starting(folder):
    def start(*_, **__):
        for number in (signal.SIGINT, signal.SIGTERM):
            processes.receive(number, None)
        return Mock(pid=7)

    with patch("signal.signal"):
        processes = Processes()
    with patch("os.killpg") as ended, patch("subprocess.Popen", start):
        with pytest.raises(SystemExit):
            processes.run(["x"])
    ended.assert_called_once_with(7, signal.SIGKILL)


def test_clean_follows_no_link(project):
    project.write("disk/a")
    project.write("disk/release/CMakeCache.txt", CACHE)
    project.write("disk/rupture-results", FIRST + ours("a"))
    for name in ("results", "build"):
        (project.root / name).symlink_to("disk")
    assert "Nothing was deleted.\n" in project.call("clean").stdout
    assert (project.root / "disk/a").exists()
    assert (project.root / "disk/release/CMakeCache.txt").exists()


@pytest.mark.parametrize(
    "to, reason", [("/dev/full", "No space left on device"), ("&-", "Bad file descriptor")]
)
def test_standard_output_that_takes_nothing_is_said(to, reason):
    command = ["bash", "-c", f"./reproduce.sh list >{to}"]
    done = subprocess.run(command, cwd=ROOT, stderr=subprocess.PIPE, text=True)
    assert (done.returncode, done.stderr) == (3, f"reproduce.sh: standard output: {reason}\n")


@pytest.mark.parametrize(
    "group, files, cores, megabytes",
    [
        ("0::/a/b", {"a/cpu.max": "5 10", "a/b/cpu.max": "max 1", "a/memory.max": "1048576"}, 1, 1),
        ("4:memory:/gone", {"memory/memory.limit_in_bytes": "2097152"}, 3, 2),
        ("1:cpu:/", {"cpu/cpu.cfs_quota_us": "200000", "cpu/cpu.cfs_period_us": "90000"}, 2, 4096),
    ],
)
def test_what_may_be_used_of_the_machine(folder, group, files, cores, megabytes):
    for name, text in ({"own": group} | files).items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    with patch.multiple(machine, OWN=folder / "own", ALL=folder):
        with patch("os.sched_getaffinity", lambda _: "045"), patch("os.sysconf", lambda _: 2**16):
            assert (machine.usable_cores(), machine.usable_megabytes()) == (cores, megabytes)
