"""Is there a straight line between two kinds of points? points.py < points.txt > points.fmb

Each line of the input is a kind, + or -, and the coordinates of a point. The line is
w1 x + w2 y = b, with all points of kind + on its far side."""

import sys

for number, line in enumerate(sys.stdin, 1):
    kind, x, y = line.split()
    relation = ">= b + 1" if kind == "+" else "<= b - 1"
    print(f"point {number} ({kind}): {x} w1 + {y} w2 {relation}")
