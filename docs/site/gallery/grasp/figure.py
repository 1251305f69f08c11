"""Two grasps of a plate, with friction cones and the line between the fingers: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

figure, both = drawing.start(6.2, 2.4, ncols=2)
for axes, (left, right), title in zip(both, (((-2, 0), (2, 0)), ((-2, -1), (2, 1))),
                                      ("every load is held", "this turn is not held")):
    axes.fill([-2, 2, 2, -2], [-1, -1, 1, 1], facecolor="#eeeeee", edgecolor=drawing.GREY)
    for (x, y), inward in ((left, 1), (right, -1)):
        axes.fill([x, x + 1.6 * inward, x + 1.6 * inward], [y, y + 0.8, y - 0.8],
                  facecolor="#9cc6e2", alpha=0.7)
        axes.plot(x, y, "o", color=drawing.BLUE)
    axes.plot(*zip(left, right), "--", color=drawing.RED, linewidth=1)
    axes.set(title=title, aspect="equal", xlim=(-3, 3), ylim=(-2, 2))
    axes.grid(False)
    axes.axis("off")
both[1].annotate("", (0.75, 0.2), (0.2, -0.75), arrowprops={
    "arrowstyle": "->", "color": drawing.RED, "connectionstyle": "arc3,rad=0.6"})
drawing.save(figure)
