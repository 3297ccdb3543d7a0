"""A user's sweep: what its file says, and what is refused before anything is computed
(recipes/sweeps)."""

import shutil
import time
import unicodedata
from pathlib import Path

import pytest

import rupture
from conftest import ROOT
from rupture.errors import Failure, UsageError
from sweeps.sweep import Sweep

BASE = ROOT / "checkpoints/fast-only.h5"
SWEEP = """[sweep]
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


@pytest.fixture(name="read")
def sweep_with_this_text(folder):
    shutil.copyfile(BASE, "base.h5")

    def read(text, name="sweep"):
        Path(f"{name}.ini").write_text(text, encoding="utf-8")
        return Sweep(folder / f"{name}.ini")

    return read


def words(sweep, command=0, number=0):
    """Of a command of a point."""
    return sweep.words(sweep.commands[command], sweep.points[number])


# --- what is taken ----------------------------------------------------------------------------


def test_units_and_headings_are_settled(read):
    text = SWEEP.replace(VALUES, f"{VALUES}\njunctions.t_R = 1 to 2 ms\njunctions.law = reference")
    text += "speed [m/s] = front.v_c.3\nF_T = stress.F_T\n"
    again = "--until-quiet --set junctions.t_R=2e-3"  # a later command may set what varies
    sweep = read(text.replace("--until-quiet", again).replace("= analyze", "= rupture analyze"))
    expected = {"tau-bar": "1", "junctions.t_R": "s", "junctions.law": "", "type": ""}
    assert sweep.units == expected | {"speed": "m/s", "F_T": "N"}
    assert sweep.columns["speed"] == "front.v_c.3"
    typed = "prepare --tau-bar 0.2 --set junctions.t_R=2ms --set junctions.law=reference -o s.h5"
    assert words(sweep, 0, -1) == [*typed.split(), "--quiet"]


def test_varied_are_values_that_differ_and_do_not_follow_others(read):
    values = f"{VALUES}\nsigma-bar = 0.01\nseed = 10 * {{tau-bar}}\nshape = uniform, bell"
    assert read(SWEEP.replace(VALUES, values)).varied == ["tau-bar", "shape"]


ALONG_X = "0.5 from 70mm to 84mm"
INNOCENT = [  # what of SWEEP is replaced by what, and words of the first command
    ("{values}", "--tau-bar {tau-bar}", "--tau-bar 0.1"),
    ("{values}", "'--set=junctions.mu_s={tau-bar}' --tau-bar 1", "--set=junctions.mu_s=0.1"),
    (VALUES, f"{VALUES}\njunctions.mu_s = {ALONG_X}", f"--set|junctions.mu_s={ALONG_X}"),
    (
        VALUES,
        f"{VALUES}\njunctions.mu_s = {ALONG_X} and 2 * {{tau-bar}} from 0 to 7mm",
        f"--set|junctions.mu_s={ALONG_X}|--set|junctions.mu_s=0.2 from 0 to 7mm",
    ),
    (
        "{values}",
        f"{{values}} --set 'junctions.mu_s={ALONG_X}' --set 'junctions.mu_s=0.3 from 0mm to 7mm'",
        f"--set|junctions.mu_s={ALONG_X}|--set|junctions.mu_s=0.3 from 0mm to 7mm",
    ),
    (VALUES, f"{VALUES}\nn = 2\nseed = {{n}} ** 2", "--seed 4"),
    (VALUES, "tau-bar = -0.1", "--tau-bar -0.1"),
    ("prepare {values}", "load --until 'F_T > {tau-bar}kN'", "--until|F_T > 0.1kN"),
]


@pytest.mark.parametrize("part, new, expected", INNOCENT)
def test_what_is_innocent_is_taken(read, part, new, expected):
    found = words(read(SWEEP.replace(part, new, 1)))
    wanted = expected.split("|") if "|" in expected else expected.split(" ")
    assert any(found[n : n + len(wanted)] == wanted for n in range(len(found)))


def test_what_varies_along_x_at_some_point_is_known(read):
    Path("p.csv").write_text("x [mm],junctions.t_R [ms]\n0,2\n140,1\n")
    options = "{values} --profile p.csv --set=junctions.mu_d=0.2 --set junctions.kappa=1e9,2e9"
    values = f"{VALUES}\njunctions.mu_s = {ALONG_X} and 0.3 from 0 to 7mm"
    text = SWEEP.replace("{values}", options).replace(VALUES, values)
    lines = {row["name"]: found for row, found in read(text).along_x}
    assert [*lines] == ["junctions.mu_s", "junctions.kappa", "junctions.t_R"]
    parts = ([0.07, 0.084], [0.5, 0.5]), ([0, 0.007], [0.3, 0.3])
    assert lines["junctions.mu_s"] == [*parts, ([0, 0.14], [0.4, 0.4])]
    assert lines["junctions.t_R"] == [([0, 0.14], [0.002, 0.001])]
    assert not read(SWEEP).along_x
    rupture.run("restart", "base.h5", output="patch.h5", for_=0, set={"junctions.mu_s": ALONG_X})
    text = SWEEP.replace("[sweep]", "[sweep]\nbase = patch.h5").replace("prepare", "restart {base}")
    text = text.replace("{values}", "{values} --for 0").replace("tau-bar = 0.1, 0.2", "seed = 1, 2")
    ((row, ((x, line),)),) = read(text).along_x
    assert (row["name"], len(x), {*line}) == ("junctions.mu_s", 57, {0.4, 0.5})
    assert not read(text.replace("seed", "junctions.mu_s")).along_x


def test_columns_of_a_table_may_be_named_in_braces_and_have_blanks_and_quotes(read):
    Path("p.csv").write_text('t end [ms],name,tau-bar\n10,"a ""b"" \'c\'",0.1\n')
    text = SWEEP.replace("[sweep]", "[sweep]\npoints = p.csv").replace(f"[values]\n{VALUES}\n", "")
    Path("a \"b\" 'c'.csv").write_text("x,junctions.mu_s\n0,0.4\n")
    text = text.replace("--until-quiet", "--for {t end} --profile {name}.csv")
    sweep = read(text, "a sweep with blanks")
    assert words(sweep, 1)[2:6] == ["--for", "10ms", "--profile", "a \"b\" 'c'.csv"]
    assert (sweep.units["t end"], sweep.units["name"]) == ("s", "")


def test_names_of_the_same_look_are_the_same(read):
    apart, micro, mu = unicodedata.normalize("NFD", "größe"), "\u00b5", "\u03bc"
    shutil.move("base.h5", f"{apart}.h5")
    Path("größe.csv").write_text(f"driving.V [{micro}m/s]\n3\n", encoding="utf-8")
    text = f"[sweep]\nbase = größe.h5\npoints = {apart}.csv\n[commands]\n"
    text += f"r = restart {{base}} {{values}} --for {{größe}} --quiet-time {{{mu}}} -o e.h5\n"
    text += f"s = analyze stress e.h5\n[values]\n{micro} = 1{mu}s\n{apart} = 1ms\n"
    sweep = read(text + f"[quantities]\n{apart}n = s.F_T\n")
    typed = f"--set driving.V=3{micro}m/s --for 1ms --quiet-time 1{micro}s -o e.h5"
    assert words(sweep)[2:] == typed.split(" ")
    assert sweep.units["größen"] == "N"


def test_what_a_variant_sets_varies_with_it(read):
    text = SWEEP.replace("[quantities]", "[variant a]\njunctions.t_R = 1ms\n[quantities]")
    text = text.replace("[quantities]", "[variant b]\njunctions.t_R = 2ms\n[quantities]")
    sweep = read(text)
    assert sweep.varied == ["variant", "tau-bar"]
    assert sweep.typed == {"variant": "", "tau-bar": "", "junctions.t_R": "ms"}
    both = text.replace("t_R = 2ms", "t_R = 2ms, 3ms")
    assert read(both).varied == ["variant", "tau-bar", "junctions.t_R"]


def test_a_list_of_a_file_is_a_number_of_a_shape(read):
    text = "[sweep]\n[commands]\nstrength = analyze strength {values} --json\n"
    rest = "[values]\nsigma-bar = 0, 0.1\n[quantities]\nm = strength.mu_bar_eff\n"
    assert read(text + rest).units["m"] == "1"


def test_ten_thousand_points_are_checked_in_little_time(read):
    begun = time.process_time()
    sweep = read(SWEEP.replace(VALUES, "tau-bar = 0 to 0.3 in 100\nseed = 1 to 100"))
    assert len(sweep.points) == 10_000
    assert time.process_time() - begun < 4


# --- refusals ---------------------------------------------------------------------------------

RESERVED = ("values", "variant", "base", "status", "sentence", "point")
OWN_MEANING = "has a meaning of its own: take another name"
LATER = "\nb = restart e.h5 --until {front.t_rupture.8} -o b.h5"
REFUSED = [
    # what of SWEEP, is replaced by what, sentence
    ("type = front.type", "", "needs a section .quantities."),
    ("[sweep]", "[sweep]\nseeds = 1, 2", "\\[sweep\\] has no key 'seeds'"),
    ("[sweep]", "[chain]", "there is no section 'chain'"),
    ("[sweep]", "[sweep]\ntitle =", "line 2: 'title' in .sweep. has no value"),
    ("[sweep]", "[sweep]\ntitle = a\ntitle = b", "line 3: 'title' in .sweep. is there twice"),
    ("[sweep]", "x", "line 1: expected .SECTION. first"),
    (VALUES, "tau-bar", "line 8: expected NAME = VALUE or .SECTION. .got 'tau-bar'"),
    (VALUES, f"{VALUES}\n[values]", "line 9: the section .values. is there twice"),
    ("[sweep]", "[sweep]\ntitle = a\x1b]0;b", "line 2: there is a control character, U.001B"),
    (VALUES, "tau-bar = 0.1\u2028", "line 8: there is a control character, U.2028"),
    ("[sweep]", "[sweep]\npoints = p.csv", "p.csv: No such file"),
    ("[sweep]", "[sweep]\npoints = /dev/zero", "/dev/zero: it is no file of up to"),
    ("[sweep]", f"[sweep]\ntitle = {'x' * 201}", "longer than 200 letters"),
    (VALUES, f"{VALUES}\n=cmd|calc!A0 = 1", "expected NAME = VALUE"),
    ("{values}", "{values} --seed {@SUM}", "there is no '@SUM'"),
    (VALUES, f"{VALUES}\n@SUM = 1", "'@SUM' cannot be the heading of a column"),
    ("[sweep]", "[sweep]\npoints = empty.csv", "there are no points"),
    ("[sweep]", "[sweep]\npoints = one.csv", "'tau-bar' is a value and a column of the table"),
    ("[sweep]", "[sweep]\nbase = no.h5", "no.h5 does not exist"),
    ("[sweep]", "[sweep]\nbase = bad.h5", "the base cannot be used: .*bad.h5"),
    ("[sweep]", "[sweep]\nkeep = x.h5", "line 2: no command writes x.h5"),
    ("[sweep]", "[sweep]\nkeep = ../s.h5", "line 2: '../s.h5' is not the name of a file in"),
    ("[sweep]", "[sweep]\naxis = lg", "an axis is log or linear, not 'lg'"),
    ("[sweep]", "[sweep]\nmemory = 0 MB", "'memory = 0 MB': give a"),
    ("[sweep]", "[sweep]\nthreads = 1.5", "'threads = 1.5': give a"),
    # commands
    ("s.h5 --until-quiet", "{base} --until-quiet", "line 4: {base} needs base = FILE"),
    ("--until-quiet", "--fro 1", "restart has no option --fro: did you mean '--for'"),
    ("--until-quiet", "--record-every 1", "restart needs --until or --for or --until-quiet or "),
    ("-o s.h5", "", "prepare needs --tau-bar or --profile, which|needs --output, which"),
    ("front r.h5", "frnt r.h5", "unknown command 'frnt': did you mean 'front'"),
    ("front r.h5", "front t.h5", "there is no t.h5: no command before it writes it"),
    ("= prepare", "= prepar", "no program 'prepar': did you mean 'prepare'"),
    ("= prepare", "= ../x/prepare", "no program '../x/prepare'"),
    ("= prepare", "= {values} prepare", "no program 'values'"),
    ("{values}", "--tau-bar 1", "no command has {values}, nor {tau-bar}"),
    ("{values}", "x{values}", "{values} stands alone"),
    ("{values}", "{valus}", "'{valus}': there is no 'valus'; there are tau-bar"),
    ("{values}", "{values", "a brace is missing"),
    ("{values}", "{values} 'x", "cannot be split into words"),
    (
        "{values}",
        "{values} --seed {stress.F_T}",
        "line 3: 'stress.F_T': .commands. has no 'stress'",
    ),
    ("s.h5 --json", f"s.h5{LATER.replace('.8', '')}", "is a list: name one element"),
    ("s.h5 --json", f"s.h5{LATER.replace('.8', '[8]')}", "is no quantity, such as"),
    ("s.h5 --json", f"s.h5{LATER.replace('rupture', 'ruptur')}", "no 'front.t_ruptur.8': did"),
    ("-o e.h5", "-o s.h5", "two commands write s.h5"),
    ("-o s.h5", "-o s.h5 -qf", "write -qf as single options"),
    ("-o s.h5", "-o s.h5 --", "write -- as single options"),
    ("-o s.h5", "--output=../s.h5", "needs the name of a file in the point's own folder"),
    ("-o s.h5", "-o {tau-bar}/s.h5", "needs the name of a file in the point's own folder"),
    ("-o s.h5", "-o s.h5 --config x", "must not have --config"),
    ("-o e.h5", "-o e.h5 -f", "must not have -f: a point starts in an empty"),
    ("-o e.h5", "-o e.h5 --dry-run", "must not have --dry-run: it computes nothing"),
    ("front r.h5", "front r.h5 --also '--stencil 7'", "must not have --also"),
    ("{values}", "{values} --tau-bar=0.1", "cannot be specified more than once|tau-bar twice"),
    # values
    (VALUES, "", "there are no points"),
    (VALUES, f"{VALUES}\ntaubar = 1", "prepare has no option --taubar: did you mean '--tau-bar'"),
    (VALUES, f"{VALUES}\nstart = 1", "'start' is the name of a value, too"),
    *((VALUES, f"{VALUES}\n{name} = 1, 2", f"line 9: '{name}' {OWN_MEANING}") for name in RESERVED),
    (VALUES, f"{VALUES}\n[variant A]\nvariant = B", f"line 10: 'variant' {OWN_MEANING}"),
    ("[sweep]", "[sweep]\nkeep = s.h5\npoints = kept.csv", f"line 3: 's.h5' {OWN_MEANING}"),
    ("[sweep]", "[variant A]\n[sweep]\npoints = labels.csv", f"line 3: 'variant' {OWN_MEANING}"),
    (VALUES, "tau-bar = 0.1, high, 0.2", r"tau-bar must be a finite number \(got 'high'"),
    (VALUES, f"{VALUES}\njunctions.t_R = 2ms, nan", r"must be a finite number in s \(got '"),
    (VALUES, f"{VALUES}\njunctions.t_R = 2ms, 1mm", r"must be a finite number in s \(got '"),
    (VALUES, f"{VALUES}\ndriving.V = 1mm/s, 1e-3m/s", "two points have the same values"),
    (VALUES, f"{VALUES}\njunctions.t_R = 2ms, 4", "is unclear: 4 needs a unit, too"),
    (VALUES, f"{VALUES}\njunctions.law = reference, other", r"decaying or distance \(got 'other'"),
    (VALUES, f"{VALUES}\nshape = uniform, bel", r"must be uniform or bell \(got 'bel'\)"),
    (VALUES, f"{VALUES}\njunctions.mu_s = 0.5 from 1 to x", "a place of junctions.mu_s must be"),
    (
        " --json\n[values]",
        f"{LATER}\n[values]\nfront.t_rupture.8 = 1",
        "'front.t_rupture.8' is the",
    ),
    # values that would be options
    ("-o s.h5", "-o s.h5 {n}", "the value '-f' would be an option"),
    ("-o s.h5", "-o s.h5 --{n2}", "must not have --force"),
    ("-o s.h5", "-o s.h5 --shape {n}", "the value '-f' would be an option"),
    ("-o s.h5", "-o s.h5 --seed '{words}'", "must be a finite number .got '2 --force'"),
    ("-o s.h5", "-o {words}", "needs the name of a file"),
    (VALUES, f"{VALUES}\nseed = 1, 2, --force", "the value '--force' would be an option"),
    # quantities
    ("front.type", "front.slow.sped", "no 'front.slow.sped': did you mean 'front.slow.speed'"),
    ("front.type", "frnt.type", "no 'frnt': did you mean 'front'"),
    ("front.type", "loading.F_T.0", ".commands. has no 'loading'; it has start, restart"),
    ("front.type", "start.F_T", "'start' does not run analyze"),
    ("front.type", "front.v_c", "'front.v_c' is a list: name one element"),
    ("front.type", "1000 * front.slow.duration", "is no quantity, such as front.slow.speed"),
    ("type = front.type", "v [km/s] = front.c_s", "says .km/s., but front.c_s is in 'm/s'"),
    ("type = ", "v/c_s = ", "cannot be the heading"),
    ("type = ", "\u00b5 = front.c_s\n\u03bc = ", "'\u00b5' in .quantities. is there twice"),
]
OTHERS = "n = -f\nn2 = force\nwords = 2 --force\n"


@pytest.mark.parametrize("part, new, sentence", REFUSED)
def test_mistakes_are_refused_in_a_sentence_with_the_line(read, part, new, sentence):
    Path("bad.h5").write_bytes(BASE.read_bytes()[:-1])
    Path("empty.csv").touch()
    for name, heading in {"one": "tau-bar", "kept": "s.h5", "labels": "variant"}.items():
        Path(f"{name}.csv").write_text(f"{heading}\n0.1\n")
    assert part in SWEEP
    text = SWEEP.replace(part, new, 1)
    named = [line for line in OTHERS.splitlines() if f"{{{line.split(' = ')[0]}}}" in new]
    text = text.replace(VALUES, "\n".join([VALUES, *named]))
    with pytest.raises(UsageError, match=f"^/.*/sweep.ini[:,] .*({sentence})"):
        read(text)


@pytest.mark.parametrize("name", [".sweep", "a\x1bb", "a\nb", "\u754c" * 67])
def test_names_that_results_cannot_have_are_refused(read, name):
    with pytest.raises(UsageError, match="rename the file|control character"):
        read(SWEEP, name)


def test_a_file_that_cannot_be_read_is_named():
    with pytest.raises(Failure, match="^none.ini: No such file"):
        Sweep(Path("none.ini"))
