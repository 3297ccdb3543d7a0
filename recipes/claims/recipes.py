"""Which recipes there are, and their READMEs."""

import re
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

RECIPES = Path(__file__).resolve().parents[1]


def natural(name):
    """Sorts fig2 before fig10."""
    return [(int(part), "") if part.isdigit() else (0, part) for part in re.split(r"(\d+)", name)]


def recipe_names(root):
    """fig1, ..., figS1, ..., then what belongs to no figure; then PAPER/fig1, ... of others."""
    recipes = root / "recipes"
    names = (str(path.parent.relative_to(recipes)) for path in recipes.rglob("commands.py"))
    return sorted(names, key=lambda name: (paper_of(name), not label(name), natural(name)))


def paper_of(name):
    """PAPER of its recipe PAPER/fig1, or claim PAPER/2A; nothing of the first paper."""
    return name.rpartition("/")[0]


def label(name):
    """Figure S3 of figS3; nothing for what belongs to no figure."""
    figure = re.fullmatch(r"(?:.*/)?fig(S?\d+)", name)
    return f"Figure {figure[1]}" if figure else ""


def function_of(recipe, name):
    """`deviation` in its commands.py, or `lengths.median` in another module of it."""
    module, _, function = name.rpartition(".")
    return getattr(import_module(f"{recipe.replace('/', '.')}.{module or 'commands'}"), function)


@dataclass(frozen=True)
class Readme:
    title: str
    commands: str  # as a reader would type them
    caption: str  # Markdown


def commands_in(text):
    """The indented code blocks."""
    blocks = re.findall(r"^ {4}.*(?:\n(?: {4}.*| *$))*", text, re.MULTILINE)
    return "\n\n".join(
        re.sub("^ {4}| +$", "", each, 0, re.MULTILINE).strip("\n") for each in blocks
    )


def read_readme(path):
    text = path.read_text(encoding="utf-8") if path.exists() else ""
    sections = re.split("^(?=## )", text, flags=re.MULTILINE)
    caption = next((each for each in sections if each.startswith("## Caption\n")), "")
    return Readme(
        title=text.partition("\n")[0].lstrip("# ").strip() if text else path.parent.name,
        commands=commands_in("".join(each for each in sections if each != caption)),
        caption=caption.removeprefix("## Caption").strip(),
    )
