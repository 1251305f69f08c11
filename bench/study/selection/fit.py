#!/usr/bin/env python3
"""Fit the choice among the pipelines of projections to regret, with whole families held out.

    fit.py BENCH SOURCE [--seed N] [--each N] [--seconds S] [--data FILE] [--write] [--forest]
           [--simulated]

BENCH is bench-selection, whose lines are data (or those of FILE, which is written if it is not
there). The report compares, on families that a fit has not seen and on families that it has under
other seeds: what the library does, the best pipeline for all, and a tree whose leaves are pipelines
(--forest: and a forest of such trees, which takes minutes). --simulated: the tree may ask for what
an elimination of signs tells (simulate.c), which the library does not make. --write puts the tree
of all data into lib/solve/portfolio/selection.c of SOURCE.

The table leaves the choice to the rules of selection.c where minors have no more than SHORT bits, as
fits did not reach those on families that they had not seen, and where more than MOST_KEPT variables
stay, or one, of which there are too few problems; the report is of both sides.

Regret is the logarithm of the time over that of the best pipeline; one that was not waited for took
half as long again as it was waited for. A leaf needs problems of several families, so that a
family by itself teaches nothing.
"""
import argparse
import json
import math
import os
import random
import re
import subprocess

LEAST = 1e-5  # [s] less is not told apart
SHORT, LEAST_KEPT, MOST_KEPT = 100, 2, 3  # where the table decides: see of_table
RULES = "as its shape tells"  # the pipeline that rules put together
THRESHOLDS = 24  # of a feature, at most
TREE = {"depth": 1, "leaf": 10, "families": 4, "gain": 0.002, "trees": 1, "features": 1.0}
FOREST = {"depth": 5, "leaf": 6, "families": 3, "gain": 0.0, "trees": 24, "features": 0.4}


def seconds(t):
    return max(LEAST, t if t >= 0 else -1.5 * t)


def read(path, names):
    with open(path, encoding="ascii") as lines:
        problems = [json.loads(text) for text in lines]
    arms = list(problems[0]["took"])
    kept = []
    for p in problems:
        took = [seconds(p["took"][a]) for a in arms]
        if all(p["took"][a] < 0 for a in arms):
            continue
        p["best"] = min(took)
        p["regret"] = [math.log(t / p["best"]) for t in took]
        p["x"] = [p["features"][name] for name in names]
        kept.append(p)
    return arms, kept


