# SPDX-FileCopyrightText: The rupture authors
# SPDX-License-Identifier: MIT

"""./reproduce.sh itself: what may be typed, installing and building (with stand-ins for apt-get and
cmake), and that nothing is left behind when it is interrupted or killed (recipes/reproduce/)."""

import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock
from collections.abc import Callable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "recipes"))

from reproduce.checks import slowest_tests  # noqa: E402
from reproduce.place import count_cores, memory_of_allocation  # noqa: E402

WITHIN = 60  # [s]
SWEEP = """[sweep]
prepare =
[values]
tau-bar = 0.1, 0.2
[quantities]
F_T = stress.F_T
"""


def described(name, kind, *options):
    """As a program says it of itself; the options take numbers."""
    numbers = [{"name": word, "short": None, "kind": "number", "unit": "1"} for word in options]
    return {"name": name, "input": kind, "one_needed": [], "options": numbers}


# Knows enough of analyze for a sweep to be planned.
COMMANDS = {"commands": [described("analyze stress", "checkpoint", "json")]}
QUANTITIES = {"parameters": [], "quantities": [{"name": "stress.F_T", "unit": "N"}]}
ANALYZE = f"""#!/bin/sh
case "$*" in
  *quantities*) echo '{json.dumps(QUANTITIES)}';;
  *--describe*) echo '{json.dumps(COMMANDS)}';;
  *) echo '{{"F_T": 1}}';;
esac
"""
# Waits for long, unless there is a file `go` in the project's folder.
PREPARE = f"""#!/bin/sh
case "$*" in
  *--describe*) echo '{json.dumps(described("prepare", None, "tau-bar", "o", "quiet"))}'; exit;;
esac
echo $$ >> ROOT/running
[ -e ROOT/go ] || exec sleep 300
"""
TINY = """\
STAGES["start"]["tiny"] = [f"{DATA}/fast-only.compared"]

rule tiny:
    input: **content_of(h5=f"{DATA}/fast-only.h5"), **script("recipes/tiny/tiny.py")
    output: f"{RESULTS}/tiny/claims.json"
    message: "tiny: draw"
    shell: "{PYTHON} {input.script} > {output}"
"""
VERIFY = "fast-only: verify the shipped checkpoint"


def write_program(path, text):
    path.write_text(text, encoding="utf-8")
    path.chmod(0o755)


