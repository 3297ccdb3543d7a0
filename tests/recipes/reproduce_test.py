"""./reproduce.sh itself: what may be typed, where it runs, and which tests it calls slow."""

import io
import os
import re
import subprocess
import sys
import unittest
from unittest.mock import patch

from stand_ins import ROOT, Project, write_program

sys.path.insert(0, str(ROOT / "recipes/common"))

from reproduce.checks import defines_layout, slowest_tests  # noqa: E402
from reproduce.pipeline import Errors  # noqa: E402
from reproduce.place import count_cores, memory_of_allocation  # noqa: E402


class CommandLine(Project):
    def refuse(self, arguments, sentence):
        done = self.call(*arguments)
        self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
        self.assertRegex(done.stderr, f"^reproduce.sh: {sentence}")

    def test_wrong_calls_are_usage_errors_of_one_sentence(self):
        for arguments, sentence in (
            (["sweep"], "'sweep' needs one file"),
            (["sweep", "a.ini", "b.ini"], "'sweep' needs one file"),
            (["sweep", "a.ini", "--from-scratch"], "--from-scratch is for figures"),
            (["--dry-run", "fig3"], "--dry-run is for 'sweep' only"),
            (["fig3", "--cores", "0"], "--cores needs a whole number from 1, not '0'"),
            (["fig3", "--cores=1e9"], "--cores needs a whole number from 1, not '1e9'"),
            (["fig3", "--cores"], "--cores needs a value"),
            (["fig3", "--fast"], "there is no option '--fast'"),
            (["fig3", "--from"], "there is no option '--from'"),
            (["fig3", "--dry-run=1"], "--dry-run takes no value"),
            (["fig3", "--profile", "nope"], "--profile 'nope' is none: .*/nope/config.yaml does"),
            (["fig3", "--profile="], "--profile '' is none"),
            (["fig3", "--programs", "/nope"], "--programs '/nope' is no folder with rupture's"),
            (["fig3", "--programs="], "--programs '' is no folder"),
        ):
            with self.subTest(arguments):
                self.refuse(arguments, f"{sentence}.*See --help.\n$")

    def test_what_there_is_follows_an_unknown_name(self):
        there_are = r"There are:\n  (choices|convergence) "
        self.refuse(["fig33"], f"there is no figure or command 'fig33'. {there_are}")
        self.refuse(["test", "fig3"], "'test' cannot be combined with other commands. There are:")

    def test_help_and_list(self):
        done = self.call("fig3", "-h")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout.startswith("Usage: ./reproduce.sh COMMAND"))
        done = self.call()
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertTrue(done.stderr.startswith("Usage: ./reproduce.sh COMMAND"))
        names = re.findall(r"^  (\S+) ", self.call("list").stdout, re.M)
        self.assertEqual(names[names.index("fig1") :][:3], ["fig1", "fig2", "fig3"])

    def test_modules_in_the_users_folder_are_not_taken_for_ours(self):
        for name in ("data", "queue", "sweeps"):
            (self.root / f"{name}.py").write_text("raise RuntimeError\n")
        self.assertEqual(self.call("list").returncode, 0)
        self.refuse(["sweep", "none.ini", "--programs", "bin"], "--programs 'bin' is no folder")

    def test_what_cannot_be_written_is_said(self):
        (self.root / "build").touch()
        done = self.call("report")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("build cannot be written (Not a directory).", done.stderr)

    def make(self, *files):
        for path in (self.root / name for name in files):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f"\nCMAKE_HOME_DIRECTORY:INTERNAL={self.root.resolve()}\n")

    def test_clean_deletes_what_was_written_here_and_names_the_rest(self):
        self.make("disk/a", "results/a", "results/x/y", "results/mine", "mine", ".snakemake/z")
        self.make("build/release/CMakeCache.txt", "build/other/o")
        (self.root / "results/disk").symlink_to("../disk")
        (self.root / "results/link").symlink_to("../mine")
        listed = "a x/y disk/a link ../mine /etc/hostname".replace(" ", "\n")
        (self.root / "results/.rupture-files").write_text(f"{listed}\n\n.\n")
        deleted, _, *left = self.call("clean").stdout.splitlines()
        self.assertEqual(deleted, "Deleted 2 files in results/, .snakemake/, build/release/.")
        kept = ["results/disk -> ../disk", "results/link -> ../mine", "results/mine"]
        self.assertEqual(left, [f"  {name}" for name in (*kept, "build/other/o")])
        for name in ("disk/a", "mine", *(one.split()[0] for one in kept)):
            self.assertTrue((self.root / name).exists(), name)
        self.assertFalse((self.root / "results/x").exists())

    def test_clean_follows_no_link(self):
        self.make("disk/a", "disk/release/CMakeCache.txt")
        (self.root / "disk/.rupture-files").write_text("a\n")
        for name in ("results", "build"):
            (self.root / name).symlink_to("disk")
        self.assertIn("Nothing was deleted.\n", self.call("clean").stdout)
        self.assertTrue((self.root / "disk/a").exists())
        self.assertTrue((self.root / "disk/release/CMakeCache.txt").exists())

    def test_standard_output_that_takes_nothing_is_said(self):
        for to, reason in (("/dev/full", "No space left on device"), ("&-", "Bad file descriptor")):
            command = ["bash", "-c", f"./reproduce.sh list >{to}"]
            done = subprocess.run(command, cwd=self.root, stderr=subprocess.PIPE, text=True)
            sentence = f"reproduce.sh: standard output: {reason}.\n"
            self.assertEqual((done.returncode, done.stderr), (1, sentence))

    def test_notes_about_the_profile_are_hidden(self):
        with patch("sys.__stderr__", io.StringIO()) as shown:
            errors = Errors()
            for line in ("Using profile local for ...", "another"):
                print(line, file=errors)
        self.assertEqual(shown.getvalue(), "another\n")

    def test_nothing_is_made_for_help_and_mistakes(self):
        before = sorted(self.root.iterdir())
        for arguments in (["-h"], ["list"], ["nope"]):
            self.call(*arguments)
        self.assertEqual(sorted(self.root.iterdir()), before)


