"""What a command is known by, and that nothing runs which nobody needs."""

import shutil
import time
from concurrent.futures import ThreadPoolExecutor

import pytest

from conftest import BIN
from rupture.commands import code
from rupture.commands.code import digest_at, sections, stamp_of
from rupture.errors import Failure, NoSuchName, UsageError
from rupture import once
from rupture.once import asked, each, measured, run

pytest_plugins = "laboratory"

RECIPE = """from rupture.once import run
def it():
    end = run("load table.csv -o end.h5")["end.h5"]
    return run(f"analyze phi {end}").read
"""
RAISES = """from rupture.errors import *
CALLS = []
def it(kind):
    CALLS.append(1)
    raise globals()[kind]("so it is")
"""
NUMBERS = """from helpers import HALF
def size(path):
    return len(open(path).read()) * HALF
"""


def test_a_command_is_done_once(lab):
    first = run("analyze stress")
    assert run("analyze  stress") == run("rupture analyze stress") == first
    lab.call()
    assert run("analyze stress") == first and first.said == "analyze stress"
    assert lab.ran() == ["analyze stress"]


@pytest.mark.parametrize("word", ["{}", "--profile {}", "--profile={}"])
def test_a_users_file_counts_by_its_bytes_wherever_it_is(lab, word):
    command = f"analyze phi {word.format(lab.write('table.csv', 'a'))}"
    assert run(command).read == "<a>"
    lab.write("table.csv", "b")
    assert run(command).read == "<b>"
    lab.write("table.csv", "a")
    lab.write("elsewhere/table.csv", "a")
    elsewhere = f"analyze phi {word.format(lab.folder / 'elsewhere/table.csv')}"
    assert run(command) == run(elsewhere)
    assert lab.ran() == [f"analyze phi {word.format('table.csv')}"] * 2


def test_a_folder_may_be_moved(lab):
    lab.write("project/table.csv", "a")
    for name in ("project", "moved"):
        once.use(store=lab.folder / name / "store")
        recipe = lab.module(f"{name}/recipe", RECIPE)
        assert recipe.it() == "<load table.csv -o end.h5<a>>"
        once.finish()
        shutil.move(lab.folder / name, lab.folder / "moved")
    assert len(lab.ran()) == 2


def test_a_changed_program_counts_its_version_does_not(lab):
    run("analyze stress")
    with open(lab.folder / "bin/analyze", "a") as file:
        file.write("# changed\n")
    run("analyze stress")
    assert len(lab.ran()) == 2
    text = (BIN / "analyze").read_bytes()
    parts, path = dict(sections(text)), lab.folder / "program"

    def digest_without_first_byte_of(name):
        path.write_bytes(text.replace(parts[name], b"?" + parts[name][1:]))
        return digest_at(str(path), stamp_of(path))

    same = digest_at(str(BIN / "analyze"), stamp_of(BIN / "analyze"))
    assert digest_without_first_byte_of(b".rupture_version") == same
    assert digest_without_first_byte_of(b".text") != same
    path.write_bytes(text[:70])
    assert digest_at(str(path), stamp_of(path)) != same, "it is no whole program"
    with pytest.raises(Failure, match="cannot read /proc/self/mem: Input/output error"):
        digest_at("/proc/self/mem", None)


def test_the_words_that_are_typed_are_those_that_run(lab):
    start = run("load -o end.h5")["end.h5"]
    other = run("load --seed 2 -o end.h5")["end.h5"]
    after = run(f"restart {start} --with={other} -o end.h5 --set 'a=0.5 from 1mm to 2mm'")["end.h5"]
    assert (
        "<restart end-2.h5 --with=end-3.h5 -o end.h5 --set a=0.5 from 1mm"
        in run(f"analyze phi {after}").read
    )
    assert lab.ran()[2:] == [
        "restart end-2.h5 --with=end-3.h5 -o end.h5 --set a=0.5 from 1mm to 2mm",
        "analyze phi end.h5",
    ]


def test_nothing_runs_for_names(lab):
    run(f"restart {run('load -o a.h5')['a.h5']} -o b.h5")["b-t0.200000000.h5"]
    assert lab.ran() == []


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: run("load -o end.h5 --record record.h5")["records.h5"],
        lambda: run("load -o end.h5", keep=["ends.h5"]),
        lambda: run("analyze stress", keep=["end.h5"]),
    ],
)
def test_a_misspelled_name_is_an_error_at_once(lab, wrong):
    with pytest.raises(NoSuchName, match="writes .*, not"):
        wrong()


@pytest.mark.parametrize(
    "line",
    [
        "",
        "rupture",
        "load -o ../end.h5",
        "load --output=/tmp/a.h5",
        "lod -o a.h5",
        "load @0123456789abcdef/a.h5 -o b.h5",
    ],
)
def test_what_cannot_be_a_command_is_refused_at_once(lab, line):
    with pytest.raises(UsageError):
        run(line)
    assert lab.ran() == []


def test_an_input_that_changes_meanwhile_is_no_input(lab):
    table = lab.write("table.csv", "a")
    made = run(f"load {table} -o a.h5")["a.h5"]
    lab.write("table.csv", "b")
    with pytest.raises(Failure, match="has changed meanwhile"):
        open(made)
    assert lab.ran() == []


@pytest.mark.parametrize("name", ["recipe.py", "bin/load"])
def test_a_program_or_module_that_changes_meanwhile_is_not_used(lab, monkeypatch, name):
    recipe = lab.module("recipe", "def it(path): return path.read_text()")
    monkeypatch.setattr(code, "BEGAN", time.time() + 0.05)
    made = run("load -o a.h5")["a.h5"]
    time.sleep(0.1)
    with open(lab.folder / name, "a") as file:
        file.write("# changed\n")
    with pytest.raises(Failure, match=f"{name} has changed meanwhile"):
        measured(recipe.it, made)
    assert lab.ran() == []


