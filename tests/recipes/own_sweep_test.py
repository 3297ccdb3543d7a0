"""A user's sweep: its plan, and what is refused before anything is computed (chains/sweeps.py)."""

import shutil
import subprocess
import unicodedata
from pathlib import Path
from unittest import mock

import pytest

from conftest import ROOT, run
from chains.sweeps import OwnSweep
from rupture.errors import Failure, UsageError

BASE = ROOT / "checkpoints/fast-only.h5"
RECORD = ROOT / "tests/compatibility/schema-3/reference-record.h5"
CHAIN = """[sweep]
[commands]
start   = prepare {values} -o s.h5 --quiet
restart = restart s.h5 --until-quiet -o e.h5 --record r.h5 --quiet
front   = analyze front r.h5 --json
stress  = analyze stress s.h5 --json
[values]
tau-bar = 0.1, 0.2
[quantities]
type = front.type
"""
VALUES = "tau-bar = 0.1, 0.2"
BASED = """[sweep]
base = base.h5
[commands]
restart = restart {base} {values} --for 0.01 -o e.h5 --record r.h5
front   = analyze front r.h5 --json
[values]
driving.V = 0.1mm/s
seed = 1, 2
[quantities]
type = front.type
"""


@pytest.fixture
def plan(tmp_path, monkeypatch):
    """Plans and reads a sweep with this text."""
    monkeypatch.chdir(tmp_path)
    shutil.copyfile(BASE, "base.h5")

    def plan(text, name="sweep"):
        Path(f"{name}.ini").write_text(text, encoding="utf-8")
        own = OwnSweep(tmp_path / f"{name}.ini")
        own.write()
        return own.sweep

    return plan


# --- plans ------------------------------------------------------------------------------------


def test_units_and_headings_are_settled(plan):
    text = CHAIN.replace(VALUES, f"{VALUES}\njunctions.t_R = 1 to 2 ms\njunctions.law = reference")
    text += "speed [m/s] = front.v_c.3\nF_T = stress.F_T\n"
    text += "c [km/s] = front.c_s / 1000\nratio = stress.F_T / 1920 / tau-bar\n"
    again = "--until-quiet --set junctions.t_R=2e-3"  # a later command may set what varies
    sweep = plan(text.replace("--until-quiet", again).replace("= analyze", "= rupture analyze"))
    expected = {"tau-bar": "1", "junctions.t_R": "s", "junctions.law": "", "type": ""}
    assert sweep.units == expected | {"speed": "m/s", "F_T": "N", "c": "km/s", "ratio": "1"}
    expected = {"type": "front.type", "speed": "front.v_c.3", "F_T": "stress.F_T"}
    expected |= {"c": "front.c_s / 1000", "ratio": "stress.F_T / 1920 / tau-bar"}
    assert sweep.columns == expected
    command = "prepare --tau-bar 0.2 --set junctions.t_R=2ms --set junctions.law=reference -o s.h5"
    assert sweep.points[-1].commands["start"] == f"{command} --quiet"


def test_varied_are_values_that_differ_and_do_not_follow_others(plan):
    values = f"{VALUES}\nsigma-bar = 0.01\nseed = 10 * {{tau-bar}}\nshape = uniform, bell"
    assert plan(CHAIN.replace(VALUES, values)).varied == ["tau-bar", "shape"]


def test_the_example_of_points_that_follow_from_points_is_that_of_the_page(folder):
    own = OwnSweep(ROOT / "docs/examples/branches.ini")
    assert own.points is None and not list(folder.iterdir())  # not yet known, and nothing is wrong
    page = (ROOT / "docs/sweeps.md").read_text("utf-8")
    for name, first in (("run", "[chain]\n"), ("branches", "base   = run:")):
        text = (ROOT / f"docs/examples/{name}.ini").read_text("utf-8").partition(first)[2]
        assert text.partition("\n[quantities]")[0].strip() in page


def test_names_of_the_same_look_are_the_same(plan):
    apart, micro, mu = unicodedata.normalize("NFD", "größe"), "\u00b5", "\u03bc"
    shutil.move("base.h5", f"{apart}.h5")
    Path("größe.csv").write_text(f"driving.V [{micro}m/s]\n3\n", encoding="utf-8")
    text = BASED.replace("base.h5", f"größe.h5\npoints = {apart}.csv")
    text = text.replace("0.01", f"{{größe + 2 * {mu}}} --set junctions.t_R={{{mu}}}")
    values = f"{micro} = 1{mu}s, 2{micro}s\n{apart} = 1ms\n[quantities]\n"
    quantity = f"{apart}n [{micro}s] = 1e6 * {micro} / größe\n"
    sweep = plan(
        text.replace("driving.V = 0.1mm/s\nseed = 1, 2\n[quantities]\n", values) + quantity
    )
    command = sweep.points[0].commands["restart"]
    assert (
        f"--set 'driving.V=3{micro}m/s' --for 0.001002 --set junctions.t_R='1{micro}s'" in command
    )
    assert sweep.units["größen"] == f"{micro}s"
    assert sweep.typed == {micro: f"{micro}s", "größe": "ms", "driving.V": f"{micro}m/s"}


