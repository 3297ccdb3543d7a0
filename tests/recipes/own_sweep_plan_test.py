"""A user's sweep file becomes a plan (common/sweeps/plan.py): short form, units, refusals."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(os.environ.get("RUPTURE_BIN", ROOT / "build/release/bin"))
sys.path.insert(0, str(ROOT / "recipes/common"))

from sweeps.names import names_of  # noqa: E402
from sweeps.plan import make_plan, plan_sweep  # noqa: E402
from sweeps.sweep import SweepError, read_sweep  # noqa: E402

NAMES = names_of(BIN)
BASE = ROOT / "checkpoints/fast-only.h5"
PREPARED = "[sweep]\nprepare = --sigma-bar 0.1\nrestart = --until-quiet\n"
VALUES = "[values]\ntau-bar = 0.1, 0.2\n"
FRONT = "[quantities]\ntype = front.type\n"
LONG = "[commands]\nstart = prepare {values} -o s.h5\nmeasured = analyze stress s.h5 --json\n"
STRESS = "[quantities]\nF_T = measured.F_T\n"


class Planning(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def plan(self, text, name="sweep"):
        path = self.folder / f"{name}.ini"
        path.write_text(text, encoding="utf-8")
        return read_sweep(make_plan(path, NAMES, BIN, self.folder / "results"))

    def commands(self, text):
        return self.plan(text).points[0].commands

    def based(self, name="base.h5", source=BASE):
        shutil.copyfile(source, self.folder / name)
        return f"[sweep]\nbase = {name}\nrestart = --for 0.01\n"


class ShortForm(Planning):
    def test_prepared(self):
        expected = {
            "prepare": "prepare --sigma-bar 0.1 --tau-bar 0.1 -o start.h5 --quiet",
            "restart": "restart start.h5 --until-quiet -o end.h5 --record record.h5 --quiet",
            "front": "analyze front record.h5 --json",
        }
        self.assertEqual(self.commands(PREPARED + VALUES + FRONT), expected)

    def test_a_checkpoint_may_be_all_that_is_measured(self):
        commands = self.commands(
            "[sweep]\nprepare =\n[values]\ntau-bar = 0\n[quantities]\nF = stress.F_T"
        )
        self.assertEqual(list(commands.values())[1], "analyze stress start.h5 --json")

    def test_from_a_base(self):
        text = self.based() + "[values]\ndriving.V = 1e-4\nseed = 1\n" + FRONT
        command = self.commands(text)["restart"]
        pattern = (
            r"restart \S*/results/data/bases/[0-9a-f]{16}.h5 --for 0.01 --set driving.V=1e-4"
            r" --seed 1 -o end.h5 --record record.h5 --quiet"
        )
        self.assertRegex(command, pattern)

    def test_loaded(self):
        rest = "[values]\ndriving.V = 1e-4\n" + FRONT
        alone = self.commands("[sweep]\nload = --until 0.5\n" + rest)
        command = "load --until 0.5 --set driving.V=1e-4 -o end.h5 --record record.h5 --quiet"
        self.assertEqual(alone["load"], command)
        both = self.commands("[sweep]\nload = --until 0.5\nrestart = --for 0.1\n" + rest)
        command = "load --until 0.5 --set driving.V=1e-4 -o start.h5 --quiet"
        self.assertEqual((both["load"], "restart" in both), (command, True))

    def test_each_analysis_is_run_once_with_its_options(self):
        quantities = "[quantities]\nF = stress.F_T\nv = front.slow.speed\ntype = front.type\n"
        options = "[analyze]\nfront = --skip-below-x 0.0275\n"
        commands = self.commands(PREPARED + VALUES + quantities + options)
        self.assertEqual(list(commands), ["prepare", "restart", "front", "stress"])
        self.assertEqual(commands["front"], "analyze front record.h5 --skip-below-x 0.0275 --json")
        self.assertEqual(commands["stress"], "analyze stress end.h5 --json")

    def test_units(self):
        text = PREPARED + VALUES + "junctions.t_R = 1e-3\njunctions.law = reference\n"
        units = self.plan(
            f"{text}[quantities]\nv = front.v_c.3\ntype = front.type\nr = strength.mu_eff.0"
        ).units
        expected = {"tau-bar": "1", "junctions.t_R": "s", "junctions.law": ""}
        self.assertEqual(units, expected | {"v": "m/s", "type": "", "r": "1"})

    def test_points_depend_neither_on_the_order_of_quantities_nor_on_their_names(self):
        def ids(quantities):
            text = PREPARED + VALUES + f"[quantities]\n{quantities}\n"
            return [point.id for point in self.plan(text).points]

        first = ids("a = front.type\nb = stress.F_T")
        self.assertEqual(first, ids("F = stress.F_T\nspeed = front.slow.speed\ntype = front.type"))
        self.assertNotEqual(first, ids("a = front.type"))


class LongForm(Planning):
    def test_commands_stay_as_they_are(self):
        sweep = self.plan("[sweep]\n" + LONG + VALUES + STRESS)
        self.assertEqual(sweep.points[1].commands["start"], "prepare --tau-bar 0.2 -o s.h5")
        self.assertEqual((sweep.columns, sweep.units["F_T"]), ({"F_T": "measured.F_T"}, "N"))

    def test_headings_may_repeat_the_unit(self):
        sweep = self.plan("[sweep]\n" + LONG + VALUES + "[table]\nF_T [N] = measured.F_T\n")
        self.assertEqual((sweep.columns, sweep.units["F_T"]), ({"F_T": "measured.F_T"}, "N"))

    def test_every_kind_of_recipe_sweep_is_understood(self):
        for path in ("fig4/strength-curves.ini", "fig3/slow_slip.ini"):
            with self.subTest(path):
                recipe = read_sweep(ROOT / "recipes" / path)
                text = (ROOT / "recipes" / path).read_text(encoding="utf-8")
                text = re.sub(
                    r"^seeds .*\n", "", text, flags=re.MULTILINE
                )  # further tables, for units
                sweep = self.plan(text)
                self.assertEqual([p.id for p in sweep.points], [p.id for p in recipe.points])


class Bases(Planning):
    def ids(self, text):
        sweep = self.plan(text + "[values]\nseed = 1, 2\n" + FRONT)
        return [re.sub(r"\S*/results/", "", str(point.commands)) for point in sweep.points]

    def test_points_follow_the_content_and_not_the_name(self):
        first = self.ids(self.based("a.h5"))
        self.assertEqual(first, self.ids(self.based("b.h5")))
        self.assertNotEqual(
            first, self.ids(self.based("a.h5", ROOT / "checkpoints/second-slow.h5"))
        )

    def test_the_copy_has_its_checksum(self):
        self.ids(self.based())
        copy = next((self.folder / "results/data/bases").glob("*.h5"))
        checksum = subprocess.run(
            [BIN / "analyze", "checksum", copy], capture_output=True, text=True, check=True
        )
        self.assertEqual(
            Path(f"{copy}.sum").read_text(),
            f"content-sha256 {checksum.stdout.strip()}  {copy.name}\n",
        )
        self.assertTrue(checksum.stdout.startswith(copy.stem))


class TablesOfPoints(Planning):
    def table(self, content, folder="tables"):
        """The text of a sweep whose points are in points.csv, in a folder beside it."""
        (self.folder / folder).mkdir(exist_ok=True)
        (self.folder / folder / "points.csv").write_bytes(content)
        return f"[sweep]\nprepare =\nrestart = --until-quiet\npoints = {folder}/points.csv\n"

    def test_the_plan_has_its_own_copy(self):
        sweep = self.plan(self.table(b"tau-bar\n0.1\n0.2\n") + FRONT)
        (self.folder / "tables/points.csv").write_text("tau-bar\n0.3\n")
        again = read_sweep(self.folder / "results/sweeps/sweep/sweep.ini")
        self.assertEqual([point.id for point in sweep.points], [point.id for point in again.points])
        self.assertEqual(len(again.points), 2)

    def test_a_byte_order_mark_and_windows_lines_change_nothing(self):
        content = b"tau-bar,seed\n0.1,2\n"
        text = self.table(content) + FRONT
        expected = [point.id for point in self.plan(text).points]
        self.table(b"\xef\xbb\xbf" + content.replace(b"\n", b"\r\n"))
        found = self.plan("\ufeff" + text.replace("\n", "\r\n"))
        self.assertEqual([point.id for point in found.points], expected)

    def test_wrong_tables(self):
        wrong = {
            b"tau-bar,seed\n0.1\n": "points.csv, line 2: the number of cells is 1, in the first"
            " line 2",
            b"tau-bar,seed\n0.1,1\n\n0.2,1,5\n": "points.csv, line 4: the number of cells is 3",
            b"tau-bar,tau-bar\n0.1,1\n": "points.csv: each column needs a heading of its own",
            b"tau-bar,\n0.1,1\n": "points.csv: each column needs a heading of its own",
            b"tau-bar\n\xff\n": "points.csv is no table of CSV in UTF-8",
            b"tau-bar\n": "there are no points",
            b"": "there are no points",
        }
        for content, sentence in wrong.items():
            with self.subTest(sentence), self.assertRaisesRegex(SweepError, sentence):
                self.plan(self.table(content) + FRONT)

    def test_any_folder_will_do(self):
        for folder in ("a #b", "a ;b"):
            (self.folder / folder).mkdir()
            path = self.folder / folder / "sweep.ini"
            path.write_text(self.table(b"tau-bar\n0.1\n", folder).replace(f"{folder}/", "") + FRONT)
            sweep = read_sweep(make_plan(path, NAMES, BIN, self.folder / "results"))
            self.assertEqual(len(sweep.points), 1)


class Mistakes(Planning):
    def refuse(self, text, sentence, name="sweep"):
        with self.subTest(sentence):
            with self.assertRaisesRegex(ValueError, sentence):
                self.plan(text, name)
            self.assertFalse(list(self.folder.glob("results/sweeps/*/*")), "nothing is written")

    def test_sections_and_keys(self):
        self.refuse(VALUES + FRONT, "no section .sweep.")
        self.refuse(
            PREPARED + "[value]\na = 1\n" + FRONT, "no section 'value'; did you mean 'values'"
        )
        self.refuse(PREPARED + VALUES + FRONT + "[DEFAULT]\na = 1", "no section 'DEFAULT'")
        self.refuse(
            PREPARED + "tittle = x\n" + VALUES + FRONT, "key .* 'tittle'; did you mean 'title'"
        )
        self.refuse(PREPARED + VALUES, "needs a section .quantities.")
        self.refuse(PREPARED + VALUES + "[quantities]\n", "needs a section .quantities.")
        self.refuse(PREPARED + VALUES + "[quantities]\na =\n", "'a' in .quantities. has no value")
        self.refuse(
            "[sweep]\nprepare = x\n" + LONG + VALUES + STRESS, "no key in .sweep. 'prepare'"
        )
        self.refuse(
            PREPARED + VALUES + FRONT + "[analyze]\nslip = --x 0\n", "'slip', of which there is no"
        )
        self.refuse(
            PREPARED + "memory = much\n" + VALUES + FRONT, "'memory = much' is not understood"
        )
        self.refuse(PREPARED + "time = 1 h\n" + VALUES + FRONT, "no key in .sweep. 'time'")
        self.refuse(PREPARED + VALUES + FRONT, "the results get the name", name="my sweep")

    def test_starts(self):
        self.refuse("[sweep]\n" + VALUES + FRONT, "one of base, prepare and load.*it has none")
        self.refuse(PREPARED + "base = x.h5\n" + VALUES + FRONT, "it has base and prepare")
        self.refuse("[sweep]\nbase = x.h5\n" + VALUES + FRONT, "not how it goes on")
        self.refuse(
            "[sweep]\nprepare =\n" + VALUES + FRONT, "reads the record of a run, and there is none"
        )
        self.refuse(
            PREPARED.replace("--until-quiet", "-o x.h5") + VALUES + FRONT, "must not have 'o'"
        )
        self.refuse(
            PREPARED.replace("0.1", "0.1 --tau-bar 1") + VALUES + FRONT,
            "tau-bar is both in .values. and in 'prepare --sigma-bar",
        )
        self.refuse(
            PREPARED.replace("0.1", "0.1 --config x") + VALUES + FRONT, "must not have --config"
        )
        self.refuse(PREPARED.replace("0.1", "'") + VALUES + FRONT, "cannot be split into words")

    def test_options(self):
        self.refuse(
            PREPARED.replace("--until-quiet", "--fro 1") + VALUES + FRONT,
            "restart has no option 'fro'; did you mean 'for'",
        )
        self.refuse(
            PREPARED.replace("--until-quiet", "--record-every 1") + VALUES + FRONT,
            "restart needs --until or --for or --until-quiet, which",
        )
        self.refuse(
            PREPARED + VALUES + FRONT + "[analyze]\nfront = --slowbelow 0.1\n",
            "analyze front has no option 'slowbelow'; did you mean 'slow-below'",
        )
        self.refuse(
            PREPARED + "[values]\ntau-bar = 0\nsigma-bar = 1\n" + FRONT,
            "sigma-bar is both in .values. and in 'prepare",
        )
        self.refuse(
            "[sweep]\nprepare =\n[values]\nseed = 1\n" + STRESS.replace("measured", "stress"),
            "prepare needs --tau-bar, which",
        )
        self.refuse(
            PREPARED + VALUES + "[quantities]\nx = slip.x\n", "analyze slip needs --x, which"
        )
        self.refuse(
            "[sweep]\n" + LONG.replace("-o s.h5", "") + VALUES + STRESS,
            "prepare needs --output, which",
        )
        self.refuse(
            "[sweep]\n" + LONG.replace("prepare", "prepar") + VALUES + STRESS,
            "no program 'prepar'; did you mean 'prepare'",
        )

    def test_options_that_the_sweep_gives_or_that_compute_nothing(self):
        for option in ("-q", "--quiet", "--record x.h5", "--json"):
            text = PREPARED.replace("--until-quiet", f"--until-quiet {option}")
            self.refuse(text + VALUES + FRONT, "'restart' must not have '.*the sweep gives itself")
        for option in (
            "-f",
            "--force",
            "--resume",
            "--dry-run",
            "--help",
            "-h",
            "--version",
            "--describe",
        ):
            text = LONG.replace("-o s.h5", f"-o s.h5 {option}")
            self.refuse("[sweep]\n" + text + VALUES + STRESS, f"must not have {option}: ")
            text = PREPARED.replace("0.1", f"0.1 {option}")
            self.refuse(text + VALUES + FRONT, f"must not have {option}: ")

    def test_a_value_is_given_once(self):
        given = {
            "--set driving.V=1": "driving.V = 1, 2",
            "--set=driving.V=1": "driving.V = 1, 2",
            "--seed 1": "numerics.seed = 1, 2",
            "--set numerics.seed=1": "seed = 1, 2",
            "--sigma-bar=0.1": "sigma-bar = 0, 0.1",
        }
        for option, values in given.items():
            text = LONG.replace("{values}", f"{{values}} {option}") + VALUES + values + "\n"
            self.refuse("[sweep]\n" + text + STRESS, "is both in .values. and in 'prepare")
        self.refuse(
            self.based() + "[values]\nseed = 1\nnumerics.seed = 2\n" + FRONT, "are the same"
        )

    def test_a_later_command_may_set_again_what_varies(self):
        text = "[sweep]\nload = --until 0.5\nrestart = --for 0.1 --set driving.V=0\n"
        self.assertEqual(len(self.plan(text + "[values]\ndriving.V = 1, 2\n" + FRONT).points), 2)

    def test_bases(self):
        values = "[values]\nseed = 1\n"
        self.refuse(
            "[sweep]\nbase = no.h5\nrestart = --for 1\n" + values + FRONT, "no.h5 does not exist"
        )
        (self.folder / "bad.h5").write_bytes(BASE.read_bytes()[:-1])
        self.refuse(
            "[sweep]\nbase = bad.h5\nrestart = --for 1\n" + values + FRONT,
            "the base cannot be used: .*bad.h5",
        )
        record = ROOT / "tests/compatibility"
        record = next(
            path
            for path in sorted(record.rglob("*.h5"))
            if path.read_bytes().startswith(b"rupture-record\n")
        )
        self.refuse(
            self.based(source=record) + values + FRONT, "is a record; runs go on from checkpoints"
        )

    def test_values(self):
        self.refuse(PREPARED + FRONT, "no points")
        self.refuse(PREPARED + "[values]\n" + FRONT, "no points")
        self.refuse(
            PREPARED + "[values]\ndriving.v = 1\n" + FRONT,
            "no parameter 'driving.v'; did you mean 'driving.V'",
        )
        self.refuse(
            PREPARED + "[values]\ntaubar = 1\n" + FRONT,
            "prepare has no option 'taubar'.*did you mean 'tau-bar'",
        )
        self.refuse(PREPARED + "[values]\nuntil = 1\n" + FRONT, "prepare has no option 'until'")
        self.refuse(
            PREPARED + "[values]\ntau-bar = 0.1, high\n" + FRONT,
            "tau-bar is a finite number, which 'high' is not",
        )
        self.refuse(
            PREPARED + "[values]\njunctions.t_R = 1ms\n" + FRONT,
            "junctions.t_R is a finite number in s, written without it, which '1ms' is not",
        )
        for value in ("nan", "inf", "-inf", "1e999"):
            text = PREPARED + f"[values]\ntau-bar = 0.1, {value}\n" + FRONT
            self.refuse(text, "tau-bar is a finite number, which")
        for values in ("0.1, 0.1", "1, 1.0", "1e-4, 0.0001"):
            text = PREPARED + f"[values]\ntau-bar = {values}\n" + FRONT
            self.refuse(text, "a point is there twice")
        self.refuse(PREPARED + "points = p.csv\n" + FRONT, "no table of points .*p.csv")
        self.refuse(
            "[sweep]\n" + LONG.replace("{values}", "--tau-bar 1") + VALUES + STRESS,
            "no command has {values}",
        )

    def test_words(self):
        for value in ("uniform bell", "'uniform'", "$HOME", "a;b"):
            self.refuse(
                PREPARED + VALUES + f"shape = {value}\n" + FRONT,
                "is no value of shape: use one word",
            )

    def test_quantities(self):
        def with_quantity(text):
            return PREPARED + VALUES + f"[quantities]\n{text}\n"

        self.refuse(
            with_quantity("v = front.slow.sped"),
            "no 'front.slow.sped'; did you mean 'front.slow.speed'",
        )
        self.refuse(with_quantity("v = frnt.type"), "no 'frnt.type'; did you mean 'front.type'")
        self.refuse(
            with_quantity("v = front.v_c"), "is a list: name one of its elements, as in front.v_c.0"
        )
        self.refuse(with_quantity("v = strength.mu_bar_eff"), "is a list")
        self.refuse(with_quantity("v = steady-state.p"), "reads no file of the points")
        self.refuse(
            with_quantity("v [km/s] = front.c_s"), "says .km/s., but front.c_s has the unit 'm/s'"
        )
        for heading in ("v/c_s", "status"):
            self.refuse(with_quantity(f"{heading} = front.c_s"), "cannot be the heading")
        self.refuse(
            with_quantity("tau-bar = front.type"), "'tau-bar' is in .values. and the heading"
        )
        self.refuse(
            "[sweep]\n" + LONG + VALUES + "[quantities]\na = mesured.F_T",
            "no command 'mesured'; did you mean 'measured'",
        )
        self.refuse(
            "[sweep]\n" + LONG + VALUES + "[quantities]\na = start.F_T", "no `analyze ... --json`"
        )
        self.refuse(
            "[sweep]\n" + LONG.replace("measured", "status") + VALUES + STRESS,
            "cannot be called 'status'",
        )

    def test_what_cannot_be_read_or_written_is_said_with_the_file(self):
        def said(path, results):
            with self.assertRaises(SweepError) as caught:
                plan_sweep(path, BIN, results)
            return str(caught.exception)

        path, file = self.folder / "none.ini", self.folder / "file"
        sentence = f"{path}: it cannot be read (No such file or directory)"
        self.assertEqual(said(path, self.folder), sentence)
        path.write_text(PREPARED + VALUES + FRONT)
        file.write_text("")
        sentence = f"{file}/sweeps/none/none.ini cannot be written (Not a directory)"
        self.assertEqual(said(path, file), f"{path}: {sentence}")


class Programs(unittest.TestCase):
    def test_every_measured_file_is_a_record_or_a_checkpoint(self):
        known = {name.split(".")[0] for name in NAMES.quantities}
        inputs = {name: NAMES.programs[f"analyze {name}"].input for name in known}
        reading = {name for name, kind in inputs.items() if kind in ("record", "checkpoint")}
        self.assertEqual(known, {*reading, "steady-state"})

    def test_each_is_asked_once(self):
        names = names_of(BIN)
        with mock.patch("subprocess.run", side_effect=subprocess.run) as run:
            for program in ("prepare", "analyze front", "analyze slip", "prepare"):
                self.assertTrue(names.programs[program].long_names["help"])
        asked = [call.args[0] for call in run.call_args_list]
        self.assertEqual(asked, [[BIN / tool, "--describe"] for tool in ("prepare", "analyze")])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