def test_any_program_can_be_run(lab):
    made = run(f"cp {lab.write('a', 'text')} b")["b"]
    assert open(made).read() == "text"
    with pytest.raises(Failure, match="'cp a b' has not written c"):
        open(run(f"cp {lab.folder}/a b")["c"])
    with pytest.raises(Failure, match="'env nothing b' ended with 127: .*env: .nothing.: No such"):
        open(run("env nothing b")["b"])


# --- measurements in Python


def measure(lab, size=NUMBERS, helpers="HALF = 0.5\n", keep=()):
    lab.call()
    lab.module("helpers", helpers)
    module = lab.module("sizes", size)
    return measured(module.size, run("load -o a.h5", keep=keep)["a.h5"])


def test_a_measurement_is_known_by_its_code_and_what_it_imports(lab):
    first = measure(lab)
    assert first == len("load -o a.h5") / 2
    assert measure(lab, "'''A docstring.'''\n# a comment\n" + NUMBERS) == first
    assert lab.ran() == ["load -o a.h5"]
    assert measure(lab, helpers="HALF = 0.25\n") == first / 2  # what it needs is made again
    assert measure(lab, NUMBERS + "OTHER = 1\n") == first
    assert lab.ran() == ["load -o a.h5"] * 2


@pytest.mark.parametrize(
    "level, name",
    [
        (0, "{folder}/elsewhere/evil"),
        (2, "{folder.name}.elsewhere.evil"),
        (1, "../{folder.name}/elsewhere/evil"),
        (0, "elsewhere/evil"),
        (0, "n" * 300),
    ],
)
def test_what_a_module_cannot_import_is_not_read(lab, capfd, level, name):
    first = measure(lab)
    lab.write("elsewhere/evil.py", "def (:")
    store, source = lab.call().store, (lab.folder / "sizes.py").read_bytes()
    planted = {"code": "c", "imports": [[level, name.format(folder=lab.folder)]]}
    store.save(code.digest("code", source), planted)
    assert measure(lab) == first
    assert "it is done again" in capfd.readouterr().err
    assert lab.ran() == ["load -o a.h5"], "its code is known again"


def test_a_relative_import_counts(lab):
    lab.write("package/helpers.py", "HALF = 0.5\n")
    lab.write("package/inside/own.py", "from ..helpers import HALF\nfrom . import other\n")
    lab.write("package/inside/other.py", "")
    store, own = lab.call().store, lab.folder / "package/inside/own.py"
    for _ in range(2):  # it is known then
        names = {path.name for path in code.modules_behind([own.resolve()], store)}
        assert names == {"own.py", "helpers.py", "other.py"}


def test_a_changed_program_measures_again(lab):
    measure(lab, keep=["a.h5"])
    with open(lab.folder / "bin/analyze", "a") as file:
        file.write("# changed\n")
    count = lab.module(
        "counting", "CALLS = []\ndef size(path):\n    CALLS.append(1)\n    return 1\n"
    )
    measured(count.size, lab.write("a", ""))
    lab.call()
    with open(lab.folder / "bin/analyze", "a") as file:
        file.write("# changed\n")
    measured(count.size, lab.folder / "a")
    assert len(count.CALLS) == 2


def test_a_measurement_takes_numbers_texts_and_users_files(lab):
    own = lab.module(
        "own", "def listed(path, *rest):\n    return [path.name, path.read_text(), *rest]\n"
    )
    table = lab.write("table.csv", "a")
    assert measured(own.listed, table, 1, "word", [0.1]) == ["table.csv", "a", 1, "word", [0.1]]
    assert measured(own.listed, str(table), 2) == ["table.csv", "a", 2]
    lab.write("table.csv", "b")
    assert measured(own.listed, table, 2) == ["table.csv", "b", 2]


def test_a_measurement_may_refuse_but_the_machines_failure_is_no_result(lab):
    own = lab.module("own", RAISES)
    for kind, count in (("Failure", 1), ("MachineFailure", 3)):
        for _ in range(2):
            with pytest.raises(Failure, match="so it is"):
                measured(own.it, kind)
        assert len(own.CALLS) == count


def test_a_function_without_a_name_cannot_be_known(lab):
    with pytest.raises(UsageError, match="lambda"):
        measured(lambda: 1)


def test_what_was_asked_for_is_known_in_order(lab):
    with asked() as log:
        run("load -o unused.h5")
        front = run(f"analyze front {run('load -o a.h5')['a.h5']}")
        each(lambda n: run(f"analyze slip --sleep {0.2 - 0.1 * n} --x {n}"), range(2))
        open(run("prepare -o b.h5")["b.h5"])
        run("analyze stress")
        run(f"analyze front {run('load -o a.h5')['a.h5']}")
    run("analyze phi")
    points = ["analyze slip --sleep 0.2 --x 0", "analyze slip --sleep 0.1 --x 1"]
    wanted = ["analyze front a.h5", *points, "prepare -o b.h5", "analyze stress"]
    assert [work.line for work in log] == wanted
    assert front.said == "analyze front a.h5"


def test_threads_may_save_one_result_at_a_time(lab):
    """As of a module that several points measure with."""
    store = once.use(store=lab.folder / "store", dry_run=False).store
    with ThreadPoolExecutor(8) as pool:
        assert all(pool.map(lambda _: store.save("ab01", {"code": "c", "imports": []}), range(800)))
