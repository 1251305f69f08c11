"""Every number, table and figure of the paper, from CSV alone: macros in numbers.tex, tables as *.tex, figures as *.pdf.
What the text says in words is held against the data here: a claim that no longer holds ends the build.
usage: evaluate.py OUT"""

import collections
import csv
import lzma
import pathlib
import sys

import numpy as np
from scipy import stats

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "apps/fmb-qualify"))
import plotting  # noqa: E402
from plotting import COLOURS, MARKS, STROKES, plt  # noqa: E402

np.seterr(invalid="ignore")  # infinite over infinite: neither was solved
INFINITE = np.inf
macros = {}


def say(name, value):
    """A macro of that name; names are letters alone."""
    assert name.isalpha() and name not in macros, name
    macros[name] = str(value)


def claim(good, words):
    if not good:
        sys.exit(f"evaluate.py: the data no longer say: {words}")


def read(path):
    with (lzma.open if path.suffix == ".xz" else open)(path, "rt", encoding="utf-8", newline="") as f:
        return list(csv.DictReader(f))


def short(x):
    """Two digits that count, and no more decimals than it takes."""
    if np.isnan(x):
        return "--"
    if np.isinf(x):
        return r"$\infty$"
    return f"{x:.0f}" if x >= 9.95 else f"{x:.1f}" if x >= 0.995 and abs(x - 1) > 0.1 else f"{x:.2f}"


def save(figure, out, name):
    plotting.key(figure)
    plotting.save(figure, out / f"{name}.pdf")


def tabular(out, name, columns, heads, rows, rule_after=()):
    lines = [r"\begin{tabular}{@{}" + columns + r"@{}}", r"\toprule", " & ".join(heads) + r" \\", r"\midrule"]
    for k, row in enumerate(rows):
        lines.append(" & ".join(row) + r" \\" + (r" \addlinespace" if k in rule_after else ""))
    (out / f"{name}.tex").write_text("\n".join([*lines, r"\bottomrule", r"\end{tabular}", ""]))


# ---- experiments: lines of `fmb-qualify run` --------------------------------------------------------


def problem_of(line):
    return line["family"], int(line["size"]), int(line["seed"])


class Runs:
    def __init__(self, lines):
        self.lines = lines
        self.run = collections.defaultdict(dict)
        for line in lines:
            self.run[line["method"], line["rules"], line["order"], line["evidence"]][problem_of(line)] = line
        self.problems = list(dict.fromkeys(map(problem_of, lines)))

    def cost(self, way, problem, measure):
        line = self.run[way].get(problem)
        if line is None or line["timed" if measure == "seconds" else "outcome"] != "decided":
            return INFINITE
        return float(line[measure]) + (measure != "seconds")

    def costs(self, ways, measure, problems=None):
        return np.array([[self.cost(way, p, measure) for p in problems or self.problems] for way in ways])

    def at_least(self, way, problem):
        """Time; of a run that was stopped, the time until then."""
        return float(self.run[way][problem]["seconds"])


def median_interval(x, level=0.95):
    """Median and its interval by ranks (binomial): it needs no finite numbers."""
    x = np.sort(x)
    n = len(x)
    k = int(stats.binom.ppf((1 - level) / 2, n, 0.5))
    return np.median(x), x[max(k - 1, 0)], x[min(n - k, n - 1)]


def ratios(runs, way, base, problems):
    """Time over that of base. Where base was stopped its time until then stands for more: the ratio is too large, never too small.
    Where this way was stopped it is infinite."""
    return np.array([runs.cost(way, p, "seconds") / runs.at_least(base, p) for p in problems])


def fm(rules, order="pairs", evidence="all"):
    return "fm", rules, order, evidence


# ---- colliding frames by dimension ---------------------------------------------------------------------

RULES = ["none", "duplicate", "dominated", "kohler", "imbert", "chernikov", "kohler,dominated", "box", "kohler,box", "default"]
WORDS = {"none": "none", "duplicate": "equal rows", "dominated": "parallel rows", "kohler": "Kohler", "imbert": "Imbert",
         "chernikov": "Chernikov", "kohler,dominated": "Kohler, parallel rows", "box": "box", "kohler,box": "Kohler, box",
         "chernikov,box": "Chernikov, box", "lp": "linear programs", "default": "default"}


