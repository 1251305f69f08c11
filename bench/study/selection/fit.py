#!/usr/bin/env python3
"""Fit the choice among the ways of projections to times, with whole families held out.

    fit.py BENCH SOURCE [--seed N] [--each N] [--seconds S] [--data FILE...] [--write]

BENCH is bench-selection, whose lines are data (or those of the FILEs; the first one is written if
none is there). Needs NumPy. What was not waited for took half as long again as it was waited for.

What is fitted: weights of features (ridge regression, Hoerl, Kennard 1970) and, to what these leave, a
sum of trees of questions about features, for each of five logarithms: the time of the best engine,
that of each engine over it, and time with bounded elimination first over time without. Weights hold
beyond what was seen, where trees do not. A tree asks the same questions in the same order of every problem, so that the answers are the number of a
leaf (Kohavi 1994). One after another is grown to what the sum so far leaves of the logarithms
(gradient boosting of squares, Friedman 2001), on seven of ten problems at random. Families weigh the
same if many of their problems are there. The report puts together from the times of engines
what turns would take (lib/solve/portfolio/slices.c), beside the best method that does one thing: on
families that a fit has not seen, and on families that it has under other seeds. --write puts the
trees of all data into lib/solve/portfolio/selection.c of SOURCE.
"""
import argparse
import json
import math
import os
import re
import subprocess
import zlib

import numpy

SINGLES = ("elimination", "double description", "support queries")
ENGINES = ("rays alone", "pruned elimination alone", "queries alone")  # as in selection.h
BOUNDED = "bounded elimination first"
LEAST = 1e-5  # [s] less is not told apart
STEP = 0.8e-9  # [s] that a step of work takes (lib/trace/run.h)
GROUPS = 11  # of families, one held out at a time
SEEDS = 4  # one of so many held out at a time
RIDGE = 300.0  # so many problems hold each weight at 0
FINE = 128  # of a part: weights are whole numbers in selection.c
TREES, QUESTIONS, RATE = 31, 6, 0.25
FEW = 15.0  # a family of so many problems weighs half of what one of many does
CALM = 24.0  # so many problems with residue 0 are added to each leaf
MOST = 3.3  # logarithms of ratios above are taken for that
SCALE = numpy.array([0.3, 1, 1, 1, 1])  # of the logarithms, where questions are chosen
SHARE = 0.7  # of problems that a tree is grown to
QUANTILES = 31  # thresholds are between so many
MARKS, PARTS = 256, 32  # of one: features and logarithms are whole numbers in selection.c
NEUTRAL, REACH = "m", 16  # what a leaf says, as a letter, so many before and after that one
PATIENCE, LONGER, LEAST_SLICE = 4, 1.5, 65536  # as in slices.c
# Recorded projections are of few families: what their files' names begin with.
RECORDED = {"rd": "random", "rs": "random", "shannon": "entropy", "col": "practice", "dep": "practice",
            "farkas": "practice", "tile": "practice"}


def rough_logarithm(x):
    """log2(1 + x) by straight lines between powers of two, as in selection.c."""
    mantissa, exponent = math.frexp(1 + x)
    return exponent - 2 + 2 * mantissa


def seconds(t):
    return max(LEAST, t if t >= 0 else -1.5 * t)


def read(paths, names):
    """The problems that some method alone has done."""
    problems = []
    for path in paths:
        with open(path, encoding="ascii") as lines:
            problems += [json.loads(text) for text in lines]
    for p in problems:
        name_recorded(p)
    return [p for p in problems if any(p["took"][a] >= 0 for a in SINGLES)
            and BOUNDED in p["took"] and all(n in p["features"] for n in names)]


def name_recorded(p):
    """A recorded file has no seed; its family is part of its name."""
    name = p["family"]
    if "." in name:
        p["family"] = "recorded " + RECORDED.get(re.split("[_0-9]", name)[0], "polytopes")
        p["seed"] = zlib.crc32(name.encode()) % 1000


def unit(f):
    """[steps] as in selection.c."""
    return 16 * max(1, f["rows"] * f["coefficients a row"]) * (64 + f["bits of a minor"])


