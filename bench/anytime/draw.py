#!/usr/bin/env python3
"""Draw what bench-anytime --csv has written: by share of the time, the share of facets found, and how
near the width of the outer projection is to the true one.

usage: draw.py FILE.csv anytime.svg
"""

import csv
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "apps/fmb-qualify"))
import plotting  # noqa: E402

TITLES = ("facets found [%]", "true width / outer width [%]")


def read(path):
    """Per problem: points (share of the time, facets found, true by outer width), the end included."""
    problems = {}
    with open(path) as f:
        for row in csv.DictReader(f):
            found = int(row["found"]) / int(row["facets"])
            problems.setdefault(row["problem"], []).append(
                (float(row["share"]), found, float(row["tight"])))
    return {name: points + [(1.0, 1.0, 1.0)] for name, points in problems.items()}


def draw(problems):
    figure, panels = plotting.start(4.0, nrows=2, sharex=True)
    for column, (axes, title) in enumerate(zip(panels, TITLES)):
        for i, (name, points) in enumerate(problems.items()):
            axes.plot([100 * p[0] for p in points], [100 * p[1 + column] for p in points], label=name, **plotting.style(i))
        axes.set(ylabel=title, ylim=(-2, 103))
    axes.set_xlabel("share of the time [%]")
    plotting.key(figure)
    return figure


if len(sys.argv) != 3:
    sys.exit(__doc__)
plotting.save(draw(read(sys.argv[1])), sys.argv[2])
