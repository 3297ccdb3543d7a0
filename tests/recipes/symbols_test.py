"""Symbols of plain texts as MathML, and what pictures show in words."""

import re
import types
import xml.etree.ElementTree as ET

import pytest

from caption import as_html, filled, seen
from claims.judge import table
from conftest import ROOT
from runs.recipes import read_readme, recipe_names
from symbols import typeset, typeset_html

C_S = "<msub><mi>c</mi><mi>s</mi></msub>"
TAU_BAR = '<mover><mi>τ</mi><mo stretchy="false">¯</mo></mover>'
MATHML = {
    "c_s": C_S,
    "mu": "<mi>μ</mi>",
    "k_ij": "<msub><mi>k</mi><mrow><mi>i</mi><mi>j</mi></mrow></msub>",
    "f_thres": "<msub><mi>f</mi><mtext>thres</mtext></msub>",
    "v_slow slip": "<msub><mi>v</mi><mtext>slow slip</mtext></msub>",
    "tau_bar_0": f"<msub>{TAU_BAR}<mn>0</mn></msub>",
    "τ̄": TAU_BAR,
    "R^2": "<msup><mi>R</mi><mn>2</mn></msup>",
    "l_0^2": "<msubsup><mi>l</mi><mn>0</mn><mn>2</mn></msubsup>",
    "<c_s>": f"<mo>⟨</mo>{C_S}<mo>⟩</mo>",
    "⟨c_s⟩": f"<mo>⟨</mo>{C_S}<mo>⟩</mo>",
    "Δt": '<mi mathvariant="normal">Δ</mi><mi>t</mi>',
    "delta_t_R": '<mi mathvariant="normal">δ</mi><msub><mi>t</mi><mi>R</mi></msub>',
    "6.66e-16": "<mn>6.66</mn><mo>×</mo><msup><mn>10</mn><mn>−16</mn></msup>",
    "1e-12": "<msup><mn>10</mn><mn>−12</mn></msup>",
}
AS_THEY_ARE = ("front_speed", "F_T_before", "A", "event I", "a", "1/e", "multiple", "0slip")
TIDY = {
    "57 x 31": "57 × 31",
    "+-2": "±2",
    "5 <= 6 >= -2": "5\u00a0≤\u00a06\u00a0≥\u00a0−2",
    "3 um": "3\u00a0µm",
    "y = 2 cm, 30 % of 3 events": "y\u00a0=\u00a02\u00a0cm, 30\u00a0% of 3 events",
    "the slider's": "the slider’s",
    "fig-2": "fig-2",
    "<b>": "&lt;b&gt;",
    **{text: text for text in AS_THEY_ARE},
}
READ = {  # as it is read aloud
    "x = 3 x 0.5, L x 2, 10 x slow": "x\u00a0=\u00a03 × 0.5, L × 2, 10 × slow",
    "v_c>=c_s/20": "vc≥cs/20",
}


def words(page):
    return "".join(ET.fromstring(f"<p>{page}</p>").itertext())


@pytest.mark.parametrize("text", MATHML)
def test_symbols_become_mathml(text):
    assert typeset(f"at {text}, so") == f"at <math>{MATHML[text]}</math>, so"


@pytest.mark.parametrize("text", TIDY)
def test_signs_are_tidied_and_other_words_left(text):
    assert typeset(text) == TIDY[text]


@pytest.mark.parametrize("text", READ)
def test_neighbours_are_left(text):
    assert words(typeset(text)) == READ[text]


def test_factors_code_and_tags_are_left():
    mean = f"<math><mo>⟨</mo>{C_S}<mo>⟩</mo></math>"
    assert typeset("2<c_s>/3") == f'2<span class="whole">{mean}/3</span>'
    page = '<a href="x_0">a</a> <code>tau_bar_0 x 3</code>'
    assert typeset_html(page) == page


@pytest.mark.parametrize("claim", table())
def test_every_claim_is_well_formed_and_has_no_raw_symbol(claim):
    for page in (typeset(table()[claim][name]) for name in ("says", "accepted")):
        assert words(page)
        assert not re.search(r"\w_\w|<\w_", re.sub(r"<math>.*?</math>", "", page))


CAPTION = """Above <t_R>.

- **A, B**: what *is* slow, against Eq. S1; red: fast. More.
- **C** (`fig1-extra.png`, `c.csv`): the tau_0
  of [all](x.md).
- `a.csv`: numbers.

**D.** Another.

- **left**: of D; `d.csv`: numbers.
"""
ALT_TEXTS = {
    "fig1.png": "T. A, B: what is slow, against Eq. S1; red: fast. left: of D.",
    "fig1B.png": "T. A, B: what is slow, against Eq. S1; red: fast.",
    "fig1D.png": "T. left: of D.",
    "fig1-extra.png": "T. C: the tau 0 of all.",
}


@pytest.mark.parametrize("picture", ALT_TEXTS)
def test_alternative_texts_say_what_the_caption_says_of_the_picture(picture):
    assert seen(picture, "T", CAPTION) == ALT_TEXTS[picture]


@pytest.mark.parametrize("name", recipe_names(ROOT))
def test_every_recipe_describes_its_pictures(name):
    readme = read_readme(ROOT / "recipes" / name / "README.md")
    for picture in re.findall(r"`([\w-]+\.png)`", readme.caption) or [f"{name}.png"]:
        assert len(seen(picture, readme.title, readme.caption)) > len(readme.title) + 25


def test_measured_texts_are_no_markdown():
    text = "[a](javascript:b) ![c](https://d.e/f.png) *g* <https://h.i>"
    claim = types.SimpleNamespace(id="2A", measured={"type": text})
    shown = as_html(filled("It is {2A: type}.", [claim]), ())
    assert not re.findall("<(?!/?(p|math|mi)>)", shown) and "[a](javascript:b)" in shown
