"""The man pages: there is one per tool and command, man finds no fault, their examples run."""

import os

from conftest import BIN, BUILD, ROOT, need, need_modules, run, tools_described

need("man")
PAGES = BUILD / "manual/man"
PLAIN = {"LC_ALL": "C.UTF-8", "MANWIDTH": "80", "MANROFFSEQ": "", "MAN_KEEP_FORMATTING": ""}
TOOLS = tools_described()
ALL = TOOLS + [command for tool in TOOLS for command in tool.get("commands", [])]
SCRIPT = ROOT / "src/tools/manual/examples.sh"


def succeeds(*command):
    done = run(*command, env=os.environ | PLAIN)
    assert done.returncode == 0, done.stderr
    return done


def text_of(name):
    page = PAGES / f"rupture-{name.replace(' ', '-')}.1.gz"
    return succeeds("man", "--no-hyphenation", "--no-justification", "-l", page).stdout


def words(text):
    return " ".join(text.split())


def test_there_is_one_for_each_tool_and_one_for_rupture_and_man_finds_no_fault():
    names = {f"rupture-{tool['name']}.1.gz".replace(" ", "-") for tool in ALL} | {"rupture.1.gz"}
    assert {page.name for page in PAGES.iterdir()} == names
    for page in PAGES.iterdir():
        done = succeeds("man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", page)
        assert done.stderr == "", page.name


def test_the_examples_run(folder):
    need_modules("h5py", "matplotlib")
    path = f"{BIN}:{os.environ['PATH']}"
    done = run("bash", "-ex", SCRIPT, env=os.environ | {"PATH": path})
    assert done.returncode == 0, done.stderr


def test_parameters_have_a_page():
    assert (
        "junctions.t_R [s] mean slipping time (above 0, at most 1000; default: 0.002; laws:"
        " reference, simplified, decaying)" in words(text_of("parameters"))
    )
