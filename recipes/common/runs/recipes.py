"""The recipes and their READMEs."""

import re
from dataclasses import dataclass


def natural(name):
    """Sorts fig2 before fig10."""
    return [(int(part), "") if part.isdigit() else (0, part) for part in re.split(r"(\d+)", name)]


def recipe_order(name):
    """fig1, fig2, ..., figS1, ..., then what belongs to no figure."""
    if re.fullmatch(r"fig\d+", name):
        group = 0
    else:
        group = 1 if re.fullmatch(r"figS\d+", name) else 2
    return group, natural(name)


def recipe_names(root):
    return sorted((path.parent.name for path in root.glob("recipes/*/rules.smk")), key=recipe_order)


def label(name):
    """Figure S3 of figS3; nothing for what belongs to no figure."""
    figure = re.fullmatch(r"fig(S?\d+)", name)
    return f"Figure {figure[1]}" if figure else ""


# --- the README of a recipe ----------------------------------------------------------------


@dataclass(frozen=True)
class Readme:
    title: str
    commands: str  # the chain, as a reader would type it
    caption: str  # Markdown


def commands_in(lines):
    """The indented code blocks."""
    blocks: list[str] = []
    block: list[str] = []
    for line in [*lines, "end"]:
        if line.startswith("    ") or (block and not line.strip()):
            block.append(line[4:].rstrip())
        elif block:
            blocks.append("\n".join(block).strip("\n"))
            block = []
    return "\n\n".join(blocks)


def read_readme(path):
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    headings = [n for n, line in enumerate(lines) if line.startswith("## ")] + [len(lines)]
    start = next((n for n in headings[:-1] if lines[n].strip() == "## Caption"), len(lines))
    end = next((n for n in headings if n > start), len(lines))
    return Readme(
        title=lines[0].lstrip("# ").strip() if lines else path.parent.name,
        commands=commands_in(lines[:start] + lines[end:]),
        caption="\n".join(lines[start + 1 : end]).strip(),
    )