class Fit:
    """Trees over features; their leaves are sums of regrets of all arms."""

    def __init__(self, arms, names):
        self.arms, self.names = arms, names
        self.choices = [a for a, name in enumerate(arms) if name not in ("auto", RULES)]

    def cuts(self, problems):
        """Thresholds of each feature, between different values."""
        out = []
        for k in range(len(self.names)):
            values = sorted(p["x"][k] for p in problems)
            step = max(1, len(values) // THRESHOLDS)
            between = {(a + b) / 2 for a, b in zip(values[::step], values[step::step]) if a < b}
            out.append(sorted(between | ({(values[0] + values[-1]) / 2} if len(set(values)) == 2
                                         else set())))
        return out

    def sums(self, problems):
        total = [0.0] * len(self.arms)
        for p in problems:
            w = p["weight"]
            total = [t + w * r for t, r in zip(total, p["regret"])]
        return total

    def least(self, total):
        return min(total[a] for a in self.choices)

    def split(self, problems, k, limits):
        """The best cut of feature k: (loss, threshold)."""
        cuts = self.cuts_of[k]
        bins = [[] for _ in range(len(cuts) + 1)]
        for p in problems:
            at, x = 0, p["x"][k]
            low, high = 0, len(cuts)
            while low < high:
                at = (low + high) // 2
                if x <= cuts[at]:
                    high = at
                else:
                    low = at + 1
            bins[low].append(p)
        total, left, best = self.sums(problems), [0.0] * len(self.arms), (math.inf, None)
        count, seen = 0, set()
        after = [set() for _ in bins]
        for b in range(len(bins) - 1, 0, -1):
            after[b - 1] = after[b] | {p["family"] for p in bins[b]}
        for b, cut in enumerate(cuts):
            if not bins[b]:
                continue
            left = [l + s for l, s in zip(left, self.sums(bins[b]))]
            count += len(bins[b])
            seen |= {p["family"] for p in bins[b]}
            if (count < limits["leaf"] or len(problems) - count < limits["leaf"] or
                    len(seen) < limits["families"] or len(after[b]) < limits["families"]):
                continue
            loss = self.least(left) + self.least([t - l for t, l in zip(total, left)])
            if loss < best[0]:
                best = (loss, cut)
        return best

    def grow(self, problems, depth, limits, rng):
        total = self.sums(problems)
        weight = sum(p["weight"] for p in problems)
        leaf = [t / weight for t in total]
        if depth == 0 or len(problems) < 2 * limits["leaf"]:
            return leaf
        best = (self.least(total) - limits["gain"] * self.weight, None, None)
        names = range(len(self.names))
        if limits["features"] < 1:
            names = rng.sample(names, max(2, int(limits["features"] * len(names))))
        for k in names:
            loss, cut = self.split(problems, k, limits)
            if loss < best[0]:
                best = (loss, k, cut)
        if best[1] is None:
            return leaf
        _, k, cut = best
        halves = [[p for p in problems if (p["x"][k] <= cut) == side] for side in (True, False)]
        return (k, cut, *(self.grow(h, depth - 1, limits, rng) for h in halves))

    def fit(self, problems, limits, seed=1):
        """Families weigh the same, however many of their problems there are."""
        rng, of = random.Random(seed), {}
        for p in problems:
            of[p["family"]] = of.get(p["family"], 0) + 1
        for p in problems:
            p["weight"] = 1 / of[p["family"]]
        self.weight = len(of)
        self.cuts_of = self.cuts(problems)
        if limits["trees"] == 1:
            return [self.grow(problems, limits["depth"], limits, rng)]
        forest = []
        for _ in range(limits["trees"]):
            drawn = set(rng.sample(sorted(of), max(1, 2 * len(of) // 3)))
            forest.append(self.grow([p for p in problems if p["family"] in drawn],
                                    limits["depth"], limits, rng))
        return forest

    def expected(self, forest, x):
        mean = [0.0] * len(self.arms)
        for tree in forest:
            while isinstance(tree, tuple):
                tree = tree[2] if x[tree[0]] <= tree[1] else tree[3]
            mean = [m + t / len(forest) for m, t in zip(mean, tree)]
        return mean

    def regret(self, forest, p):
        mean = self.expected(forest, p["x"])
        best = min(self.choices, key=lambda a: mean[a])
        return p["regret"][best]

    def leaf_choice(self, leaf):
        return min(self.choices, key=lambda a: leaf[a])

    def merge(self, tree):
        """A node whose leaves choose the same is a leaf."""
        if not isinstance(tree, tuple):
            return tree
        k, cut, yes, no = tree
        yes, no = self.merge(yes), self.merge(no)
        if not isinstance(yes, tuple) and not isinstance(no, tuple) and \
                self.leaf_choice(yes) == self.leaf_choice(no):
            return yes
        return (k, cut, yes, no)

    def show(self, tree, indent=0):
        if not isinstance(tree, tuple):
            return [" " * indent + self.arms[self.leaf_choice(tree)]]
        k, cut, yes, no = tree
        return ([" " * indent + f"{self.names[k]} <= {cut:.4g}"] + self.show(yes, indent + 2) +
                [" " * indent + "else"] + self.show(no, indent + 2))


def line(name, regrets):
    n = len(regrets)
    mean = sum(regrets) / n
    error = math.sqrt(sum((r - mean) ** 2 for r in regrets) / max(1, n - 1) / n)
    over = [100 * sum(r > math.log(k) for r in regrets) / n for k in (2, 3)]
    return (f"| {name} | {math.exp(mean):.3f} | {math.exp(mean - 1.96 * error):.3f} - "
            f"{math.exp(mean + 1.96 * error):.3f} | {over[0]:.1f} | {over[1]:.1f} | "
            f"{math.exp(max(regrets)):.1f} |")


def of_table(p):
    x = p["features"]
    return x["bits of a minor"] > SHORT and LEAST_KEPT <= x["variables that stay"] <= MOST_KEPT


def table(title, fit, problems, fold_of, fits):
    """fold_of(p): what is held out together with p."""
    print(f"\n{title}\n\n| choice | geometric mean | 95 % | over 2x, % | over 3x, % | worst |")
    print("|---|---|---|---|---|---|")
    single = min(fit.choices, key=lambda a: sum(p["regret"][a] for p in problems))
    print(line("auto, as it is", [p["regret"][fit.arms.index("auto")] for p in problems]))
    if RULES in fit.arms:
        print(line("rules", [p["regret"][fit.arms.index(RULES)] for p in problems]))
    print(line(f"always {fit.arms[single]}", [p["regret"][single] for p in problems]))
    means = []
    for name, limits in fits:
        regrets = []
        for f in sorted({fold_of(p) for p in problems}):
            forest = fit.fit([p for p in problems if fold_of(p) != f], limits)
            regrets += [fit.regret(forest, p) for p in problems if fold_of(p) == f]
        print(line(name, regrets), flush=True)
        means.append(math.exp(sum(regrets) / len(regrets)))
    return means[0]


def families_in_groups(problems, groups):
    names = sorted({p["family"] for p in problems})
    random.Random(7).shuffle(names)
    return {name: i % groups for i, name in enumerate(names)}


# ---- the table ----------------------------------------------------------------------------------

BEGIN = "/* Made by `ninja fit-selection`; do not edit from here. */"
END = "/* To here. */"


def identifiers(path, macro):
    """{name: identifier} of a list of macro(IDENTIFIER, "name", ...)."""
    with open(path, encoding="utf-8") as text:
        return {name: word for word, name in re.findall(macro + r'\((\w+),\s*"([^"]+)"', text.read())}


def lines_of(fit, tree, features, pipelines, indent, out):
    """Append the lines of a tree: a question, lines for yes, lines for no."""
    at = len(out)
    if not isinstance(tree, tuple):
        out.append("    /* %3d */ %s%s," % (at, "  " * indent, "TAKE(%s)" % pipelines[
            fit.arms[fit.leaf_choice(tree)]]))
        return
    k, cut, yes, no = tree
    out.append(None)
    lines_of(fit, yes, features, pipelines, indent + 1, out)
    out[at] = "    /* %3d */ %sASK(%s, %.4g, %d)," % (at, "  " * indent, features[fit.names[k]],
                                                       cut, len(out))
    lines_of(fit, no, features, pipelines, indent + 1, out)


def write(source, head, fit, tree):
    folder = os.path.join(source, "lib/solve/portfolio")
    path = os.path.join(folder, "selection.c")
    out = [f"    /*   0 */ ASK(MINOR_BITS, {SHORT}, 2),", "    /*   1 */   TAKE(OF_SHAPE),",
           f"    /*   2 */ ASK(KEPT, {LEAST_KEPT - 1}, 4),", "    /*   3 */   TAKE(OF_SHAPE),", None]
    lines_of(fit, tree, identifiers(os.path.join(folder, "features.h"), "F"),
             identifiers(path, "P"), 1, out)
    out[4] = f"    /*   4 */ ASK(KEPT, {MOST_KEPT}, {len(out)}),"
    out.append("    /* %3d */   TAKE(OF_SHAPE)," % len(out))
    with open(path, encoding="utf-8") as text:
        code = text.read()
    table_text = "\n".join([BEGIN, "/* " + head + " */",
                            "static const fmb_selection_line TABLE[] = {", *out, "};", END])
    code = code[:code.index(BEGIN)] + table_text + code[code.index(END) + len(END):]
    with open(path, "w", encoding="utf-8") as text:
        text.write(code)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bench")
    parser.add_argument("source")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--each", default="6")
    parser.add_argument("--seconds", default="0.5")
    parser.add_argument("--data", default="selection.jsonl")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--forest", action="store_true")
    parser.add_argument("--simulated", action="store_true")
    a = parser.parse_args()
    if not os.path.exists(a.data):
        with open(a.data, "w", encoding="ascii") as out:
            subprocess.run([a.bench, "--seed", a.seed, "--each", a.each, "--seconds", a.seconds],
                           stdout=out, check=True)
    names = list(identifiers(os.path.join(a.source, "lib/solve/prepare/features.h"), "F"))
    if a.simulated:
        names += ["simulated rows", "simulated pairs", "variables left by simulation",
                  "simulated first growth"]
    arms, problems = read(a.data, names)
    fit = Fit(arms, names)
    commit = subprocess.run(["git", "-C", a.source, "rev-parse", "--short", "HEAD"],
                            capture_output=True, text=True, check=False).stdout.strip()
    every = problems
    problems = [p for p in every if of_table(p)]
    group = families_in_groups(every, 11)
    seeds = [p["seed"] for p in problems]
    what = (f"{len(problems)} problems of {len({p['family'] for p in problems})} families, seeds "
            f"{min(seeds)} to {max(seeds)}, commit {commit}")
    print(what)
    fits = [("tree", TREE)] + ([("forest", FOREST)] if a.forest else [])
    others = [p for p in every if not of_table(p)]
    table("By rules. Families held out whole", fit, others, lambda p: group[p["family"]], fits)
    table("By rules. Families seen, other seeds", fit, others, lambda p: p["seed"] % 6, fits)
    held = table("By the table. Families held out whole, an eleventh of them at a time.", fit, problems,
                 lambda p: group[p["family"]], fits)
    seen = table("By the table. Families seen, other seeds.", fit, problems, lambda p: p["seed"] % 6, fits)
    if a.write:
        tree = fit.merge(fit.fit(problems, TREE)[0])
        print("\n" + "\n".join(fit.show(tree)))
        write(a.source, f"{what}.\n * Time over that of the best pipeline: {seen:.3f} on families seen, "
              f"{held:.3f} on others.", fit, tree)


main()
