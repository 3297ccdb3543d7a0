"""Symbols as plain texts write them, in Unicode: tau_bar and <t_R> become τ̄ and ⟨t_R⟩. In HTML,
what follows _ is an index, and ^ a power. What stands in `code` stays as it is."""

import re

from markupsafe import Markup, escape

GREEK = dict(alpha="α", delta="δ", eta="η", mu="μ", phi="φ", rho="ρ", sigma="σ", tau="τ")
LETTER = re.compile(rf"(?<![^\W_])({'|'.join(GREEK)})([_-]bar)?(?![^\W_])")
SIGNS = [
    (re.compile(r"<(\w+_\w+)>"), r"⟨\1⟩"),
    (re.compile("<="), "≤"),
    (re.compile(">="), "≥"),
    (re.compile(r"\+-"), "±"),
    (re.compile(r"(?<=\d )x(?= \d)"), "×"),
]
INDEX = re.compile(r"(?<![^\W_])([^\W\d_]\u0304?)_(slow[ ]slip|[A-Za-z0-9]+)(?!\w)")
POWER = re.compile(r"(?<=\w)\^(-?\d+)")


def outside(kept, change, text):
    """The text, changed but for what the pattern `kept` finds."""
    parts = re.split(f"({kept})", text, flags=re.DOTALL)
    return "".join(part if n % 2 else change(part) for n, part in enumerate(parts))


def with_signs(text):
    for pattern, sign in SIGNS:
        text = pattern.sub(sign, text)
    return LETTER.sub(lambda found: GREEK[found[1]] + ("\u0304" if found[2] else ""), text)


def with_indexes(text):
    return POWER.sub(r"<sup>\1</sup>", INDEX.sub(r"\1<sub>\2</sub>", text))


def in_unicode(text):
    """A plain text, or one in Markdown."""
    return outside("`[^`]*`", with_signs, text)


def in_html(page):
    """HTML with indexes and powers."""
    return Markup(outside("<code.*?</code>|<[^>]*>", with_indexes, page))


def typeset(text):
    """The HTML of a plain text."""
    return in_html(str(escape(in_unicode(text))))
