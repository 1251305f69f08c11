"""What an experiment (`fmb-qualify run`) found, to be looked at: from its lines of CSV alone, a figure each for the
field's questions as SVG and PDF, a table in LaTeX, and report.html, which holds them all.
usage: plots.py FOLDER RUNS.csv

A run that was stopped by a limit is censored: it counts as not solved, in comparisons of pairs as worse than every
run that was decided, and as equal to another that was stopped. Nothing is left out."""

import collections
import csv
import html
import lzma
import pathlib
import sys

try:
    import numpy as np
    import plotting
    from scipy import stats
except ImportError as missing:
    sys.exit(f"fmb-qualify: python3 has no {missing.name}: figures need matplotlib, numpy and scipy")

matplotlib, plt, style = plotting.matplotlib, plotting.plt, plotting.style
HEIGHT, SHOWN = 2.4, 12  # inches; ways

# ---- runs -----------------------------------------------------------------------------------------

PROBLEM = ("family", "size", "seed", "digits", "density")


def read(path):
    """The lines of a file, which may be compressed."""
    with (lzma.open if str(path).endswith(".xz") else open)(path, "rt", encoding="utf-8", newline="") as f:
        lines = list(csv.DictReader(f))
    if not lines:
        sys.exit(f"fmb-qualify: {path}: no runs")
    return lines


class Runs:
    """All runs by way and by problem. A problem is one that every way was asked about."""

    def __init__(self, path):
        lines = read(path)
        orders = len({line["order"] for line in lines if line["order"]})
        kinds = len({line["evidence"] for line in lines})
        self.run = collections.defaultdict(dict)
        for line in lines:
            name = line["rules"] or line["method"]
            if orders > 1 and line["order"]:
                name += f' ({line["order"]})'
            if kinds > 1:
                name += f' [{line["evidence"]}]'
            self.run[name][tuple(line[key] for key in PROBLEM)] = line
        self.problems = list(dict.fromkeys(tuple(line[key] for key in PROBLEM) for line in lines))
        self.all_ways = [way for way in self.run if any(line["outcome"] != "unknown" for line in self.run[way].values())]
        self.ways = self.some(self.all_ways)
        self.rules = self.some([way for way in self.all_ways if next(iter(self.run[way].values()))["method"] == "fm"])
        self.timed = any(line["timed"] != "no" for line in lines)
        self.facts = {key: sorted({line[key] for line in lines}) for key in ("plan", "version", "commit", "machine", "passes")}

    def some(self, ways):
        """What a figure can show: the first way, which others are compared with, and of the rest those that decided most."""
        by_decided = sorted(ways[1:], key=lambda way: -sum(line["outcome"] == "decided" for line in self.run[way].values()))
        return [way for way in ways if way in ways[:1] + by_decided[:SHOWN - 1]]

    def decided(self, way, problem, measure):
        line = self.run[way].get(problem)
        return line is not None and line["timed" if measure == "seconds" else "outcome"] == "decided"

    def cost(self, way, problem, measure):
        """Seconds, or a count and one; infinite where the run was stopped, refused or wrong."""
        if not self.decided(way, problem, measure):
            return np.inf
        return float(self.run[way][problem][measure]) + (measure != "seconds")

    def costs(self, ways, measure):
        """[ways][problems]"""
        return np.array([[self.cost(way, problem, measure) for problem in self.problems] for way in ways])




WORDS = {"seconds": "time", "made": "rows made"}

# ---- figures: each gives its caption ---------------------------------------------------------------


def cactus(runs, measure, axes):
    for i, way in enumerate(runs.ways if measure == "seconds" else runs.rules):
        costs = np.sort([c for c in runs.costs([way], measure)[0] if np.isfinite(c)])
        axes.plot(np.arange(1, len(costs) + 1), np.cumsum(costs), label=f"{way}: {len(costs)}", markevery=0.15, **style(i))
    axes.set(yscale="log", xlabel=f"problems solved, of {len(runs.problems)}", ylabel="time, all of them together [s]")
    return ("Cactus plot: how many problems a way solves within a time, the quickest first. A run that reached a limit is "
            "not solved.")


