"""The installed CMake package, as the project of a user (project/) uses it."""

import re
import shlex
import shutil
import tempfile
import unittest
from pathlib import Path

from conftest import BUILD, ODD, ROOT, run

PROJECT = ROOT / "tests/regression/project"


class Package(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.prefix = Path(folder.name) / ODD
        self.source = Path(folder.name) / "project"
        self.build = Path(folder.name) / "build"
        shutil.copytree(PROJECT, self.source)
        self.done("cmake", "--install", BUILD, "--prefix", self.prefix)

    def done(self, *command, **options):
        result = run(*command, **options)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def configure(self, *options, call=run):
        prefix = f"-DCMAKE_PREFIX_PATH={self.prefix}"
        return call("cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", prefix, *options)

    def configured(self, *options):
        return self.configure(*options, call=self.done)

    def ctest(self):
        return run("ctest", "--test-dir", self.build, "--output-on-failure")

    def regenerate(self):
        return self.done("cmake", "--build", self.build, "--target", "rupture_regenerate_goldens")

    def replace(self, file, old, new):
        text = (self.source / file).read_text(encoding="utf-8")
        self.assertIn(old, text)
        (self.source / file).write_text(text.replace(old, new), encoding="utf-8")

    def write_project(self, languages):
        (self.source / "CMakeLists.txt").write_text(
            f"cmake_minimum_required(VERSION 3.25)\nproject(mine LANGUAGES {languages})\n"
            "enable_testing()\nfind_package(rupture REQUIRED)\n"
            "rupture_add_checkpoint_test(NAME mine PIPELINE my_pipeline.sh GOLDEN mine.sums)\n",
            encoding="utf-8",
        )

    def test_a_project_notices_that_its_results_changed(self):
        self.configured()
        self.done("cmake", "--build", self.build)
        self.assertIn("there is no golden file", self.ctest().stdout)

        self.regenerate()
        self.assertIn("100% tests passed, 0 tests failed out of 2", self.ctest().stdout)
        before = (self.source / "my_pipeline.sums").read_text(encoding="utf-8")

        self.replace("my_slider.ini", "N_s = 37", "N_s = 38")
        said = self.ctest().stdout
        self.assertIn("50% tests passed, 1 tests failed out of 2", said)
        self.assertIn("Files that differ, 3 of 3: event-record.h5 event.h5", said)
        analyze = shlex.quote(f"{self.prefix}/libexec/rupture/analyze")
        self.assertIn(f"{analyze} diff {self.build}/my_pipeline.files/equal", said)

        said = self.regenerate()
        self.assertIn("my_program.sums is current", said)
        self.assertIn("100% tests passed", self.ctest().stdout)
        old = self.source / "my_pipeline.sums.old1"
        self.assertEqual(old.read_text(encoding="utf-8"), before)

    def test_rupture_finds_its_tools_and_recipes_and_writes_where_it_is_called(self):
        folder = self.prefix.parent / f"work in {ODD}"
        folder.mkdir()
        rupture = self.prefix / "bin/rupture"
        self.assertEqual([path.name for path in rupture.parent.iterdir()], ["rupture"])
        self.assertIn("0 steps", self.done(rupture, "load", "-o", folder / "a.h5"))
        self.assertTrue((self.prefix / "share/man/man1/rupture-load.1.gz").exists())
        other = self.prefix.parent / "python/rupture/__init__.py"  # as beside a clone's src/
        other.parent.mkdir(parents=True)
        other.write_text("raise RuntimeError\n")
        for name in ("json", "numpy", "sitecustomize"):
            other.with_name(f"{name}.py").write_text("raise RuntimeError\n")
        self.assertIn("usage:", self.done(rupture, "map", "--help", cwd=other.parent))
        self.assertIn("  fig3 ", self.done(rupture, "reproduce", "list"))
        self.assertNotIn("tidy", self.done(rupture, "reproduce", "--help"))
        before = sorted(self.prefix.rglob("*"))
        self.done(rupture, "reproduce", "figS1", "figS3", cwd=folder)
        for name in ("figS1", "figS3"):
            self.assertTrue((folder / f"results/{name}/claims.json").exists())
        self.assertEqual(sorted(self.prefix.rglob("*")), before)
        listing = self.done(rupture, "reproduce", "list")
        names = re.findall(r"^  (\S+)", listing, re.MULTILINE)
        figures = names[: names.index("all")]
        self.assertGreaterEqual(len(figures), 17)
        said = self.done(rupture, "reproduce", *figures, "--dry-run", cwd=folder)
        self.assertGreater(said.count("\nrupture restart "), 20)  # no chain leads nowhere
        done = run(rupture, "reproduce", "test")
        self.assertEqual(done.returncode, 2)
        self.assertIn("there is no figure or command 'test'", done.stderr)

    def test_a_project_without_compiled_languages_needs_the_tools_alone(self):
        self.write_project("NONE")
        self.configured()
        self.regenerate()
        self.assertIn("100% tests passed, 0 tests failed out of 1", self.ctest().stdout)

    def test_a_project_in_cpp_has_the_library_without_asking(self):
        self.replace("CMakeLists.txt", " COMPONENTS library", "")
        page = (ROOT / "docs/library.md").read_text(encoding="utf-8")
        program = "".join(re.findall("```cpp\n(.*?)```", page, re.DOTALL))
        (self.source / "my_program.cpp").write_text(program, encoding="utf-8")
        self.configured()
        self.done("cmake", "--build", self.build, "--target", "my_program")
        stopped = self.build / "stopped.h5"
        record = ROOT / "tests/compatibility/schema-3/reference-record.h5"
        start = ROOT / "checkpoints/fast-only.h5"
        said = self.done(self.build / "my_program", start, stopped, record)
        self.assertEqual((said.count(" N\n"), said.count("arrested\n")), (11, 1))
        self.assertRegex(self.done(BUILD / "bin/analyze", "show", stopped), r"driving.V +0 m/s")

    def test_any_version_of_eigen_is_taken(self):
        """By ours and by our users' projects: a version asked for excludes the next major one."""
        cache = (BUILD / "CMakeCache.txt").read_text(encoding="utf-8")
        [installed] = re.findall("^Eigen3_DIR:PATH=(.*)$", cache, re.MULTILINE)
        config = self.prefix.parent / "Eigen3Config.cmake"
        config.write_text(f'include("{installed}/Eigen3Config.cmake")\n')
        config.with_name("Eigen3ConfigVersion.cmake").write_text("set(PACKAGE_VERSION 5.0)\n")
        options = (f"-DEigen3_DIR={config.parent}", f"-DCMAKE_IGNORE_PATH={installed}")
        for source in (self.source, ROOT):
            shutil.rmtree(self.build, ignore_errors=True)
            self.configured("-S", source, "-DRUPTURE_TESTS=OFF", *options)

    def test_without_its_dependencies_the_library_is_missed_only_if_asked_for(self):
        without = "-DCMAKE_DISABLE_FIND_PACKAGE_fmt=ON"
        result = self.configure(without)
        self.assertNotEqual(result.returncode, 0)
        said = " ".join(result.stderr.split())
        self.assertIn("it needs fmt, which cannot be found", said)
        self.write_project("CXX")
        self.assertIn("it needs fmt, which cannot be found", self.configured(without))

    def test_wrong_arguments_are_named(self):
        for old, new, sentence in (
            ("GOLDEN my_pipeline.sums", "", "GOLDEN is missing"),
            ("NAME my_pipeline", "twice NAME my_pipeline", "'twice' is neither NAME"),
            ("COMPONENTS library", "COMPONENTS libary", "libary"),
        ):
            shutil.copytree(PROJECT, self.source, dirs_exist_ok=True)
            self.replace("CMakeLists.txt", old, new)
            result = self.configure()
            self.assertNotEqual(result.returncode, 0)
            self.assertIn(sentence, " ".join(result.stderr.split()))
