"""Entropies of three variables that are alike: what Shannon's inequalities leave: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

three = fmb.System.parse(drawing.written("entropies.py", "A", "B", "C"), "fmb")
for row in ("hA = 1", "hB = 1", "hC = 1", "hAC = hAB", "hBC = hAB"):
    three.add(row)
alike = fmb.Polyhedron(fmb.project(three, "hAB hABC"))
figure, axes = drawing.start(4.4, 3.4)
alike.plot(axes, facecolor="#cfe3f1", edgecolor=drawing.BLUE, alpha=1, linewidth=1.2)
axes.plot([0.9, 2.1], [1.35, 3.15], "--", color=drawing.RED)
axes.text(1.5, 2.5, "Han: 2 hABC = 3 hAB", color=drawing.RED, ha="right")
axes.set(xlabel="entropy of two [bits]", ylabel="entropy of all three [bits]", xlim=(0.8, 2.2), ylim=(0.8, 3.2))
drawing.save(figure)
