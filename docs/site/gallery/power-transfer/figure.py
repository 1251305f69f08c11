"""What two generators may feed into the grid: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

grid = fmb.System.read(drawing.HERE / "grid.fmb")
feasible = fmb.Polyhedron(fmb.project(grid, "g1 g2"))
figure, axes = drawing.start(4.4, 3.8)
feasible.plot(axes, facecolor="#cfe3f1", edgecolor=drawing.BLUE, alpha=1, linewidth=1.5)
best = feasible.maximize(fmb.total(fmb.vars("g1 g2"))).point
g1, g2 = float(best["g1"]), float(best["g2"])
axes.plot(g1, g2, "o", color=drawing.RED)
axes.annotate(f"largest sum, {g1 + g2:g} MW", (g1, g2), (8, 4), textcoords="offset points")
axes.set(xlabel="generator at node 1 [MW]", ylabel="generator at node 2 [MW]", xlim=(0, 320),
         ylim=(0, 320))
drawing.save(figure)