class Places(unittest.TestCase):
    def test_cores_of_all_nodes(self):
        for text, cores in (("2", 2), ("16(x3)", 48), ("16(x2),8", 40), ("1,2(x2),3", 8)):
            self.assertEqual(count_cores(text), cores)

    def test_memory_as_far_as_it_is_known(self):
        per_core = {"SLURM_MEM_PER_CPU": "500"}
        per_node = {"SLURM_MEM_PER_NODE": "3000", "SLURM_JOB_NUM_NODES": "2"}
        self.assertEqual(memory_of_allocation(per_core, 4), 2000)
        self.assertEqual(memory_of_allocation(per_node, 4), 6000)
        self.assertIsNone(memory_of_allocation({}, 4))


class Checks(Project):
    def test_the_ten_that_took_longest_are_read_from_the_log_of_ctest(self):
        passed = [f" {n}/12 Test  #{n}: t_{n} ......   Passed    {n}.50 sec" for n in range(1, 12)]
        failed = "12/12 Test #40: Units/of.a/1 ...***Failed  Required regular expression  99.05 sec"
        found = slowest_tests("\n".join([*passed, failed, "Total Test time (real) = 200 sec"]))
        self.assertEqual(found[:2], [(99.05, "Units/of.a/1"), (11.5, "t_11")])
        self.assertEqual(len(found), 10)

    def test_another_version_does_not_judge_the_layout(self):
        write_program(self.bin / "black", "#!/bin/sh\necho black, 25.1.0\n")
        with patch.dict(os.environ, {"CI": ""}), patch("reproduce.checks.say") as said:
            self.assertFalse(defines_layout(self.bin / "black"))
        said.assert_called_once()


class Profiles(Project):
    def test_outside_an_allocation_and_inside_a_step_slurm_is_refused(self):
        for name in ("analyze", "load", "modify-phi", "prepare", "restart"):
            write_program(self.bin / name, "#!/bin/sh\n")
        for variables, sentence in (
            (
                {},
                "the profile slurm computes in an allocation of SLURM; give the command to sbatch",
            ),
            ({"SLURM_JOB_ID": "7", "SLURM_STEP_ID": "0"}, "inside a step of a job"),
        ):
            with patch.dict(os.environ, variables):
                done = self.call("fig3", "--profile", "slurm", "--programs", "bin")
            self.assertEqual(done.returncode, 1)
            self.assertTrue(done.stderr.startswith(f"reproduce.sh: {sentence}"), done.stderr)


if __name__ == "__main__":
    unittest.main()
