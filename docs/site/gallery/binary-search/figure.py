"""Runs of a binary search among 16 numbers, in the triangle of its invariant: figure.py OUT.svg"""

import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

body = fmb.System.read(drawing.HERE / "body.fmb")
body.add("n = 16")
states = fmb.Polyhedron(fmb.project(body, "lo hi")) | "lo = hi; 0 <= lo <= 16"
figure, axes = drawing.start(4.4, 4.0)
states.plot(axes, facecolor="#e3eff8", edgecolor=drawing.BLUE, alpha=1, linewidth=1)


def draw(lo, hi):
    """Arrows from a state to the two that may follow."""
    if lo < hi:
        mid = lo + (hi - lo) // 2
        for after, colour in (((mid + 1, hi), drawing.RED), ((lo, mid), drawing.GREEN)):
            axes.annotate("", after, (lo, hi),
                          arrowprops={"arrowstyle": "->", "color": colour, "lw": 0.8})
            draw(*after)


draw(0, 16)
axes.text(9, 2.2, "red: lo = mid + 1", color=drawing.RED)
axes.text(9, 0.8, "green: hi = mid", color=drawing.GREEN)
axes.set(xticks=range(0, 17, 4), yticks=range(0, 17, 4), xlabel="lo", ylabel="hi", aspect="equal")
drawing.save(figure)
