"""What all programs say of themselves, to --help, --describe and --version, and take what they say;
what parameters says of each parameter."""

import json
import re

import pytest

from commands import json_of, lines_of, output_of, refuses, run

# All programs in C++ and all commands of analyze; those in Python.
PROGRAMS = ["load", "prepare", "restart", "modify-phi", "parameters", "finish", "seal"]
PYTHON = ["map", "movie", "xdmf"]
COMMANDS = [command["name"] for command in json_of("analyze --describe")["commands"]]
VALUES = {"number": "0.5", "integer": "7", "text": "word", "parameter": "a=1"}
VALUES |= {"input file": "a.h5", "output file": "b.h5"}
each_program = pytest.mark.parametrize("name", PROGRAMS + COMMANDS + PYTHON)
pytestmark = pytest.mark.usefixtures("small_ini")


def given(option):
    """--NAME VALUE, or --NAME of a flag."""
    kind = option["kind"]
    value = option["words"][0] if kind == "choice" else VALUES.get(kind)
    assert value or kind == "flag"
    return f" --{option['name']}" + (f" {value}" if value else "")


def options_of(program):
    return {option["name"]: option for option in program["options"]}


@each_program
def test_all_options_are_described_with_the_texts_of_help(name):
    text, described = output_of(f"{name} --help"), output_of(f"{name} --describe")
    program = json.loads(described)
    assert (len(lines_of(described)), program["name"]) == (1, name)
    call = f"sage: rupture {program['synopsis']}\n"
    assert text.startswith((f"U{call}", f"u{call}"))
    assert program["synopsis"].startswith(f"{name} ")
    assert "\n" not in program["purpose"]
    options = options_of(program)
    assert options.keys() >= {"help", "describe", "version"}
    assert len(options) == len(program["options"])
    for option in options.values():
        assert f"--{option['name']} " in text
        unit = option["unit"]
        assert bool(unit) == (option["kind"] in ("number", "integer")), option
        assert unit in ("", "1") or f"{option['value']} [{unit}]" in text


@pytest.mark.parametrize("name", [*PYTHON, "reproduce"])
def test_help_says_what_words_without_an_option_are(name):
    (words,) = re.findall(r"\npositional arguments:\n((?: .*\n)+)", output_of(f"{name} --help"))
    assert not re.search(r"^  \S+$", words, re.MULTILINE)


@pytest.mark.parametrize("name", PROGRAMS + COMMANDS)
def test_the_options_that_are_described_are_taken(name):
    options = options_of(json_of(f"{name} --describe"))
    taken = (given(options[option]) for option in options if option not in ("describe", "version"))
    assert output_of(name + "".join(taken)) == output_of(f"{name} --help")


@each_program
def test_one_of_those_that_are_needed_is_needed(name):
    program = json_of(f"{name} --describe")
    options, groups = options_of(program), program["one_needed"]
    for missing in groups:
        command = name + (" none.h5" if program["input"] else "")
        command += "".join(given(options[group[0]]) for group in groups if group != missing)
        refuses(command, 2, f"...--{missing[-1]}...")


@each_program
def test_each_program_states_its_version(name):
    isa = "(baseline|sse2|avx2|avx512|neon)"
    version = output_of(f"{name} --version")
    assert re.fullmatch(rf"{name} \(rupture .*, commit .*, {isa}\)\n", version)


def test_rupture_lists_every_program_with_its_summary():
    tools, text = json_of("rupture --describe")["tools"], output_of("rupture help")
    assert {"analyze", "reproduce", *PROGRAMS, *PYTHON} == {tool["name"] for tool in tools}
    for tool in tools:
        assert f"\n  {tool['name']:<12} {tool['summary']}\n" in text
    assert output_of("rupture --help") == output_of("rupture help help") == text
    assert run("rupture") == (2, "", text)


# --- parameters


def table():
    return json_of("parameters --json")["parameters"]


def test_parameters_are_those_of_a_file():
    output_of("load -o a.h5 -q")
    in_file, rows = json_of("analyze show a.h5 --json")["parameters"], table()
    assert {row["name"]: row["default"] for row in rows} == in_file
    assert isinstance(in_file["driving.V"], float) and isinstance(in_file["slider.Nx"], int)


def test_a_restart_keeps_what_the_row_says():
    output_of("load --config small.ini -o a.h5")
    was = json_of("analyze show a.h5 --json")["parameters"]
    for row in table():
        name = row["name"]
        other = row.get("words", [7 if isinstance(was[name], int) else 0.7])[-1]
        err = run(f"restart a.h5 -o b.h5 -f --for 0 --set {name}={other}").err
        kept = f"{name} cannot change in a restart: the checkpoint has " in err
        assert kept != row["restart_may_change"], (name, err)