def by_dimension(runs):
    """Frames of size s have s + 1 dimensions."""
    found = collections.defaultdict(list)
    for problem in runs.problems:
        found[problem[1] + 1].append(problem)
    return found


def pays_from(runs, way, base, dims):
    """The least dimension from which on, up to the largest, the interval of the median ratio lies below 1. Where base was stopped
    and this way was not, the ratio counts as 0."""
    good = []
    for dim in sorted(dims, reverse=True):
        a, b = runs.costs([way, base], "seconds", dims[dim])
        found = np.where(np.isfinite(a), np.where(np.isfinite(b), a / b, 0), INFINITE)
        if median_interval(found)[2] >= 1:
            break
        good.append(dim)
    return min(good) if good else None


def collisions(out):
    runs = Runs(read(HERE / "data/collisions.csv.xz"))
    dims = by_dimension(runs)
    wrong = sum(line["outcome"] == "wrong" or line["timed"] == "wrong" for line in runs.lines)
    claim(wrong == 0, "no wrong answer among the frames")
    say("FrameSystems", len(runs.problems))
    say("FrameSystemsEach", len(dims[2]))
    say("FrameMostRows", f'{int(runs.lines[0]["max_rows"]):,}'.replace(",", r"\,"))
    rows = []
    for rules in RULES:
        cells = [WORDS[rules]]
        for dim in sorted(dims):
            made = runs.costs([fm(rules)], "made", dims[dim])[0] - 1
            cells += [short(np.median(made)) if np.isfinite(np.median(made)) else rf"$>${len(made) - np.isfinite(made).sum()} st."]
        rows.append(cells)
    tabular(out, "frames-rows", "l" + "r" * len(dims), ["rules", *(f"$D={dim}$" for dim in sorted(dims))], rows, rule_after=(2, 6))
    figure, panels = plt.subplots(1, 2, figsize=(6.3, 2.5), layout="constrained")
    shown = ["dominated", "duplicate", "kohler", "imbert", "chernikov", "kohler,box", "default"]
    for axes, base, ways in ((panels[0], "none", shown), (panels[1], "kohler", ["imbert", "chernikov", "kohler,dominated", "kohler,box", "default"])):
        for i, rules in enumerate(ways):
            points = [(dim, *median_interval(ratios(runs, fm(rules), fm(base), dims[dim]))) for dim in sorted(dims)]
            points = [(dim + 0.07 * (i - len(ways) / 2), *rest) for dim, *rest in points if np.isfinite(rest[0])]
            k = shown.index(rules) if rules in shown else len(shown)
            x, middle, low, high = (np.array(column) for column in zip(*points))
            axes.plot(x, middle, MARKS[k] + STROKES[k % 4], color=COLOURS[k], markersize=3, label=WORDS[rules])
            axes.vlines(x, low, np.where(np.isfinite(high), high, 5), color=COLOURS[k], linewidth=0.7)
        axes.axhline(1, color="#222222", linewidth=0.8)
        axes.set(yscale="log", xlabel="dimension $D$ of the frames", ylabel=f"time over that of {WORDS[base]}", xticks=sorted(dims))
        axes.yaxis.set_major_formatter("{x:g}")
    save(figure, out, "frames-time")
    for rules, name in (("kohler", "Kohler"), ("imbert", "Imbert"), ("chernikov", "Chernikov"), ("default", "Default"), ("kohler,box", "KohlerBox")):
        first = pays_from(runs, fm(rules), fm("none"), dims)
        claim(first is not None, f"{rules} pays somewhere")
        say(f"{name}PaysFrom", first)
    claim(pays_from(runs, fm("dominated"), fm("none"), dims) is None, "parallel rows alone never pay on frames")
    claim(pays_from(runs, fm("duplicate"), fm("none"), dims) is None, "equal rows alone never pay on frames")
    claim(pays_from(runs, fm("kohler,dominated"), fm("kohler"), dims) is None, "parallel rows beside Kohler never pay on frames")
    claim(pays_from(runs, fm("imbert"), fm("kohler"), dims) is None, "Imbert's beside Kohler's does not pay on frames")
    drop = 1 - np.median(runs.costs([fm("kohler")], "made", dims[3]) - 1) / np.median(runs.costs([fm("none")], "made", dims[3]) - 1)
    say("KohlerDropsInThree", f"{100 * drop:.0f}")
    space = dims[4]
    for rules, name in (("dominated", "Dominated"), ("duplicate", "Duplicate"), ("kohler", "Kohler"), ("imbert", "Imbert"), ("default", "Default")):
        say(f"{name}TimeInFour", short(np.median(ratios(runs, fm(rules), fm("none"), space))))
    say("DominatedSolvedInFour", int(np.isfinite(runs.costs([fm("dominated")], "made", space)).sum()))
    say("NoneSolvedInFour", int(np.isfinite(runs.costs([fm("none")], "made", space)).sum()))
    say("NoneSolvedInFive", int(np.isfinite(runs.costs([fm("none")], "made", dims[5])).sum()))
    say("DominatedSolvedInFive", int(np.isfinite(runs.costs([fm("dominated")], "made", dims[5])).sum()))
    for name, rules, base in (("ImbertOverKohlerMost", "imbert", "kohler"), ("ParallelOverKohlerMost", "kohler,dominated", "kohler"),
                              ("KohlerBoxOverKohlerLeast", "kohler,box", "kohler")):
        medians = [np.median(ratios(runs, fm(rules), fm(base), dims[dim])) for dim in sorted(dims)]
        say(name, short(max(medians) if name.endswith("Most") else min(medians)))
        if name.startswith("Imbert"):
            say("ImbertOverKohlerLeast", short(min(medians)))
    made = [[runs.costs([fm(rules)], "made", dims[dim])[0].sum() for rules in ("kohler", "imbert", "chernikov")] for dim in sorted(dims)]
    say("ImbertRowsSaved", f"{100 * (1 - sum(m[1] for m in made) / sum(m[0] for m in made)):.1f}")
    say("ChernikovRowsSaved", f"{100 * (1 - sum(m[2] for m in made) / sum(m[0] for m in made)):.1f}")
    return runs.lines[0]


