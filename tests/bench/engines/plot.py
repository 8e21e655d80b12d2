"""The geometric means of the tables of docs/motions.md, from record.json, as a picture: for each engine a line per tool, from
its untouched mesh to the tuned one.

Usage: python tests/bench/engines/plot.py OUT.svg
"""

import sys

import numpy as np

from record import Record
from simplifiers import OURS
from tables import cells_of, complete_cells, means, methods_of

WIDTH, LEFT, RIGHT = 760, 210, 30
ROW, HEAD, GAP, AXIS = 20, 26, 12, 34
OUR_COLOUR, OTHER_COLOUR = "#3876c9", "#c9744f"
NAMES = {"limber": "Limber", "update + Regularize": "meshoptimizer", "pymeshlab, planar": "pymeshlab (planar)"}


def text(x, y, words, anchor="start", style=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {style}>{words}</text>'


def rows_of(cells):
    """[(method, untouched, tuned)]"""
    found = means(cells)
    return [(method, found[method, "untouched"], found[method, "tuned"]) for method in methods_of(cells)]


def svg(record):
    found = [(title, len(complete_cells(cells)), rows_of(cells)) for title, cells in cells_of(record.motions).items()]
    values = [value for _, _, rows in found for _, *pair in rows for value in pair]
    low, high = np.log10(min(values)) - 0.08, np.log10(max(values)) + 0.08
    at = lambda value: LEFT + (np.log10(value) - low) / (high - low) * (WIDTH - LEFT - RIGHT)
    parts, y = [], 8
    for title, count, rows in found:
        parts.append(text(8, y + 16, f"{title} (mean of {count})", style='font-weight="600"'))
        y += HEAD
        for method, before, after in rows:
            colour, middle = OUR_COLOUR if method in OURS else OTHER_COLOUR, y + ROW / 2
            parts.append(text(LEFT - 14, middle + 4, NAMES.get(method, method), "end"))
            parts.append(f'<line x1="{at(before):.1f}" x2="{at(after):.1f}" y1="{middle}" y2="{middle}" stroke="{colour}" '
                         'stroke-width="2"/>')
            parts.append(f'<circle cx="{at(before):.1f}" cy="{middle}" r="4" fill="#fff" stroke="{colour}" stroke-width="2"/>')
            parts.append(f'<circle cx="{at(after):.1f}" cy="{middle}" r="5" fill="{colour}"/>')
            y += ROW
        y += GAP
    ticks = [value for value in (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20) if low <= np.log10(value) <= high]
    grid = [f'<line x1="{at(t):.1f}" x2="{at(t):.1f}" y1="8" y2="{y}" stroke="#d6dbe2"/>' for t in ticks]
    parts += [text(at(t), y + 16, f"{t:g} %", "middle") for t in ticks]
    parts.append(text(WIDTH - RIGHT, y + 32, "distance from the original; open: untouched, filled: tuned", "end"))
    height = y + AXIS + 6
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" font-family="sans-serif" font-size="12" '
            f'fill="#28303c"><rect width="{WIDTH}" height="{height}" fill="#fafbfd"/>{"".join(grid + parts)}</svg>\n')


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(svg(Record.load()))