def test_commands_of_points_that_are_not_known_yet_are_checked(plan):
    shutil.copy(ROOT / "docs/examples/run.ini", ".")
    text = (ROOT / "docs/examples/branches.ini").read_text("utf-8")
    with pytest.raises(UsageError, match="branches.ini, line .*needs the name of a file"):
        plan(text.replace("-o before.h5", "-o {start}/x"), "branches")
    assert plan(f"{text}late [ms] = event.t_rupture[8] * 1e3\n", "branches").units["late"] == "ms"
    assert plan(f"{text}late = event.t_rupture[8]\n", "branches").units["late"] == "1"
    assert plan(f"{text}late = after.t_rupture[8]\n", "branches").units["late"] == "s"


def test_points_follow_the_content_of_the_base_which_is_copied(plan):
    first = plan(BASED).points
    (copy,) = Path("results/data/bases").glob("*.h5")
    command = first[0].commands["restart"]
    assert command.startswith(f"restart {copy} --set driving.V=0.1mm/s --seed 1 --for 0.01")
    assert run("analyze", "checksum", copy).stdout.startswith(copy.stem)
    shutil.move("base.h5", "b.h5")
    again = plan(BASED.replace("base.h5", "b.h5")).points
    assert [point.id for point in again] == [point.id for point in first]
    shutil.copyfile(ROOT / "checkpoints/second-slow.h5", "base.h5")
    assert not {point.id for point in first} & {point.id for point in plan(BASED).points}


@pytest.mark.parametrize("folder", ["tables", "a #b", "a ;b"])
def test_the_plan_has_its_own_table_of_points(plan, folder):
    Path(folder).mkdir()
    table = Path(folder) / "points.csv"
    table.write_text("tau-bar\n0.1\n0.2\n")
    text = CHAIN.replace("[sweep]", "\ufeff[sweep]\npoints = points.csv").replace(VALUES, "")
    sweep = plan(text.replace("\n", "\r\n"), f"{folder}/sweep")
    table.write_text("tau-bar\n0.3\n")
    again = OwnSweep("results/sweeps/sweep/sweep.ini").sweep
    assert [point.values["tau-bar"] for point in again.points] == ["0.1", "0.2"]
    assert [point.id for point in again.points] == [point.id for point in sweep.points]


def test_each_command_is_asked_once(plan):
    with mock.patch("rupture.programs.subprocess.Popen", side_effect=subprocess.Popen) as run:
        plan(CHAIN)
    asked = [call.args[0] for call in run.call_args_list]
    assert len(asked) == 9 == len({tuple(words) for words in asked})


# --- refusals ---------------------------------------------------------------------------------