# ---- the benchmark -----------------------------------------------------------------------------------------

METHODS = {"fm": "elimination", "dd": "double description", "hull": "queries", "auto": "automatic"}


def benchmark(out):
    path = HERE.parent / "leaderboard.csv.xz"
    runs = Runs(read(path))
    orders = ["pairs", "given", "min", "fill"]
    rules = list(dict.fromkeys(way[1] for way in runs.run if way[0] == "fm"))
    claim(not any("wrong" in (line["outcome"], line["timed"]) for line in runs.lines), "no wrong answer on the benchmark")
    say("BenchProblems", len(runs.problems))
    say("BenchFamilies", len({p[0] for p in runs.problems}))
    say("BenchRuns", f"{len(runs.lines):,}".replace(",", r"\,"))
    say("BenchWays", len(runs.run))
    say("BenchMostRows", f'{int(runs.lines[0]["max_rows"]):,}'.replace(",", r"\,"))
    say("BenchMostSeconds", runs.lines[0]["max_seconds"])
    stopped = [line["stop"] for line in runs.lines if line["method"] == "fm" and line["outcome"] == "stopped"]
    say("StoppedByRows", f"{100 * np.mean([stop == 'rows' for stop in stopped]):.0f}")
    order_table(out, runs, rules, orders)
    rule_table(out, runs, rules)
    methods(out, runs)
    say("RuleSets", len(rules))
    say("Commit", runs.lines[0]["commit"])
    say("Machine", runs.lines[0]["machine"])


def solved(runs, way):
    return int(np.isfinite(runs.costs([way], "made")).sum())


def geometric(runs, way, base, measure):
    """Over the problems that both decided, and how many those are."""
    a, b = runs.costs([way, base], measure)
    both = np.isfinite(a) & np.isfinite(b)
    return (stats.gmean(a[both] / b[both]) if both.any() else np.nan), int(both.sum())


