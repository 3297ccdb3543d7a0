"""Maps of front types for other lengths and nucleation energies."""

from measure.tables import rows_of
from measure import front_map
from measure.front_map import types_of
from measure.map_panels import draw_key, draw_regions
from rupture.figures import DOUBLE, lettered, save

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


def make(chains, results):
    points = [*chains["geometry"], *chains["geometry_seeds"]]
    maps = front_map.read_variants(rows_of(points), TITLES)
    draw(maps, results / "geometry")
    front_map.write_variants(results / "geometry.csv", maps)
