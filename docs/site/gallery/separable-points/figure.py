"""Two kinds of points that a line separates, and two that none does: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

figure, both = drawing.start(6.4, 3.1, ncols=2, sharey=True)
for axes, name in zip(both, ("points", "mixed")):
    points = []
    for line in (drawing.HERE / f"{name}.txt").read_text().splitlines():
        kind, x, y = line.split()
        points.append((kind, int(x), int(y)))
        axes.plot(int(x), int(y), "P" if kind == "+" else "o",
                  color=drawing.BLUE if kind == "+" else drawing.RED, markersize=7)
    answer = fmb.solve(drawing.written("points.py", read=f"{name}.txt"))
    if answer:
        w1, w2, b = (float(answer.point[k]) for k in ("w1", "w2", "b"))
        axes.axline((b / (w1 + w2), b / (w1 + w2)), (b / (w1 + w2) + w2, b / (w1 + w2) - w1),
                    color=drawing.GREY, linestyle="--")
    else:
        for kind, colour in (("+", drawing.BLUE), ("-", drawing.RED)):
            corners = [points[i][1:] for i in answer.conflict.numbers if points[i][0] == kind]
            axes.fill(*zip(*corners), facecolor=colour, edgecolor=colour, alpha=0.25)
    axes.set(xlim=(0, 8), ylim=(0, 7), aspect="equal", xlabel="x")
both[0].set(ylabel="y")
drawing.save(figure)
