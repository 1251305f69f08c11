#!/usr/bin/env python3
"""Fit the choice among the pipelines of projections to regret, with whole families held out.

    fit.py BENCH SOURCE [--seed N] [--each N] [--seconds S] [--data FILE...] [--write]

BENCH is bench-selection, whose lines are data (or those of the FILEs; the first one is written if
none is there). Needs NumPy. Regret is the logarithm of the time over that of the best method that
does one thing; a pipeline that was not waited for took half as long again as it was waited for.

What is fitted: weights of the logarithms of features, for each pipeline; the one with the least sum
is taken. They begin as the least squares of regrets (ridge regression), and go down the gradient of
the regret that is expected where pipelines are drawn with probabilities that fall with their sums,
for a fixed number of steps. Families weigh the same, however many of their problems there are. The
report compares that with what the library does, on families that a fit has not seen and on families
that it has under other seeds; --write puts the weights of all data into
lib/solve/portfolio/selection.c of SOURCE.
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
LEAST = 1e-5  # [s] less is not told apart
GROUPS = 11  # of families, one held out at a time
SEEDS = 4  # one of so many held out at a time
RIDGE = 1.0  # standard deviations count as so many problems with regret 0
STEPS, RATE, SHARPNESS = 300, 0.02, 3.0  # of the descent
# Recorded projections are of few families: what their files' names begin with.
RECORDED = {"rd": "random", "rs": "random", "shannon": "entropy", "col": "practice", "dep": "practice",
            "farkas": "practice", "tile": "practice"}
SCALE = 1000  # weights are whole numbers, in parts of one


def rough_logarithm(x):
    """log2(1 + x) by straight lines between powers of two, as in selection.c."""
    mantissa, exponent = math.frexp(1 + x)
    return exponent - 2 + 2 * mantissa


def seconds(t):
    return max(LEAST, t if t >= 0 else -1.5 * t)


def read(paths, names, arms):
    """The problems that some method alone has done."""
    problems = []
    for path in paths:
        with open(path, encoding="ascii") as lines:
            problems += [json.loads(text) for text in lines]
    for p in problems:
        name_recorded(p)
    return [p for p in problems if any(p["took"][a] >= 0 for a in SINGLES)
            and all(a in p["took"] for a in arms) and all(n in p["features"] for n in names)]


def name_recorded(p):
    """A file has no seed, and a family only by its name."""
    name = p["family"]
    if "." in name:
        p["family"] = "recorded " + RECORDED.get(re.split("[_0-9]", name)[0], "polytopes")
        p["seed"] = zlib.crc32(name.encode()) % 1000


class Data:
    def __init__(self, problems, names, arms):
        best = [min(seconds(p["took"][a]) for a in SINGLES if p["took"][a] >= 0) for p in problems]
        self.regret = numpy.array([[math.log(seconds(p["took"][a]) / b) for a in arms]
                                   for p, b in zip(problems, best)])
        self.auto = numpy.array([math.log(seconds(p["took"]["auto"]) / b)
                                 for p, b in zip(problems, best)])
        self.x = numpy.array([[1.0] + [rough_logarithm(p["features"][n]) for n in names]
                              for p in problems])
        self.family = numpy.array([p["family"] for p in problems])
        self.seed = numpy.array([p["seed"] for p in problems])


def fit(x, regret, family):
    """Weights [1 + features][pipelines]."""
    _, place, count = numpy.unique(family, return_inverse=True, return_counts=True)
    w = 1 / count[place]
    mean, spread = x.mean(0), x.std(0) + 1e-9
    mean[0], spread[0] = 0, 1
    z = (x - mean) / spread
    ridge = RIDGE * numpy.eye(len(mean))
    ridge[0, 0] = 1e-6
    b = SHARPNESS * numpy.linalg.solve(z.T @ (z * w[:, None]) + ridge, z.T @ (regret * w[:, None]))
    w /= w.sum()
    first, second = numpy.zeros_like(b), numpy.zeros_like(b)  # moments (Kingma, Ba 2015)
    for t in range(1, STEPS + 1):
        s = z @ b
        p = numpy.exp(s.min(1, keepdims=True) - s)
        p /= p.sum(1, keepdims=True)
        expected = (p * regret).sum(1, keepdims=True)
        gradient = z.T @ (w[:, None] * p * (expected - regret))
        first = 0.9 * first + 0.1 * gradient
        second = 0.99 * second + 0.01 * gradient * gradient
        b -= RATE * first / (1 - 0.9**t) / (numpy.sqrt(second / (1 - 0.99**t)) + 1e-8)
    b /= spread[:, None]
    b[0] -= mean[1:] @ b[1:]
    return numpy.rint(SCALE * b / SHARPNESS)


def regrets(data, weights, rows):
    return data.regret[rows, (data.x[rows] @ weights).argmin(1)]


def held_out(data, group):
    """Regrets by fits to all other groups."""
    out = numpy.zeros(len(group))
    for g in numpy.unique(group):
        weights = fit(data.x[group != g], data.regret[group != g], data.family[group != g])
        rows = numpy.flatnonzero(group == g)
        out[rows] = regrets(data, weights, rows)
    return out


def line(name, r):
    mean, error = r.mean(), r.std(ddof=1) / math.sqrt(len(r))
    print(f"| {name} | {math.exp(mean):.3f} | {math.exp(mean - 1.96 * error):.3f} - "
          f"{math.exp(mean + 1.96 * error):.3f} | {100 * (r > math.log(2)).mean():.1f} | "
          f"{100 * (r > math.log(3)).mean():.1f} | {math.exp(r.max()):.1f} |", flush=True)


# ---- the table ----------------------------------------------------------------------------------

BEGIN = "/* Made by `ninja fit-selection`; do not edit from here. */"
END = "/* To here. */"


def names_of(path, macro):
    """Those of a list of macro(IDENTIFIER, "name", ...)."""
    with open(path, encoding="utf-8") as text:
        return re.findall(macro + r'\(\w+,\s*"([^"]+)"', text.read())


def rows_of(weights):
    """Of each pipeline, in lines of at most 100 characters."""
    out = []
    for row in weights.T.astype(int).tolist():
        text = ", ".join(map(str, row))
        cut = text.rfind(" ", 0, 92) if len(text) > 92 else len(text)
        out.append("    {" + text[:cut] + ("\n     " + text[cut + 1:] if cut < len(text) else "") + "},")
    return out


def write(path, head, weights):
    with open(path, encoding="utf-8") as text:
        code = text.read()
    table = "\n".join([BEGIN, head, "static const short WEIGHT[PIPELINE_COUNT][1 + FMB_FEATURE_COUNT] = {",
                       *rows_of(weights), "};", END])
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
    arms = names_of(path, "P")
    data = Data(read(a.data, names, arms), names, arms)
    commit = subprocess.run(["git", "-C", a.source, "rev-parse", "--short", "HEAD"],
                            capture_output=True, text=True, check=False).stdout.strip()
    families = numpy.unique(data.family)
    numpy.random.default_rng(7).shuffle(families)
    group = numpy.array([list(families).index(f) % GROUPS for f in data.family])
    what = (f"{len(data.seed)} problems of {len(families)} families, seeds {data.seed.min()} to "
            f"{data.seed.max()}, ways as of commit {commit}.")
    print(what + "\n\n| choice | geometric mean | 95 % | over 2x, % | over 3x, % | worst |\n"
          "|---|---|---|---|---|---|")
    line("as it was", data.auto)
    line("best pipeline", data.regret.min(1))
    unseen, seen = held_out(data, group), held_out(data, data.seed % SEEDS)
    line("families held out", unseen)
    line("families seen, other seeds", seen)
    if a.write:
        write(path, f"/* {what}\n * Time over that of the best method alone: "
              f"{math.exp(seen.mean()):.3f} on families seen, {math.exp(unseen.mean()):.3f} on others. */",
              fit(data.x, data.regret, data.family))


main()
