"""Programs of the package as a user runs them."""

import json
import os
import subprocess
from pathlib import Path


def ran(name, *arguments, **options):
    """Exit code, standard output, standard error."""
    words = [Path(os.environ["RUPTURE_BIN"]) / name, *map(str, arguments)]
    done = subprocess.run(words, capture_output=True, text=True, check=False, **options)
    return done.returncode, done.stdout, done.stderr


def check_refusals(test, name, cases, **options):
    """`cases`: arguments, exit code and a part of the sentence, which is the only one. Nothing is
    left behind."""
    before = sorted(Path().rglob("*"))
    for arguments, code, part in cases:
        found, said, sentence = ran(name, *arguments, **options)
        test.assertEqual(sorted(Path().rglob("*")), before)
        test.assertEqual((found, said, sentence.count("\n")), (code, "", 1), sentence)
        test.assertTrue(sentence.startswith(f"rupture {name}: "), sentence)
        test.assertIn(part, sentence)


def check_description(test, name):
    """--help and --describe name the same options."""
    described = json.loads(ran(name, "--describe")[1])
    test.assertEqual(described["name"], name)
    text = ran(name, "--help")[1]
    for option in described["options"]:
        test.assertIn("--" + option["name"], text)
    test.assertIn("rupture", ran(name, "--version")[1])
