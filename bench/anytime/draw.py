#!/usr/bin/env python3
"""Draw what bench-anytime --csv has written: by share of the time, the share of facets found, and how
near the width of the outer projection is to the true one.

usage: draw.py FILE.csv > anytime.svg
"""

import csv
import sys

WIDTH, HEIGHT = 330, 230  # pixels of a panel
LEFT, TOP, GAP = 50, 40, 70
KEY = 110                 # pixels for the names
COLOURS = ("#1f77b4", "#ff7f0e", "#2ca02c", "#d62728", "#9467bd",
           "#8c564b", "#e377c2", "#7f7f7f", "#bcbd22", "#17becf")


def read(path):
    """Per problem: points (share of the time, facets found, true by outer width), the end included."""
    problems = {}
    with open(path) as f:
        for row in csv.DictReader(f):
            found = int(row["found"]) / int(row["facets"])
            problems.setdefault(row["problem"], []).append(
                (float(row["share"]), found, float(row["tight"])))
    return {name: points + [(1.0, 1.0, 1.0)] for name, points in problems.items()}


def panel(problems, at, column, title):
    x0, y0 = LEFT + at * (WIDTH + GAP), TOP
    lines = [f'  <text x="{x0}" y="{y0 - 14}">{title}</text>',
             f'  <rect x="{x0}" y="{y0}" width="{WIDTH}" height="{HEIGHT}" fill="none" '
             'stroke="#000000"/>']
    for tick in (0, 0.1, 0.3, 0.6, 1):
        lines.append(f'  <text x="{x0 + tick * WIDTH:g}" y="{y0 + HEIGHT + 18}" '
                     f'text-anchor="middle">{tick:.0%}</text>')
    for tick in (0, 0.5, 1):
        lines.append(f'  <text x="{x0 - 6}" y="{y0 + (1 - tick) * HEIGHT + 5:g}" '
                     f'text-anchor="end">{tick:.0%}</text>')
    for colour, points in zip(COLOURS, problems.values()):
        path = " ".join(f"{x0 + p[0] * WIDTH:.1f},{y0 + (1 - p[column]) * HEIGHT:.1f}"
                        for p in points)
        lines.append(f'  <polyline points="{path}" fill="none" stroke="{colour}" '
                     'stroke-width="2"/>')
    return lines


def draw(problems):
    width = LEFT + 2 * WIDTH + GAP + KEY + 20
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" '
             f'height="{TOP + HEIGHT + 40}" font-family="sans-serif" font-size="13">',
             '  <rect width="100%" height="100%" fill="#ffffff"/>']
    lines += panel(problems, 0, 1, "facets found, by share of the time")
    lines += panel(problems, 1, 2, "true width / outer width, by share of the time")
    for k, (colour, name) in enumerate(zip(COLOURS, problems)):
        x, y = LEFT + 2 * WIDTH + GAP + 16, TOP + 12 + 20 * k
        lines += [f'  <path d="M {x},{y} h 18" stroke="{colour}" stroke-width="3"/>',
                  f'  <text x="{x + 26}" y="{y + 5}">{name}</text>']
    return "\n".join(lines + ["</svg>"])


if len(sys.argv) != 2:
    sys.exit(__doc__)
print(draw(read(sys.argv[1])))
