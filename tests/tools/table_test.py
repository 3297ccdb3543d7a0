"""Runs the rows of tables/*.txt: a command, its exit code and what it says.

  == BEGINNING          a new table; commands that begin with .. begin so
  @ COMMAND             made before each row: a program that must succeed, file NAME "TEXT",
                        folder NAME, link NAME TARGET, copy FROM TO, move FROM TO, mode NAME
                        OCTAL, remove PATTERN, or change NAME as changes.py says; or what
                        holds: same A B (bytes), equal A B (checksums), summed NAME (by its
                        .sum), absent PATTERN, files NAME ... (all that there are), lacks NAME
                        PATH (a dataset or group)
  NAME [EXIT COMMAND]   a row: {a|b} stands for each of them, {1} for the first that was chosen,
                        sum(FILE) for its checksum, $SOURCE and $BIN for folders
      TEXT              the sentence on standard error, in which ... is any text. No file changed
      @ COMMAND         made then
      > EXIT COMMAND    then this, which says the TEXTs that follow

Of a command that exits with 0, or 1> (what differs is no failure), each TEXT is a line of
standard output, lines: N their number, or something about JSON, as in expect_json(); the first
is the head of CSV, whose lines have as many cells. Lines of the other stream are marked stdout:
or stderr:. Without --force or --resume no file changed, behind 0= none at all; with 1+ files
came although the command failed. In front of a command may stand [disk=BYTES], [stdout=FILE],
[memory=GIB] and [nobody]: not as root; [nobody=else]: and not as this user either. Before COMMAND
<- CHANGE, x.h5 becomes good.h5 with this change, as changes.py says it. The command rebuilt FILE
demands that the commands of its lineage make it from nothing.
"""

import glob
import itertools
import json
import os
import re
import shutil
import tempfile
from collections import namedtuple
from pathlib import Path

import h5py
import pytest

from changes import change
from commands import SANITIZED, changed, checksum_of, expect_rebuilt, files
from commands import is_like, lines_of, name_of, run
from conftest import BIN, ROOT

Row = namedtuple("Row", "setup steps")
Step = namedtuple("Step", "exit command said")
CHOICE = re.compile(r"\{([^{}]*\|[^{}]*)\}")


def rows():
    """Yields the rows of all tables. A line that ends in a backslash goes on in the next."""
    for path in sorted((ROOT / "tests/tools/tables").glob("*.txt")):

        def step(line):
            exit_code, _, command = line.partition(" ")
            if found := re.match(r"(\[\S+\] )?\.\.", command):
                command = (found[1] or "") + beginning + command[found.end() :]
            return Step(exit_code, command, [])

        beginning = ""
        setup: tuple = ()
        steps: list = []
        for line in re.sub(r"\\\n *", "", path.read_text()).split("\n"):
            if line.startswith("=="):
                beginning, setup = line[3:], ()
            elif line.startswith("@ "):
                setup = (*setup, step(line).command)
            elif line.startswith(("    @ ", "    > ")):
                steps.append(step(line[4:].removeprefix("> ")))
            elif line.startswith("    "):
                steps[-1].said.append(line[4:])
            elif line and line[0] != "#":
                name, *command = line.split(" ", 1)
                steps = [step(words) for words in command]
                yield pytest.param(Row(setup, steps), id=f"/{path.stem}/{name}")


def choices_in(text):
    """Every choice among {a|b|...}, with the words that were chosen."""
    parts = CHOICE.split(text)
    for words in itertools.product(*(part.split("|") for part in parts[1::2])):
        parts[1::2] = words
        yield "".join(parts), words


def filled(text, chosen):
    """{1}, {2}, ... become the words that were chosen, sum(FILE) its checksum."""
    text = text.replace("$SOURCE", str(ROOT)).replace("$BIN", str(BIN))
    for n, word in enumerate(chosen, 1):
        text = text.replace(f"{{{n}}}", word)
    return re.sub(r"sum\(([^)]*)\)", lambda file: checksum_of(file[1]), text)


def words_of(command):
    """Quotes hold spaces, or nothing; double ones are those of JSON."""
    found = re.finditer(r"""'([^']*)'|("(?:[^"\\]|\\.)*")|[^ ]+""", command)
    return [json.loads(at[2]) if at[2] else at[0] if at[1] is None else at[1] for at in found]


# --- what stands behind an @


def remove(pattern):
    """Files whose names match, as a shell takes it."""
    names = glob.glob(pattern)
    assert names, pattern
    for name in names:
        os.remove(name)


def same(one, other):
    assert Path(one).read_bytes() == Path(other).read_bytes()


def equal(one, other):
    assert checksum_of(one) == checksum_of(other)


def absent(pattern):
    assert not glob.glob(pattern)


def all_files(*names):
    assert sorted(files()) == sorted(names)


def lacks(name, path):
    with h5py.File(name) as file:
        assert path not in file


VERBS: dict = {
    "file": lambda name, text: Path(name).write_text(text),
    "folder": lambda name: Path(name).mkdir(parents=True, exist_ok=True),
    "link": lambda name, target: os.symlink(target, name),
    "copy": shutil.copyfile,
    "move": os.rename,
    "mode": lambda name, octal: os.chmod(name, int(octal, 8)),
    "files": all_files,
} | {verb.__name__: verb for verb in (remove, same, equal, absent, lacks)}


def make(line):
    verb, *words = words_of(line)
    if verb == "change":
        change(*line.split(" ", 2)[1:])
    elif verb in VERBS:
        VERBS[verb](*words)
    else:
        done = run([verb, *words])
        assert done.code == 0, (line, done.err)


