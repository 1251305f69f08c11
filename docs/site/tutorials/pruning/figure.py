"""Rows after each round of an elimination, by rules: figure.py OUT.svg"""

import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "gallery"))
import drawing  # noqa: E402
import fmb  # noqa: E402

MOST = 60000
dense = fmb.System.read(HERE / "dense.fmb")


def rows_by_round(rules):
    """The numbers of rows, the first of them before the elimination; where a limit ended it, the last is that."""
    rows = [len(dense)]

    def watch(event):
        told = json.loads(event.text)
        if told["event"] == "round":
            rows.append(told["rows_out"])

    answer = fmb.project(dense, "x1 x2", method="fm", rules=rules, order="given", max_rows=MOST, progress=watch)
    return rows + ([] if answer.done else [MOST])


figure, axes = drawing.start(5.6, 3.4)
for rules, color, mark, label in (("none", drawing.RED, "o", "no rule"), ("kohler", drawing.BLUE, "s", "Kohler"),
                                  ("lp", drawing.GREEN, "^", "linear programs")):
    counts = rows_by_round(rules)
    axes.semilogy(range(len(counts)), counts, marker=mark, color=color, label=label)
axes.axhline(MOST, color=drawing.GREY, linestyle="--", linewidth=1)
axes.text(0, MOST * 1.15, "limit", color=drawing.GREY, fontsize=9)
axes.set(xlabel="round", ylabel="rows left", xticks=range(5), ylim=(8, 2e5))
axes.legend(frameon=False, loc="center left")
drawing.save(figure)
