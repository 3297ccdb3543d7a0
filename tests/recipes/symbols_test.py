"""Symbols of plain texts as MathML, and what pictures show in words."""

import re
import types

import pytest

from report.caption import as_html, filled, seen
from report.symbols import typeset

C_S = "<msub><mi>c</mi><mi>s</mi></msub>"
TAU_BAR = '<mover><mi>τ</mi><mo stretchy="false">¯</mo></mover>'
TYPESET = {
    "at v_slow slip": "at <math><msub><mi>v</mi><mtext>slow slip</mtext></msub></math>",
    "tau_bar_0": f"<math><msub>{TAU_BAR}<mn>0</mn></msub></math>",
    "<c_s>": f"<math><mo>⟨</mo>{C_S}<mo>⟩</mo></math>",
    "1e-12": "<math><msup><mn>10</mn><mn>−12</mn></msup></math>",
    "57 x 31 > front_speed <b>": "57 × 31 &gt; front_speed &lt;b&gt;",
}


@pytest.mark.parametrize("text", TYPESET)
def test_symbols_become_mathml_and_other_words_are_left(text):
    assert typeset(text) == TYPESET[text]


def test_alternative_texts_say_what_the_caption_says_of_the_picture():
    caption = "Above <t_R>.\n\n- **A, B**: what *is* slow, against Eq. S1; red: fast. More.\n"
    assert seen("fig1.png", "T", caption) == "T. A, B: what is slow, against Eq. S1; red: fast."


def test_measured_texts_are_no_markdown():
    text = "[a](javascript:b) ![c](https://d.e/f.png) *g* <https://h.i>"
    claim = types.SimpleNamespace(id="2A", measured={"type": text})
    shown = as_html(filled("It is {2A: type}.", [claim]), ())
    assert not re.findall("<(?!/?(p|math|mi)>)", shown) and "[a](javascript:b)" in shown