# --- what a command says


def at_path(document, path):
    """What a JSON pointer names; /# behind it for its size."""
    for key in path.removesuffix("/#").split("/")[1:]:
        document = document[int(key) if isinstance(document, list) else key] if key else document
    return len(document) if path.endswith("/#") else document


def expect_json(document, line, first):
    """One line about JSON: PATH = JSON, PATH ~ NUMBER or LIST +- NUMBER, PATH < NUMBER, PATH >
    NUMBER, or PATH same, in all that the row runs."""
    path, relation, value = (line.split(" ", 2) + [""])[:3]
    found = at_path(document, path)
    if relation == "=":
        wanted = json.loads(value)
        assert (found, type(found) is bool) == (wanted, type(wanted) is bool), line
    elif relation == "~":
        wanted, tolerance = (json.loads(text) for text in value.split("+-"))
        assert found == pytest.approx(wanted, rel=0, abs=tolerance), line
    elif relation == "same":
        assert found == first.setdefault(line, found), line
    else:
        assert found < float(value) if relation == "<" else found > float(value), (line, found)
        assert relation in "<>"


def expect_output(out, said, step, first):
    lines = lines_of(out)
    rest = iter(lines)
    if said and " --csv" in step.command:
        assert is_like(lines[0], said[0])
        assert {line.count(",") for line in lines} == {lines[0].count(",")}
    for line in said:
        if line.startswith("/") and out.startswith("{"):
            expect_json(json.loads(out), line, first)
        elif line.startswith("lines: "):
            assert len(lines) == int(line[7:]), (step.command, out)
        else:
            assert any(is_like(text, line) for text in rest), (step.command, out, line)


def expect_texts(done, step, tool, chosen, first):
    is_done = step.exit[0] == "0" or step.exit.endswith(">")
    sentence = [] if is_done else [f"{name_of(tool)}:"]
    said: dict = {"stdout: ": [], "stderr: ": []}
    for line in (filled(text, chosen) for text in step.said):
        if line[:8] in said:
            said[line[:8]].append(line[8:])
        elif is_done:
            said["stdout: "].append(line)
        else:
            sentence.append(line)
    err = "".join(line + "\n" for line in [*said["stderr: "], " ".join(sentence)] if line)
    assert is_like(done.err, err), (step.command, done.err)
    assert step.exit != "2" or not done.out, step.command
    expect_output(
        done.out, [text for line in said["stdout: "] for text, _ in choices_in(line)], step, first
    )


def expect_kept(before, exit_code, words):
    """Which files may have changed depends on the exit code and the options."""
    may_write, after = exit_code[-1] in "0>+", files()
    if may_write and {"-f", "--force", "--resume"} & set(words):
        return
    assert not [name for name in changed(before, after) if not may_write or name in before]


def options_in(command):
    """[disk=BYTES], [stdout=FILE], [memory=GIB] or [nobody] in front of a command."""
    found = re.match(r"\[(\w+)=?([^\]]*)\] ", command)
    if not found:
        return command, {}
    name, value = found.groups()
    kinds: dict = {"disk": int, "stdout": str, "nobody": str, "memory": lambda n: int(n) << 30}
    return command[found.end() :], {name: kinds[name](value or "yes")}


def spoil(line):
    path = Path("x.h5")
    if path.is_dir():
        path.rmdir()
    path.unlink(missing_ok=True)
    shutil.copyfile("good.h5", path)
    change(path, line)


def expect_command(step, command, chosen, first):
    if command.startswith("rebuilt "):
        return expect_rebuilt(command[8:])
    command, options = options_in(command)
    if "memory" in options and SANITIZED:
        pytest.skip("AddressSanitizer needs more memory")
    if options.get("nobody") == "else" and os.geteuid():
        pytest.skip("only root can be two users")
    command, _, made = command.partition(" <- ")
    if made:
        spoil(made)
    words, before = words_of(command), files()
    done = run(words, **options)
    assert done.code == int(step.exit.rstrip("=>+")), (command, done.err)
    expect_texts(done, step, words[0], chosen, first)
    return expect_kept(before, step.exit, words)


SAVED = tempfile.TemporaryDirectory()
FOLDERS: dict = {}  # copies in it of folders as they were left, by the commands that were run there


def copy_folder(source, to):
    assert run(["/bin/cp", "-a", f"{source}/.", to]).code == 0


def set_up(commands):
    """The folder after these commands, each of which is run once for all rows."""
    if commands in FOLDERS:
        copy_folder(FOLDERS[commands], ".")
    elif commands:
        set_up(commands[:-1])
        for command, chosen in choices_in(commands[-1]):
            make(filled(command, chosen))
        if not any(command.startswith("mode") for command in commands):  # not all can be read then
            FOLDERS[commands] = f"{SAVED.name}/{len(FOLDERS)}"
            copy_folder(".", FOLDERS[commands])


@pytest.mark.parametrize("row", rows())
def test_row(small_ini, row):
    first: dict = {}  # what was found first for each line that ends in "same"
    set_up(row.setup)
    for front, chosen in choices_in(row.steps[0].command):
        for step in row.steps:
            text = front if step is row.steps[0] else step.command
            for command, more in choices_in(filled(text, chosen)):
                words = (*chosen, *more)
                if step.exit == "@":
                    make(filled(command, words))
                else:
                    expect_command(step, filled(command, words), words, first)
