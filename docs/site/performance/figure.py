"""How many times faster than each library, over all problems: figure.py OUT.svg"""

import sys

sys.path[:0] = [__file__.rpartition("/")[0] + "/../gallery"]
import drawing  # noqa: E402

sys.path[:0] = [str(drawing.HERE)]
import tables  # noqa: E402

data = tables.Data(drawing.HERE / "data")
figure, panels = drawing.start(6.4, 5.4, nrows=2, ncols=2, sharey=True)
for axes, (name, title) in zip(panels.flat, tables.QUESTIONS.items()):
    for i, library in enumerate(tables.LIBRARIES):
        ratios = sorted(tables.best(line, library) / tables.best(line, "fmb") for line in data[name]
                        if tables.best(line, library) and tables.best(line, "fmb"))
        if ratios:
            axes.plot([100 * (i + 0.5) / len(ratios) for i in range(len(ratios))], ratios, markevery=0.12,
                      label=tables.LIBRARIES[library], **drawing.style(i))
    axes.axhline(1, color="black", linewidth=0.8)
    axes.set(title=title, yscale="log", xlim=(0, 100))
for axes in panels[1]:
    axes.set(xlabel="share of the problems [%]")
for axes in panels[:, 0]:
    axes.set(ylabel="their time / ours")
drawing.plotting.key(figure)
drawing.save(figure)
