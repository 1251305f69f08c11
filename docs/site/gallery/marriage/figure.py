"""Who fits which job, with the people and jobs of the conflict marked: figure.py OUT.svg"""

import re
import sys

sys.path.insert(0, __file__.rpartition("/")[0] + "/..")
import drawing  # noqa: E402
import fmb  # noqa: E402

jobs = fmb.System.read(drawing.HERE / "jobs.fmb")
blamed = {row.label for row in fmb.solve(jobs).conflict.rows}
people = [row.label for row in jobs if row.label and row.relation == "="]
figure, axes = drawing.start(4.2, 3.2)
for name in jobs.names:
    person, job = re.fullmatch(r"(\D+)(\d)", name).groups()
    person = person.capitalize()
    both = person in blamed
    axes.plot((0, 1), (-people.index(person), 1 - int(job)), color=drawing.RED if both else drawing.GREY,
              linewidth=1.6 if both else 0.9)
for words, x, side in ((people, 0, "right"), ([f"job {i}" for i in range(1, 6)], 1, "left")):
    for i, word in enumerate(words):
        axes.text(x + (0.04 if x else -0.04), -i, word, ha=side, va="center",
                  color=drawing.RED if word in blamed else "black")
axes.set(xlim=(-0.4, 1.4), ylim=(-4.4, 0.4))
axes.axis("off")
drawing.save(figure)
