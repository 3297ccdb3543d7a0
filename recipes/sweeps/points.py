"""What points find: their commands by `rupture.once`, one after the other."""

from rupture.commands.identity import Command as Work
from rupture.commands.identity import Made, Refused
from rupture.commands.store import place_of
from rupture.errors import Failure, UsageError
from rupture.tools.command_line import in_one_line, plural
from sweeps.sweep import find
from sweeps.words import without_time

DONE, REFUSED, UNFINISHED = "done", "refused", "unfinished"
SHOWN = 5  # sentences
LEFT_OUT = "{} was left out, because it needs a value that is null"


class Points:
    """compute(point) for `each`. A refusal is a result, and so is what ended for reasons of the
    machine: the other points go on."""

    def __init__(self, sweep, making):
        self.sweep, self.making = sweep, making

    def compute(self, point):
        """Its row of the table."""
        reports: dict[str, dict] = {}
        row = {**point.values, "status": DONE, "sentence": ""}
        try:
            row |= self.run(point, reports)
        except (Refused, UsageError) as why:
            row |= {"status": REFUSED, "sentence": str(why)}
        except Failure as why:
            row |= {"status": UNFINISHED, "sentence": str(why)}
        for name, path in self.sweep.columns.items():
            row[name] = in_cell(find(reports, path))
        asked = self.making.scope.asked
        return row | {"point": asked[-1].own if asked else ""}

    def run(self, point, reports):
        """Fills the reports. A command that needs a value that is null is left out, and so is what
        needs its files. Returns a sentence about these, and the places of kept files."""
        made: dict[str, Work] = {}
        missing: set[str] = set()
        kept, left_out = [], []
        for command in self.sweep.commands:
            words = self.sweep.words(command, point, reports)
            if words is None or not missing.isdisjoint(map(without_time, words)):
                missing.update(command.outputs)
                left_out.append(command.name)
                continue
            if command.is_later:
                command.check(words, self.sweep.are_files(made))
            work = self.work(words, made)
            made |= {name: work for name in work.outputs}
            if work.has_report:
                reports[command.name] = self.making.report(work)
            kept += [work[name] for name in work.kept]
        for file in kept:
            self.making.path(file)
        sentence = "; ".join(LEFT_OUT.format(name) for name in left_out)
        places = {file.name: f"store/{place_of(file.work.own, file.name)}" for file in kept}
        return {"sentence": sentence} | places

    def work(self, words, made):
        """The command, with the files of earlier ones in place of their names."""
        sources = (made.get(without_time(word)) for word in words)
        inputs = [Made(one, word) if one else word for one, word in zip(sources, words)]
        work = Work(inputs, self.making, self.sweep.folder)
        work.kept = {name for name in self.sweep.kept if without_time(name) in work.outputs}
        return self.making.name(work)


def most_said(said, elsewhere=""):
    """Lines with the sentences that most points end with; `said`: a Counter of them."""
    lines = [f"  {times} x {in_one_line(sentence)}" for sentence, times in said.most_common(SHOWN)]
    if len(said) > SHOWN:
        lines.append(f"  and {plural(len(said) - SHOWN, 'other sentence')}{elsewhere}")
    return lines


def in_cell(value):
    """A number, a text or a truth value; None for parts of reports."""
    return value if isinstance(value, (int, float, str)) else None
