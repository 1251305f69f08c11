"""The states from which the cart can stay on its rail: figure.py OUT.svg"""

import contextlib
import os
import runpy
import sys
import tempfile

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(None):
    os.chdir(folder)
    found = runpy.run_path(str(drawing.HERE / "rail.py"))
    os.chdir(drawing.HERE)
safe = fmb.Polyhedron(found["states"])
figure, axes = drawing.start()
safe.plot(axes, facecolor="#cfe3f1", edgecolor=drawing.BLUE, alpha=1, linewidth=1.5)
# A run along the border: full speed towards the end, then the brakes.
p, v, run = 0.0, 3.0, []
for _ in range(4):
    run.append((p, v))
    a = max(-1.0, min(1.0, -v))
    p, v = p + v + a / 2, v + a
axes.plot(*zip(*run), "o-", color=drawing.RED, markersize=4, label="full brakes, second by second")
axes.set(xlabel="position [m]", ylabel="speed [m/s]")
axes.legend(loc="lower left", frameon=False)
drawing.save(figure)
