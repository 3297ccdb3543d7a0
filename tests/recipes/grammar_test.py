"""Files of chains and sweeps as they are read: their points, their commands, and what is wrong in a
sentence with the file and the line (recipes/chains)."""

import json
import re

import pytest

from chains.check import check
from chains.points import Waiting
from chains.selection import Chains
from chains.store import STORE
from rupture.errors import UsageError


class Files:
    """Files in a/ of the current folder; .read() for one of them, with what is wrong in it as an
    error."""

    def __init__(self, folder):
        self.folder, self.chains = folder / "a", Chains()
        self.folder.mkdir()

    def write(self, **texts):
        for name, text in texts.items():
            (self.folder / f"{name}.ini").write_text(text)

    def read(self, name="x"):
        chain = self.chains.load(self.folder / f"{name}.ini")
        check(self.chains, chain)
        return self.chains.points(chain)

    def has_run(self, name, *reports):
        """What points report, in their order."""
        for point, report in zip(self.read(name), reports, strict=True):
            STORE.mkdir(parents=True, exist_ok=True)
            result = {"status": "done", "sentence": "", "checksums": {}, "reports": report}
            point.path.write_text(json.dumps(result))


@pytest.fixture(name="files")
def files_in_a_folder(folder):
    return Files(folder)


RUN = "[commands]\nrun = prepare {values} -o a.h5\n"


def run(words, values):
    return f"[commands]\nrun = prepare {words} -o a.h5\n[values]\n{values}\n"


COMMANDS = [  # a file, and the commands of its points, without the program and `-o a.h5`
    (run("{values}", "tau-bar = 0.1, 0.2"), ["--tau-bar 0.1", "--tau-bar 0.2"]),
    (f"[sweep]\n{RUN}[values]\nseed = 1 to 2", ["--seed 1", "--seed 2"]),
    (run("{values}", "a.E = 2 GPa\nx = 2 * {a.E}"), ["--set 'a.E=2 GPa' --x 4000000000"]),
    (f"{RUN}[variant v]\nseed = 1\n[variant w]\nseed = 2", ["--seed 1", "--seed 2"]),
    # A value that is named is no option.
    (run("{values} --seed {n}", "n = 7\ntau-bar = 0.1"), ["--tau-bar 0.1 --seed 7"]),
    (run("--seed {n + 1}", "n = 7"), ["--seed 8"]),
    (run("--x {m}", "n = 7\nm = {n / 2}"), ["--x 3.5"]),
    (run("--x {n}", "n = $(x) y"), ["--x '$(x) y'"]),
    ("[commands]\nrun = analyze phi x-t{0.2}.h5", ["phi x-t0.200000000.h5"]),
    (  # filled in when it runs
        "[commands]\nfront = analyze front r.h5\nrun = restart a.h5 --until {front.t_rupture[8]}",
        ["a.h5 --until {front.t_rupture[8]}"],
    ),
]


@pytest.mark.parametrize("text, expected", COMMANDS)
def test_the_commands_of_points(files, text, expected):
    files.write(x=text)
    found = [point.commands["run"].removesuffix(" -o a.h5") for point in files.read()]
    assert [command.split(" ", 1)[1] for command in found] == expected


ABOVE = (
    "[chain]\nkeep = l.h5 l-t{0.1 to 0.3 by 0.1}.h5\n[commands]\nl = load {values} -o l.h5\n"
    + ("events = analyze events r.h5\n[values]\nseed = 1, 2\n")
)
BELOW = "[commands]\nrun = restart {base} -o a.h5 --until {until}\nx = analyze stress {base}\n"
EVENTS = (
    {"events": {"list": [{"t": 0.25, "big": True}, {"t": 0.35, "big": False}]}},
    {"events": None},
)


def below(points, base="l.h5", values="until = 1"):
    return f"[chain]\npoints = {points}\nbase = above: {base}\n{BELOW}[values]\n{values}\n"


SELECTED = [  # a chain that comes from `above`, and its points: (seed, base, until)
    (below("above"), [(1, "l.h5", 1), (2, "l.h5", 1)]),
    (below("above where seed == 2"), [(2, "l.h5", 1)]),
    (
        below("above where seed == 2 or until > 1", values="until = 1, 2"),
        [(1, "l.h5", 2), (2, "l.h5", 1), (2, "l.h5", 2)],
    ),
    (below("first above"), [(1, "l.h5", 1)]),
    (below("above", "l-t{0.2}.h5"), [(1, "l-t0.200000000.h5", 1), (2, "l-t0.200000000.h5", 1)]),
    (
        below("e in above: events.list", "l-t{last before until}.h5", "until = {e.t - 0.05}"),
        [(1, "l-t0.100000000.h5", 0.2), (1, "l-t0.200000000.h5", 0.3)],
    ),
    (below("e in above: events.list where e.big"), [(1, "l.h5", 1)]),
    (below("first e in above: events.list where not e.big"), [(1, "l.h5", 1)]),
]


