"""The core of the game of dams, in the shares of two purposes: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

core = fmb.Polyhedron(fmb.project(fmb.System.read(drawing.HERE / "dams.fmb"), "n f"))
figure, axes = drawing.start(4.8, 3.6)
core.plot(axes, facecolor="#cfe3f1", edgecolor=drawing.BLUE, alpha=1, linewidth=1.5)
for n, f in core.vertices():
    axes.plot(float(n), float(f), "o", color=drawing.BLUE, markersize=4)
total, lone = 412.584, (163.520, 140.826, 250.096)
saved = (sum(lone) - total) / 3
axes.plot(lone[0] - saved, lone[1] - saved, "D", color=drawing.RED, linestyle="none",
          label="the same saving for all")
axes.set(xlabel="navigation pays [million \\$]", ylabel="flood control pays [million \\$]")
axes.legend(loc="lower left", frameon=False)
drawing.save(figure)
