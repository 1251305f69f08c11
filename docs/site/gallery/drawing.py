"""What the figures of the gallery share: size, letters, colours, and how a file is written. The style is that of all figures
(apps/fmb-qualify/plotting.py), with the letters of a page that is read on a screen."""

import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "apps/fmb-qualify"))
import plotting  # noqa: E402
from plotting import BLUE, BROWN, GREEN, GREY, PURPLE, RED, plt, style  # noqa: E402,F401

HERE = pathlib.Path(sys.argv[0]).resolve().parent

plt.rcParams.update({"font.size": 10, "axes.titlesize": 10, "axes.labelsize": 10, "xtick.labelsize": 9, "ytick.labelsize": 9,
                     "legend.fontsize": 9, "lines.linewidth": 1.6, "lines.markersize": 4.5})


def start(width=5.2, height=3.6, **how):
    """A figure of so many inches, and its axes."""
    return plotting.start(height, width, **how)


def save(figure):
    """Write the figure to the file that the command line names; the same bytes every time."""
    plotting.save(figure, sys.argv[1])


def written(script, *arguments, read=None):
    """What a script beside the figure prints, given a file beside it to read."""
    text = (HERE / read).read_text() if read else None
    return subprocess.run([sys.executable, "-B", HERE / script, *arguments], input=text, text=True,
                          capture_output=True, check=True).stdout
