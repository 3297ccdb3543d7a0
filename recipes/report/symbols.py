"""Symbols as plain texts write them become MathML: tau_bar_0, c_s, <t_R>, R^2, 3e-12.

A symbol is a Greek letter, by its name or itself, or a Latin one. What may follow: `_bar`, an index
(`_0`, `_ij`, `_thres`) and a power (`^2`). A Latin letter alone is one only if it is among ALONE,
for "A" is a panel and "m" a unit. `code` stays as it is.
"""

import re

from markupsafe import Markup, escape

GREEK = dict(alpha="α", delta="δ", eta="η", mu="μ", phi="φ", rho="ρ", sigma="σ", tau="τ")
ALONE = "KLVhkptx"
TWO_WORDS = "slow[ ]slip"  # an index with a space: v_slow slip
BAR = "\u0304"

# Texts are HTML already, in which < is written &lt;
TIMES = re.compile(r"(?<=\d )x(?= )|(?<=[\w;)] )x(?= [\d{])")  # 57 x 31, L x 2, not x = 3
TIDY = [
    (re.compile(r"&lt;="), "≤"),
    (re.compile(r"&gt;="), "≥"),
    (re.compile(r"\+-"), "±"),
    (re.compile(r"\bR²"), "R^2"),
    (re.compile(r"&#39;|'"), "’"),
    (TIMES, "×"),
    (re.compile(r"(?<=\d[ \u00a0])u(?=[ms]\b)"), "µ"),  # 3 um
    (re.compile(r"(?<=\s)-(?=\s)|(?<![\w.)])-(?=[\d.])"), "−"),
]
POWER_OF_TEN = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?)e([+-]?)0*(\d+)(?!\w)")
SYMBOL = re.compile(
    rf"""(?:(?P<mean>&lt;|⟨)|(?<![\w’&]))
    (?P<change>[Δδ]|delta_)?
    (?P<name>{"|".join(GREEK)}|[α-ωΑ-Ω]|[A-Za-z](?=[_^])|[{ALONE}])
    (?P<bar>[_-]bar|{BAR})?
    (?:_(?P<index>{TWO_WORDS}|[A-Za-z0-9]+))?
    (?:\^(?P<power>-?\d+))?
    (?!\w)(?(mean)(?:&gt;|⟩))""",
    re.VERBOSE,
)
MATH = r"<math>(?:(?!</math>).)*</math>"
UNITS = "%|[mcnµμu]?[ms]|[kM]?N|[GM]?Pa|L|m?m/s"
SIGN = "(?:[=≤≥≈]|&[lg]t;)"
BEFORE_UNIT = rf"(?<=[\d\]])\s(?=(?:{UNITS})(?!\w))"
UNBROKEN = re.compile(  # x = 2 cm
    rf"(?<=[\w>])\s(?={SIGN}\s?[\d−])|(?:(?<=[=≤≥≈])|(?<=&[lg]t;))\s(?=[\d−])|{BEFORE_UNIT}"
)
WHOLE = re.compile(rf"[\[(]?(?:{MATH}|[\w.\]]+)(?:[/\u00a0](?:{MATH}|{SIGN}|[\w.%−]+))+")  # c_s/3
KEPT = re.compile(r"(<code.*?</code>|<[^>]*>)", re.DOTALL)  # code and tags


def in_math(content):
    return f"<math>{content}</math>"


def index(text):
    """Numbers and words are upright; of two letters, each is an index."""
    if text.isdigit():
        return f"<mn>{text}</mn>"
    if len(text) > 2:
        return f"<mtext>{text}</mtext>"
    letters = "".join(f"<mi>{letter}</mi>" for letter in text)
    return f"<mrow>{letters}</mrow>" if len(text) > 1 else letters


def with_scripts(base, below, above):
    if below and above:
        return f"<msubsup>{base}{below}{above}</msubsup>"
    if below:
        return f"<msub>{base}{below}</msub>"
    return f"<msup>{base}{above}</msup>" if above else base


def of_symbol(found):
    base = f"<mi>{GREEK.get(found['name'], found['name'])}</mi>"
    if found["bar"]:
        base = f'<mover>{base}<mo stretchy="false">¯</mo></mover>'
    below = index(found["index"]) if found["index"] else ""
    power = (found["power"] or "").replace("-", "−")
    symbol = with_scripts(base, below, f"<mn>{power}</mn>" if power else "")
    if found["change"]:
        sign = "Δ" if found["change"] == "Δ" else "δ"
        symbol = f'<mi mathvariant="normal">{sign}</mi>{symbol}'
    return in_math(f"<mo>⟨</mo>{symbol}<mo>⟩</mo>" if found["mean"] else symbol)


def of_power(found):
    factor, sign, exponent = found.groups()
    ten = f"<msup><mn>10</mn><mn>{'−' if sign == '-' else ''}{exponent}</mn></msup>"
    return in_math(ten if factor == "1" else f"<mn>{factor}</mn><mo>×</mo>{ten}")


def in_text(text):
    for pattern, better in TIDY:
        text = pattern.sub(better, text)
    text = SYMBOL.sub(of_symbol, POWER_OF_TEN.sub(of_power, UNBROKEN.sub("\u00a0", text)))
    whole = '<span class="whole">{}</span>'
    return WHOLE.sub(lambda f: whole.format(f[0]) if "<math>" in f[0] else f[0], text)


def typeset_html(page):
    parts = KEPT.split(page)  # texts, and between them what is kept
    return Markup("".join(part if n % 2 else in_text(part) for n, part in enumerate(parts)))


def typeset(text):
    """The HTML of a plain text."""
    return typeset_html(str(escape(text)))