TWICE = "sets numerics.seed twice; remove it from .values. or .commands."
REFUSED = [
    # what of CHAIN, is replaced by what, sentence
    ("type = front.type", "", "needs a section .quantities."),
    ("[sweep]", "[sweep]\nseeds = 1, 2", "\\[sweep\\] has no key 'seeds'"),
    ("[sweep]", "[sweep]\npoints = p.csv", "no table of points .*p.csv"),
    ("[sweep]", "[sweep]\npoints = empty.csv", "there are no points"),
    ("[sweep]", "[sweep]\npoints = heading.csv", "there are no points"),
    ("[sweep]", "[sweep]\npoints = one.csv", "'tau-bar' is a value and a column of the table"),
    ("[sweep]", "[sweep]\npoints = sweep", "points cannot come from themselves"),
    ("[sweep]", "[sweep]\nbase = no.h5", "no.h5 does not exist"),
    ("[sweep]", "[sweep]\nbase = bad.h5", "the base cannot be used: .*bad.h5"),
    ("[sweep]", "[sweep]\nbase = record.h5", "is a record; runs continue from checkpoints"),
    ("--until-quiet", "--fro 1", "unknown option '--fro': did you mean '--for'"),
    ("--until-quiet", "--record-every 1", "restart needs --until or --for or --until-quiet or "),
    ("front r.h5", "front r.h5 --slowbelow 0.1", "unknown option '--slowbelow'.*'--slow-below'"),
    ("-o s.h5", "", "prepare needs --output, which"),
    (VALUES, "seed = 1", "prepare needs --tau-bar or --profile, which"),
    ("front r.h5", "slip r.h5", "analyze slip needs --x, which"),
    ("front r.h5", "frnt r.h5", "unknown command 'frnt': did you mean 'front'"),
    ("= prepare", "= prepar", "no program 'prepar': did you mean 'prepare'"),
    ("= prepare", "= script x.py", "no program 'script'"),
    ("= prepare", "= ../x/prepare", "no program '../x/prepare'"),
    ("{values}", "--tau-bar 1", "no command has {values}"),
    ("= prepare", "= {values} prepare", "no program '{values}'"),
    ("-o s.h5", "-o s.h5 -qf", "write -qf as single options"),
    ("-o s.h5", "-o s.h5 --", "write -- as single options"),
    ("-o s.h5", "-o /abs/s.h5", "needs the name of a file in the point's own folder"),
    ("-o s.h5", "--output=../s.h5", "needs the name of a file"),
    ("-o s.h5", "-o .s.h5", "needs the name of a file"),
    ("-o s.h5", "-o '' --quiet", "needs the name of a file"),
    ("-o s.h5", "-o {tau-bar}/s.h5", "needs the name of a file"),
    ("-o e.h5 --record r.h5", "-o e.h5 --record ../../x", "--record needs the name of a file"),
    ("-o s.h5", "-o s.h5 --config x", "must not have --config: points would not follow"),
    ("-o e.h5", "-o e.h5 -f", "must not have -f: a point starts in an empty"),
    ("-o e.h5", "-o e.h5 --resume", "must not have --resume: a point starts in an empty"),
    *(
        ("-o e.h5", f"-o e.h5 {option}", f"must not have {option}: it computes nothing")
        for option in ("--dry-run", "--help", "-h", "--version", "--describe")
    ),
    ("{values}", "{values} --tau-bar=0.1", "'--tau-bar' cannot be specified more than once"),
    ("-o s.h5", "-o s.h5 --seed 1 --set numerics.seed=1", TWICE),
    (VALUES, "seed = 1\nnumerics.seed = 1\ntau-bar = 0.1", TWICE),
    # values
    (VALUES, "", "there are no points"),
    (VALUES, f"{VALUES}\ndriving.v = 1", "no parameter 'driving.v': did you mean 'driving.V'"),
    (VALUES, f"{VALUES}\ntaubar = 1", "unknown option '--taubar': did you mean '--tau-bar'"),
    (VALUES, f"{VALUES}\noutput = x", "'--output' cannot be specified more than once"),
    (VALUES, "tau-bar = 0.1, high, 0.2", r"tau-bar must be a finite number \(got 'high'"),
    (VALUES, "tau-bar = high", "--tau-bar high is not a number"),
    *(
        (VALUES, f"{VALUES}\njunctions.t_R = 1ms, {text}", r"must be a finite number in s \(got '")
        for text in ("1mm", "nan", "1e999")
    ),
    *(
        (VALUES, f"{VALUES}\n{same}", "two points have the same values")
        for same in ("seed = 1, 1.0", "sigma-bar = 1e-4, 0.0001", "driving.V = 1mm/s, 1e-3m/s")
    ),
    (VALUES, f"{VALUES}\njunctions.t_R = 2ms, 4", "is unclear: 4 needs a unit, too"),
    (VALUES, f"{VALUES}\njunctions.law = reference, other", r"decaying or distance \(got 'other'"),
    (VALUES, f"{VALUES}\nshape = uniform, bel", r"must be uniform or bell \(got bel\)"),
    # quantities
    ("front.type", "front.slow.sped", "no 'front.slow.sped': did you mean 'front.slow.speed'"),
    ("front.type", "frnt.type", "no 'frnt': did you mean 'front'"),
    ("front.type", "loading.F_T.0", "write one like loading = analyze loading record.h5"),
    ("front.type", "start.F_T", "'start' does not run analyze"),
    ("front.type", "front.v_x[3] / 2", "no 'front.v_x'"),
    ("front.type", "start.F_T / 2", "'start' does not run analyze"),
    ("front.type", "2 * frnt.c_s", "there is no 'frnt'"),
    ("front.type", "2 * (front.c_s", "cannot be read as an expression"),
    ("[sweep]", "[sweep]\naxis = lg", "an axis is log or linear, not 'lg'"),
    ("type = front.type", "v [km/s] = front.c_s", "says .km/s., but front.c_s has the unit 'm/s'"),
    ("type = front.type", "v [mm/s] = front.v_c[3]", "says .mm/s., but front.v_c.3. has the unit"),
    ("type = front.type", "t [m] = front.type", "front.type has no unit; leave out .m."),
    (
        "type = ",
        "\u00b5 = front.c_s\n\u03bc = ",
        "option '\u00b5' in section 'quantities' already exists",
    ),
    ("type = ", "v/c_s = ", "cannot be the heading"),
    ("type = ", "status = ", "cannot be the heading"),
    ("type = ", "tau-bar = ", "cannot be the heading"),
    ("type = ", "@SUM(1) = ", "cannot be the heading"),
    (VALUES, f"[variant =cmd|calc!A0]\n{VALUES}", "variant must be a word or a name"),
    (VALUES, f"{VALUES}\nseed = {'-' * 10_000}1 * {{tau-bar}}", "cannot be calculated"),
]