@pytest.mark.parametrize("text, expected", SELECTED)
def test_points_from_another_chain(files, text, expected):
    files.write(above=ABOVE, x=text)
    waits = "events" in text
    if waits:
        with pytest.raises(Waiting):
            files.read()
        assert len(files.chains.deciding) == 2
        files.chains = Chains()
    files.has_run("above", *EVENTS)
    found = files.read()
    assert bool(files.chains.deciding) == waits
    each = [(p.known("seed"), p.base["shown"], pytest.approx(p.known("until"))) for p in found]
    assert each == expected


def test_points_come_from_a_list(files):
    files.write(above=ABOVE, x=below("e in above: events"))
    files.read("above")
    files.has_run("above", *EVENTS[:1], *EVENTS[:1])
    with pytest.raises(UsageError, match="events is no list"):
        files.read()


def test_nobody_asks_for_reports_of_points_whose_values_leave_them_out(files):
    files.write(above=ABOVE, x=below("e in above: events.list where seed == 2 and e.big"))
    with pytest.raises(Waiting):
        files.read()
    assert [point.known("seed") for point in files.chains.deciding] == [2]


def test_values_from_reports_of_other_points_are_options(files):
    values = "tau-bar = {e.t}\nseed = 3\nlater = {x.p[0]}\n"
    above = ABOVE.replace("[values]\nseed = 1, 2\n", "")
    run = "[commands]\nrun = prepare {values} -o a.h5\nx = analyze stress a.h5\n"
    files.write(above=above)
    files.write(x=f"[chain]\npoints = e in above: events.list\n{run}[values]\n{values}")
    files.has_run("above", EVENTS[0])
    assert [point.commands["run"] for point in files.read()] == [
        "prepare --tau-bar 0.25 --seed 3 -o a.h5",
        "prepare --tau-bar 0.35 --seed 3 -o a.h5",
    ]
    first = files.read()[0]
    assert first.texts(first.known) == {"tau-bar": "0.25", "seed": "3", "later": None}


def test_like_takes_what_a_file_lacks(files):
    files.write(y=f"[chain]\nkeep = a.h5\nmemory = 2 GB\n{RUN}[values]\nseed = 1, 2\n[variant v]\n")
    files.write(x="[chain]\nlike = y.ini\nmemory = 3 GB\n[values]\nseed = 3\n")
    (point,) = files.read()
    assert point.values == {"variant": "v", "seed": "3"}
    assert (point.chain.keep, point.chain.needs["megabytes"]) == (["a.h5"], 3000)


def test_points_of_the_same_commands_are_one(files):
    files.write(x=f"{RUN}[values]\nseed = 1, 2\n[variant v]\n[variant w]\n")
    found = files.read()
    assert [point.values["variant"] for point in found] == ["v", "v", "w", "w"]
    assert len({point.path for point in found}) == 2


# --- values and points ------------------------------------------------------------------------


def values_in(points):
    return ["".join(sum(point.values.items(), ())).replace(" ", "_") for point in points]


PRODUCTS = [  # [values] and variants, and the points
    ("a = 1, 2\nb = 3, 4", "a1b3 a1b4 a2b3 a2b4"),  # the last one varies fastest
    ("c = sqrt({b})\nb = {a} ** 2 * 4\na = 1, 3", "c2b4a1 c6b36a3"),
    ("a = -2\nb = {a} ** 2", "a-2b4"),
    ("a = 2ms\nb = 0.3 * {a}", "a2msb0.0006"),
    ("a = 4 kN/m\nb = {a} / 2", "a4_kN/mb2000"),
    ("a = 1, 2  # both\n", "a1 a2"),
    # variants replace common values
    (
        "a = 1\nb = 2\n[variant X]\na = 5, 6\n[variant Y]\nb = 7",
        "variantXa5b2 variantXa6b2 variantYa1b7",
    ),
]


@pytest.mark.parametrize("text, expected", PRODUCTS)
def test_every_combination_is_a_point(files, text, expected):
    files.write(x=f"[sweep]\n{RUN}[values]\n{text}")
    assert values_in(files.read()) == expected.split()


FOUR = "seed1a1b2 seed2a1b2 seed1a3b4 seed2a3b4"
TABLES = [  # a table of points (tests/tools/csv.txt has more), and the points with two seeds
    (b"a, b\n1, 2\n3,4\n", FOUR),
    (  # of a sweep that has run
        b"driving.V [mm/s],variant,status,v [m/s],type\n0.4,x,done,2,slow\n",
        "seed1driving.V0.4mm/svariantx seed2driving.V0.4mm/svariantx",
    ),
]


@pytest.mark.parametrize("content, expected", TABLES)
def test_points_from_a_table(files, content, expected):
    (files.folder / "../points.csv").write_bytes(content)
    files.write(x=f"[sweep]\npoints = ../points.csv\n{RUN}[values]\nseed = 1, 2")
    assert values_in(files.read()) == expected.split()