def rule_table(out, runs, rules):
    ways = [fm(name) for name in rules]
    best = runs.costs(ways, "made").min(axis=0)
    quickest = runs.costs(ways, "seconds").min(axis=0)
    ranks = {m: stats.rankdata(runs.costs(ways, m), axis=0).mean(axis=1) for m in ("made", "held", "seconds")}
    rows = []
    for way, made, held, seconds in sorted(zip(ways, *ranks.values()), key=lambda row: row[1]):
        with np.errstate(invalid="ignore"):
            factors = [np.median((runs.costs([way], m)[0] / least)[np.isfinite(least)]) for m, least in (("made", best), ("seconds", quickest))]
        price = geometric(runs, way, (*way[:3], "none"), "seconds")[0]
        rows.append([WORDS.get(way[1], way[1]), str(solved(runs, way)), f"{made:.2f}", short(factors[0]), f"{held:.2f}", f"{seconds:.2f}",
                     short(factors[1]), f"{price:.2f}"])
    tabular(out, "rules", "lrrrrrrr", ["rules", "solved", "rows", "factor", "peak", "time", "factor", "proofs"], rows)
    for name in ("none", "duplicate", "dominated", "kohler", "imbert", "chernikov", "chernikov,box", "lp", "default"):
        say("Solved" + "".join(part.capitalize() for part in name.split(",")), solved(runs, fm(name)))
    claim(solved(runs, fm("none")) <= solved(runs, fm("dominated")) < solved(runs, fm("kohler")) < solved(runs, fm("chernikov")),
          "parallel rows solve fewer than Kohler's rule, that fewer than Chernikov's")
    claim({row[0] for row in rows[:2]} == {WORDS["default"], WORDS["chernikov,box"]}, "the default and Chernikov's rule with boxes are first by rows")
    for a, b, name in (("imbert", "kohler", "ImbertKohler"), ("chernikov", "imbert", "ChernikovImbert"), ("dominated", "none", "DominatedNone"),
                       ("duplicate", "none", "DuplicateNone"), ("kohler", "none", "KohlerNone")):
        for measure, word in (("made", "Rows"), ("seconds", "Time")):
            value, both = geometric(runs, fm(a), fm(b), measure)
            say(f"{name}{word}", f"{value:.2f}")
        say(f"{name}Both", both)


def order_table(out, runs, rules, orders):
    heads, rows = ["rules", *orders, "worst/best"], []
    spread = {}
    for name in rules:
        costs = runs.costs([fm(name, order) for order in orders], "made")
        known = np.isfinite(costs).all(axis=0)
        spread[name] = np.median(costs[:, known].max(axis=0) / costs[:, known].min(axis=0))
        rows.append([WORDS.get(name, name), *(str(solved(runs, fm(name, order))) for order in orders), short(spread[name])])
    tabular(out, "orders", "l" + "r" * (len(orders) + 1), heads, rows)
    say("OrderSpreadNone", short(spread["none"]))
    say("OrderSpreadDefault", short(spread["default"]))
    for order in ("given", "min", "fill"):
        value, both = geometric(runs, fm("default", order), fm("default"), "made")
        say(f"Order{order.capitalize()}Rows", f"{value:.2f}")
        say(f"Order{order.capitalize()}Time", f'{geometric(runs, fm("default", order), fm("default"), "seconds")[0]:.2f}')
    claim(all(solved(runs, fm(name, "given")) <= solved(runs, fm(name, "pairs")) + 2 for name in rules), "the given order solves no more, but for a few")


