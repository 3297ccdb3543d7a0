"""A user's sweep: what its file says, checked before anything runs. Each point is checked with the
words of all its commands; what earlier commands report is filled in when it is there."""

import math
import re
from dataclasses import dataclass
from functools import cache, cached_property

from rupture.errors import Failure, UsageError
from rupture.programs import output_of
from rupture.tools.command_line import check_known, suggestion
from rupture.units import in_si, unit_in
from sweeps.along import lines_along_x
from sweeps.text import Text, existing, is_values, name_of
from sweeps.values import HEADING, check_length, combined, references, rows_in, values_of
from sweeps.words import PLAIN, VALUES, Command, Described, Later, file_in, options_of
from sweeps.words import without_time

PATH = re.compile(r"[\w-]+(\.-?\w+)+")  # to a quantity: front.v_c.28
INDEX = re.compile(r"\.-?\d+(?=\.|$)")
NAME = re.compile(r"\w[\w., +-]{0,99}")  # of a column
OWN = {"base", VALUES}  # holes that are no names
STATE = ("status", "sentence", "point")  # columns of every table
MEGABYTES = {"MB": 1, "GB": 1000}
AXES = ("log", "linear")


@dataclass(frozen=True)
class Point:
    number: int
    values: dict  # {name: text}, as they are typed
    options: list  # words for {values}

    def __repr__(self):
        return " ".join(f"{name} {text}" for name, text in self.values.items())


@cache
def compared(text):
    """The value, as it is compared with others."""
    try:
        return in_si(text)[0]
    except ValueError:
        return text


def check_name(name, taken):
    """Of a value, which is the heading of a column, too."""
    if name in taken:
        raise UsageError(f"'{name}' has a meaning of its own: take another name")
    if not NAME.fullmatch(name):
        raise UsageError(f"'{name}' cannot be the heading of a column")


