"""The one style of all figures: reports of fmb-qualify, experiments, the paper, the site. Made for a column of a paper (85 mm):
sans-serif letters of 7 and 8 points, colours that the colour-blind tell apart, a mark and a stroke of its own for each curve, and
keys below or beside the data, never over them. Files are vectors, and the same bytes every time."""

import logging
import math

import matplotlib

logging.getLogger("matplotlib").setLevel(logging.ERROR)  # not of the cache of fonts
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib import ticker  # noqa: E402

COLUMN, PAGE = 85 / 25.4, 178 / 25.4  # inches
# Dark enough for thin lines on white.
BLUE, RED, GREEN, PURPLE, BROWN, INDIGO, GREY, BLACK = COLOURS = (
    "#0072b2 #c44e00 #007a55 #aa3377 #8a6d00 #332288 #666666 #000000".split())
STROKES = ["-", "--", "-.", ":", (0, (5, 1, 1, 1, 1, 1)), (0, (1, 1)), (0, (7, 2)), (0, (3, 1, 1, 1))]
MARKS = "os^Dv<>P"

plt.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "fmb", "pdf.fonttype": 42, "font.family": "sans-serif", "font.size": 8,
    "axes.titlesize": 8, "axes.labelsize": 8, "xtick.labelsize": 7, "ytick.labelsize": 7, "legend.fontsize": 7,
    "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True, "axes.grid": True,
    "axes.linewidth": 0.6, "xtick.major.width": 0.6, "ytick.major.width": 0.6, "xtick.minor.width": 0.4,
    "ytick.minor.width": 0.4, "grid.color": "#dddddd", "grid.linewidth": 0.5, "lines.linewidth": 1.2,
    "lines.markersize": 3.2, "legend.frameon": False, "legend.handlelength": 2.6, "legend.columnspacing": 1.2,
})


def style(i):
    """Of curve i: no two of the first eight share a colour, a stroke or a mark, and no two of 64 share all three."""
    turn = i // len(COLOURS)
    return {"color": COLOURS[i % len(COLOURS)], "linestyle": STROKES[(i + turn) % len(STROKES)], "marker": MARKS[(i + turn) % len(MARKS)]}


def start(height, width=COLUMN, **how):
    """A figure of so many inches, and its axes."""
    return plt.subplots(figsize=(width, height), layout="constrained", **how)


def key(figure, handles=None, labels=None, title=None):
    """Below the panels, in as many columns as there is room for; the figure grows by its height. By itself: the curves of all
    panels, each name once."""
    if handles is None:
        named = {}
        for axes in figure.axes:
            for handle, label in zip(*axes.get_legend_handles_labels()):
                named.setdefault(label, handle)
        handles, labels = list(named.values()), list(named)
    width, height = figure.get_size_inches()
    for rows in range(1, len(handles) + 1):
        columns = math.ceil(len(handles) / rows)
        legend = figure.legend(handles, labels, loc="lower center", ncols=columns, title=title, title_fontsize=7, borderaxespad=0.2)
        box = legend.get_window_extent(figure.canvas.get_renderer())
        if columns == 1 or box.width <= figure.bbox.width:
            break
        legend.remove()
    more = box.height / figure.dpi + 0.05
    figure.set_size_inches(width, height + more)
    share = more / (height + more)
    figure.get_layout_engine().set(rect=(0, share, 1, 1 - share))


def round_places(low, high, most):
    """At most so many round numbers in between, as many as can be."""
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    for digits in ((1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9), (1, 1.5, 2, 3, 5, 7), (1, 2, 5), (1, 3), (1,)):
        places = [digit * 10.0 ** decade for decade in decades for digit in digits]
        places = [x for x in places if low <= x <= high]
        if len(places) <= most:
            return places
    return places[::math.ceil(len(places) / most)]


def logarithmic(axis, low, high, most=6):
    """An axis that ends where the data end, with plain numbers at round places."""
    margin = max(1.12, (high / low) ** 0.05)
    low, high = low / margin, high * margin
    getattr(axis.axes, f"set_{axis.axis_name}scale")("log")
    getattr(axis.axes, f"set_{axis.axis_name}lim")(low, high)
    axis.set_major_locator(ticker.FixedLocator(round_places(low, high, most)))
    axis.set_minor_locator(ticker.NullLocator())
    plain = 1e-3 < low and high < 2e5
    axis.set_major_formatter(ticker.FuncFormatter(lambda x, _: f"{x:g}") if plain else ticker.LogFormatterMathtext())


def equal(axes, horizontal=True):
    """The line where both take the same."""
    (axes.axhline if horizontal else axes.axvline)(1, color="#222222", linewidth=0.8, zorder=1)


def save(figure, *paths):
    """Each ending in .svg or .pdf."""
    for path in map(str, paths):
        date = {"Date": None, "Creator": f"matplotlib {matplotlib.__version__}"} if path.endswith("svg") else {
            "CreationDate": None, "Creator": None, "Producer": None}
        figure.savefig(path, metadata=date)
        figure.set_layout_engine("none")  # it is laid out
    plt.close(figure)