def methods(out, runs):
    ways = {"fm": fm("default"), **{m: (m, "", "", "all") for m in ("dd", "hull", "auto")}}
    costs = {m: runs.costs([way], "seconds")[0] for m, way in ways.items()}
    engines = ("fm", "dd", "hull")
    least = np.min([costs[m] for m in engines], axis=0)
    families = list(dict.fromkeys(p[0] for p in runs.problems))
    winners, table = {}, []
    for family in families:
        mine = [k for k, p in enumerate(runs.problems) if p[0] == family]
        ranked = {m: np.exp(np.mean(np.log(np.minimum(costs[m][mine], 10)))) for m in engines}
        done = {m: np.isfinite(costs[m][mine]).sum() for m in engines}
        winners[family] = max(engines, key=lambda m: (done[m], -ranked[m]))
        table.append((family, len(mine), done, ranked, winners[family]))
    for m in engines:
        say(f"Wins{m.capitalize()}", sum(w == m for w in winners.values()))
        say(f"Fastest{m.capitalize()}", int(np.sum(np.isfinite(costs[m]) & (costs[m] <= least))))
        say(f"Decided{m.capitalize()}", int(np.isfinite(costs[m]).sum()))
    say("DecidedAuto", int(np.isfinite(costs["auto"]).sum()))
    for m in engines:
        say(f"Families{m.capitalize()}", ", ".join(sorted(f for f, w in winners.items() if w == m)) or "none")
    with np.errstate(invalid="ignore", divide="ignore"):
        say("FmMedianFactor", short(np.median(costs["fm"] / least)))
        say("HullMedianFactor", short(np.median(costs["hull"] / least)))
    for m in ways:
        say(f"{m.capitalize()}Tail", int(np.sum(~(costs[m] <= 10 * np.min([costs[k] for k in ways], axis=0)))))
    one = [k for k, p in enumerate(runs.problems) if int(runs.run[ways["fm"]][p]["variables"]) - int(runs.run[ways["fm"]][p]["kept"]) == 1]
    say("OneGoneFm", f"{100 * np.mean(costs['fm'][one] <= least[one]):.0f}" if one else "--")
    claim(not one or np.mean(costs["fm"][one] <= least[one]) > 0.5, "elimination of one variable is hardly beaten")
    figure, panels = plt.subplots(1, 2, figsize=(6.3, 2.5), layout="constrained")
    best = np.min([costs[m] for m in ways], axis=0)
    for i, (m, cost) in enumerate(costs.items()):
        found = np.sort((cost / best)[np.isfinite(cost)])
        panels[0].step([*found, 1e3], [*(np.arange(1, len(found) + 1) / len(best)), len(found) / len(best)], where="post",
                       label=METHODS[m], color=COLOURS[i], linestyle=STROKES[i])
    panels[0].set(xscale="log", xlim=(1, 1e3), ylim=(0, 1.02), xlabel="time over that of the fastest", ylabel="share of problems")
    gone = collections.defaultdict(lambda: [0, 0, 0])
    for k, p in enumerate(runs.problems):
        line = runs.run[ways["fm"]][p]
        away = min(int(line["variables"]) - int(line["kept"]), 9)
        place = [costs[m][k] for m in engines]
        if np.isfinite(min(place)):
            gone[away][int(np.argmin(place))] += 1
    x = sorted(gone)
    shares = np.array([gone[k] for k in x], float)
    shares /= shares.sum(axis=1, keepdims=True)
    bottom = np.zeros(len(x))
    for i, m in enumerate(engines):
        panels[1].bar(range(len(x)), shares[:, i], bottom=bottom, color=COLOURS[i], width=0.8, label=METHODS[m], hatch=["", "///", "..."][i],
                      edgecolor="white", linewidth=0.4)
        bottom += shares[:, i]
    panels[1].set_xticks(range(len(x)), [f"{k}" if k < 9 else "9+" for k in x])
    panels[1].set(xlabel="eliminated variables", ylabel="share where it is the fastest", ylim=(0, 1), yticks=[0, 0.25, 0.5, 0.75, 1])
    panels[1].grid(False)
    save(figure, out, "methods")


# ---- pairs of frames: elimination and separating axes ---------------------------------------------------------

CASES = {"2d-static": "2D", "3d-static": "3D", "2d-dynamic": "2D, moving", "3d-dynamic": "3D, moving"}


def article(out):
    lines = read(HERE / "data/article.csv")
    claim(len(lines) == 24 and not any(int(line[f"{way}.wrong"]) for line in lines for way in ("asked", "packed")), "24 cells, all right")
    rows = []
    for line in lines:
        rows.append([CASES[line["case"]], line["pair"], "yes" if line["meeting"] == "True" else "no", f'{float(line["published"]):.2f}',
                     f'{float(line["repeated.mean"]):.2f}', f'{float(line["listed.fmb_over_sat.ratio"]):.2f}', f'{float(line["asked.fmb_over_sat.ratio"]):.2f}',
                     f'{float(line["packed.fmb_over_sat.ratio"]):.2f}', f'{float(line["packed.fmb_ns"]):.0f}'])
    tabular(out, "table1", "lllrrrrrr", ["case", "pair", "meet", "published", "its method", "distinct", "ours", "packed", "[ns]"], rows,
            rule_after=(5, 11, 17))
    for name, key in (("Published", "published"), ("Listed", "listed.fmb_over_sat.ratio"), ("Ours", "asked.fmb_over_sat.ratio"), ("Packed", "packed.fmb_over_sat.ratio")):
        values = [float(line[key]) for line in lines]
        say(f"Table{name}Least", f"{min(values):.2f}")
        say(f"Table{name}Most", f"{max(values):.2f}")
        say(f"Table{name}Mean", f"{stats.gmean(values):.2f}")
        say(f"Table{name}Wins", sum(v < 1 for v in values))
    say("ArticlePairs", f'{int(lines[0]["queries"]):,}'.replace(",", r"\,"))
    say("ListedWrong", sum(int(line["listed.wrong"]) for line in lines))
    say("SlowerWhenMeeting", f'{stats.gmean([float(l["published"]) for l in lines if l["meeting"] == "True"]):.2f}')
    say("SlowerWhenApart", f'{stats.gmean([float(l["published"]) for l in lines if l["meeting"] != "True"]):.2f}')
    say("CompilerWords", lines[0]["compiler"])
    say("LoadThen", lines[0]["load"])


