"""The program `rupture golden` by itself, with the built tools."""

import subprocess
import tempfile
import unittest
from pathlib import Path

from conftest import BIN as TOOLS, ROOT as SOURCE

INI = SOURCE / "tests/regression/project/my_slider.ini"
PREPARE = f"prepare -q --config {INI} --tau-bar 0.5 --sigma-bar 0.15 "
TWO = PREPARE + "-o a.h5\n" + PREPARE + "--seed 2 -o b.h5\n"
COPY = f'test -z "$(ls)"\ncp {SOURCE}/checkpoints/fast-only.h5 "$1"\n'


class Golden(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.program = TOOLS / "golden"

    def golden(self, *arguments):
        return subprocess.run(
            [self.program, *arguments],
            cwd=self.folder,
            capture_output=True,
            text=True,
            check=False,
        )

    def run_pipeline(self, command, commands, *arguments):
        path = self.folder / "pipeline"
        path.write_text("#!/bin/sh\nset -e\n" + commands, encoding="utf-8")
        path.chmod(0o755)
        return self.golden(command, "golden.sums", "./pipeline", *arguments)

    def check(self, commands=TWO, *arguments):
        return self.run_pipeline("check", commands, *arguments)

    def regenerate(self, commands=TWO, *arguments):
        run = self.run_pipeline("regenerate", commands, *arguments)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return run.stdout

    def sums(self, name="golden.sums"):
        return (self.folder / name).read_text(encoding="utf-8")

    def change_sums(self, old, new):
        (self.folder / "golden.sums").write_text(self.sums().replace(old, new), encoding="utf-8")

    def assert_fails(self, run, *parts):
        self.assertEqual(run.returncode, 1, run)
        for part in parts:
            self.assertIn(part, run.stdout + run.stderr)


class Checking(Golden):
    def test_what_was_regenerated_is_equal_and_kept(self):
        self.regenerate()
        self.assertTrue(self.sums().startswith("content-sha256 "))
        run = self.check()
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(run.stdout, "2 of 2 content checksums are equal.\n")
        kept = self.folder / "golden.sums.files"
        names = {str(path.relative_to(kept)) for path in kept.rglob("*")}
        self.assertEqual(names, {"rupture-golden.lock", "equal", "equal/a.h5", "equal/b.h5"})
        self.change_sums("content-sha256 ", "")  # as earlier versions wrote them
        self.assertEqual(self.check().returncode, 0)

    def test_a_file_that_differs_is_named_with_the_command_that_compares_it(self):
        self.regenerate()
        run = self.check(TWO.replace("--seed 2", "--seed 3"))
        self.assert_fails(run, "1 of 2 content checksums are equal, all but: b.h5\n")
        self.assertIn("  differs  b.h5\n    golden ", run.stdout)
        compare = next(line for line in run.stdout.splitlines() if " diff " in line)
        said = subprocess.run(compare, shell=True, capture_output=True, text=True, check=False)
        self.assertEqual((said.returncode, said.stderr), (1, ""))
        self.assertIn("/parameters/numerics/seed", said.stdout)

    def test_no_comparison_is_offered_with_a_file_that_has_another_checksum(self):
        self.regenerate()
        self.change_sums(self.sums().split()[1], "0" * 64)
        run = self.check()
        self.assert_fails(run, "all but: a.h5\n")
        self.assertNotIn(" diff ", run.stdout)

    def test_missing_and_new_files_are_named(self):
        self.regenerate()
        run = self.check(PREPARE + "-o a.h5\n" + PREPARE + "-o 'c d.h5'\n")
        self.assert_fails(run, "1 of 2 content checksums are equal, all but: b.h5 c d.h5\n")
        self.assertIn("  missing  b.h5\n  new      c d.h5\n", run.stdout)

    def test_a_damaged_file_is_named_with_what_is_wrong(self):
        self.regenerate()
        damage = TWO + "printf x | dd of=b.h5 bs=1 seek=9000 conv=notrunc status=none\n"
        self.assert_fails(self.check(damage), "  damaged  b.h5\n", "analyze: b.h5")
        run = self.run_pipeline("regenerate", damage)
        self.assert_fails(run, "b.h5 is damaged, so ")
        self.assertEqual(self.check().returncode, 0)

    def test_arguments_reach_the_pipeline_and_its_folder_is_fresh(self):
        self.regenerate(COPY, "a.h5")
        self.assertEqual(self.check(COPY, "a.h5").returncode, 0)
        for _ in range(2):
            self.assert_fails(self.check(COPY, "b.h5"), "missing  a.h5")

    def test_a_pipeline_may_say_that_it_cannot_be_run_here(self):
        self.regenerate()
        run = self.check("echo no such processor; exit 77\n")
        self.assertEqual((run.returncode, run.stdout), (77, "no such processor\n"))

    def test_the_tools_are_found_beside_the_program(self):
        self.program = self.folder / "bin/golden"
        self.program.parent.mkdir()
        for name in ("golden", "prepare", "analyze"):
            self.program.with_name(name).symlink_to(TOOLS / name)
        self.regenerate(f'test "$(command -v prepare)" = {self.folder}/bin/prepare\n' + TWO)
        self.assertEqual(len(self.sums().splitlines()), 2)


class Regenerating(Golden):
    def test_every_old_golden_file_is_kept(self):
        written = []
        for name in ("a.h5", "b.h5", "c.h5"):
            self.regenerate(COPY, name)
            written.append(self.sums())
        self.assertEqual([self.sums(f"golden.sums.old{n}") for n in (1, 2)], written[:2])
        self.assertEqual(self.check(COPY, "c.h5").returncode, 0)

    def test_an_equal_golden_file_stays_as_it_is(self):
        self.regenerate()
        before = (self.folder / "golden.sums").stat().st_mtime_ns
        self.assertIn("is current", self.regenerate())
        self.assertEqual((self.folder / "golden.sums").stat().st_mtime_ns, before)
        self.assertEqual(list(self.folder.glob("golden.sums.old*")), [])

    def test_a_pipeline_that_fails_changes_nothing(self):
        self.regenerate()
        before = self.sums()
        run = self.run_pipeline("regenerate", PREPARE + "-o c.h5\nexit 3\n")
        self.assert_fails(run, "the pipeline failed with exit code 3: ")
        self.assertEqual(self.sums(), before)


class Refusing(Golden):
    def test_pipelines(self):
        self.regenerate()
        for commands, *parts in (
            ("load --until never -o a.h5\n", "the pipeline failed with exit code 2: ", "load: "),
            ("exit 0\n", "the pipeline wrote no *.h5 in its working folder"),
        ):
            self.assert_fails(self.check(commands), *parts)
        run = self.golden("check", "golden.sums", "./absent")
        self.assert_fails(run, "absent cannot be run: give a program")

    def test_no_golden_file(self):
        self.assert_fails(self.check(), "there is no golden file ")
        run = self.golden("--work", "mine", "check", "golden.sums", "./pipeline")
        again = run.stderr.split("write it with: ")[1]
        subprocess.run(again, shell=True, cwd=self.folder, check=True, capture_output=True)
        self.assertEqual(self.check().returncode, 0)

    def test_golden_files_that_are_none(self):
        form = "has a line that is not 'content-sha256 <64 hex digits>  <file>.h5': "
        for text, part in (
            ("", "names no files"),
            ("abc  a.h5\n", form + "abc  a.h5"),
            ("0" * 64 + "  a.txt\n", form),
        ):
            (self.folder / "golden.sums").write_text(text, encoding="utf-8")
            self.assert_fails(self.check(), part)

    def test_folders(self):
        self.regenerate()
        (self.folder / "mine/found").mkdir(parents=True)
        run = self.golden("check", "--work", "mine", "golden.sums", "./pipeline")
        self.assert_fails(run, "has a 'found' or 'equal' that another")
        self.assertTrue((self.folder / "mine/found").exists())
        again = "flock", "golden.sums.files/rupture-golden.lock", *run.args[:2], *run.args[4:]
        run = subprocess.run(again, cwd=self.folder, capture_output=True, text=True, check=False)
        self.assert_fails(run, "another run uses ")
        run = self.golden("check", "--tools", self.folder, "golden.sums", "./pipeline")
        self.assert_fails(run, "no rupture tools in ")

    def test_command_lines(self):
        for arguments in (
            (),
            ("check",),
            ("check", "a.sums"),
            ("list", "a", "b"),
            ("check", "--x"),
        ):
            run = self.golden(*arguments)
            self.assertEqual((run.returncode, run.stdout), (2, ""))
            self.assertIn("see rupture golden --help", run.stderr)
