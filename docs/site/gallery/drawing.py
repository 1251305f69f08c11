"""What the figures of the gallery share: size, letters, colours, and how a file is written."""

import pathlib
import subprocess
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

# Different to the colour-blind, and dark enough for thin lines on white.
BLUE, RED, GREEN, PURPLE, BROWN, GREY = "#0072b2 #c44e00 #007a55 #aa3377 #8a6d00 #666666".split()
HERE = pathlib.Path(sys.argv[0]).resolve().parent

plt.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "fmb", "font.family": "sans-serif", "font.size": 10,
    "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True,
    "axes.grid": True, "grid.color": "#dddddd", "grid.linewidth": 0.6, "lines.linewidth": 1.6,
})


def start(width=5.2, height=3.6, **how):
    """A figure of so many inches, and its axes."""
    return plt.subplots(figsize=(width, height), layout="constrained", **how)


def save(figure):
    """Write the figure to the file that the command line names; the same bytes every time."""
    figure.savefig(sys.argv[1], format="svg", metadata={"Date": None, "Creator": f"matplotlib {matplotlib.__version__}"})


def written(script, *arguments, read=None):
    """What a script beside the figure prints, given a file beside it to read."""
    text = (HERE / read).read_text() if read else None
    return subprocess.run([sys.executable, "-B", HERE / script, *arguments], input=text, text=True,
                          capture_output=True, check=True).stdout
