"""The states that the cart reaches after one to four seconds: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

cart = fmb.System.read(drawing.HERE / "cart.fmb")
figure, axes = drawing.start()
for k, shade in zip((4, 3, 2, 1), ("#cfe3f1", "#9cc6e2", "#5fa4cf", drawing.BLUE)):
    reached = fmb.Polyhedron(fmb.project(cart, f"p{k} v{k}"))
    reached.plot(axes, facecolor=shade, edgecolor=drawing.BLUE, alpha=1, linewidth=1)
    tip = max(reached.vertices())
    axes.annotate(f"{k} s", (float(tip[0]), float(tip[1])), (4, 2), textcoords="offset points")
axes.set(xlabel="position [m]", ylabel="speed [m/s]")
drawing.save(figure)
