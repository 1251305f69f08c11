"""A triangle on its way into a parallelogram: figure.py OUT.svg"""

import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "gallery"))
import drawing  # noqa: E402
import fmb  # noqa: E402

origin, edges, speed = np.array([6, 4]), np.array([[2.5, 0.5], [0.5, 2]]), np.array([-5, -4])
tile = np.array([[0, 0], [3, 0.5], [3.5, 2.5], [0.5, 2]])
still = fmb.Frames([tile[0]], [[tile[1], tile[3]]])
coming = fmb.Frames([origin], [edges], speed=[speed], shape="simplex")
first = still.test(coming, times=True).time[0, 0]

figure, axes = drawing.start(5.6, 3.8)
axes.fill(*tile.T, facecolor=drawing.BLUE, alpha=0.5, edgecolor=drawing.BLUE)
for t, alpha, name in ((0, 0.12, "t = 0"), (first, 0.5, f"first contact, t = {first:.3f}"), (1, 0.12, "t = 1")):
    corners = np.array([origin, origin + edges[0], origin + edges[1]]) + t * speed
    axes.fill(*corners.T, facecolor=drawing.RED, alpha=alpha)
    axes.plot(*np.vstack([corners, corners[:1]]).T, color=drawing.RED, linewidth=1)
    axes.text(*(corners[1] + [0.1, 0]), name, fontsize=9, va="center")
axes.annotate("", origin + 0.97 * speed, origin, arrowprops={"arrowstyle": "->", "color": drawing.GREY})
axes.set(aspect="equal", xlim=(-0.5, 10.3), ylim=(-0.4, 6.4))
drawing.save(figure)
