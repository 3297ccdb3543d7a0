"""Man pages and completion, from what the programs say of themselves (--describe).

manual.py FOLDER_OF_PROGRAMS OUTPUT VERSION

writes OUTPUT/man/rupture.1.gz and a page per tool and command, OUTPUT/rupture for bash,
OUTPUT/_rupture for zsh.
"""

import gzip
import json
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import jinja2

# The files behind `input` or `holds` of a description; any file if it is not here.
PATTERNS = {
    "checkpoint": "*.h5",
    "record": "*.[hp]*[5t]",  # .h5 or .h5.part
    "file": "*.h5",
    "options and parameters": "*.ini",
}
EXAMPLES = Path(__file__).with_name("examples.sh")
ROFF = {"\\": r"\e", "-": r"\-", "'": r"\(aq", "`": r"\(ga", "^": r"\(ha", "~": r"\(ti"}


def roff(text):
    """Text that troff prints as it is."""
    escaped = "".join(ROFF.get(letter, letter) for letter in " ".join(text.split()))
    return f"\\&{escaped}" if escaped.startswith(".") else escaped


def answer(program, *words):
    result = subprocess.run([program, *words], check=True, capture_output=True, text=True)
    return json.loads(result.stdout)


def with_defaults(tool):
    empty: dict = {"input": None, "words": [], "options": [], "commands": [], "parameters": False}
    tool = empty | tool
    option = {"holds": "", "words": [], "short": None, "value": "", "unit": "", "default": None}
    tool["options"] = [option | known for known in tool["options"]]
    tool["commands"] = [with_defaults(command) for command in tool["commands"]]
    return tool


def leaves(tools):
    """What takes options: the tools, and in place of one with commands its commands."""
    return [leaf for tool in tools for leaf in tool["commands"] or [tool]]


def explained(things, before="", after="", key="name"):
    texts = ((one[key], one.get("summary") or one["help"]) for one in things if one[key])
    return [f"{before}{name.split()[-1]}{after}:{text}" for name, text in texts]


def files(holds):
    return [f":{PATTERNS.get(holds, '*')}"]


def values_of(option, parameters):
    if "|" in option["value"]:
        return option["words"] or option["value"].split("|")[1:]
    if option["kind"] == "parameter":
        return explained(parameters, after="=")
    return files(option["holds"]) if option["kind"] in ("input file", "output file") else []


def arguments_of(leaf, parameters):
    """Any file of what describes neither options nor input."""
    if leaf["input"] == "parameter":
        return explained(parameters)
    if leaf["input"] == "word":
        return leaf["words"]
    return files(leaf["input"]) if leaf["input"] or not leaf["options"] else []


def completions(tools, parameters):
    """What may follow, by the words before: WORD:EXPLANATION or WORD, and last :PATTERN of files,
    which may follow if no word fits."""
    found = {"help": explained(tools)}
    found[""] = ["help:say how a tool is used", *found["help"], "--help", "--version"]
    for tool in tools:
        if tool["commands"]:
            found[tool["name"]] = explained(tool["commands"])
            found[f"help {tool['name']} "] = found[tool["name"]]
    for leaf in leaves(tools):
        name = leaf["name"]
        shorts = explained(leaf["options"], before="-", key="short")
        found[f"{name} -"] = explained(leaf["options"], before="--") + shorts
        found[f"{name} *"] = arguments_of(leaf, parameters)
        for option in leaf["options"]:
            if option["kind"] != "flag":
                found[f"{name} --{option['name']}"] = values_of(option, parameters)
                if option["short"]:
                    found[f"{name} -{option['short']}"] = values_of(option, parameters)
    found |= {f"{row['name']}=": row["words"] for row in parameters}
    found["reproduce sweep"] = files("options and parameters")
    return found


def templates():
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(Path(__file__).parent),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters |= {"roff": roff, "quoted": shlex.quote}
    return environment


def main(programs, output, version):
    programs, output = Path(programs), Path(output)
    rupture = answer(programs / "rupture", "--describe")
    listed = rupture.pop("tools")
    tools = [with_defaults(one | answer(programs / one["name"], "--describe")) for one in listed]
    rows = answer(programs / "parameters", "--json")["parameters"]
    parameters = [{"words": []} | row for row in rows]
    environment = templates()
    environment.globals |= {
        "tools": tools,
        "completions": completions(tools, parameters),
        "parameters": parameters,
        "examples": EXAMPLES.read_text(encoding="utf-8").splitlines(),
        "version": version,
    }
    shutil.rmtree(output / "man", ignore_errors=True)  # of an earlier build, with other tools
    (output / "man").mkdir(parents=True)
    top = with_defaults(rupture | {"name": "", "commands": tools})
    for tool in [top, *tools, *leaves(tools)]:
        page = f"rupture-{tool['name']}".replace(" ", "-").removesuffix("-")
        text = environment.get_template("page.1.j2").render(tool=tool, page=page)
        path = output / f"man/{page}.1.gz"
        path.write_bytes(gzip.compress(text.encode(), 9, mtime=0))
    for name in ("rupture", "_rupture"):
        text = environment.get_template(f"{name}.j2").render()
        (output / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