def profile(runs, measure, axes):
    ways = runs.ways if measure == "seconds" else runs.rules
    costs = runs.costs(ways, measure)
    best = costs.min(axis=0)
    known = np.isfinite(best)
    ratios = costs[:, known] / best[known]
    most = max(np.max(ratios[np.isfinite(ratios)], initial=1) * 1.1, 2)
    for i, way in enumerate(ways):
        found = np.sort(ratios[i][np.isfinite(ratios[i])])
        share = np.arange(1, len(found) + 1) / len(runs.problems)
        axes.step([*found, most], [*share, share[-1] if len(share) else 0], where="post", label=way, markevery=(0.03 * i % 0.2, 0.2), **style(i))
    axes.set(ylim=(0, 1.02), xlabel=f"{WORDS[measure]}, over the least of all ways",
             ylabel="share of problems")
    plotting.logarithmic(axes.xaxis, 1, most)
    axes.set_xlim(left=1)
    return (f"Performance profiles (Dolan, Moré 2002) of {WORDS[measure]}: on which share of the {len(runs.problems)} problems a way "
            f"is within a factor of the best one. {int(np.sum(~known))} were solved by none.")


def rounds(runs, _, axes):
    common = [p for p in runs.problems if all(runs.decided(way, p, "made") for way in runs.rules)]
    most = 1
    for i, way in enumerate(runs.rules):
        alive = [[int(word) for word in runs.run[way][p]["rounds"].split() if word != "..."] for p in common]
        table = [[row[k] for row in alive if len(row) > k] for k in range(32)]
        table = np.array([np.quantile(column, (0.25, 0.5, 0.75)) for column in table if len(column) >= 5])
        if not len(table):
            continue
        most = max(most, len(table))
        x = np.arange(1, len(table) + 1) + 0.6 * (i / max(1, len(runs.rules) - 1) - 0.5)
        axes.plot(x, table[:, 1], label=way, **style(i))
        axes.vlines(x, table[:, 0], table[:, 2], color=style(i)["color"], linewidth=0.5)
    axes.set(yscale="log", xlabel="round", ylabel="rows alive after it")
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_formatter(matplotlib.ticker.LogFormatter(minor_thresholds=(2, 0.5)))
    axes.set_xticks(range(1, most + 1, max(1, most // 12)))
    return (f"Rows alive after each round: median and quartiles over the runs that had so many rounds, at least five of the {len(common)} "
            "problems that every set of rules decided.")


def growth(runs, _, axes):
    rows, largest = {}, 1
    for i, way in enumerate(runs.rules):
        most = collections.defaultdict(list)
        for line in runs.run[way].values():
            k = int(line["variables"]) - int(line["kept"])
            most[k].append((int(line["held"]), line["outcome"] != "decided"))
            rows.setdefault(k, []).append(int(line["rows"]))
        most = {k: found for k, found in sorted(most.items()) if len(found) >= 5}
        middle = {k: np.median([held for held, _ in found]) for k, found in most.items()}
        largest = max([largest, *middle.values()])
        axes.plot(list(middle), list(middle.values()), label=way, **style(i))
        censored = [k for k, found in most.items() if 2 * sum(stopped for _, stopped in found) >= len(found)]
        axes.plot(censored, [middle[k] for k in censored], "^", color=style(i)["color"], markersize=7, fillstyle="none")
    theory = [(k, 4 * (np.median(of_k) / 4) ** (2.0 ** k)) for k, of_k in sorted(rows.items()) if k <= 6]
    theory = [(k, value) for k, value in theory if value < 30 * largest]
    if theory:
        axes.plot(*zip(*theory), color="#000000", linewidth=0.8, marker="+", label="$4(m/4)^{2^k}$")
    axes.set(yscale="log", xlabel="variables eliminated, k", ylabel="most rows at once")
    axes.xaxis.set_major_locator(plotting.ticker.MaxNLocator(integer=True, nbins=9))
    return ("Growth: the most rows at once against the number of eliminated variables, medians over at least five problems. Triangles: "
            "half of the runs or more were stopped, and the median is a lower bound. The thin line is the worst that elimination "
            "can do to the median number m of rows.")


def made_at_least(line):
    """Rows made; of a run that was stopped, a lower bound."""
    return 1 + max(int(line["made"]), int(line["held"]) - int(line["rows"]))


def family_ratio(runs, family, way, base):
    """The mean of log10 of rows made over those of base, and "", "<" or ">", what it is no more or no less than."""
    found, marks = [], set()
    for problem in runs.problems:
        ends = [runs.decided(name, problem, "made") for name in (way, base)]
        if problem[0] == family and any(ends):
            found.append(np.log10(made_at_least(runs.run[way][problem]) / made_at_least(runs.run[base][problem])))
            marks.add({(True, True): "", (True, False): "<", (False, True): ">"}[tuple(ends)])
    return (np.mean(found) if found else np.nan), "~" if marks >= {"<", ">"} else "".join(sorted(marks))


def heat(runs, _, axes):
    families = list(dict.fromkeys(problem[0] for problem in runs.problems))
    base, ways = runs.rules[0], runs.rules[1:]
    cells = [[family_ratio(runs, family, way, base) for way in ways] for family in families]
    table = np.array([[value for value, _ in row] for row in cells])
    limit = max(np.nanmax(np.abs(table), initial=0.1), 0.1)
    image = axes.imshow(table, cmap="RdBu_r", vmin=-limit, vmax=limit, aspect="auto")
    axes.set_xticks(range(len(ways)), ways, rotation=35, ha="right")
    axes.set_yticks(range(len(families)), [pathlib.Path(family).name for family in families], fontsize=7)
    axes.grid(False)
    for r, c in np.argwhere(np.isfinite(table)):
        axes.text(c, r, f"{cells[r][c][1]}{10 ** table[r, c]:.2g}", ha="center", va="center", fontsize=6.5,
                  color="white" if abs(table[r, c]) > 0.6 * limit else "black")
    axes.figure.colorbar(image, ax=axes, label="log$_{10}$ of the ratio", shrink=0.8)
    return (f"Rows made over those of {base}, geometric means by family over the problems that one of both decided. <: {base} was "
            "stopped on some, and the ratio can only be smaller; >: the other was; ~: both happened. Empty where neither decided any.")


def holm(values):
    """Adjusted values of several tests (Holm 1979)."""
    order = np.argsort(values)
    adjusted = np.maximum.accumulate(np.minimum(1, np.asarray(values)[order] * np.arange(len(values), 0, -1)))
    return adjusted[np.argsort(order)]


def compare(costs):
    """Mean ranks, and the adjusted value of Wilcoxon's test for each pair of ways."""
    finite = costs[np.isfinite(costs)]
    logs = np.log(np.where(np.isfinite(costs), costs, 10 * np.max(finite, initial=1)))
    ranks = stats.rankdata(costs, axis=0).mean(axis=1)
    pairs = [(i, j) for i in range(len(costs)) for j in range(i)]
    values = [stats.wilcoxon(logs[i], logs[j], zero_method="zsplit", method="approx").pvalue if np.any(logs[i] != logs[j]) else 1.0
              for i, j in pairs]
    return ranks, dict(zip(pairs, holm(values)))


def cliques(ranks, values, level=0.05):
    """Runs of neighbours by rank of which no two differ."""
    order = list(np.argsort(ranks))
    found = []
    for a in range(len(order)):
        b = a
        while b + 1 < len(order) and all(values[max(i, order[b + 1]), min(i, order[b + 1])] >= level for i in order[a:b + 1]):
            b += 1
        if b > a and not any(lo <= a and b <= hi for lo, hi in found):
            found.append((a, b))
    return order, found


def critical(runs, measure, axes):
    ways = runs.ways if measure == "seconds" else runs.rules
    ranks, values = compare(runs.costs(ways, measure))
    order, bars = cliques(ranks, values)
    half = (len(ways) + 1) // 2
    for place, i in enumerate(order):
        left = place < half
        y = -0.6 - 0.5 * (place if left else len(order) - 1 - place) - 0.22 * len(bars)
        end = 0.6 if left else len(ways) + 0.4
        axes.plot([ranks[i], ranks[i], end], [0, y, y], color="#222222", linewidth=0.8)
        axes.text(end, y, f"{ways[i]} {ranks[i]:.2f} " if left else f" {ways[i]} {ranks[i]:.2f}",
                  ha="right" if left else "left", va="center", fontsize=8)
    for k, (a, b) in enumerate(bars):
        axes.plot([ranks[order[a]] - 0.04, ranks[order[b]] + 0.04], [-0.25 - 0.22 * k] * 2, color=plotting.BLUE, linewidth=3)
    axes.set(xlim=(-1.3, len(ways) + 2.3), ylim=(-0.9 - 0.5 * half - 0.22 * len(bars), 0.2))
    axes.spines[["left", "bottom"]].set_visible(False)
    axes.plot([1, len(ways)], [0, 0], color="#222222", linewidth=1)
    for tick in range(1, len(ways) + 1):
        axes.plot([tick, tick], [0, 0.08], color="#222222", linewidth=1)
        axes.text(tick, 0.12, str(tick), ha="center", va="bottom", fontsize=8)
    axes.set_yticks([])
    axes.set_xticks([])
    return (f"Mean ranks by {WORDS[measure]} over {len(runs.problems)} problems, 1 is best. Ways that one bar joins are not told apart "
            "at 5 %, by Wilcoxon's signed ranks on logarithms with Holm's correction (no two of them). What was stopped is worse than "
            "all that was decided, and equal to what was stopped.")


def figures(runs):
    """Name, drawing, measure, height."""
    if runs.timed:
        yield "cactus", cactus, "seconds", HEIGHT
        yield "profile-time", profile, "seconds", HEIGHT
        yield "critical-time", critical, "seconds", 1.3 + 0.2 * len(runs.ways)
    if len(runs.rules) > 1:
        yield "profile-rows", profile, "made", HEIGHT
        yield "critical-rows", critical, "made", 1.3 + 0.2 * len(runs.rules)
        yield "rounds", rounds, None, HEIGHT
        yield "growth", growth, None, HEIGHT
        yield "heat", heat, None, 1.4 + 0.15 * len({problem[0] for problem in runs.problems})


# ---- the table ------------------------------------------------------------------------------------


def table(runs):
    """Heads, and a line of texts a way. A mean of ratios is over the problems that both decided."""
    heads = ["way", "decided", "stopped", "refused", "wrong", "rows made", "of", "time", "of"]
    base, lines = runs.rules[0] if runs.rules else runs.ways[0], []
    for way in runs.all_ways:
        outcomes = collections.Counter(line["outcome"] for line in runs.run[way].values())
        line = [way, *(str(outcomes[word]) for word in ("decided", "stopped", "refused", "wrong"))]
        for measure in ("made", "seconds"):
            both = [p for p in runs.problems if runs.decided(way, p, measure) and runs.decided(base, p, measure)]
            ratios = [runs.cost(way, p, measure) / runs.cost(base, p, measure) for p in both]
            shown = both and (measure == "seconds" or way in runs.rules)
            line += [f"{stats.gmean(ratios):.3g}" if shown else "-", str(len(both)) if shown else "-"]
        lines.append(line)
    return heads, lines, (f"Outcomes of {len(runs.problems)} problems; rows made and time over those of {base}, geometric means over so many "
                          "problems that both decided.")


def latex(heads, lines, caption):
    def row(cells):
        return " & ".join(cell.replace("_", r"\_") for cell in cells) + r" \\" + "\n"
    return ("\\begin{table}\n\\caption{" + caption + "}\n\\begin{tabular}{l" + "r" * (len(heads) - 1) + "}\n\\hline\n" +
            row(heads) + "\\hline\n" + "".join(map(row, lines)) + "\\hline\n\\end{tabular}\n\\end{table}\n")


# ---- the report -----------------------------------------------------------------------------------


def main(path, folder):
    runs = Runs(path)
    folder.mkdir(exist_ok=True)
    facts = "; ".join(f"{key} {', '.join(values)}" for key, values in runs.facts.items())
    parts = [f"<h1>{html.escape(pathlib.Path(path).name)}</h1>\n<p>{html.escape(facts)}</p>\n"]
    if len(runs.ways) < len(runs.all_ways):
        parts.append(f"<p>Figures show {len(runs.ways)} of {len(runs.all_ways)} ways: the first one, and those that decided most.</p>\n")
    heads, lines, caption = table(runs)
    (folder / "table.tex").write_text(latex(heads, lines, caption))
    folded = (f'<details><summary>All numbers</summary><p>{html.escape(caption)}</p><div class="wide"><table>' + "".join(
        "<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in cells) + "</tr>\n" for cells in [heads, *lines]) + "</table></div></details>\n")
    for name, draw, measure, height in figures(runs):
        wide = draw in (critical, heat) and len(runs.ways) > 6
        figure, axes = plotting.start(height, plotting.PAGE if wide else plotting.COLUMN)
        caption = draw(runs, measure, axes)
        if axes.get_legend_handles_labels()[0]:
            plotting.key(figure)
        plotting.save(figure, folder / f"{name}.svg", folder / f"{name}.pdf")
        parts.append(f'<figure><img src="{name}.svg" alt="{name}"><figcaption>{html.escape(caption)}</figcaption></figure>\n')
    (folder / "report.html").write_text(
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1"><title>fmb-qualify plots</title>\n<style>body { font: 16px/1.5 '
        "sans-serif; max-width: 44em; margin: 1.5em auto; padding: 0 1em } td { padding: .1em .6em; border-bottom: 1px solid #ddd } "
        ".wide { overflow-x: auto } figure { margin: 1em 0 } img { width: 34em; max-width: 100% } figcaption { font-size: 14px }</style></head>\n<body>\n" + "".join(parts) + folded + "</body></html>\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(sys.argv[2], pathlib.Path(sys.argv[1]))