@pytest.mark.parametrize("part, new, sentence", REFUSED)
def test_mistakes_are_refused_in_a_sentence_and_nothing_is_written(plan, part, new, sentence):
    Path("bad.h5").write_bytes(BASE.read_bytes()[:-1])
    Path("empty.csv").touch()
    Path("heading.csv").write_text("tau-bar\n")
    Path("one.csv").write_text("tau-bar\n0.1\n")
    shutil.copyfile(RECORD, "record.h5")
    assert part in CHAIN
    with pytest.raises(UsageError, match=f"^/.*/sweep.ini[:,] .*{sentence}"):
        plan(CHAIN.replace(part, new, 1))
    assert not list(Path("results").glob("sweeps/*/*"))


def test_a_list_of_a_file_is_a_number_of_a_shape(plan):
    text = "[sweep]\n[commands]\nstrength = analyze strength {values} --json\n"
    rest = "[values]\nsigma-bar = 0, 0.1\n[quantities]\nm = strength.mu_bar_eff\n"
    assert plan(text + rest).units["m"] == "1"
    of_file = plan(CHAIN.replace("stress s.h5", "strength s.h5") + "m = stress.mu_bar_eff")
    assert of_file.units["m"] == "1"


def test_a_logarithmic_axis_has_positive_numbers(plan):
    log = CHAIN.replace("[sweep]", "[sweep]\naxis = log")
    assert plan(log).axis == "log"
    assert plan(log.replace(VALUES, f"{VALUES}\nsigma-bar = 0")).axis == "log"  # it has no axis
    with pytest.raises(UsageError, match="sweep.ini, line 2: tau-bar is 0: a logarithmic axis has"):
        plan(log.replace(VALUES, "tau-bar = 0, 0.1"))


def test_what_a_variant_sets_varies_with_it(plan):
    text = CHAIN.replace("[quantities]", "[variant a]\njunctions.t_R = 1ms\n[quantities]")
    text = text.replace("[quantities]", "[variant b]\njunctions.t_R = 2ms\n[quantities]")
    sweep = plan(text)
    assert sweep.varied == ["variant", "tau-bar"]
    assert sweep.typed == {"variant": "", "tau-bar": "", "junctions.t_R": "ms"}
    both = text.replace("t_R = 2ms", "t_R = 2ms, 3ms")
    assert plan(both).varied == ["variant", "tau-bar", "junctions.t_R"]


def test_what_cannot_be_named_read_or_written_is_said_with_the_file(plan, tmp_path):
    with pytest.raises(UsageError, match="rename the file: its results take its name"):
        plan(CHAIN, "my sweep")
    with pytest.raises(Failure, match="^none.ini: No such file"):
        OwnSweep(Path("none.ini"))
    Path("results").touch()
    with pytest.raises(Failure, match="results/rupture-results: Not a directory$"):
        plan(CHAIN)


@pytest.mark.parametrize("ending", [".ini", ".csv", ".hdf5", ".png", ".pdf"])
def test_files_of_the_user_are_not_replaced(plan, ending):
    plan(CHAIN)
    plan(CHAIN)  # what is ours is
    mine = Path(f"results/sweeps/other/other{ending}")
    mine.parent.mkdir()
    mine.write_text("mine")
    with pytest.raises(UsageError, match=f"^/.*/other.ini: {mine} is not in results"):
        plan(CHAIN, "other")
    assert ([*mine.parent.iterdir()], mine.read_text()) == ([mine], "mine")
    assert mine.name not in Path("results/rupture-results").read_text()
