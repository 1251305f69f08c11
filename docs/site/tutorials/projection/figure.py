"""The polyhedron of breakfasts, and its shadow on bread and milk: figure.py OUT.svg"""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "gallery"))
import drawing  # noqa: E402
import fmb  # noqa: E402

P = fmb.Polyhedron(fmb.System.read(HERE.parents[2] / "examples/breakfast.fmb"))
figure = drawing.plt.figure(figsize=(7, 3.4), layout="constrained")
solid = P.plot(figure.add_subplot(1, 2, 1, projection="3d"), facecolor=drawing.BLUE)
solid.view_init(elev=25, azim=-115)
solid.set_box_aspect((1, 1, 0.8), zoom=0.82)
solid.locator_params(nbins=4)
solid.set_title("breakfasts")
flat = figure.add_subplot(1, 2, 2)
shadow = P.project("bread milk")
shadow.plot(flat, facecolor=drawing.BLUE)
for corner, place in zip(sorted(shadow.vertices()), ((8, 4), (-30, -16), (-20, 10))):
    x, y = map(float, corner)
    flat.plot(x, y, "o", color=drawing.RED)
    flat.annotate("(" + ", ".join(map(str, corner)) + ")", (x, y), xytext=place, textcoords="offset points", fontsize=8)
flat.set(xlim=(1, 2.8), ylim=(0.5, 2.4))
flat.set_title("their shadow")
drawing.save(figure)
