"""The two drones from above: where they start, and where they first touch: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

import json  # noqa: E402

figure, axes = drawing.start(5.0, 3.8)
pair = json.loads((drawing.HERE / "drones.jsonl").read_text().splitlines()[0])
from fractions import Fraction  # noqa: E402

# The first pair is the second one with a drone B that starts at a height of 2 m.
apart = (drawing.HERE / "apart.fmb").read_text()
contact = float(fmb.bounds(fmb.System.parse(apart.replace("z = 1", "z = 2"), "fmb"))["t"].lower)


def corners(frame, t):
    """Of the base at time t."""
    number = lambda v: [float(Fraction(c)) for c in v]
    o, (a, b, _), v = number(frame["orig"]), map(number, frame["comp"]), number(frame["vel"])
    o = [x + t * s for x, s in zip(o, v)]
    return [(o[0] + i * a[0] + j * b[0], o[1] + i * a[1] + j * b[1])
            for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]


for name, colour in (("A", drawing.BLUE), ("B", drawing.RED)):
    for t, alpha in ((0, 0.25), (contact, 0.8), (1, 0.25)):
        axes.fill(*zip(*corners(pair[name], t)), facecolor=colour, alpha=alpha)
    begin, end = corners(pair[name], 0)[0], corners(pair[name], 1)[0]
    axes.annotate("", end, begin, arrowprops={"arrowstyle": "->", "color": colour, "lw": 0.8})
    axes.annotate(name, begin, (4, -12), textcoords="offset points", color=colour)
axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
drawing.save(figure)
