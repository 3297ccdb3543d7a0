#!/usr/bin/env python3
"""Draws docs/model.svg: the slider, a block with its springs, and a junction.

    PYTHONPATH=recipes:python python3 -m report.model_drawing
"""

import re
from html import escape
from pathlib import Path

from rupture.plotting import BLACK, BLUE, GREEN, VERMILION

DRAWING = Path(__file__).resolve().parents[2] / "docs/model.svg"
GREY = "#999999"
WIDTH, HEIGHT = 900, 330


def path(points, colour=BLACK, width=1.5, dashes=""):
    ends = " L".join(f"{x:g} {y:g}" for x, y in points)
    dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
    return f'<path d="M{ends}" fill="none" stroke="{colour}" stroke-width="{width:g}"{dashed}/>'


def spring(start, end, colour=BLACK, turns=6, size=4):
    """A zigzag with straight ends."""
    (x, y), dx, dy = start, end[0] - start[0], end[1] - start[1]
    length = (dx**2 + dy**2) ** 0.5
    steps = [0, 0.2, *(0.2 + 0.6 * (n + 0.5) / turns for n in range(turns)), 0.8, 1]
    sides = [0, 0, *(size * (-1) ** n / length for n in range(turns)), 0, 0]
    points = [
        (round(x + s * dx - w * dy, 2), round(y + s * dy + w * dx, 2)) for s, w in zip(steps, sides)
    ]
    return path(points, colour)


def arrow(start, end, colour=BLACK):
    (x, y), dx, dy = end, end[0] - start[0], end[1] - start[1]
    length = (dx**2 + dy**2) ** 0.5
    a, b = 8 * dx / length, 8 * dy / length
    head = [(x - a - b / 2, y - b + a / 2), end, (x - a + b / 2, y - b - a / 2)]
    return path([start, end], colour) + path([(round(u, 2), round(v, 2)) for u, v in head], colour)


def dot(x, y, radius=3.5):
    return f'<circle cx="{x:g}" cy="{y:g}" r="{radius:g}" fill="{BLACK}"/>'


def text(x, y, words, anchor="middle", size=14, colour=BLACK):
    """What follows _ is an index."""
    lower = r'<tspan dy="4" font-size="10">\1</tspan><tspan dy="-4">&#8203;</tspan>'
    said = re.sub(r"_(\w+)", lower, escape(words))
    look = f'text-anchor="{anchor}" font-size="{size}" fill="{colour}"'
    return f'<text x="{x:g}" y="{y:g}" {look}>{said}</text>'


def slider():
    """Columns and rows are fewer than in the model."""
    xs, ys = [90 + 30 * n for n in range(7)], [90 + 30 * n for n in range(5)]
    drawn = [text(180, 20, "a  slider, loading and interface")]
    for x in xs:
        drawn += [arrow((x, 50), (x, 78)), path([(x, ys[0]), (x, ys[-1])], GREY, 1)]
        drawn += [spring((x, ys[-1]), (x, 250), BLUE)]
        drawn += [spring((x, ys[-1]), (x + 16, 250), VERMILION)]
    drawn += [path([(xs[0], y), (xs[-1], y)], GREY, 1) for y in ys]
    drawn += [dot(x, y) for x in xs for y in ys]
    drawn += [path([(60, 250), (300, 250)], BLACK, 2), text(180, 44, "F_N")]
    drawn += [spring((35, ys[-2]), (xs[0], ys[-2]), GREEN), text(60, ys[-2] - 12, "K")]
    drawn += [arrow((15, ys[-2] + 22), (45, ys[-2] + 22), GREEN), text(30, ys[-2] + 40, "V")]
    drawn += [path([(300, ys[-2]), (300, ys[-1])]), text(312, ys[-2] + 20, "h", "start")]
    drawn += [arrow((60, 290), (120, 290)), text(130, 295, "x", "start")]
    drawn += [arrow((60, 290), (60, 262)), text(48, 270, "z")]
    drawn += [text(160, 275, "foundation k_f", "start", 12, BLUE)]
    return drawn + [text(160, 295, "N_s junctions per block", "start", 12, VERMILION)]


def block():
    """A block with its eight neighbours."""
    x, y, far = 450, 150, 70
    drawn = [text(x, 20, "b  block and its springs")]
    for a, b in [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)]:
        end = x + a * far, y + b * far
        drawn += [spring((x, y), end, BLACK if a * b == 0 else GREY, 8), dot(*end)]
    drawn += [dot(x, y, 6), text(x + 40, y - 10, "k, η")]
    drawn += [text(x + 48, y + 36, "k/2, η", "start", colour=GREY)]
    drawn += [text(x, 255, "m = M/(N_x N_z)")]
    return drawn + [text(x, 280, "k = 3BE/4,  η² = 0.1 k m", size=12)]


def junction():
    """The force of a junction while its block moves on."""
    x, y = 620, 230
    drawn = [text(740, 20, "c  force of a junction")]
    drawn += [arrow((x, y), (x + 250, y)), arrow((x, y), (x, 60)), text(x + 235, y + 20, "x_i")]
    drawn += [text(x - 8, 55, "f_T", "end"), path([(x, 90), (x + 240, 90)], GREY, 1, "4 4")]
    drawn += [path([(x, 165), (x + 240, 165)], GREY, 1, "4 4")]
    drawn += [text(x - 6, 94, "f_thres", "end"), text(x - 6, 169, "f_slip", "end")]
    drawn += [path([(x, y), (x + 70, 90)], VERMILION, 2.5), text(x + 22, 140, "k_ij", "end")]
    drawn += [path([(x + 70, 90), (x + 70, 165)], VERMILION, 2.5, "3 3")]
    drawn += [path([(x + 70, 165), (x + 150, 165)], VERMILION, 2.5)]
    drawn += [path([(x + 150, 165), (x + 150, y)], VERMILION, 2.5, "3 3")]
    drawn += [path([(x + 150, y), (x + 220, 90)], VERMILION, 2.5)]
    drawn += [text(x + 74, 82, "breaks", "start", 12), text(x + 110, 157, "slips for t_R", size=12)]
    drawn += [text(x + 154, 222, "pinned, f_new = 0", "start", 12)]
    law = "f_thres = μ_s f_N,  f_slip = μ_d f_N,  f_N = p_i/N_s"
    return drawn + [text(740, 280, law, size=12)]


def drawing():
    parts = "\n".join([*slider(), *block(), *junction()])
    view = f'viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}"'
    white = f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>'
    head = f'<svg xmlns="http://www.w3.org/2000/svg" {view} font-family="sans-serif">'
    return f"{head}\n{white}\n{parts}\n</svg>\n"


if __name__ == "__main__":
    DRAWING.write_text(drawing(), encoding="utf-8")
