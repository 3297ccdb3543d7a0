"""The Debian package that cpack makes: its contents, its dependencies, and lintian's opinion."""

import subprocess
import tempfile
import unittest
from pathlib import Path

from conftest import BUILD, need

need("dpkg-shlibdeps", "lintian")


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class DebianPackage(unittest.TestCase):
    package: Path
    unpacked: Path

    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        output_of("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", folder.name)
        [cls.package] = Path(folder.name).glob("rupture_*_*.deb")
        cls.unpacked = Path(folder.name) / "unpacked"
        output_of("dpkg-deb", "--extract", cls.package, cls.unpacked)

    def test_lintian_finds_no_error(self):
        done = subprocess.run(
            ["lintian", "--allow-root", self.package], capture_output=True, text=True, check=False
        )
        self.assertEqual((done.returncode, done.stdout), (0, ""), done.stderr)

    def test_it_depends_on_libraries_and_on_what_recipes_need(self):
        depends = output_of("dpkg-deb", "--field", self.package, "Depends")
        packages = {each.split()[0] for each in depends.split(", ")}
        self.assertLessEqual({"snakemake", "python3-h5py", "python3-matplotlib"}, packages)
        self.assertIn("libc6", packages)
        self.assertIn("ffmpeg", output_of("dpkg-deb", "--field", self.package, "Recommends"))
        self.assertTrue(any(each.startswith("libhdf5") for each in packages), packages)

    def test_what_it_unpacks_is_complete(self):
        self.assertEqual([path.name for path in (self.unpacked / "usr/bin").iterdir()], ["rupture"])
        said = output_of(self.unpacked / "usr/bin/rupture", "reproduce", "list")
        self.assertIn("  fig3 ", said)
        for path in (
            "doc/rupture/copyright",
            "doc/rupture/README.md",
            "doc/rupture/CHANGELOG.md",
            "man/man1/rupture.1.gz",
            "rupture/checkpoints/manifest",
            "rupture/benchmarks/lammps/bulk.in",
        ):
            self.assertTrue((self.unpacked / "usr/share" / path).exists(), path)