def with_bounded_elimination(p, best):
    """The time with bounded elimination first over that without; at least 1 if it does not answer."""
    ratio = seconds(p["took"][BOUNDED]) / best
    return ratio if p["answered"][BOUNDED] else max(1, ratio)


class Data:
    def __init__(self, problems, names):
        self.single = numpy.array([min(seconds(p["took"][a]) for a in SINGLES if p["took"][a] >= 0)
                                   for p in problems])
        self.auto = numpy.array([seconds(p["took"]["auto"]) for p in problems])
        self.time = numpy.array([[seconds(p["took"][a]) for a in ENGINES] for p in problems])
        self.best = self.time.min(1)
        self.bounded = numpy.array([with_bounded_elimination(p, b) for p, b in zip(problems, self.best)])
        self.answered = numpy.array([p["answered"][BOUNDED] for p in problems])
        self.unit = numpy.array([unit(p["features"]) for p in problems])
        self.told = numpy.c_[numpy.log2(self.best / STEP / self.unit),
                             numpy.minimum(numpy.log2(self.time / self.best[:, None]), MOST),
                             numpy.clip(numpy.log2(self.bounded), -MOST, MOST)]
        self.mark = numpy.array([[int(MARKS * rough_logarithm(p["features"][n])) for n in names]
                                 for p in problems])
        self.family = numpy.array([p["family"] for p in problems])
        self.seed = numpy.array([p["seed"] for p in problems])


# ---- the fit ------------------------------------------------------------------------------------


def weigh(family):
    """Problems, so that families of many weigh the same, and of few less."""
    _, place, count = numpy.unique(family, return_inverse=True, return_counts=True)
    weight = 1 / (count[place] + FEW)
    return weight * len(family) / weight.sum()


def find_leaves(questions, mark):
    leaf = numpy.zeros(len(mark), int)
    for feature, above in questions:
        leaf = 2 * leaf + (mark[:, feature] > above)
    return leaf


def sums_by_leaf(leaf, leaves, of):
    return numpy.stack([numpy.bincount(leaf, column, leaves) for column in of.T], 1)


def choose_question(bins, leaf, leaves, weighed, thresholds, asked):
    """By sums over leaves and bins: those of the bins up to a threshold say no."""
    best, most = None, -1
    for feature, above in enumerate(thresholds):
        n = len(above) + 1
        s = sums_by_leaf(leaf * n + bins[:, feature], leaves * n, weighed)
        no = s.reshape(leaves, n, -1).cumsum(1)
        yes = no[:, -1:] - no
        explained = sum(((t[:, :, :-1] ** 2).sum(2) / (t[:, :, -1] + CALM)).sum(0)
                        for t in (no[:, :-1], yes[:, :-1]))
        for k in numpy.flatnonzero(explained > most):
            if explained[k] > most and (feature, above[k]) not in asked:
                best, most = (feature, above[k]), explained[k]
    return best


def weigh_features(mark, told, weight):
    """What logarithms begin with, and weights of features [features][logarithms], in 1 / FINE parts
    for each mark."""
    x = mark / MARKS
    mean = numpy.average(x, 0, weight)
    spread = numpy.sqrt(numpy.average((x - mean) ** 2, 0, weight)) + 0.05
    z = (x - mean) / spread
    squares = (z * weight[:, None]).T @ z + RIDGE * numpy.eye(z.shape[1])
    left = told - numpy.average(told, 0, weight)
    slope = numpy.linalg.solve(squares, (z * weight[:, None]).T @ left) / spread[:, None]
    start = numpy.average(told, 0, weight) - mean @ slope
    return (numpy.rint(PARTS * FINE * MARKS * start).astype(int),
            numpy.rint(PARTS * FINE * slope).astype(int))


def by_weights(start, slope, mark):
    """In PARTS, rounded towards 0 as in selection.c."""
    return numpy.fix((start + mark @ slope) / (FINE * MARKS)).astype(int)


