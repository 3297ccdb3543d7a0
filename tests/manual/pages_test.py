"""The man pages: there is one per tool and command, man finds no fault, their examples run."""

import os

from conftest import BIN, BUILD, ROOT, need, need_modules, succeeds, tools_described

need("man")
PAGES = BUILD / "manual/man"
SETTINGS = {"LC_ALL": "C.UTF-8", "MANWIDTH": "80", "MANROFFSEQ": "", "MAN_KEEP_FORMATTING": ""}
PLAIN = os.environ | SETTINGS
TOOLS = tools_described()
ALL = TOOLS + [command for tool in TOOLS for command in tool.get("commands", [])]
SCRIPT = ROOT / "src/tools/manual/examples.sh"


def test_there_is_one_for_each_tool_and_one_for_rupture_and_man_finds_no_fault():
    names = {f"rupture-{tool['name']}.1.gz".replace(" ", "-") for tool in ALL} | {"rupture.1.gz"}
    assert {page.name for page in PAGES.iterdir()} == names
    for page in PAGES.iterdir():
        done = succeeds("man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page, env=PLAIN)
        assert done.stderr == "", page.name


def test_the_examples_run(folder):
    need_modules("h5py", "matplotlib")
    path = f"{BIN}:{os.environ['PATH']}"
    succeeds("bash", "-ex", SCRIPT, env=os.environ | {"PATH": path})


def test_parameters_have_a_page():
    page = PAGES / "rupture-parameters.1.gz"
    said = succeeds("man", "--no-hyphenation", "--no-justification", "-l", page, env=PLAIN).stdout
    of_t_R = "(above 0, at most 1000; default: 0.002; laws: reference, simplified, decaying)"
    assert f"junctions.t_R [s] mean slipping time {of_t_R}" in " ".join(said.split())
