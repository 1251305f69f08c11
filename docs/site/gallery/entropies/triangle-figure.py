"""Entropies that three shared sources allow, among those that Shannon allows: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

entropies = drawing.written("entropies.py", *"ABCXYZ")
network = fmb.System.parse(entropies + (drawing.HERE / "network.txt").read_text(), "fmb")
for row in ("hA = 1", "hB = 1", "hC = 1", "hAC = hAB", "hBC = hAB"):
    network.add(row)
figure, axes = drawing.start(4.6, 3.4)
fmb.Polyhedron("hAB >= 1; hAB <= 2; hABC >= hAB; hABC <= 2hAB - 1; 2hABC <= 3hAB").plot(
    axes, facecolor="#eeeeee", edgecolor=drawing.GREY, alpha=1, linewidth=0.8)
fmb.Polyhedron(fmb.project(network, "hAB hABC")).plot(
    axes, facecolor="#9cc6e2", edgecolor=drawing.BLUE, alpha=1, linewidth=1.2)
axes.plot(1, 1, "o", color=drawing.RED)
axes.annotate("a common coin", (1, 1), (8, -3), textcoords="offset points", color=drawing.RED)
axes.set(xlabel="entropy of two [bits]", ylabel="entropy of all three [bits]")
drawing.save(figure)