def grow(mark, bins, left, weight, thresholds):
    """A tree: questions, and what its leaves add [leaves][logarithms], in PARTS."""
    left = left * weight[:, None]
    questions, weighed = [], numpy.c_[left * SCALE, weight]
    for _ in range(QUESTIONS):
        leaf = find_leaves(questions, mark)
        questions.append(choose_question(bins, leaf, 2 ** len(questions), weighed, thresholds, questions))
    s = sums_by_leaf(find_leaves(questions, mark), 2**QUESTIONS, numpy.c_[left, weight])
    value = RATE * s[:, :-1] / (s[:, -1:] + CALM)
    return questions, numpy.clip(numpy.rint(PARTS * value), -REACH, REACH).astype(int)


def fit(mark, told, family):
    """The constants of the logarithms, the weights, and the trees."""
    draw, weight = numpy.random.default_rng(1), weigh(family)
    at = numpy.linspace(0, 1, QUANTILES + 1)[1:-1]
    thresholds = [numpy.unique(numpy.quantile(column, at).astype(int)) for column in mark.T]
    bins = numpy.stack([numpy.searchsorted(t, column) for t, column in zip(thresholds, mark.T)], 1)
    start, slope = weigh_features(mark, told, weight)
    so_far, trees = by_weights(start, slope, mark), []
    for _ in range(TREES):
        some = draw.random(len(mark)) < SHARE
        left = told[some] - so_far[some] / PARTS
        trees.append(grow(mark[some], bins[some], left, weight[some], thresholds))
        so_far = so_far + trees[-1][1][find_leaves(trees[-1][0], mark)]
    return start, slope, trees


def foretell(fitted, mark):
    start, slope, trees = fitted
    return (by_weights(start, slope, mark) + sum(value[find_leaves(questions, mark)] for questions, value in trees)) / PARTS


# ---- what that costs ----------------------------------------------------------------------------


def take_turns(needs, expected):
    """[steps] until the first engine ends, by slices as in slices.c."""
    spent = numpy.zeros(len(needs))
    while True:
        needed = numpy.maximum(expected, spent / PATIENCE)
        k = int(needed.argmin())
        until = LONGER * PATIENCE * numpy.partition(needed, 1)[1]
        until = max(until, spent[k] + LEAST_SLICE)
        if until >= needs[k]:
            return spent.sum() - spent[k] + needs[k]
        spent[k] = until


def costs(data, told, rows):
    """[s] of problems, with bounded elimination first if it is foretold to pay."""
    out = numpy.zeros(len(rows))
    for i, (row, t) in enumerate(zip(rows, told)):
        turns = STEP * take_turns(data.time[row] / STEP, data.unit[row] * 2 ** (t[0] + t[1:4]))
        first = data.bounded[row] * data.best[row]
        out[i] = (turns if t[4] >= 0 else first if data.answered[row]
                  else turns + first - data.best[row])
    return out


def held_out(data, group):
    """Regrets by fits to all other groups: logarithms of time over that of the best method."""
    out = numpy.zeros(len(group))
    for g in numpy.unique(group):
        fitted = fit(data.mark[group != g], data.told[group != g], data.family[group != g])
        rows = numpy.flatnonzero(group == g)
        out[rows] = numpy.log(costs(data, foretell(fitted, data.mark[rows]), rows) / data.single[rows])
    return out


def line(name, r):
    mean, error = r.mean(), r.std(ddof=1) / math.sqrt(len(r))
    print(f"| {name} | {math.exp(mean):.3f} | {math.exp(mean - 1.96 * error):.3f} - "
          f"{math.exp(mean + 1.96 * error):.3f} | {100 * (r > math.log(2)).mean():.1f} | "
          f"{100 * (r > math.log(3)).mean():.1f} | {math.exp(r.max()):.1f} |", flush=True)


