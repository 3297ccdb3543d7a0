"""Maps of front types for other lengths and nucleation energies."""

from rupture.figures import DOUBLE, lettered, save

from measure.front_map import types_of, write_variants
from measure.map_panels import draw_key, draw_regions
from robustness.commands import geometry

TITLES = {
    "L x 0.75": r"$0.75\,L$",
    "L x 1.5": r"$1.5\,L$",
    "trigger 0.2": r"$\bar\tau_\mathrm{trigger} = 0.2$",
    "trigger 0.4": r"$\bar\tau_\mathrm{trigger} = 0.4$",
}


def draw(maps, stem):
    fig, panels = lettered("ABCD", DOUBLE, 0.32 * DOUBLE, sharey=True)
    for text, (name, fronts) in zip("ABCD", maps.items()):
        types = types_of(fronts)
        draw_regions(panels[text], types, types)
        panels[text].set(title=TITLES[name], **({} if text == "A" else {"ylabel": ""}))
    draw_key(panels["D"])
    save(fig, stem)


def make(results):
    draw(geometry(), results / "geometry")
    write_variants(results / "geometry.csv", geometry())
