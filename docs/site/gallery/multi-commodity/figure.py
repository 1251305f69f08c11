"""The network, and dashed, what is to be sent: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

place = {"x": (-2, 0), "y": (2, 0), "a": (0, 1.2), "b": (0, 0), "c": (0, -1.2)}
figure, axes = drawing.start(4.6, 3.0)
curve = {"xy": -0.75, "ab": -0.5, "bc": -0.5, "ac": 0.7}
for line in (drawing.HERE / "network.txt").read_text().splitlines():
    word, a, b, _ = line.split()
    if word == "edge":
        axes.plot(*zip(place[a], place[b]), color=drawing.BLUE)
    else:
        axes.annotate("", place[a], place[b], arrowprops={
            "arrowstyle": "-", "linestyle": "--", "color": drawing.RED,
            "connectionstyle": f"arc3,rad={curve[a + b]}"})
for node, (x, y) in place.items():
    axes.text(x, y, node, ha="center", va="center", bbox={
        "boxstyle": "circle", "facecolor": "white", "edgecolor": drawing.BLUE})
axes.set(xlim=(-2.5, 2.5), ylim=(-2.0, 1.7))
axes.axis("off")
drawing.save(figure)
