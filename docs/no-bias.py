"""Draw what `fmb-qualify bias` found: intervals of the ratio of equal ways, and whether 1 lies in them.
usage: no-bias.py BIAS.csv OUT"""

import csv
import pathlib
import sys

DOCS = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(DOCS.parent / "apps/fmb-qualify"), str(DOCS.parents[1] / "fmb")]  # in the tree, or installed
import plotting  # noqa: E402

KINDS = {"total": "totals", "median": "median ratio"}
IN, OUT = plotting.BLUE, plotting.RED


def main(path, out):
    with open(path, encoding="utf-8", newline="") as f:
        lines = list(csv.DictReader(f))
    figure, panels = plotting.start(3.4, nrows=2, sharex=True)
    for axes, (kind, words) in zip(panels, KINDS.items()):
        held = 0
        for k, line in enumerate(lines):
            low, ratio, high = (float(line[kind + end]) for end in ("_low", "", "_high"))
            inside = low <= 1 <= high
            held += inside
            axes.plot([k + 1, k + 1], [low, high], color=IN if inside else OUT, linewidth=1.4 if inside else 2.4)
            axes.plot(k + 1, ratio, "o" if inside else "D", color=IN if inside else OUT, markersize=2.5 if inside else 4)
        plotting.equal(axes)
        axes.set(title=f"{words}: 1 lies in {held} of {len(lines)}", ylabel="time, none / none")
    panels[1].set_xlabel("repetition")
    plotting.save(figure, out)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
