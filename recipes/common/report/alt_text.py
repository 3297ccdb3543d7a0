"""What a picture shows, in words for those who do not see it, from the caption of its recipe."""

import re

FILES = r" \((?:`[^`]*`(?:, )?)+\)"  # in parentheses
LINK = r"\[([^\]]*)\]\([^)]*\)"
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
    plain = re.sub(MARKS, "", re.sub(LINK, r"\1", re.sub(FILES, "", "; ".join(clauses))))
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
