"""./reproduce.sh installs packages and builds, with stand-ins for apt-get and cmake
(recipes/common/reproduce/set-up.sh)."""

import os
import re
import subprocess
import unittest

from stand_ins import SWEEP, WITHIN, Project, write_program

NOBODY = 65534


class SettingUp(Project):
    def set_up(self, *words, user=None):
        return subprocess.run(
            [self.root / "recipes/common/reproduce/set-up.sh", *words],
            env=self.environment(),
            capture_output=True,
            text=True,
            check=False,
            timeout=WITHIN,
            user=user,
        )

    def calls(self):
        return (self.root / "calls").read_text(encoding="utf-8")


class Building(SettingUp):
    def make_cmake(self, says):
        """Notes its calls."""
        text = (
            '#!/bin/bash\necho "$*" >> calls\n'
            f"case \"$*\" in *--build*) printf '%b' '{says}';; esac\n"
        )
        write_program(self.bin / "cmake", text)

    def test_figures_and_sweeps_build_the_programs_only(self):
        self.make_cmake("ninja: no work to do.\\n")
        (self.root / "my.ini").write_text(SWEEP)
        self.call("sweep", "my.ini", "--dry-run")
        targets = re.findall(r"--target (\S+)", self.calls())
        self.assertEqual(targets, ["tools"])

    def configured(self):
        ninja = self.root / "build/release/build.ninja"
        ninja.parent.mkdir(parents=True)
        ninja.touch()
        return ninja

    def test_building_is_said_when_something_is_built(self):
        self.configured()
        self.make_cmake("[0/1] Re-checking globbed directories...\\nninja: no work to do.\\n")
        self.assertEqual(self.set_up("build", "2", "tools").stdout, "")
        self.make_cmake("[1/2] Building CXX object x.o\\n[2/2] Linking CXX executable x\\n")
        said = self.set_up("build", "2", "tools").stdout
        self.assertEqual(said, "Building (log: build/log/build.log) ...\n  50 %\n  100 %\n")

    def test_a_first_build_is_said_at_once_and_its_percentage_moves(self):
        wait = "for i in {1..100}; do [[ -e %s ]] && break; sleep 0.1; done; [[ -e %s ]] || exit 1"
        text = "#!/bin/bash\n" + wait.replace("%s", "said") + "\n[[ $1 == --build ]] || exit 0\n"
        text += "for n in 1 2 3 4; do echo [$n/40] Building x.o; done\n" + wait.replace(
            "%s", "moved"
        )
        write_program(self.bin / "cmake", text)
        words = ["recipes/common/reproduce/set-up.sh", "build", "2", "tools"]
        with subprocess.Popen(
            words, cwd=self.root, env=self.environment(), stdout=subprocess.PIPE, text=True
        ) as started:
            lines = iter(started.stdout or ())
            self.assertTrue(next(lines, "").startswith("Building"))
            (self.root / "said").touch()
            self.assertEqual(next(lines, ""), "  10 %\n")
            (self.root / "moved").touch()
        self.assertEqual(started.returncode, 0)

    def test_configures_if_the_presets_are_newer(self):
        self.make_cmake("")
        presets, ninja = self.root / "CMakePresets.json", self.configured()
        for path in (presets, ninja, presets):
            path.touch()
            self.set_up("build", "2", "tools")
        configured = [call.startswith("--preset release") for call in self.calls().splitlines()]
        self.assertEqual(configured, [True, False, False, True, False])

    def test_a_failed_build_shows_its_end(self):
        write_program(self.bin / "cmake", "#!/bin/sh\necho error: x\n! [ $1 = --build ]\n")
        self.configured()
        done = self.set_up("build", "2", "tools")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn(
            "error: x\nreproduce.sh: The build failed; the whole output is in", done.stderr
        )


@unittest.skipIf(os.geteuid() != 0, "installs packages, if only with stand-ins")
class Installing(SettingUp):
    def setUp(self):
        super().setUp()
        write_program(self.bin / "dpkg-query", "#!/bin/sh\n")  # nothing is installed

    def test_other_programs_that_install_are_waited_for(self):
        write_program(
            self.bin / "apt-get",
            '#!/bin/bash\necho "$*" >> calls\n[[ $* != update || $(wc -l < calls) -gt 1 ]] || {\n'
            "  echo 'E: Could not get lock /var/lib/apt/lists/lock. It is held' >&2; exit 100; }\n",
        )
        done = self.set_up("packages", "bench")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(
            self.calls(),
            "^update\nupdate\n-o DPkg::Lock::Timeout=[0-9]+ install -y --no-remove .* lammps\n$",
        )

    def test_who_is_not_root_hears_of_all_packages_at_once(self):
        self.root.chmod(0o777)
        table = (self.root / "packages.txt").read_text(encoding="utf-8")
        for command, purpose in (("fig3", "run"), ("tidy", "check"), ("test-slurm", "slurm")):
            done = self.set_up("python", "--cores", "1", command, user=NOBODY)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            command = "sudo apt-get install --no-remove --no-install-recommends "
            named = done.stderr.splitlines()[-1].removeprefix(command).split()
            needed = re.findall(f"^(?:build|run|{purpose}) +(\\S+)", table, re.MULTILINE)
            self.assertEqual(named, sorted(set(needed)))

    def test_what_compiling_needs_is_installed_first_and_the_rest_meanwhile(self):
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

    def test_other_failures_of_apt_get_are_final(self):
        write_program(self.bin / "apt-get", "#!/bin/sh\necho 'E: no network' >&2; exit 100\n")
        done = self.set_up("packages", "bench")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no network\nreproduce.sh: Installing packages failed", done.stderr)


if __name__ == "__main__":
    unittest.main()
