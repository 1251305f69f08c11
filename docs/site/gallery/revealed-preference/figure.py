"""What each purchase reveals: an arrow leads to a bundle that was affordable: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

import math  # noqa: E402

observations = []
for line in (drawing.HERE / "purchases.txt").read_text().splitlines():
    if not line.startswith("#"):
        observations.append([[int(x) for x in part.split()] for part in line.split("|")])
figure, axes = drawing.start(4.2, 3.2)
place = [(math.sin(2 * math.pi * t / 3), math.cos(2 * math.pi * t / 3)) for t in range(3)]
for t, (prices, bought) in enumerate(observations):
    x, y = place[t]
    axes.text(x, y, f"{t + 1}: " + ", ".join(map(str, bought)), ha="center", va="center",
              bbox={"boxstyle": "round", "facecolor": "white", "edgecolor": drawing.BLUE})
    spent = sum(p * q for p, q in zip(prices, bought))
    for s, (_, other) in enumerate(observations):
        cost = sum(p * q for p, q in zip(prices, other))
        if s != t and cost <= spent:
            u, v = place[s]
            axes.annotate("", (0.75 * u + 0.25 * x, 0.75 * v + 0.25 * y),
                          (0.25 * u + 0.75 * x, 0.25 * v + 0.75 * y),
                          arrowprops={"arrowstyle": "->", "color": drawing.RED})
            axes.text(0.55 * (u + x), 0.55 * (v + y) - 0.05, f"spent {spent},\ncould cost {cost}",
                      ha="center", va="center", fontsize=8,
                      bbox={"facecolor": "white", "edgecolor": "none", "pad": 1})
axes.set(xlim=(-1.5, 1.5), ylim=(-0.9, 1.3))
axes.axis("off")
drawing.save(figure)
