"""The output of the network: exact, and what the relaxation leaves: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

relaxed = fmb.Polyhedron(fmb.project(fmb.System.read(drawing.HERE / "network.fmb"), "x1 y"))
figure, axes = drawing.start(4.8, 3.4)
relaxed.plot(axes, facecolor="#e3eff8", edgecolor=drawing.BLUE, alpha=1, linewidth=1.2)


def output(x1, x2):
    """What the network says."""
    relu = lambda a: max(0.0, a)
    return 1 + relu(x1 + x2 - 0.5) - relu(x1 - x2) - 0.5 * relu(2 * x2 - x1 - 0.5)


steps = [i / 200 for i in range(201)]
ends = [[end(output(x1, x2) for x2 in steps) for end in (min, max)] for x1 in steps]
axes.fill_between(steps, *zip(*ends), color="#5fa4cf")
axes.text(0.5, 1.0, "exact", ha="center", color="white")
axes.axhline(0, color=drawing.RED, linestyle="--")
axes.set(xlabel="input x1", ylabel="output y")
drawing.save(figure)
