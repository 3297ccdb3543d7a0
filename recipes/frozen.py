"""What claims are judged on: seeds and places, as frozen.toml has them (docs/frozen.md)."""

import tomllib
from pathlib import Path

from measure.tables import rounded

TABLE = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
SEEDS = TABLE["seeds"]  # of independent runs
SEEDS_OF_PREPARED = sorted(TABLE["prepared"])  # of prepared interfaces; the first draws a map


def tau_bars(recipe, values, step):
    """The prestress of a grid, shifted as this recipe's are."""
    return [rounded(of + TABLE["shifts"][f"{recipe} tau_bar"] * step) for of in values]


def sigma_bars(recipe, values, step):
    """The widths of a grid, shifted as this recipe's are; 0 remains, since there is none below."""
    shift = TABLE["shifts"][f"{recipe} sigma_bar"] * step
    return [rounded(of + shift) if of > 0 else of for of in values]
