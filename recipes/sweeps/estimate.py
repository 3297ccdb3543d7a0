"""What a sweep would need, by the programs' own --dry-run, and what they refuse."""

import json
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

from rupture.commands.code import path_of
from rupture.commands.processes import Local
from rupture.tools.command_line import plural
from sweeps.points import most_said
from sweeps.words import without_time

RUNS = ("load", "restart")  # they have --dry-run; other programs take no time
LONGEST = 30.0  # [s]


class Estimate:
    """Asks programs about the runs of points, in folders that are deleted again."""

    def __init__(self, sweep):
        self.sweep, self.begun = sweep, time.monotonic()
        self.executor = Local(sweep.megabytes, sweep.threads)
        self.runs = [one for one in sweep.commands if one.program != "analyze"]
        self.refused: Counter[str] = Counter()
        self.asked, self.at_most = 0, ""
        self.needs, self.unknown = [], set()

    def ask(self, points):
        """In an order in which the first ones, if there is no time for others, are of all kinds."""
        with ThreadPoolExecutor(self.executor.cores) as pool:
            list(pool.map(self.ask_about, Random(1).sample(points, len(points))))

    def ask_about(self, point):
        if time.monotonic() - self.begun > LONGEST:
            return
        self.asked += 1
        need: Counter[str] = Counter()
        before: set[str] = set()
        with TemporaryDirectory() as folder:
            for command in self.runs:
                words = self.sweep.words(command, point)
                files = (word for word in words if without_time(word) in before)
                if command.is_later or not all(Path(folder, file).exists() for file in files):
                    self.unknown.add(command.name)
                elif not self.ask_program(command.program, words, before, folder, need):
                    return
                before.update(command.outputs_of(words))
        self.needs.append(need)

    def ask_program(self, program, words, before, folder, need):
        """`need` grows by what it says. One without --dry-run runs."""
        words = [word if word in before else self.with_path(word) for word in words[1:]]
        words += ["--dry-run"] if program in RUNS else []
        words += [word for word in ("--json", "--quiet") if word not in words]
        code, output, sentence = self.executor.run([path_of(program), *words], folder)
        if code:
            self.refused["".join(sentence.splitlines()[-1:])] += 1
        elif program in RUNS:
            said = json.loads(output)
            need.update(time=said["time"], disk=said["disk"])
            self.at_most = "at most " if said["at_most"] else self.at_most
        return not code

    def with_path(self, word):
        """Files of the user are elsewhere."""
        option, equals, value = word.partition("=") if word[:2] == "--" else ("", "", word)
        is_file = self.sweep.is_own_file(value)
        return f"{option}{equals}{(self.sweep.folder / value).resolve()}" if is_file else word

    def lines(self, count):
        """What is said of `count` points."""
        if (number := len(self.needs)) and any(one.program in RUNS for one in self.runs):
            seconds, disk = (sum(need[k] for need in self.needs) / number for k in ("time", "disk"))
            cores = self.executor.cores
            whole = f"{duration(count * seconds / cores)} with {plural(cores, 'core')}"
            each = f"{self.at_most}{duration(seconds)} and {disk / 1e6:.2g} MB"
            yield f"Each point takes {each}, all of them {self.at_most}{whole}."
            if self.sweep.kept:
                yield f"Files that are kept take {self.at_most}{count * disk / 1e6:.2g} MB."
        if self.unknown:
            names = ", ".join(sorted(self.unknown))
            yield f"Not counted, because they start from what runs find: {names}."
        if self.refused:
            some = "" if self.asked == count else f", of {self.asked:,} points that were asked"
            yield f"Refused{some}:"
        yield from most_said(self.refused)


def duration(seconds):
    for unit, length in (("days", 86400), ("h", 3600), ("min", 60)):
        if seconds >= 2 * length:
            return f"{seconds / length:.3g} {unit}"
    return f"{seconds:.2g} s"
