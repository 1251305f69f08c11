"""Draw what `fmb-qualify bias` found: intervals of the ratio of equal ways, and whether 1 lies in them.
usage: no-bias.py BIAS.csv OUT"""

import csv
import logging
import sys

import matplotlib
logging.getLogger("matplotlib").setLevel(logging.ERROR)  # not of the cache of fonts
matplotlib.use("Agg")
import matplotlib.pyplot as plt

KINDS = {"total": "totals", "median": "median ratio"}
IN, OUT = "#0072b2", "#c44e00"
plt.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "fmb", "pdf.fonttype": 42, "font.size": 9, "axes.spines.top": False,
                     "axes.spines.right": False})


def main(path, out):
    with open(path, encoding="utf-8", newline="") as f:
        lines = list(csv.DictReader(f))
    figure, panels = plt.subplots(1, 2, figsize=(6.4, 2.6), layout="constrained", sharex=True)
    for axes, (kind, words) in zip(panels, KINDS.items()):
        held = 0
        for k, line in enumerate(lines):
            low, ratio, high = (float(line[kind + end]) for end in ("_low", "", "_high"))
            inside = low <= 1 <= high
            held += inside
            axes.plot([k + 1, k + 1], [low, high], color=IN if inside else OUT, linewidth=1.4 if inside else 2.4)
            axes.plot(k + 1, ratio, "o" if inside else "D", color=IN if inside else OUT, markersize=2.5 if inside else 4)
        axes.axhline(1, color="#222222", linewidth=0.8)
        axes.set(title=f"{words}: 1 lies in {held} of {len(lines)}", xlabel="repetition")
        axes.title.set_fontsize(9)
    panels[0].set_ylabel("time, none over none")
    figure.savefig(out, metadata={"Date": None, "Creator": None} if out.endswith("svg") else {"CreationDate": None})


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2])