class Project(unittest.TestCase):
    """A copy of the command, with stand-ins for programs in bin/."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.bin = self.root / "bin"
        self.bin.mkdir()
        for name in ("recipes", "python"):
            shutil.copytree(ROOT / name, self.root / name)
        for name in ("reproduce.sh", "packages.txt", "codemeta.json"):
            shutil.copy2(ROOT / name, self.root / name)

    def start(self, *arguments):
        path = f"{self.bin}{os.pathsep}{os.environ['PATH']}"
        return subprocess.Popen(
            [self.root / "reproduce.sh", *arguments],
            cwd=self.root,
            env=dict(os.environ, PATH=path),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def call(self, *arguments):
        process = self.start(*arguments)
        output, errors = process.communicate(timeout=WITHIN)
        return subprocess.CompletedProcess(arguments, process.returncode, output, errors)


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

    def test_clean_deletes_what_is_behind_a_link(self):
        (self.root / "disk/fig1").mkdir(parents=True)
        (self.root / "disk/runs.jsonl").touch()
        (self.root / "results").symlink_to("disk")
        self.assertEqual(self.call("clean").stdout, "Deleted build/ and results/.\n")
        self.assertEqual(list((self.root / "disk").iterdir()), [])

    def test_nothing_is_made_for_help_and_mistakes(self):
        before = sorted(self.root.iterdir())
        for arguments in (["-h"], ["list"], ["nope"]):
            self.call(*arguments)
        self.assertEqual(sorted(self.root.iterdir()), before)


class SettingUp(Project):
    def set_up(self, *words):
        path = f"{self.bin}{os.pathsep}{os.environ['PATH']}"
        return subprocess.run(
            [self.root / "recipes/reproduce/set-up.sh", *words],
            env=dict(os.environ, PATH=path),
            capture_output=True,
            text=True,
            check=False,
            timeout=WITHIN,
        )

    def make_cmake(self, says):
        """Notes its calls."""
        text = (
            '#!/bin/bash\necho "$*" >> calls\n'
            f"case \"$*\" in *--build*) printf '%b' '{says}';; esac\n"
        )
        write_program(self.bin / "cmake", text)

    def calls(self):
        return (self.root / "calls").read_text(encoding="utf-8")

    def test_figures_and_sweeps_build_the_programs_only(self):
        self.make_cmake("ninja: no work to do.\\n")
        (self.root / "my.ini").write_text(SWEEP)
        self.call("sweep", "my.ini", "--dry-run")
        targets = re.findall(r"--target (\S+)", self.calls())
        self.assertEqual(targets, ["tools"])

    def test_building_is_said_when_something_is_built(self):
        self.make_cmake("[0/1] Re-checking globbed directories...\\nninja: no work to do.\\n")
        self.assertEqual(self.set_up("build", "2", "tools").stdout, "")
        self.make_cmake("[1/2] Building CXX object x.o\\n[2/2] Linking CXX executable x\\n")
        said = self.set_up("build", "2", "tools").stdout
        self.assertEqual(said, "Building (log: build/log/build.log) ...\n")

    def test_configures_if_the_presets_are_newer(self):
        self.make_cmake("")
        presets, ninja = self.root / "CMakePresets.json", self.root / "build/release/build.ninja"
        ninja.parent.mkdir(parents=True)
        for path in (presets, ninja, presets):
            path.touch()
            self.set_up("build", "2", "tools")
        configured = [call == "--preset release" for call in self.calls().splitlines()]
        self.assertEqual(configured, [True, False, False, True, False])

    def test_a_failed_build_shows_its_end(self):
        write_program(self.bin / "cmake", "#!/bin/sh\necho error: x\n! [ $1 = --build ]\n")
        done = self.set_up("build", "2", "tools")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn(
            "error: x\nreproduce.sh: The build failed; the whole output is in", done.stderr
        )

    @unittest.skipIf(os.geteuid() != 0, "installs packages, if only with stand-ins")
    def test_other_programs_that_install_are_waited_for(self):
        write_program(self.bin / "dpkg-query", "#!/bin/sh\n")
        write_program(
            self.bin / "apt-get",
            '#!/bin/bash\necho "$*" >> calls\n[[ $* != update || $(wc -l < calls) -gt 1 ]] || {\n'
            "  echo 'E: Could not get lock /var/lib/apt/lists/lock. It is held' >&2; exit 100; }\n",
        )
        done = self.set_up("packages", "bench")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(
            self.calls(),
            "^update\nupdate\n-o DPkg::Lock::Timeout=[0-9]+ install -y .* lammps\n$",
        )

    @unittest.skipIf(os.geteuid() != 0, "installs packages, if only with stand-ins")
    def test_what_compiling_needs_is_installed_first_and_the_rest_meanwhile(self):
        write_program(self.bin / "dpkg-query", "#!/bin/sh\n")
        write_program(
            self.bin / "apt-get",
            "#!/bin/bash\n[[ $* == *install* ]] || exit 0\n"
            "[[ $* == *cmake* ]] && { echo compilers >> calls; exit; }\n"
            "until [ -e built ]; do sleep 0.02; done; sleep 0.2; echo recipes >> calls\n",
        )
        for code in (0, 1):
            with self.subTest(f"the build ends with {code}"):
                (self.root / "calls").unlink(missing_ok=True)
                (self.root / "built").unlink(missing_ok=True)
                cmake = f"#!/bin/sh\necho cmake >> calls; touch built; exit {code}\n"
                write_program(self.bin / "cmake", cmake)
                done = self.set_up("build", "2", "tools", "run")
                self.assertEqual(done.returncode, code, done.stderr)
                calls = list(dict.fromkeys(self.calls().split()))
                self.assertEqual(calls, ["compilers", "cmake", "recipes"])

    @unittest.skipIf(os.geteuid() != 0, "installs packages, if only with stand-ins")
    def test_other_failures_of_apt_get_are_final(self):
        write_program(self.bin / "dpkg-query", "#!/bin/sh\n")
        write_program(self.bin / "apt-get", "#!/bin/sh\necho 'E: no network' >&2; exit 100\n")
        done = self.set_up("packages", "bench")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no network\nreproduce.sh: Installing packages failed", done.stderr)


class Ending(Project):
    def setUp(self):
        super().setUp()
        (self.root / "my.ini").write_text(SWEEP)
        for name in ("load", "modify-phi", "restart"):
            write_program(self.bin / name, "#!/bin/sh\n")
        write_program(self.bin / "analyze", ANALYZE)
        write_program(self.bin / "prepare", PREPARE.replace("ROOT", str(self.root)))

    def sweep(self):
        return self.start("sweep", "my.ini", "--programs", "bin", "--cores", "2")

    def wait_for(self, condition):
        end = time.monotonic() + WITHIN
        while not condition():
            self.assertLess(time.monotonic(), end)
            time.sleep(0.05)

    def running(self):
        """Programs of points that have not ended."""
        path = self.root / "running"
        numbers = path.read_text().split() if path.exists() else []
        return [number for number in numbers if self.is_alive(number)]

    def is_alive(self, number):
        try:
            return Path(f"/proc/{number}/stat").read_text().rsplit(")", 1)[1].split()[0] != "Z"
        except OSError:
            return False

    def started(self):
        process = self.sweep()
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.wait_for(lambda: len(self.running()) == 2 or process.poll() is not None)
        self.assertIsNone(process.poll())
        return process

    def test_a_signal_ends_all_that_runs(self):
        for number, code in ((signal.SIGINT, 130), (signal.SIGTERM, 143), (signal.SIGHUP, 129)):
            with self.subTest(number.name):
                process = self.started()
                process.send_signal(number)
                self.assertEqual(process.wait(WITHIN), code)
                self.assertEqual(self.running(), [])

    def test_a_signal_ends_what_was_started_in_the_background_of_a_script(self):
        ignored = signal.signal(signal.SIGINT, signal.SIG_IGN)
        try:
            process = self.started()
        finally:
            signal.signal(signal.SIGINT, ignored)
        process.terminate()
        self.assertEqual(process.wait(WITHIN), 143)
        self.assertEqual(self.running(), [])

    def test_a_reader_that_has_gone_does_not_stop_it(self):
        (self.root / "go").touch()
        process = self.sweep()
        process.stdout.close()
        process.stderr.read()
        self.assertEqual(process.wait(WITHIN), 141)
        self.assertEqual(len(list((self.root / "results/data/points").glob("*.json"))), 2)
        self.assertTrue((self.root / "results/sweeps/my/my.csv").exists())

    def test_a_point_that_other_programs_have_computed_since_is_computed_again(self):
        (self.root / "go").touch()
        (self.root / "other.ini").write_text(SWEEP.replace("0.1, 0.2", "0.1"))
        first = (self.bin / "load").read_text()
        for sweep, load in (("my", first), ("other", "#!/bin/sh\n# 2\n"), ("my", first)):
            write_program(self.bin / "load", load)
            done = self.call("sweep", f"{sweep}.ini", "--programs", "bin")
            self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("2 points: 2 done.\nComputed now: 1; there before: 1.", done.stdout)

    def test_a_damaged_result_is_computed_again(self):
        (self.root / "go").touch()
        self.call("sweep", "my.ini", "--programs", "bin")
        next((self.root / "results/data/points").glob("*.json")).write_text("{")
        done = self.call("sweep", "my.ini", "--programs", "bin")
        self.assertIn("2 points: 2 done.\nComputed now: 1; there before: 1.", done.stdout)

    def test_a_second_run_is_refused_while_the_first_one_runs(self):
        self.started()
        done = self.call("sweep", "my.ini", "--programs", "bin")
        sentence = "reproduce.sh: another ./reproduce.sh is running in this folder; wait until"
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1))
        self.assertIn(sentence, done.stderr)

    def test_what_a_killed_run_leaves_behind_ends_by_itself(self):
        process = self.started()
        process.kill()
        process.wait()
        self.wait_for(lambda: not self.running())

    def test_after_a_killed_run_the_same_command_goes_on(self):
        process = self.started()
        process.kill()
        process.wait()
        (self.root / "go").touch()
        done = self.call("sweep", "my.ini", "--programs", "bin")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 points: 2 done.", done.stdout)

    def test_snakemake_alone_may_be_killed(self):
        process = self.started()
        (pipeline,) = [
            int(folder.name)
            for folder in Path("/proc").glob("[0-9]*")
            if self.is_child(folder, process.pid) and self.runs_pipeline(folder)
        ]
        os.kill(pipeline, signal.SIGKILL)
        self.assertEqual(process.wait(WITHIN), 1)
        self.wait_for(lambda: not self.running())

    def is_child(self, folder, parent):
        try:
            return (folder / "stat").read_text().rsplit(")", 1)[1].split()[1] == str(parent)
        except OSError:
            return False

    def runs_pipeline(self, folder):
        return b"reproduce/pipeline.py" in (folder / "cmdline").read_bytes()


class NothingToDo(Project):
    """With a recipe that starts from a shipped checkpoint, and stand-ins for cmake and analyze."""

    def setUp(self):
        super().setUp()
        for rules in self.root.glob("recipes/*/rules.smk"):
            shutil.rmtree(rules.parent)
        write_program(self.bin / "cmake", "#!/bin/sh\n")
        for name, text in (
            ("recipes/tiny/rules.smk", TINY),
            ("recipes/tiny/tiny.py", "print([])\n"),
            ("src/load.cpp", "// 1\n"),
            ("build/release/bin/analyze", "#!/bin/sh\nsha256sum < $2 | cut -d' ' -f1\n"),
        ):
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            write_program(self.root / name, text)
        shutil.copytree(self.root / "build/release/bin", self.bin, dirs_exist_ok=True)
        write_program(self.bin / "load", "#!/bin/sh\n")
        self.ship(b"a checkpoint")

    def ship(self, content):
        folder = self.root / "checkpoints"
        folder.mkdir(exist_ok=True)
        (folder / "fast-only.h5").write_bytes(content)
        checksum = hashlib.sha256(content).hexdigest()
        (folder / "manifest").write_text(f"content-sha256 {checksum}  fast-only.h5\n")

    def append(self, name):
        with open(self.root / name, "a", encoding="utf-8") as file:
            file.write("# 2\n")

    def change_rule(self):
        rules = TINY.replace("> {output}", "| tee {output}")
        (self.root / "recipes/tiny/rules.smk").write_text(rules, encoding="utf-8")

    def test_what_was_run_is_noted_for_the_report(self):
        self.steps()
        lines = (self.root / "results/jobs.jsonl").read_text(encoding="utf-8").splitlines()
        last = json.loads(lines[-1])
        self.assertEqual((last["rule"], last["output"]), ("tiny", ["results/tiny/claims.json"]))
        self.assertIn("recipes/tiny/tiny.py", last["command"])
        crate = json.loads((self.root / "results/ro-crate-metadata.json").read_text())
        [run] = [each for each in crate["@graph"] if each["@id"] == "#run-tiny"]
        self.assertLessEqual(run["startTime"], run["endTime"])

    def test_what_describes_the_results_is_written_again_when_that_may_differ(self):
        crate = self.root / "results/ro-crate-metadata.json"
        changes: list[Callable] = [
            lambda: None,
            lambda: None,
            lambda: self.append("recipes/tiny/README.md"),
            lambda: self.delete("results/tiny/claims.json"),
        ]
        times = []
        for change in changes:
            change()
            self.steps()
            times.append(crate.stat().st_mtime_ns)
        self.assertEqual(times[0], times[1])
        self.assertEqual(times[1:], sorted(set(times[1:])))

    def delete(self, name):
        (self.root / name).unlink()

    def steps(self, *options):
        """That a call takes. It says so if there are none."""
        done = self.call("tiny", *options)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        steps = re.findall(r"^\[.*\] \d+/\d+ (.*)", done.stdout, re.MULTILINE)
        self.assertEqual("Nothing is to be computed" in done.stdout, not steps, done.stdout)
        return steps

    def test_is_said_and_whatever_is_stale_is_found(self):
        self.assertEqual(len(self.steps()), 3)
        self.assertEqual(self.steps(), [])
        draw = "tiny: draw"
        for name, change, last_step in (
            ("a source", lambda: self.append("src/load.cpp"), VERIFY),
            ("a script", lambda: self.append("recipes/tiny/tiny.py"), draw),
            ("what scripts share", lambda: self.append("recipes/claims/claim.py"), draw),
            ("a rule", self.change_rule, draw),
            ("a shipped checkpoint", lambda: self.ship(b"another checkpoint"), draw),
            ("a deleted result", lambda: self.delete("results/tiny/claims.json"), draw),
            ("a deleted file behind it", lambda: self.delete("results/data/fast-only.h5"), VERIFY),
            ("an edited result", lambda: self.append("results/data/fast-only.h5.sum"), draw),
        ):
            with self.subTest(name):
                change()
                self.assertIn(last_step, self.steps())
        self.assertEqual(self.steps(), [])

    def test_other_programs_count_by_their_bytes(self):
        options = ("--programs", "bin")
        self.steps(*options)
        self.assertEqual(self.steps(*options), [])
        self.append("bin/load")
        self.assertIn(VERIFY, self.steps(*options))


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


class SlowestTests(unittest.TestCase):
    def test_the_ten_that_took_longest_are_read_from_the_log_of_ctest(self):
        passed = [f" {n}/12 Test  #{n}: t_{n} ......   Passed    {n}.50 sec" for n in range(1, 12)]
        failed = "12/12 Test #40: Units/of.a/1 ...***Failed  Required regular expression  99.05 sec"
        found = slowest_tests("\n".join([*passed, failed, "Total Test time (real) = 200 sec"]))
        self.assertEqual(found[:2], [(99.05, "Units/of.a/1"), (11.5, "t_11")])
        self.assertEqual(len(found), 10)


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
            with unittest.mock.patch.dict(os.environ, variables):
                done = self.call("fig3", "--profile", "slurm", "--programs", "bin")
            self.assertEqual(done.returncode, 1)
            self.assertTrue(done.stderr.startswith(f"reproduce.sh: {sentence}"), done.stderr)


if __name__ == "__main__":
    unittest.main()
