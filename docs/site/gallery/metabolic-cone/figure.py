"""What yeast makes of one glucose, by glycerol and energy: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

made = fmb.image(fmb.System.read(drawing.HERE / "yeast.fmb"),
                 (drawing.HERE / "exchange.map").read_text())
one = fmb.Polyhedron(made) & "glucose = 1"
figure, axes = drawing.start(5.0, 3.4)
one.project("glycerol ATP").plot(axes, facecolor="#cfe3f1", edgecolor=drawing.BLUE, alpha=1)
for vertex in one.vertices():
    pure = dict(zip(one.names, vertex))
    place = float(pure["glycerol"]), float(pure["ATP"])
    others = [f"{pure[x]} {x}" for x in ("oxygen", "ethanol") if pure[x]]
    axes.plot(*place, "o", color=drawing.RED)
    axes.annotate("\n".join(others), place, (6, 6), textcoords="offset points", fontsize=9)
axes.set(xlabel="glycerol per glucose", ylabel="ATP per glucose", xlim=(-0.1, 2.2), ylim=(-2, 40))
drawing.save(figure)
