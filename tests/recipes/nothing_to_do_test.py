"""A second call of ./reproduce.sh: what is current is not computed again, whatever is stale is."""

import hashlib
import json
import re
import shutil
import unittest
from collections.abc import Callable

from stand_ins import Project, write_program

TINY = """\
STAGES["start"]["tiny"] = [f"{DATA}/fast-only.compared"]

rule tiny:
    input: **content_of(h5=f"{DATA}/fast-only.h5"), **script("recipes/tiny/tiny.py")
    output: f"{RESULTS}/tiny/claims.json"
    message: "tiny: draw"
    shell: "{PYTHON} {input.script} > {output}"
"""
VERIFY = "fast-only: verify the shipped checkpoint"


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
            ("what scripts share", lambda: self.append("recipes/common/claims/claim.py"), draw),
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


if __name__ == "__main__":
    unittest.main()