def report_steps(problems):
    """[ns] that a step of each engine takes, where it took long enough to be told: STEP is about the
    mean of all, and each is near it (lib/trace/run.h)."""
    for engine in ENGINES:
        for digits, numbers in ((0, "short"), (9, "long")):
            ns = [1e9 * p["took"][engine] / p["steps"][engine] for p in problems
                  if p["digits"] == digits and p["took"][engine] > 3 * LEAST
                  and p.get("steps", {}).get(engine, 0) > 0]
            if len(ns) > 9:
                print(f"{engine}, {numbers} numbers: {len(ns)} problems, a step takes %.2f ns, 80 %% of "
                      "them %.2f to %.2f" % tuple(numpy.quantile(ns, (0.5, 0.1, 0.9))))


# ---- the table ----------------------------------------------------------------------------------

BEGIN = "/* Made by `ninja fit-selection`; do not edit from here. */"
END = "/* To here. */"


def names_of(path, macro):
    """Those of a list of macro(IDENTIFIER, "name", ...)."""
    with open(path, encoding="utf-8") as text:
        return re.findall(macro + r'\(\w+,\s*"([^"]+)"', text.read())


def text_of(tree):
    """The questions, and a letter for each leaf and logarithm, in lines of at most 100 characters."""
    questions, value = tree
    text = "".join(chr(ord(NEUTRAL) + v) for v in value.flat)
    lines = [f'     "{text[k:k + 93]}"' for k in range(0, len(text), 93)]
    asked = ", ".join(f"{{{feature}, {above}}}" for feature, above in questions)
    return "    {{" + asked + "},\n" + "\n".join(lines) + "},"


def write(path, head, fitted):
    with open(path, encoding="utf-8") as text:
        code = text.read()
    start, slope, trees = fitted
    assert abs(slope).max() < 2**15  # a short
    table = "\n".join([BEGIN, head, "static const int START[FORETOLD_COUNT] = {"
                       + ", ".join(map(str, start)) + "};",
                       "static const short WEIGHT[FMB_FEATURE_COUNT][FORETOLD_COUNT] = {",
                       *(f"    {{{', '.join(map(str, row))}}}," for row in slope), "};",
                       "static const tree TREE[] = {",
                       *map(text_of, trees), "};", END])
    code = code[:code.index(BEGIN)] + table + code[code.index(END) + len(END):]
    with open(path, "w", encoding="utf-8") as text:
        text.write(code)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bench")
    parser.add_argument("source")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--each", default="16")
    parser.add_argument("--seconds", default="0.2")
    parser.add_argument("--data", nargs="+", default=["selection.jsonl"])
    parser.add_argument("--write", action="store_true")
    a = parser.parse_args()
    if not os.path.exists(a.data[0]):
        with open(a.data[0], "w", encoding="ascii") as out:
            subprocess.run([a.bench, "--seed", a.seed, "--each", a.each, "--seconds", a.seconds],
                           stdout=out, check=True)
    path = os.path.join(a.source, "lib/solve/portfolio/selection.c")
    names = names_of(os.path.join(a.source, "lib/solve/prepare/features.h"), "F")
    problems = read(a.data, names)
    report_steps(problems)
    data = Data(problems, names)
    commit = subprocess.run(["git", "-C", a.source, "rev-parse", "--short", "HEAD"],
                            capture_output=True, text=True, check=False).stdout.strip()
    families = numpy.unique(data.family)
    numpy.random.default_rng(7).shuffle(families)
    group = numpy.array([list(families).index(f) % GROUPS for f in data.family])
    what = (f"{len(data.seed)} problems of {len(families)} families, seeds {data.seed.min()} to "
            f"{data.seed.max()}, ways as of commit {commit}.")
    print(what + "\n\n| choice | geometric mean | 95 % | over 2x, % | over 3x, % | worst |\n"
          "|---|---|---|---|---|---|")
    line("as it was", numpy.log(data.auto / data.single))
    line("best engine", numpy.log(data.best / data.single))
    unseen, seen = held_out(data, group), held_out(data, data.seed % SEEDS)
    line("families held out", unseen)
    line("families seen, other seeds", seen)
    if a.write:
        write(path, f"/* {what}\n * Time over that of the best method alone: "
              f"{math.exp(seen.mean()):.3f} on families seen, {math.exp(unseen.mean()):.3f} on others. */",
              fit(data.mark, data.told, data.family))


main()