class Sweep:
    def __init__(self, path):
        self.name = name_of(path)
        self.text, self.described, self.folder = Text(path), Described(), path.parent
        self.keys = self.text["sweep"]
        self.title = self.keys.get("title", self.name)
        with self.text.errors_at("sweep", "title"):
            check_length(self.title)
        self.is_own_file = file_in(self.folder)
        self.base = self.checked_base()
        self.commands = self.checked_commands()
        self.points = self.all_points()
        self.columns, self.units = self.checked_columns()
        self.units |= self.units_of_values()
        self.check_keys()
        self.check_points()

    # --- what the file says --------------------------------------------------------------------

    def checked_base(self):
        """The path of the file that {base} stands for."""
        if not (name := self.keys.get("base")):
            return None
        with self.text.errors_at("sweep", "base"):
            path = existing(self.folder / name)
            try:
                output_of("analyze", "checksum", "--", path)
            except Failure as error:
                raise UsageError(f"the base cannot be used: {error}") from None
            return str(path)

    def checked_commands(self):
        commands: list[Command] = []
        files: set[str] = set()
        for name, line in self.text["commands"].items():
            with self.text.errors_at("commands", name):
                command = Command(name, line, self.described)
                for hole in command.holes:
                    command.is_later |= self.check_hole(hole, commands)
                if twice := files.intersection(command.outputs):
                    raise UsageError(f"two commands write {', '.join(twice)}")
                files.update(command.outputs)
                commands.append(command)
        if not commands:
            raise self.text.error(0, "it has no section [commands]")
        with self.text.errors_at("sweep", "keep"):
            for one in self.kept:
                if without_time(one) not in files:
                    raise UsageError(f"no command writes {one}")
        return commands

    def check_hole(self, hole, before):
        """Whether it is a place in what an earlier command reports; names of values are checked
        with the points."""
        if hole == "base" and not self.base:
            raise UsageError("{base} needs base = FILE in [sweep]")
        is_later = hole.partition(".")[0] in self.text["commands"]
        if is_later and not PATH.fullmatch(hole):
            raise UsageError(f"'{{{hole}}}' is no quantity, such as {{front.t_rupture.8}}")
        if is_later:
            self.unit_at(hole, before)
        return is_later

    def all_points(self):
        lists: dict[str, dict] = {}
        taken = {*STATE, *OWN, *self.kept}
        for section in filter(is_values, self.text.sections):
            lists[section] = {}
            for name, text in self.text[section].items():
                with self.text.errors_at(section, name):
                    check_name(name, {"variant", *taken})
                    lists[section][name] = values_of(text)
        with self.text.errors_at("sweep", "points"):
            name = self.keys.get("points")
            self.table = existing(self.folder / name) if name else None
            rows = rows_in(self.table) if name else [{}]
            for name in next(iter(rows), {}):
                check_name(name, {"variant", *taken} if lists.keys() - {VALUES} else taken)
        self.lists = [item for one in lists.values() for item in one.items()]
        with self.text.errors_at(VALUES):
            found = [*combined(lists, rows)]
            if not found or not any(found):
                sentence = "there are no points: [values] or a table says for which values to run"
                raise UsageError(sentence)
            if len({tuple((n, compared(t)) for n, t in one.items()) for one in found}) < len(found):
                raise UsageError("two points have the same values: remove the repeated value")
            return [Point(n, one, self.options(one)) for n, one in enumerate(found)]

    def options(self, values):
        chosen = self.chosen(tuple(values))
        return [*options_of({name: values[name] for name in chosen}, self.described)]

    @cache
    def chosen(self, names):
        """The values for {values}: those that no hole of a command names. What only other values
        name is none either, unless the program knows it."""
        for command in self.commands:
            with self.text.errors_at("commands", command.name):
                self.check_names(command, {*names})
        holes = {hole for command in self.commands for hole in command.holes}
        named = {one for _, texts in self.lists for text in texts for one in references(text)}
        named = {n for n in named if self.described.unit_of(n, self.with_values) is None}
        found = [name for name in names if name not in {"variant"} | holes | named]
        if found and self.with_values is None:
            raise UsageError(f"no command has {{values}}, nor {{{found[0]}}}")
        return found

    def check_names(self, command, names):
        later = {hole for hole in command.holes if hole.partition(".")[0] in self.text["commands"]}
        for name in names & {command.name, *later}:
            raise UsageError(f"'{name}' is the name of a value, too: take another one")
        for hole in command.holes:
            if hole not in later | names | OWN:
                near = suggestion(hole, names) or f"; there are {', '.join(sorted(names))}"
                raise UsageError(f"'{{{hole}}}': there is no '{hole}'{near}")

    @cached_property
    def with_values(self):
        """The first program that gets {values}."""
        return next((one.call for one in self.commands if VALUES in one.holes), None)

    @cached_property
    def kept(self):
        for name in (names := self.keys.get("keep", "").split()):
            if not PLAIN.fullmatch(name):
                raise UsageError(f"'{name}' is not the name of a file in the point's own folder")
        return names

    @cached_property
    def along_x(self):
        return lines_along_x(self)

    # --- what is measured ----------------------------------------------------------------------

    def unit_at(self, path, commands):
        """`path` is the name of a command, then a place in what it reports. `analyze strength`
        reports numbers of a shape, but lists of a file."""
        name, _, rest = path.partition(".")
        by_name = {one.name: one for one in commands}
        if name not in by_name:
            near = suggestion(name, by_name) or f"; it has {', '.join(by_name) or 'none before'}"
            raise UsageError(f"'{path}': [commands] has no '{name}'{near}")
        if (call := by_name[name].call)[0] != "analyze":
            raise UsageError(f"'{path}': the command '{name}' does not run analyze")
        quantity, known = f"{call[1]}.{rest}", self.described.quantities
        pattern = INDEX.sub(".*", quantity)
        is_list, of_file = f"{pattern}.*" in known, ".h5" in by_name[name].line
        if pattern in known and not (is_list and of_file):
            return known[pattern]
        if is_list:
            raise UsageError(f"'{path}' is a list: name one element, as in {path}.8")
        near = suggestion(pattern, known) or "; rupture analyze quantities lists what there is"
        raise UsageError(f"analyze reports no '{quantity}'{near}")

    def checked_columns(self):
        """{name: path} and {name: unit}. A heading may repeat the unit, as in `speed [m/s]`."""
        columns: dict[str, str] = {}
        units: dict[str, str] = {}
        taken = [*STATE, *self.kept, *(name for name, _ in self.lists)]
        taken += self.points[0].values
        if not (rows := self.text["quantities"]):
            raise self.text.error(0, "it needs a section [quantities], as in type = front.type")
        for heading, path in rows.items():
            with self.text.errors_at("quantities", heading):
                ((name, _, stated),) = HEADING.findall(heading)
                if not PATH.fullmatch(path):
                    raise UsageError(f"'{path}' is no quantity, such as front.slow.speed")
                unit = self.unit_at(path, self.commands)
                if stated not in ("", unit):
                    raise UsageError(f"'{heading}' says [{stated}], but {path} is in '{unit}'")
                if not NAME.fullmatch(name) or name in (*columns, *taken):
                    raise UsageError(f"'{heading}' cannot be the heading of a column")
                columns[name], units[name] = path, unit
        return columns, units

    def units_of_values(self):
        """Of those that no program knows, that of their numbers."""
        found = {}
        for name in dict.fromkeys(n for point in self.points for n in point.values):
            unit = self.described.unit_of(name, self.with_values) if self.with_values else None
            found[name] = self.unit_in_texts(name) if unit is None else unit
        return found

    def unit_in_texts(self, name):
        try:
            units = {in_si(p.values[name])[1] or "1" for p in self.points if name in p.values}
        except ValueError:
            return ""
        return units.pop() if len(units) == 1 else ""

    # --- the words of all points ---------------------------------------------------------------

    def check_points(self):
        """By descriptions of programs; the first of each form by the programs themselves, too."""
        forms = set()
        for point in self.points:
            made: set[str] = set()
            form = tuple(point.values)
            for command in self.commands:
                with self.text.errors_at("commands", command.name):
                    words = self.words(command, point)
                    command.check(words, self.are_files(made))
                    if form not in forms and not any(isinstance(word, Later) for word in words):
                        self.described.answer(*words, "--describe")
                    made.update(command.outputs_of(words))
            forms.add(form)

    def are_files(self, made):
        """Tells which words are files, of earlier commands or of the user."""
        return lambda word: without_time(word) in made or self.is_own_file(word)

    def words(self, command, point, reports=None):
        """Without `reports`, parts of them are Later. None if a part has no value."""
        return command.filled(lambda name: self.text_of(name, point, reports), point.options)

    def text_of(self, name, point, reports):
        """Of what a hole names."""
        if name in point.values:
            return point.values[name]
        if name == "base":
            return self.base
        return Later("1") if reports is None else text_in(reports, name)

    @cached_property
    def varied(self):
        """Names of the values that differ between points, and follow no others."""
        follows = {name for name, texts in self.lists if len(texts) == 1 and references(texts[0])}
        rows = [point.values for point in self.points]
        names = dict.fromkeys(name for row in rows for name in row if name not in follows)
        found = [name for name in names if len({row.get(name) for row in rows}) > 1]
        return [name for name in found if name == "variant" or not self.names_variant(name)]

    def names_variant(self, name):
        """Whether each variant has one value of it, so that it varies with the variant."""
        pairs = {(point.values.get("variant"), point.values.get(name)) for point in self.points}
        return len(pairs) == len({variant for variant, _ in pairs}) > 1

    @cached_property
    def typed(self):
        """{name: unit} where all numbers of a name have the same."""
        found: dict[str, set] = {}
        for name, text in (item for point in self.points for item in point.values.items()):
            found.setdefault(name, set()).add(unit_in(text))
        return {name: units.pop() for name, units in found.items() if len(units) == 1}

    def check_keys(self):
        self.axis = self.keys.get("axis", "")
        with self.text.errors_at("sweep", "axis"):
            check_known(self.axis, ("", *AXES), "an axis is log or linear, not")
        memory, threads = self.keys.get("memory", "1 GB"), self.keys.get("threads", "1")
        with self.text.errors_at("sweep", "memory"):
            amount = re.fullmatch(r"(\d{0,9}\.?\d{1,9})\s*(MB|GB)", memory)
            self.megabytes = math.ceil(float(amount[1]) * MEGABYTES[amount[2]]) if amount else 0
            if not self.megabytes:
                raise UsageError(f"'memory = {memory}': give a number and MB or GB, as in 2 GB")
        with self.text.errors_at("sweep", "threads"):
            if not re.fullmatch("[1-9][0-9]{0,3}", threads):
                raise UsageError(f"'threads = {threads}': give a whole number from 1")
            self.threads = int(threads)


def text_in(reports, path):
    """A number or a word of a report for a command; None if there is none."""
    value = find(reports, path)
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        return None
    return f"{value!r}" if isinstance(value, float) else f"{value}"


def find(tree, path):
    """The value that a path such as front.v_c.3 leads to; None where it leads nowhere."""
    key, _, rest = path.partition(".")
    try:
        one = tree[int(key)] if isinstance(tree, list) else tree[key]
    except (KeyError, IndexError, TypeError, ValueError):
        return None
    return find(one, rest) if rest else one
