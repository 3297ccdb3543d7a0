"""Captions, from a recipe's README (recipes/README.md says how): Markdown with measured numbers,
symbols and links."""

import re

import markdown
from markupsafe import Markup

from claims.claim import number, split_unit
from rupture.errors import Failure
from report.symbols import in_html, in_unicode

NOT_RUN = "not run"
PLACE = re.compile(r"\{([\w/-]+):\s([^{}]+)\}")  # {claim: quantity [unit]}
SENTENCE = re.compile(r"((?<=\.)\s+(?=[A-Z{])|\n\s*\n|\n(?=- ))")  # what ends one, or an item
MARKS_OF_MARKDOWN = re.compile(r"[\\`*_\[\]!]")
LINK = re.compile(r'<a href="(?!https?:|#)([^"]*)">(.*?)</a>', re.DOTALL)
RAW = ("html", "autolink", "automail", "image_link", "image_reference")  # what stays text


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


def filled(text, claims):
    """The text with its places filled. A place may extend over the end of a line. Raises Failure if
    one names a quantity that was not measured."""
    known = {(one.id, k): value_text(k, v) for one in claims for k, v in one.measured.items()}
    measured = {claim_id for claim_id, _ in known}
    for claim_id, name in PLACE.findall(text):
        if claim_id in measured and (claim_id, " ".join(name.split())) not in known:
            raise Failure(
                f"A caption has {{{claim_id}: {name}}}, which {claim_id} does not measure."
            )
    parts = SENTENCE.split(text)  # sentences, and between them what ends one
    return "".join(p if n % 2 else filled_sentence(p, known) for n, p in enumerate(parts))


# --- as HTML -------------------------------------------------------------------------------


def link(found, shown):
    """A link to the section of another recipe, if the page has it; to no file: it may not be
    there."""
    address, text = found.groups()
    recipe = re.fullmatch(r"\.\./(\w+)/(README\.md)?", address)
    return f'<a href="#{recipe[1]}">{text}</a>' if recipe and recipe[1] in shown else text


def converted(text):
    """Markdown as HTML, in which tags are text: <t_R> is a quantity."""
    toc = {"toc": {"baselevel": 2, "permalink": False}}
    converter = markdown.Markdown(extensions=["toc"], extension_configs=toc, output_format="html")
    converter.preprocessors.deregister("html_block")
    for pattern in RAW:
        converter.inlinePatterns.deregister(pattern)
    return converter.convert(in_unicode(text))


def as_html(text, shown):
    """`shown` are the recipes that have a section on the page."""
    return in_html(LINK.sub(lambda found: link(found, shown), converted(text)))


def seen(picture, title, caption):
    """The alternative text of a picture: the title, and the first sentence of the part of the
    caption that names its file, or else of the caption."""
    parts = re.split(r"\n(?=- )|\n\s*\n", caption)
    part = next((one for one in parts if f"`{picture}`" in one), parts[0])
    part = part.removeprefix("- ").removeprefix(f"`{picture}`: ")
    sentence = re.split(r"(?<!Eq)(?<!Fig)\.\s", re.sub(r" \(`.*?`\)", "", part), maxsplit=1)[0]
    return f"{in_unicode(title)}. {Markup(converted(sentence)).striptags().rstrip('.:;')}."
