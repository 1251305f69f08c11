#!/usr/bin/env python3
"""Draw a pair of frames in the plane as `fmb intersect` answers it: the frames, their common part,
its tightest box, and a common point.

usage: overlap.py FMB PAIRS.jsonl LINE > overlap.svg
"""

import json
import subprocess
import sys
from fractions import Fraction

SCALE = 90   # pixels in 1
MARGIN = 30  # pixels


def corners(frame):
    """In order around the frame, which has two edges."""
    number = lambda v: [Fraction(x) for x in v]
    o, (a, b) = number(frame["orig"]), map(number, frame["comp"])
    add = lambda p, q: [x + y for x, y in zip(p, q)]
    around = [o, add(o, a), add(add(o, a), b), add(o, b)]
    if frame["type"] != "cuboid":
        del around[2]
    turn = a[0] * b[1] - a[1] * b[0]
    return around if turn > 0 else around[::-1]


def clip(polygon, p, q):
    """What lies on the left of the line from p to q (Sutherland and Hodgman 1974)."""
    side = lambda x: (q[0] - p[0]) * (x[1] - p[1]) - (q[1] - p[1]) * (x[0] - p[0])
    result = []
    for x, y in zip(polygon, polygon[1:] + polygon[:1]):
        s, t = side(x), side(y)
        if s >= 0:
            result.append(x)
        if s * t < 0:
            result.append([u + (v - u) * s / (s - t) for u, v in zip(x, y)])
    return result


def common(a, b):
    for p, q in zip(b, b[1:] + b[:1]):
        a = clip(a, p, q)
    return a


class Drawing:
    def __init__(self, points):
        self.low = [min(p[k] for p in points) for k in (0, 1)]
        self.high = [max(p[k] for p in points) for k in (0, 1)]
        size = [float(h - l) * SCALE + 2 * MARGIN for l, h in zip(self.low, self.high)]
        self.lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0]:g}" '
                      f'height="{size[1]:g}" font-family="sans-serif" font-size="15">',
                      '  <rect width="100%" height="100%" fill="#ffffff"/>']

    def place(self, p):
        x = float(p[0] - self.low[0]) * SCALE + MARGIN
        y = float(self.high[1] - p[1]) * SCALE + MARGIN
        return f"{x:.5g},{y:.5g}"

    def polygon(self, points, style):
        where = " ".join(map(self.place, points))
        self.lines.append(f'  <polygon points="{where}" {style}/>')

    def dot(self, p):
        x, y = self.place(p).split(",")
        self.lines.append(f'  <circle cx="{x}" cy="{y}" r="4"/>')

    def text(self, p, words, style=""):
        x, y = self.place(p).split(",")
        self.lines.append(f'  <text x="{x}" y="{y}" {style}>{words}</text>')

    def finish(self):
        return "\n".join(self.lines + ["</svg>"])


def main():
    fmb, path, line = sys.argv[1], sys.argv[2], int(sys.argv[3])
    with open(path, encoding="utf-8") as f:
        pair = f.read().splitlines()[line - 1]
    reply = subprocess.run([fmb, "intersect", "-", "--json"], input=pair, capture_output=True,
                           text=True, check=True).stdout
    answer, frames = json.loads(reply)["pairs"][0], json.loads(pair)
    a, b = corners(frames["A"]), corners(frames["B"])
    (left, right), (low, high) = ([Fraction(e) for e in ends] for ends in answer["world"])
    both = common(a, b)
    assert [min(p[0] for p in both), max(p[0] for p in both)] == [left, right]
    assert [min(p[1] for p in both), max(p[1] for p in both)] == [low, high]
    draw = Drawing(a + b)
    draw.polygon(a, 'fill="#4477aa" fill-opacity="0.25" stroke="#4477aa" stroke-width="2"')
    draw.polygon(b, 'fill="#ccbb44" fill-opacity="0.3" stroke="#998822" stroke-width="2"')
    draw.polygon(both, 'fill="#228833" fill-opacity="0.6"')
    draw.polygon([[left, low], [right, low], [right, high], [left, high]],
                 'fill="none" stroke="#aa3377" stroke-width="2" stroke-dasharray="6 4"')
    draw.dot([Fraction(x) for x in answer["witness"]])
    draw.text([a[0][0] + Fraction(1, 5), a[0][1] + Fraction(1, 6)], "A")
    draw.text([b[1][0] - Fraction(1, 2), b[1][1]], "B")
    centre = [sum(p[k] for p in both) / len(both) for k in (0, 1)]
    draw.text(centre, "common", 'text-anchor="middle" fill="#ffffff"')
    draw.text([left, high + Fraction(1, 15)], "tightest box", 'fill="#aa3377"')
    print(draw.finish())


if __name__ == "__main__":
    main()
