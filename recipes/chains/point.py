"""Computes a point, or several of a chain, one after the other:

    python -m chains.point results/data/points/ID.todo

The file, which Ninja writes and deletes, has the work of each point: commands, names in their
holes, files to keep, the base. The commands run in a folder of their own, which is deleted at the
end. Then the files that stay get their names, the result last; whatever is equal to what is there
keeps its date, so that nothing after it is stale. A program's refusal is a result; if a program
crashes, there is none."""

import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from chains.store import digest_file, is_current, make_spare, origin_of, read, result_of
from chains.store import save_origin, tools_of, write_if_changed
from rupture.commands.code import WRITERS
from rupture.programs import output_of
from rupture.replacing import write_whole
from report.written import append_to

HOLE = re.compile(r"\{([^{}]*)\}")
OUTPUTS = ("-o", "--output", "--record")  # options with which a program writes files
JOBS = Path("results/jobs.jsonl")
USER_ERRORS = (1, 2)  # exit codes with which a tool says that the request cannot be met
INTERRUPTIONS = (signal.SIGINT, signal.SIGTERM)
UNFINISHED = "unfinished"
PROGRAMS = ("analyze", *WRITERS)
# What nobody types: how a command says what it found.
SAID = {"analyze": ["--json"], **dict.fromkeys(WRITERS, ["--quiet"])}


# --- one command -------------------------------------------------------------------------------


def run(folder_of_tools, words, folder, files):
    """The finished command. `files`: {name in the command: file elsewhere}."""
    tool, *others = words
    arguments = [os.path.abspath(files[word]) if word in files else word for word in others]
    command = [Path(folder_of_tools, tool).resolve(), *arguments]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if -done.returncode in INTERRUPTIONS:
        sys.exit(128 - done.returncode)  # the signal was for all that runs
    return done


def fault(command, done):
    """The status of a point whose command ended so: the tool says why, or it crashed. Paths are
    those of this folder."""
    said = done.stderr.strip().replace(f"{os.getcwd()}/", "")
    if done.returncode in USER_ERRORS:
        return {"status": "failed", "sentence": said.splitlines()[-1] if said else command}
    sentence = f"'{command}' ended with {done.returncode}{': ' if said else ''}{said}"
    return {"status": UNFINISHED, "sentence": sentence}


# --- what names in it mean ---------------------------------------------------------------------


def without_time(word):
    """a.h5 of its checkpoint a-t0.200000000.h5."""
    return re.sub(r"-t[\d.]+(?=\.h5$)", "", word)


class Names:
    """What names in holes mean: those of `work`, and what commands have reported."""

    def __init__(self, names, reports):
        self.names, self.reports = names, reports

    def __call__(self, name):
        if name in self.reports:
            return self.reports[name]
        source = self.names[name]
        if isinstance(source, list):
            return source[0]
        if source.startswith("{"):
            return self.value(source[1:-1])
        return result_of(source)["reports"].get(name)

    def value(self, text):
        from chains.expressions import Expression  # few points need it

        return Expression(text, [*self.names, *self.reports]).value(self)

    def filled(self, line):
        """The command as it is typed; None if a value is null."""
        if not (holes := HOLE.findall(line)):
            return line
        from chains.expressions import as_text

        values = {hole: self.value(hole) for hole in holes}
        if None in values.values():
            return None
        return HOLE.sub(lambda hole: shlex.quote(as_text(values[hole[1]])), line)


# --- a point -----------------------------------------------------------------------------------


