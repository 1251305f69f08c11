"""The coefficients of all linear ranking functions of the loop: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

loop = fmb.System.read(drawing.HERE / "loop.fmb")
ranks = fmb.Polyhedron(fmb.project(loop, "a b")) & "a <= 5"
figure, axes = drawing.start(4.4, 3.2)
ranks.plot(axes, facecolor="#cfe3f1", edgecolor="none", alpha=1)
axes.plot([2, 5], [1, 1], color=drawing.BLUE)
axes.plot([2, 5], [1, 4], color=drawing.BLUE)
axes.plot(2, 1, "o", color=drawing.RED)
axes.annotate("2x + y", (2, 1), (-46, -4), textcoords="offset points")
axes.set(xlabel="a", ylabel="b", xlim=(0, 5), ylim=(0, 4.2))
drawing.save(figure)