@pytest.mark.parametrize(
    "content, sentence",
    [
        (b"a,b\n0.1\n", "points.csv, line 2: it needs as many cells as the first line"),
        (b"a,b\n0.1,1\n\n0.2,1,5\n", "points.csv, line 4: it needs as many cells"),
        (b",a\n0.1,1\n", "points.csv: each column needs a heading of its own"),
        (b"a\n\xff\n", "points.csv is not a CSV table in UTF-8"),
    ],
)
def test_wrong_tables_of_points(files, content, sentence):
    (files.folder / "points.csv").write_bytes(content)
    files.write(x=f"[sweep]\npoints = points.csv\n{RUN}")
    with pytest.raises(UsageError, match=sentence):
        files.read()


def chain(keys):
    return f"[chain]\n{keys}\n{RUN}"


WHOLE = f"[sweep]\n{RUN}"
WRONG = [  # a file, and the sentence that follows its name
    (RUN.replace("prepare", "rm"), "line 2: there is no program 'rm'"),
    (RUN.replace("{values}", "{valus}"), "line 2: 'valus': there is no 'valus'; there are run"),
    (f"{RUN}y = load {{run.a}} {{ru.b}}", "line 3: 'ru.b': there is no 'ru': did you mean 'run'"),
    (f"{RUN}y = load {{base}}", r"line 3: .*{base} needs base = FILE in \[chain\]"),
    (f"{RUN}y = load {{x", "line 3: .*a brace is missing"),
    (f"{RUN}y = load 'x", "line 3: .*cannot be split into words"),
    (f"{RUN}y = load {{values.x}}", "line 3: 'values.x': there is no 'values'"),
    (f"{RUN}[values]\nx = {{y + 1}}", "line 4: 'y . 1': there is no 'y'; there are run, x"),
    (f"{RUN}y = script fit.py", "line 3: there is no program 'script'"),
    (f"{RUN}y = map r.h5 -o r.png", "line 3: there is no program 'map'"),
    (f"{RUN}[values]\nrun = 1", "line 2: 'run' is the name of a value, too"),
    (chain("points = run in above: events.list"), "line 4: 'run' is the name of a value"),
    (f"{RUN}[values]\nx = 1 to 2.5", "line 4: .*give its step"),
    (f"{RUN}[values]\nx =", "line 4: 'x' in .values. has no value"),
    (chain("point = y"), "line 2: .chain. has no key 'point': did you mean 'points'"),
    (f"[chains]\nbase = y\n{RUN}", "line 2: there is no section 'chains': did you mean 'chain'"),
    (chain("points = y"), "line 2: there is no chain .*/a/y.ini; beside it are above, x"),
    (chain("points = e in above"), "line 2: write points = CHAIN, or NAME in CHAIN: LIST"),
    (chain("points = e in above: event.s"), "line 2: 'event.s': .*'event': did you mean 'events'"),
    (chain("points = above where sed == 1"), "line 2: .*there is no 'sed': did you mean 'seed'"),
    (chain("points = above\nbase = above: r.h5"), "line 3: .*above.ini does not keep r.h5"),
    (chain("base = above: l.h5"), "line 2: its points do not come from above"),
    (chain("keep = b.h5"), "line 2: no command writes b.h5"),
    (chain("keep = ../a.h5"), "line 2: '../a.h5' is not the name of a file"),
    ("[chain]\nlike = x.ini\n", "'like' leads back to the same file"),
    # values
    *((f"{WHOLE}[values]\na = {n}\n", "depend on itself") for n in ("{a}", "{a}.real")),
    *(  # no finite real number
        (f"{WHOLE}[values]\nb = 9\na = {text}", re.escape(f"'{text}' "))
        for text in ("{z} + 1", "__import__('os') * {b}", "1 / 0 * {b}", "{b} +", "{b} + x")
        + ("{b}**{b}**{b}**{b}", "sqrt({b} - 10)", "({b} - 10) ** 0.5", "{b} * 1e308 * 10")
    ),
    (f"{WHOLE}[values]\na = 1 to 1e5\nb = 1 to 1e5", "10,000,000,000 points; at most 100,000"),
    # sections and lines
    ("", "no section .commands."),
    ("x", "line 1: expected .SECTION. first"),
    (f"{WHOLE}[values]\na\n", r"line 5: expected NAME = VALUE or .SECTION. \(got 'a'\)"),
    (f"{WHOLE}[values]\na = 1\na = 2\n", "'a' in section 'values' already exists"),
    (f"{WHOLE}[values]\n[values]\n", "section 'values' already exists"),
    (f"{WHOLE}[DEFAULT]\na = 1\n", "no section 'DEFAULT'"),
    *(
        (f"[sweep]\n{need}\n{RUN}", f"'{need}' is not understood: give a")
        for need in ("memory = 10", "memory = 0 MB", "memory = 2 kg", "memory = .")
        + ("threads = 0", "threads = 1.5")
    ),
]


@pytest.mark.parametrize("text, sentence", WRONG)
def test_what_is_wrong_is_said_with_the_file_and_the_line(files, text, sentence):
    files.write(above=ABOVE, x=text)
    with pytest.raises(UsageError, match=f"/a/x.ini[,:] .*?({sentence})"):
        files.read()