def shares(out):
    lines = read(HERE / "data/mixes.csv")
    figure, panels = plt.subplots(1, 2, figsize=(6.3, 2.3), layout="constrained")
    every = []
    for i, line in enumerate(lines):
        points = [(float(line[f"fmb_over_sat.{k}.percent_meeting"]), *(float(line[f"fmb_over_sat.{k}.{word}"]) for word in ("total", "least", "most")))
                  for k in range(11)]
        x, total, low, high = zip(*points)
        every += total
        panels[0].plot(x, total, MARKS[i] + STROKES[i], color=COLOURS[i], markersize=3, label=CASES[line["case"]])
        panels[0].vlines(x, low, high, color=COLOURS[i], linewidth=0.5)
    panels[0].axhline(1, color="#222222", linewidth=0.8)
    panels[0].set(xlabel="pairs that meet [%]", ylabel="time, FMB over SAT")
    say("MixMedian", f"{np.median(every):.2f}")
    say("MixLeast", f"{min(every):.2f}")
    say("MixMost", f"{max(every):.2f}")
    widths = [(word, HERE / f"data/width-{simd}.csv") for simd, word in (("plain", "2 lanes"), ("avx2", "4 lanes"), ("avx512", "8 lanes"))]
    widths = [(word, read(path)) for word, path in widths if path.exists()]
    for i, case in enumerate(CASES):
        means = [stats.gmean([float(l["packed.fmb_over_sat.ratio"]) for l in lines if l["case"] == case]) for _, lines in widths]
        panels[1].plot(range(len(widths)), means, MARKS[i] + STROKES[i], color=COLOURS[i], markersize=4, label=CASES[case])
    panels[1].axhline(1, color="#222222", linewidth=0.8)
    panels[1].set_xticks(range(len(widths)), [word for word, _ in widths])
    panels[1].set(ylabel="time, FMB over SAT, packed", xlim=(-0.3, len(widths) - 0.7))
    words = [rf'{stats.gmean([float(l["packed.fmb_over_sat.ratio"]) for l in lines]):.2f} with {word}' for word, lines in widths]
    say("Widths", ", ".join(words))
    save(figure, out, "shares")
    touching = read(HERE / "data/touching.csv")
    claim(not any(int(line["different"]) for line in touching), "the same verdicts on touching pairs")
    for name, meets in (("Meet", "True"), ("Near", "False")):
        mine = [line for line in touching if line["meeting"] == meets]
        say(f"Touching{name}Ratio", f'{stats.gmean([float(l["fmb_over_sat.ratio"]) for l in mine]):.2f}')
        say(f"Touching{name}Exact", f'{100 * np.mean([float(l["exact_share"]) for l in mine]):.0f}')
    say("TouchingPlainWrong", sum(int(line["sat_plain_wrong"]) for line in touching))
    say("TouchingPairs", f'{sum(int(line["queries"]) for line in touching):,}'.replace(",", r"\,"))


def bias(out):
    lines = read(HERE.parent / "no-bias.csv")
    for kind in ("total", "median"):
        inside = sum(float(line[kind + "_low"]) <= 1 <= float(line[kind + "_high"]) for line in lines)
        claim(0.9 * len(lines) <= inside, "1 lies in 95 % of the intervals, give or take 5")
        say(f"Bias{kind.capitalize()}", inside)
    say("BiasAll", len(lines))


def main(out):
    out.mkdir(parents=True, exist_ok=True)
    collisions(out)
    benchmark(out)
    article(out)
    shares(out)
    bias(out)
    (out / "numbers.tex").write_text("".join(rf"\newcommand{{\n{name}}}{{{value}}}" + "\n" for name, value in macros.items()))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]))
