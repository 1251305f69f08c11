"""For which times is Fischer's protocol unsafe? figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

run = fmb.System.read(drawing.HERE / "bad-run.fmb")
unsafe = fmb.Polyhedron(fmb.project(run, "write delay")) & "write <= 4"
figure, axes = drawing.start(4.2, 3.4)
unsafe.plot(axes, facecolor="#f6d5c0", edgecolor="none", alpha=1)
axes.plot([0, 4], [0, 4], "--", color=drawing.RED)
axes.text(2.6, 0.9, "both may enter", ha="center")
axes.text(1.2, 2.9, "safe, with\nthe dashed line", ha="center")
axes.set(xlabel="write [s]", ylabel="delay [s]", xlim=(0, 4), ylim=(0, 4))
drawing.save(figure)
