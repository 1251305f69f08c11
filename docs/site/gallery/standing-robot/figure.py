"""Where the centre of mass may be, and the triangle of the feet: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

robot = fmb.System.read(drawing.HERE / "robot.fmb")
figure, axes = drawing.start(4.8, 3.4)
feet = [(0, -1), (0, 1), (3, 0)]
axes.fill(*zip(*feet), facecolor="none", edgecolor=drawing.GREY, linestyle="--",
          label="triangle of the feet")
fmb.Polyhedron(fmb.project(robot, "cx cy")).plot(
    axes, facecolor="#9cc6e2", edgecolor=drawing.BLUE, alpha=0.9, linewidth=1.4,
    label="centre of mass: stands")
for number, (x, y) in enumerate(feet, 1):
    axes.plot(x, y, "o", color=drawing.RED)
    axes.annotate(str(number), (x, y), (6, 5), textcoords="offset points", color=drawing.RED)
axes.set(xlabel="x", ylabel="y", aspect="equal")
axes.legend(loc="upper right", frameon=False, fontsize=9)
drawing.save(figure)
