#!/usr/bin/env python3
"""Symbols of plain texts as MathML, and what pictures show in words."""

import re
import sys
import unittest
import xml.etree.ElementTree as ET

from fixture import SOURCE

sys.path[:0] = [str(SOURCE / "recipes/common"), str(SOURCE / "recipes/common/report")]
from alt_text import seen  # noqa: E402  (found through the line above)
from project import listed_claims, read_readme, recipe_names  # noqa: E402
from symbols import typeset, typeset_html  # noqa: E402

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
AS_THEY_ARE = ("front_speed", "F_T_before", "A", "event I", "5 m", "a", "1/e", "multiple", "0slip")
TIDY = {
    "57 x 31": "57 × 31",
    "+-2": "±2",
    "5 <= 6 >= -2": "5 ≤ 6 ≥ −2",
    "3 um": "3 µm",
    "the slider's": "the slider’s",
    "fig-2": "fig-2",
    "<b>": "&lt;b&gt;",
}


def words(page):
    return "".join(ET.fromstring(f"<p>{page}</p>").itertext())


class Symbols(unittest.TestCase):
    def test_symbols_become_mathml(self):
        for text, mathml in MATHML.items():
            with self.subTest(text):
                self.assertEqual(typeset(f"at {text}, so"), f"at <math>{mathml}</math>, so")

    def test_neighbours_are_left(self):
        self.assertEqual(typeset("2<c_s>/3"), f"2<math><mo>⟨</mo>{C_S}<mo>⟩</mo></math>/3")
        self.assertEqual(
            words(typeset("x = 3 x 0.5, L x 2, 10 x slow")), "x = 3 × 0.5, L × 2, 10 × slow"
        )
        self.assertEqual(words(typeset("v_c>=c_s/20")), "vc≥cs/20")

    def test_other_words_are_left(self):
        for text in AS_THEY_ARE:
            self.assertEqual(typeset(text), text)

    def test_signs_are_tidied(self):
        for text, tidy in TIDY.items():
            self.assertEqual(typeset(text), tidy)

    def test_code_and_tags_are_left(self):
        page = '<a href="x_0">a</a> <code>tau_bar_0 x 3</code>'
        self.assertEqual(typeset_html(page), page)

    def test_every_claim_is_well_formed_and_has_no_raw_symbol(self):
        for claim in listed_claims(SOURCE):
            for text in (claim.claim, claim.acceptance):
                with self.subTest(text):
                    page = typeset(text)
                    self.assertTrue(words(page))
                    self.assertNotRegex(re.sub(r"<math>.*?</math>", "", page), r"\w_\w|<\w_")


CAPTION = """Above <t_R>.

- **A, B**: what *is* slow, against Eq. S1; red: fast. More.
- **C** (`fig1-extra.png`, `c.csv`): the tau_0
  of [all](x.md).
- `a.csv`: numbers.

**D.** Another.

- **left**: of D; `d.csv`: numbers.
"""


class AltTexts(unittest.TestCase):
    def test_say_what_the_caption_says_of_the_picture(self):
        expected = {
            "fig1.png": "T. A, B: what is slow, against Eq. S1; red: fast. left: of D.",
            "fig1B.png": "T. A, B: what is slow, against Eq. S1; red: fast.",
            "fig1D.png": "T. left: of D.",
            "fig1-extra.png": "T. C: the tau 0 of all.",
        }
        for picture, text in expected.items():
            self.assertEqual(seen(picture, "T", CAPTION), text)

    def test_every_recipe_describes_its_pictures(self):
        for name in recipe_names(SOURCE):
            readme = read_readme(SOURCE / "recipes" / name / "README.md")
            named = re.findall(r"`([\w-]+\.png)`", readme.caption) or [f"{name}.png"]
            for picture in named:
                with self.subTest(picture):
                    text = seen(picture, readme.title, readme.caption)
                    self.assertGreater(len(text), len(readme.title) + 25)


if __name__ == "__main__":
    unittest.main()
