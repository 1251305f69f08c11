"""The parity polytope of three coordinates is a tetrahedron in the cube: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

parity = fmb.Polyhedron(fmb.project(fmb.System.parse(drawing.written("parity.py", "3"), "fmb"), "x1 x2 x3"))
figure = drawing.plt.figure(figsize=(3.6, 3.4), layout="constrained")
axes = figure.add_subplot(projection="3d")
parity.plot(axes, facecolor="#5fa4cf", alpha=0.6)
corners = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
for p in corners:
    for q in corners:
        if sum(abs(a - b) for a, b in zip(p, q)) == 1 and p < q:
            axes.plot(*zip(p, q), color=drawing.GREY, linewidth=0.8)
axes.set_box_aspect(None, zoom=0.8)
axes.set(xticks=(0, 1), yticks=(0, 1), zticks=(0, 1))
drawing.save(figure)
