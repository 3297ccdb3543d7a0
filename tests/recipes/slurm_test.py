"""Commands as SLURM jobs (recipes/slurm/), with a srun, squeue and scancel that only pretend."""

import io
import os
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

sys.path[:0] = [
    str(Path(__file__).resolve().parents[2] / "recipes"),
    "/usr/lib/python3/dist-packages",
]

from slurm import job as job_module  # noqa: E402
from slurm import line as line_module  # noqa: E402
from slurm.job import Command, Job, Needs, script  # noqa: E402
from slurm.line import Line  # noqa: E402
from slurm.settings import Settings, read_settings  # noqa: E402

POINT = Needs("point", 1, 500, 10)
LOAD = Needs("load", 2, 800, 30)

# Does what the next line of `plan` says; without one, runs the job.
SRUN = """#!/bin/bash
cd "$(dirname "$0")"
{ flock 9; plan=$(sed -n 1p plan); sed -i 1d plan; echo "$*" >> calls; } 9>> lock
cd - > /dev/null
[[ $plan != down ]] || { echo 'srun: error: Unable to contact slurm controller (connect failure)' >&2; exit 1; }
[[ $plan != refuse ]] || { echo 'srun: error: Invalid partition name specified' >&2; exit 1; }
while [[ $1 == -* ]]; do shift; done
if [[ $plan == limit || $plan == cancel ]]; then
  timeout --signal=KILL 0.5 "$@"
  [[ $plan != limit ]] || echo 'slurmstepd: error: *** STEP 7.0 ON n CANCELLED AT 12:00 DUE TO TIME LIMIT ***' >&2
  [[ $plan != cancel ]] || echo 'slurmstepd: error: *** STEP 7.0 ON n CANCELLED AT 12:00 ***' >&2
  exit 137
fi
[[ $plan != noise ]] || echo Welcome
exec "$@"
"""
SQUEUE = "#!/bin/bash\ncat $(dirname $0)/queue\n"
SCANCEL = """#!/bin/bash
cd "$(dirname "$0")"; echo "$*" >> cancelled
for number; do sed -i "/^$number /d" queue; done
"""


