"""When each step of the schedule may begin if the shop closes at 13: figure.py OUT.svg"""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "gallery"))
import drawing  # noqa: E402
import fmb  # noqa: E402

schedule = (HERE.parents[2] / "examples/schedule.fmb").read_text()
times = fmb.bounds(fmb.System.parse(schedule.replace("12", "13")))
figure, axes = drawing.start(5.6, 2.2)
for row, (name, (first, last)) in enumerate(times.items()):
    first, last = float(first), float(last)
    axes.barh(row, last - first, left=first, height=0.5, color=drawing.BLUE, alpha=0.7)
    axes.text(last + 0.1, row, f"{first:g} to {last:g}", va="center", fontsize=9)
axes.set(yticks=range(len(times)), yticklabels=list(times), xlabel="begin, in hours", xlim=(7.8, 14.4))
axes.invert_yaxis()
axes.grid(axis="y", visible=False)
drawing.save(figure)