def compute(work, folder):
    """The result. What needs a null, or a file of a command that was left out, is left out."""
    reports: dict = {}
    result: dict = {"commands": {}, "status": "done", "sentence": "", "reports": reports}
    names, base = Names(work["names"], reports), work["base"]
    is_missing = base and os.path.isfile(base["file"]) and not os.path.getsize(base["file"])
    missing = {base["shown"]} if is_missing else set()  # files that no command has written
    if base and base["of"] and (sentence := result_of(base["of"])["sentence"]):
        return result | {"status": "failed", "sentence": sentence, "checksums": {}}
    for name, line in work["commands"].items():
        try:
            command = names.filled(line)
        except ValueError as error:
            result |= {"status": "failed", "sentence": f"{name}: {error}"}
            break
        words = shlex.split(command or HOLE.sub("", line))
        if command is None or missing.intersection([*words, *map(without_time, words)]):
            missing.update(after for word, after in zip(words, words[1:]) if word in OUTPUTS)
            reports[name] = None
            continue
        result["commands"][name] = command
        for word in SAID.get(words[0], ()):
            words += [word] if word not in words else []
        files = {base["shown"]: base["file"]} if base else {}
        done = run(os.environ["RUPTURE_BIN"], words, folder, files)
        if done.returncode:
            result |= fault(command, done)
            break
        if "--json" in words:
            said = [json.loads(line) for line in done.stdout.splitlines()]
            reports[name] = said if "--also" in words else said[0]
    absent = [file for file in work["keep"] if not Path(folder, file).exists()]
    absent = [file for file in absent if without_time(file) not in missing]
    if absent and result["status"] == "done":
        result |= {"status": "failed", "sentence": f"no command has written {absent[0]}"}
    written = sorted(Path(folder).glob("*.h5"))
    sums = {file.name: output_of("analyze", "checksum", file).strip() for file in written}
    return result | {"checksums": sums}


def keep(path, result, names, folder):
    """Files that the point does not have are empty, so that none is missing."""
    text = json.dumps(result) + "\n"
    kept = [path.with_suffix(f".{name}") for name in names]
    if path.exists() and path.read_text(encoding="utf-8") == text and all(map(Path.exists, kept)):
        return
    for name, file in zip(names, kept):
        made, part = Path(folder, name), file.with_name(f"{file.name}.part")
        shutil.move(made, part) if made.exists() else part.write_bytes(b"")
        os.replace(part, file)
    write_if_changed(path, text)


def note(outputs, described, rule, command, inputs, started):
    """What was done, for the report (report/origin.py)."""
    job = {"description": described, "rule": rule, "started": started, "command": command}
    job |= {"input": list(map(str, inputs)), "output": list(map(str, outputs))}
    with append_to(JOBS) as file:
        file.write(json.dumps(job | {"seconds": time.time() - started}) + "\n")


def finish(work, about):
    """Computes a point unless its result is there. Returns a sentence if a program crashed."""
    started, path, base = time.time(), Path(work.pop("path")), work["base"]
    tools = tools_of(work["commands"].values())
    origin = origin_of(work, [read(digest_file(tool)) for tool in tools])
    crash = path.with_suffix(".crash")
    kept = [path.with_suffix(f".{name}") for name in work["keep"]]
    if is_current(path, origin) and all(map(Path.exists, kept)):
        return ""
    with tempfile.TemporaryDirectory(prefix="rupture-point-") as folder:
        result = compute(work, folder)
        if result["status"] == UNFINISHED:
            write_whole(crash, result["sentence"])
            return result["sentence"]
        crash.unlink(missing_ok=True)
        keep(path, result, work["keep"], folder)
    save_origin(path, origin)
    if len(about["works"]) > 1:
        make_spare(path, *kept)
    inputs = [file for file in (base["file"], base["of"]) if file] if base else []
    command = " && ".join(result["commands"].values())
    note([path, *kept], about["described"], about["chain"], command, inputs, started)
    return ""


def main(todo):
    for number in INTERRUPTIONS:  # so that the point's folder is deleted
        signal.signal(number, lambda which, _: sys.exit(128 + which))
    about, sentences = result_of(todo), []
    for work in about["works"]:
        try:
            sentences.append(finish(work, about))
        except OSError as error:  # of a full disk, for instance
            sentences.append(f"{error.filename or work['commands']}: {error.strerror}")
    if any(sentences):
        sys.exit("\n".join(filter(None, sentences)))


if __name__ == "__main__":
    main(*sys.argv[1:])
