"""The program rupture-golden by itself, with the built tools.

golden_test.py SOURCE TOOLS
"""

import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE, TOOLS = Path(sys.argv[1]), Path(sys.argv[2])
PROGRAM = SOURCE / "src/tools/rupture-golden"
INI = SOURCE / "tests/regression/project/my_slider.ini"
PREPARE = f"prepare -q --config {INI} --tau-bar 0.5 --sigma-bar 0.15 "
SHIPPED = SOURCE / "checkpoints/fast-only.h5"


class Golden(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.pipeline("prepare_two", PREPARE + "-o a.h5\n" + PREPARE + "--seed 2 -o b.h5\n")

    def pipeline(self, name, commands):
        path = self.folder / name
        path.write_text("#!/bin/sh\nset -e\n" + commands, encoding="utf-8")
        path.chmod(0o755)

    def golden(self, *arguments):
        return subprocess.run(
            [PROGRAM, *arguments], cwd=self.folder, capture_output=True, text=True, check=False
        )

    def run_with(self, command, pipeline, *arguments):
        options = ["--tools", TOOLS, "golden.sums", self.folder / pipeline, *arguments]
        return self.golden(command, *options)

    def check(self, pipeline="prepare_two", *arguments):
        return self.run_with("check", pipeline, *arguments)

    def regenerate(self, pipeline="prepare_two", *arguments):
        return self.run_with("regenerate", pipeline, *arguments)

    def sums(self, name="golden.sums"):
        return (self.folder / name).read_text(encoding="utf-8")

    def assert_fails(self, run, sentence):
        self.assertEqual(run.returncode, 1, run)
        self.assertIn(sentence, run.stdout + run.stderr)


class Checking(Golden):
    def test_what_was_regenerated_is_equal_and_kept(self):
        self.assertEqual(self.regenerate().returncode, 0)
        run = self.check()
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(run.stdout, "2 of 2 content checksums are equal.\n")
        kept = self.folder / "golden.sums.files"
        self.assertEqual(
            sorted(p.name for p in (kept / "equal").iterdir()),
            ["a.h5", "b.h5"],
        )
        self.assertFalse((kept / "found").exists())

    def test_golden_files_of_earlier_versions_are_read(self):
        self.regenerate()
        self.assertTrue(self.sums().startswith("content-sha256 "))
        text = self.sums().replace("content-sha256 ", "")
        (self.folder / "golden.sums").write_text(text, encoding="utf-8")
        self.assertEqual(self.check().returncode, 0)

    def test_a_file_that_differs_is_named_with_the_command_that_compares_it(self):
        self.regenerate()
        self.pipeline("other", PREPARE + "-o a.h5\n" + PREPARE + "--seed 3 -o b.h5\n")
        run = self.check("other")
        self.assert_fails(run, "1 of 2 content checksums are equal, all but: b.h5\n")
        self.assertIn("  differs  b.h5\n    golden ", run.stdout)
        compare = next(line for line in run.stdout.splitlines() if " diff " in line)
        said = subprocess.run(compare, shell=True, capture_output=True, text=True, check=False)
        self.assertEqual((said.returncode, said.stderr), (1, ""))
        self.assertIn("/parameters/numerics/seed", said.stdout)

    def test_no_comparison_is_offered_with_a_file_that_has_another_checksum(self):
        self.regenerate()
        first = self.sums().split()[1]
        text = self.sums().replace(first, "0" * 64)
        (self.folder / "golden.sums").write_text(text, encoding="utf-8")
        run = self.check()
        self.assert_fails(run, "all but: a.h5\n")
        self.assertNotIn(" diff ", run.stdout)

    def test_missing_and_new_files_are_named(self):
        self.regenerate()
        self.pipeline("other", PREPARE + "-o a.h5\n" + PREPARE + "-o 'c d.h5'\n")
        run = self.check("other")
        self.assert_fails(run, "1 of 2 content checksums are equal, all but: b.h5 c d.h5\n")
        self.assertIn("  missing  b.h5\n  new      c d.h5\n", run.stdout)

    def test_a_damaged_file_is_named_with_what_is_wrong(self):
        self.regenerate()
        damage = "printf x | dd of=b.h5 bs=1 seek=9000 conv=notrunc status=none\n"
        self.pipeline("other", PREPARE + "-o a.h5\n" + PREPARE + "--seed 2 -o b.h5\n" + damage)
        run = self.check("other")
        self.assert_fails(run, "  damaged  b.h5\n")
        self.assertIn("analyze: b.h5", run.stderr)
        self.assert_fails(self.regenerate("other"), "b.h5 is damaged, so ")
        self.assertEqual(self.check().returncode, 0)

    def test_arguments_reach_the_pipeline_and_its_folder_is_fresh(self):
        self.pipeline("copy", 'test -z "$(ls)"\ncp "$1" "$2"\n')
        self.assertEqual(self.regenerate("copy", SHIPPED, "a.h5").returncode, 0)
        self.assertEqual(self.check("copy", SHIPPED, "a.h5").returncode, 0)
        self.assert_fails(self.check("copy", SHIPPED, "b.h5"), "missing  a.h5")
        self.assert_fails(self.check("copy", SHIPPED, "b.h5"), "missing  a.h5")

    def test_a_pipeline_may_say_that_it_cannot_be_run_here(self):
        self.regenerate()
        self.pipeline("skipped", "echo no such processor; exit 77\n")
        run = self.check("skipped")
        self.assertEqual((run.returncode, run.stdout), (77, "no such processor\n"))

    def test_the_tools_are_found_beside_the_program(self):
        shutil.copytree(
            TOOLS, self.folder / "bin", ignore=shutil.ignore_patterns("*_test", "bench*")
        )
        shutil.copy(PROGRAM, self.folder / "bin")
        program = str(self.folder / "bin/rupture-golden")
        command = [program, "regenerate", "x.sums", "./prepare_two"]
        subprocess.run(command, cwd=self.folder, check=True, capture_output=True)
        self.assertEqual(len(self.sums("x.sums").splitlines()), 2)


class Regenerating(Golden):
    def test_every_old_golden_file_is_kept(self):
        self.pipeline("copy", 'cp "$1" "$2"\n')
        written = []
        for name in ("a.h5", "b.h5", "c.h5"):
            self.assertEqual(self.regenerate("copy", SHIPPED, name).returncode, 0)
            written.append(self.sums())
        self.assertEqual([self.sums(f"golden.sums.old{n}") for n in (1, 2)], written[:2])
        self.assertEqual(self.check("copy", SHIPPED, "c.h5").returncode, 0)

    def test_an_equal_golden_file_stays_as_it_is(self):
        self.regenerate()
        before = (self.folder / "golden.sums").stat().st_mtime_ns
        self.assertIn("is current", self.regenerate().stdout)
        self.assertEqual((self.folder / "golden.sums").stat().st_mtime_ns, before)
        self.assertEqual(list(self.folder.glob("golden.sums.old*")), [])

    def test_a_pipeline_that_fails_changes_nothing(self):
        self.regenerate()
        self.pipeline("failing", PREPARE + "-o c.h5\nexit 3\n")
        before = self.sums()
        self.assert_fails(self.regenerate("failing"), "the pipeline failed with exit code 3: ")
        self.assertEqual(self.sums(), before)


class Refusing(Golden):
    def test_a_pipeline_that_fails(self):
        self.regenerate()
        self.pipeline("failing", "load --until never -o a.h5\n")
        run = self.check("failing")
        self.assert_fails(run, "the pipeline failed with exit code 2: ")
        self.assertIn("load: ", run.stderr)

    def test_a_pipeline_that_writes_nothing(self):
        self.regenerate()
        self.pipeline("idle", "exit 0\n")
        self.assert_fails(self.check("idle"), "the pipeline wrote no *.h5 in its working folder")

    def test_a_pipeline_that_is_no_program(self):
        self.regenerate()
        self.assert_fails(self.check("absent"), "absent cannot be run: give a program")

    def test_no_golden_file(self):
        run = self.check()
        self.assert_fails(run, "there is no golden file ")
        again = run.stderr.split("write it with: ")[1]
        subprocess.run(again, shell=True, cwd=self.folder, check=True, capture_output=True)
        self.assertEqual(self.check().returncode, 0)

    def test_a_golden_file_that_is_none(self):
        for text, sentence in (
            ("", "names no file"),
            (
                "abc  a.h5\n",
                "has a line that is not 'content-sha256 <64 hex digits>  <file>.h5': abc  a.h5",
            ),
            ("0" * 64 + "  a.txt\n", "has a line that is not"),
        ):
            (self.folder / "golden.sums").write_text(text, encoding="utf-8")
            self.assert_fails(self.check(), sentence)

    def test_a_work_folder_with_files_of_others(self):
        self.regenerate()
        (self.folder / "mine/found").mkdir(parents=True)
        options = ["--tools", TOOLS, "--work", "mine", "golden.sums", "./prepare_two"]
        self.assert_fails(self.golden("check", *options), "has a 'found' or 'equal' that is not")
        self.assertTrue((self.folder / "mine/found").exists())

    def test_a_work_folder_in_use(self):
        self.regenerate()
        lock = self.folder / "golden.sums.files/rupture-golden.lock"
        command = f"flock {lock} {PROGRAM} check --tools {TOOLS} golden.sums ./prepare_two".split()
        run = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False)
        self.assert_fails(run, "another run uses ")

    def test_wrong_folder_of_tools(self):
        run = self.golden("check", "--tools", self.folder, "golden.sums", "./prepare_two")
        self.assert_fails(run, "there are no tools of rupture in ")

    def test_wrong_usage_prints_the_help(self):
        for arguments in (
            (),
            ("check",),
            ("check", "a.sums"),
            ("list", "a", "b"),
            ("check", "--x"),
        ):
            run = self.golden(*arguments)
            self.assertEqual(run.returncode, 2)
            self.assertIn("rupture golden check [OPTION]... GOLDEN PIPELINE", run.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
