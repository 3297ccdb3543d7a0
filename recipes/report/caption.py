"""Captions, from a recipe's README (recipes/README.md says how): Markdown with measured numbers,
symbols and links, and in words for those who do not see a picture."""

import re

import markdown

from claims.claim import number, split_unit
from report.symbols import typeset_html

NOT_RUN = "not run"
PLACE = re.compile(r"\{([\w/-]+):\s([^{}]+)\}")  # {claim: quantity [unit]}
SENTENCE = re.compile(r"((?<=\.)\s+(?=[A-Z{])|\n\s*\n|\n(?=- ))")  # what ends one, or an item
MARKS_OF_MARKDOWN = re.compile(r"[\\`*_\[\]!]")
LINK = re.compile(r'<a href="(?![a-z]+:|#)([^"]*)">(.*?)</a>', re.DOTALL)  # to a file


# --- measured numbers ----------------------------------------------------------------------


def value_text(name, value):
    unit = split_unit(name)[1]
    text = MARKS_OF_MARKDOWN.sub(r"\\\g<0>", number(value))  # a text is no link
    return text if value is None else f"{text}\u00a0{unit}".rstrip()


def filled_sentence(text, known):
    """The sentence, filled; nothing if it has places and none of them can be filled."""
    places = [(claim_id, " ".join(name.split())) for claim_id, name in PLACE.findall(text)]
    if places and not known.keys() & {*places}:
        return ""
    values = (known.get(place, NOT_RUN) for place in places)
    return PLACE.sub(lambda _: next(values), text)


def of_files(text, names):
    """Without items, or their ends after a semicolon, that name files none of which is there."""
    blocks = re.split(r"(?=\n- |\n\s*\n|;\s`[\w-]+\.(?:png|csv)`)", text)
    named = [re.findall(r"`([\w-]+\.(?:png|csv))`", block) for block in blocks]
    return "".join(b for b, files in zip(blocks, named) if not files or names & {*files})


def filled(text, claims):
    """The text with its places filled. A place may extend over the end of a line."""
    known = {(one.id, k): value_text(k, v) for one in claims for k, v in one.measured.items()}
    parts = SENTENCE.split(text)  # sentences, and between them what ends one
    return "".join(p if n % 2 else filled_sentence(p, known) for n, p in enumerate(parts))


# --- as HTML -------------------------------------------------------------------------------


def link(found, shown):
    """To the section of another recipe if the page has it; to no file, which may not be there."""
    address, text = found.groups()
    recipe = re.fullmatch(r"\.\./(\w+)/(README\.md)?", address)
    return f'<a href="#{recipe[1]}">{text}</a>' if recipe and recipe[1] in shown else text


def as_html(text, shown):
    """Markdown without its HTML, of which a caption has no need: <t_R> is a quantity. `shown` are
    the recipes that have a section on the page."""
    toc = {"toc": {"baselevel": 2, "permalink": False}}
    converter = markdown.Markdown(extensions=["toc"], extension_configs=toc, output_format="html")
    converter.preprocessors.deregister("html_block")
    for pattern in ("html", "autolink", "automail"):
        converter.inlinePatterns.deregister(pattern)
    return typeset_html(LINK.sub(lambda found: link(found, shown), converter.convert(text)))


# --- in words ------------------------------------------------------------------------------

FILES = r" \((?:`[^`]*`(?:, )?)+\)"  # in parentheses
MARKDOWN_LINK = r"\[([^\]]*)\]\([^)]*\)"
MARKS = r"[*`]|<(?=\w+>)|(?<=\w)>"


def described(caption):
    """[(letters of its panels, text), ...] of the items. An item without a letter belongs to the
    last paragraph before it that begins with one, as in **A.**"""
    found, above = [], ""
    for block in re.split(r"\n(?=- )|\n\s*\n", caption):
        head = re.match(r"(?:- )?\*\*([A-Z](?:, [A-Z])*)\b", block)
        letters = head[1] if head else above
        if block.startswith("- "):
            found.append((letters, block[2:]))
        else:
            above = letters
    return found


def in_words(item):
    """Its first sentence without marks of Markdown, files and tables."""
    text = " ".join(item.split())
    sentence = re.split(r"(?<!Eq)(?<!Fig)\. ", text, maxsplit=1)[0]
    clauses = [part for part in sentence.split("; ") if not re.match(r"`[^`]*\.csv`", part)]
    plain = re.sub(MARKS, "", re.sub(MARKDOWN_LINK, r"\1", re.sub(FILES, "", "; ".join(clauses))))
    return plain.replace("_", " ").rstrip(".;")


def seen(picture, title, caption):
    """What a picture shows: the items of the caption that name its file, or else those of the
    panels in its name, or else those that name no file."""
    items = described(caption)
    panels = re.search(r"([A-Z]*)\.png$", picture)
    chosen = (
        [text for _, text in items if f"`{picture}`" in text]
        or [text for letters, text in items if panels and set(letters) & set(panels[1])]
        or [text for _, text in items if ".png`" not in text and not text.startswith("`")]
    )
    parts = [in_words(text.removeprefix(f"`{picture}`: ")) for text in chosen]
    return ". ".join(filter(None, [in_words(title), *parts])) + "."
