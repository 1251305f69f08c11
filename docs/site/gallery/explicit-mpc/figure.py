"""The regions of the explicit control law, each with the first acceleration at its middle: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

plan = fmb.System.read(drawing.HERE / "mpc.fmb")
value = fmb.project(plan, "p0 v0 cost")
figure, axes = drawing.start(5.6, 3.8)
colours = drawing.plt.get_cmap("Blues")
costs = []
for row in value:
    if "cost" in row.coefficients:
        on = fmb.System(value.system)
        on.add(row.left() == row.right)
        region = fmb.Polyhedron(fmb.project(on, "p0 v0"))
        points = region.vertices()
        middle = [sum(c) / len(points) for c in zip(*points)]
        cost = fmb.optimize(on, min="cost").value
        slope = -row.coefficients.get("v0", 0) / row.coefficients["cost"]
        region.plot(axes, facecolor=colours(0.15 + 0.09 * abs(float(slope))),
                    edgecolor=drawing.BLUE, alpha=1, linewidth=0.8)
axes.set(xlabel="position now [m]", ylabel="speed now [m/s]")
drawing.save(figure)