class WithSlurm(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name, text in {"srun": SRUN, "squeue": SQUEUE, "scancel": SCANCEL}.items():
            (self.folder / name).write_text(text)
            (self.folder / name).chmod(0o755)
        for name in ("plan", "calls", "queue", "cancelled"):
            (self.folder / name).touch()
        path = f"{self.folder}{os.pathsep}{os.environ['PATH']}"
        for patch in (
            mock.patch.dict(os.environ, PATH=path),
            mock.patch.object(job_module, "RETRY_EVERY", 0.05),
            mock.patch.object(line_module, "GATHERING", 0.1),
            mock.patch.object(sys, "stdout", io.StringIO()),
        ):
            patch.start()
            self.addCleanup(patch.stop)
        self.line = None

    def settings(self, jobs=4, group=20, group_time=120):
        return Settings(
            ["--partition=x"],
            *(jobs, group, group_time, self.folder / "logs"),
            *("rupture:/x:", "rupture:/x:now"),
        )

    def open(self, **settings):
        self.line = Line(self.settings(**settings))
        self.line.open()

    def plan(self, *steps):
        (self.folder / "plan").write_text("".join(f"{step}\n" for step in steps))

    def calls(self):
        return (self.folder / "calls").read_text().splitlines()

    def lines_of(self, name):
        return (self.folder / name).read_text().splitlines()

    def command(self, text, needs=POINT):
        return Command(text, needs, [self.folder / "rule.log"])

    def run_all(self, commands):
        threads = [threading.Thread(target=self.line.run, args=[each]) for each in commands]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(30)
            self.assertFalse(thread.is_alive())
        return [command.code for command in commands]


class Scripts(WithSlurm):
    def codes(self, *texts):
        done = subprocess.run(
            ["bash", "-c", script([self.command(text) for text in texts])],
            capture_output=True,
            text=True,
        )
        begun, *reports = done.stdout.splitlines()
        self.assertEqual(begun, "rupture: begun")
        return [report.removeprefix("rupture: ") for report in reports], done.returncode

    def test_the_end_of_each_command_is_reported(self):
        self.assertEqual(self.codes("true", "exit 3", "echo noise"), (["0 0", "1 3", "2 0"], 0))

    def test_commands_are_strict(self):
        self.assertEqual(
            self.codes("false | true", "echo $nothing", "false; true")[0], ["0 1", "1 1", "2 1"]
        )

    def test_a_command_that_was_killed_ends_the_job_without_a_report(self):
        self.assertEqual(self.codes("true", "kill -9 $$", "true"), (["0 0"], 137))
        self.assertEqual(self.codes("true", "exit 143", "true"), (["0 0"], 143))

    def test_a_crash_is_the_commands_own(self):
        self.assertEqual(self.codes("kill -SEGV $$", "true"), (["0 139", "1 0"], 0))


class Sharing(unittest.TestCase):
    def size(self, needs, waiting, free, group=20, group_time=120):
        settings = Settings([], 50, group, group_time, Path("x"), "x", "x")
        return Line(settings).group_size(needs, waiting, free)

    def test_commands_are_shared_out_among_the_jobs_that_may_start(self):
        for waiting, free, expected in ((3, 50, 1), (100, 50, 2), (101, 50, 3), (5000, 50, 20)):
            self.assertEqual(self.size(Needs("point", 1, 500, 1), waiting, free), expected)

    def test_a_job_asks_for_no_more_than_group_time(self):
        self.assertEqual(self.size(Needs("point", 1, 500, 50), 5000, 1), 2)
        self.assertEqual(self.size(Needs("point", 1, 500, 500), 5000, 1), 1)

    def test_only_points_share(self):
        self.assertEqual(self.size(LOAD, 5000, 1), 1)


class Running(WithSlurm):
    def test_a_job_asks_for_what_its_rule_says(self):
        self.open()
        self.assertEqual(self.run_all([self.command("echo $OMP_NUM_THREADS >&2; true", LOAD)]), [0])
        words = self.calls()[0].split()
        for word in (
            *("--job-name=load-0001", "--comment=rupture:/x:now", "--cpus-per-task=2", "--mem=800"),
            *("--time=30", "--partition=x", "--ntasks=1"),
        ):
            self.assertIn(word, words)
        self.assertIn("\n2\n", (self.folder / "logs/load-0001.log").read_text())

    def test_many_points_are_few_jobs_and_each_runs_once(self):
        self.open(jobs=4)
        done = self.folder / "done"
        codes = self.run_all([self.command(f"echo {n} >> {done}") for n in range(60)])
        self.assertEqual(codes, [0] * 60)
        self.assertEqual(sorted(map(int, done.read_text().split())), list(range(60)))
        self.assertLess(len(self.calls()), 20)
        self.assertIn("--time=120", self.calls()[0])  # 15 of 60 for each of 4, but group_time

    def test_no_more_jobs_than_allowed_at_a_time(self):
        self.open(jobs=2)
        text = f"cd {self.folder}; echo + >> n; sleep 0.1; echo - >> n"
        self.run_all([self.command(text, LOAD) for _ in range(8)])
        at_once, most = 0, 0
        for sign in self.lines_of("n"):
            at_once += 1 if sign == "+" else -1
            most = max(most, at_once)
        self.assertEqual(most, 2)

    def test_a_command_that_fails_is_not_tried_again(self):
        self.open()
        self.assertEqual(self.run_all([self.command("exit 3", LOAD)]), [3])
        self.assertEqual(len(self.calls()), 1)

    def test_what_slurm_ends_is_tried_again_with_more(self):
        self.plan("limit")
        self.open(jobs=1)
        done = self.folder / "done"
        slow = f"[[ -e {self.folder}/second ]] || {{ touch {self.folder}/second; sleep 9; }}; echo b >> {done}"
        codes = self.run_all([self.command(f"echo a >> {done}"), self.command(slow)])
        self.assertEqual(codes, [0, 0])
        self.assertEqual(sorted(self.lines_of("done")), ["a", "b"])  # what was finished stays so
        self.assertIn("--mem=500 --time=20", self.calls()[0])
        self.assertIn("--mem=1000 --time=20", self.calls()[1])

    def test_a_command_is_given_up_in_the_end(self):
        self.plan("limit", "limit", "limit")
        self.open()
        self.assertEqual(self.run_all([self.command("sleep 9", LOAD)]), [1])
        self.assertEqual(
            [call.split("--mem=")[1].split()[0] for call in self.calls()], ["800", "1600", "2400"]
        )
        self.assertIn("SLURM ended the job", (self.folder / "rule.log").read_text())

    def test_a_cancelled_job_is_tried_again_with_the_same(self):
        self.plan("cancel")
        self.open()
        self.assertEqual(self.run_all([self.command("sleep 1", LOAD)]), [0])
        self.assertIn("--mem=800 --time=30", self.calls()[1])

    def test_a_refusal_is_final_for_all_that_need_the_same(self):
        self.plan(*["refuse"] * 60)
        self.open(jobs=1)
        self.assertEqual(self.run_all([self.command("true") for _ in range(60)]), [1] * 60)
        self.assertEqual(len(self.calls()), 1)
        self.assertIn("Invalid partition", (self.folder / "rule.log").read_text())

    def test_other_words_on_the_way_do_not_matter(self):
        self.plan("noise")
        self.open()
        self.assertEqual(self.run_all([self.command("true", LOAD)]), [0])

    def test_without_a_place_for_logs_commands_fail(self):
        self.open()
        (self.folder / "logs").rmdir()
        self.assertEqual(self.run_all([self.command("true", LOAD)]), [1])

    def test_a_controller_that_is_away_is_waited_for(self):
        self.plan(*["down"] * 5)
        self.open()
        self.assertEqual(self.run_all([self.command("true", LOAD)]), [0])
        self.assertEqual(len(self.calls()), 6)
        self.assertIn("--mem=800", self.calls()[5])  # no attempt was lost

    def test_closing_ends_what_waits_and_what_runs(self):
        self.open(jobs=1)
        raised = []

        def run(command):
            try:
                self.line.run(command)
            except KeyboardInterrupt:
                raised.append(command)

        commands = [self.command("sleep 2", LOAD) for _ in range(3)]
        threads = [threading.Thread(target=run, args=[each]) for each in commands]
        for thread in threads:
            thread.start()
        while not self.calls():
            time.sleep(0.02)
        self.line.close()
        for thread in threads:
            thread.join(10)
        while self.line.running:
            time.sleep(0.02)
        self.assertEqual(len(raised), 3)
        self.assertEqual(len(self.calls()), 1)


class Queue(WithSlurm):
    def test_jobs_of_a_killed_run_are_cancelled(self):
        (self.folder / "queue").write_text(
            "7 point-0001 None rupture:/x:then\n8 other None (null)\n"
            "9 point-0001 None rupture:/y:now\n11 load-0002 None rupture:/x:then\n"
        )
        self.open()
        self.assertEqual(self.lines_of("cancelled"), ["7 11"])

    def test_a_job_without_srun_is_cancelled(self):
        with mock.patch.object(line_module, "TEND_EVERY", 0.1):
            self.open()
            (self.folder / "queue").write_text("7 point-0001 None rupture:/x:now\n")
            end = time.monotonic() + 10
            while not self.lines_of("cancelled") and time.monotonic() < end:
                time.sleep(0.05)
        self.assertEqual(set(self.lines_of("cancelled")), {"7"})


    def test_a_job_that_can_never_start_is_named(self):
        with mock.patch.object(line_module, "TEND_EVERY", 0.05):
            self.open()
            (self.folder / "queue").write_text("7 load-0001 PartitionTimeLimit rupture:/x:now\n")
            end = time.monotonic() + 10
            while "load-0001 cannot start: PartitionTimeLimit" not in sys.stdout.getvalue():
                self.assertLess(time.monotonic(), end)
                time.sleep(0.05)


class Profile(WithSlurm):
    def test_the_profile_can_be_read(self):
        path = Path(__file__).resolve().parents[2] / "recipes/profiles/slurm/srun.ini"
        settings = read_settings(path, "/x", self.folder)
        self.assertEqual((settings.options, settings.folder), ([], "rupture:/x:"))

    def test_mistakes_are_one_sentence(self):
        path = self.folder / "srun.ini"
        for text in (
            "",
            "x",
            "[srun]\njobs = 0",
            "[srun]\njobs = many",
            "[srun]\njbos = 3",
            "[srun]\noptions = '",
        ):
            path.write_text(text)
            with self.subTest(text), self.assertRaisesRegex(ValueError, "^[^\n]+$"):
                read_settings(path, "/x", self.folder)


if __name__ == "__main__":
    unittest.main()
