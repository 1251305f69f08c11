#!/usr/bin/env python3
"""Fit the choice among the ways of a projection to regret, with whole families held out.

    fit.py BENCH SOURCE [--seed N] [--each N] [--seconds S] [--data FILE]

BENCH is bench-selection, whose lines are data (or those of FILE, which is written if it is not
there). The report compares, on families that a fit has not seen and on families that it has under
other seeds: each arm by itself, the rules (lib/solve/portfolio/selection.c), a forest of regret
trees over all arms, and the same that leaves the rules only where it expects much.

Regret is the logarithm of the time over that of the best arm; an arm that did not end in the limit
took three times the limit.
"""
import argparse
import json
import math
import os
import random
import subprocess

ARMS = ["rules", "fm", "dd", "hull", "no-bounded", "no-pruned", "no-rays"]
LEAST = 2e-5  # [s] less is not told apart
DEPTH, LEAVES, TREES = 5, 6, 24


def features(p):
    rows, columns, entries = p["rows"], max(1, p["columns"]), p["entries"]
    by_row = entries / max(1, rows)
    return [p["kept"], p["variables"], p["given"], p["strict"], p["wide"], columns, rows,
            entries, p["bounds"] / max(1, rows), p["freedom"], p["minor_bits"], p["long"],
            p["origin"], p["simulated_most"], p["simulated_last"], p["simulated_left"],
            by_row, by_row / columns, rows / columns, columns - p["kept"],
            p["simulated_most"] / max(1, rows)]


def read(path):
    problems = []
    with open(path, encoding="ascii") as lines:
        for line in lines:
            p = json.loads(line)
            took = [max(LEAST, p[a] if p[a] is not None else 3 * p["limit"]) for a in ARMS]
            p["best"] = min(took)
            p["regret"] = [math.log(t / p["best"]) for t in took]
            p["x"] = features(p)
            if any(p[a] is not None for a in ARMS):
                problems.append(p)
    return problems


def sums(problems):
    return [sum(p["weight"] * p["regret"][a] for p in problems) for a in range(len(ARMS))]


def grow(problems, depth, rng):
    """A tree whose leaves are mean regrets; of two halves, the sums of their best arms are least."""
    total, n = sums(problems), sum(p["weight"] for p in problems)
    leaf = [t / n for t in total]
    if depth == 0 or len(problems) < 2 * LEAVES:
        return leaf
    best = (min(total) - 1e-9, None, None)
    for k in rng.sample(range(len(problems[0]["x"])), 8):
        order = sorted(problems, key=lambda p: p["x"][k])
        left = [0.0] * len(ARMS)
        for i in range(len(order) - 1):
            p, w = order[i], order[i]["weight"]
            for a, r in enumerate(p["regret"]):
                left[a] += w * r
            x, y = p["x"][k], order[i + 1]["x"][k]
            if x == y or i + 1 < LEAVES or len(order) - i - 1 < LEAVES:
                continue
            loss = min(left) + min(t - l for t, l in zip(total, left))
            if loss < best[0]:
                best = (loss, k, (x + y) / 2)
    if best[1] is None:
        return leaf
    _, k, at = best
    return (k, at, grow([p for p in problems if p["x"][k] <= at], depth - 1, rng),
            grow([p for p in problems if p["x"][k] > at], depth - 1, rng))


def fit(problems, seed):
    """Families weigh the same, however many of their problems there are."""
    rng, of = random.Random(seed), {}
    for p in problems:
        of[p["family"]] = of.get(p["family"], 0) + 1
    for p in problems:
        p["weight"] = 1 / of[p["family"]]
    forest = []
    for _ in range(TREES):
        drawn = set(rng.sample(sorted(of), max(1, 3 * len(of) // 4)))
        forest.append(grow([p for p in problems if p["family"] in drawn], DEPTH, rng))
    return forest


def expected(forest, x):
    mean = [0.0] * len(ARMS)
    for tree in forest:
        while isinstance(tree, tuple):
            tree = tree[2] if x[tree[0]] <= tree[1] else tree[3]
        mean = [m + t / len(forest) for m, t in zip(mean, tree)]
    return mean


def choose(forest, x, margin):
    """The best arm; the rules, unless it is expected to take so much less."""
    mean = expected(forest, x)
    best = mean.index(min(mean))
    return best if mean[best] < mean[0] - margin else 0


def line(name, regrets):
    n = len(regrets)
    mean = sum(regrets) / n
    error = math.sqrt(sum((r - mean) ** 2 for r in regrets) / max(1, n - 1) / n)
    over = [100 * sum(r > math.log(k) for r in regrets) / n for k in (2, 3)]
    return (f"| {name} | {math.exp(mean):.3f} | {math.exp(mean - 1.96 * error):.3f} - "
            f"{math.exp(mean + 1.96 * error):.3f} | {over[0]:.1f} | {over[1]:.1f} | "
            f"{math.exp(max(regrets)):.1f} |")


MARGINS = [("the forest", 0.0), ("rules unless 1.1", math.log(1.1)),
           ("rules unless 1.25", math.log(1.25)), ("rules unless 1.5", math.log(1.5))]


def table(title, problems, fold_of):
    """fold_of(p): what is held out together with p."""
    folds, chosen = sorted({fold_of(p) for p in problems}), {m: [] for m, _ in MARGINS}
    for f in folds:
        forest = fit([p for p in problems if fold_of(p) != f], 1)
        for p in problems:
            if fold_of(p) == f:
                for name, margin in MARGINS:
                    chosen[name].append(p["regret"][choose(forest, p["x"], margin)])
    print(f"\n{title}\n\n| choice | geometric mean | 95 % | over 2x, % | over 3x, % | worst |")
    print("|---|---|---|---|---|---|")
    for a, name in enumerate(ARMS):
        print(line(name, [p["regret"][a] for p in problems]))
    for name, _ in MARGINS:
        print(line(name, chosen[name]))


def families_in_groups(problems, groups):
    names = sorted({p["family"] for p in problems})
    random.Random(7).shuffle(names)
    return {name: i % groups for i, name in enumerate(names)}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("bench")
    parser.add_argument("source")
    parser.add_argument("--seed", default="1")
    parser.add_argument("--each", default="4")
    parser.add_argument("--seconds", default="1")
    parser.add_argument("--data", default="selection.jsonl")
    a = parser.parse_args()
    if not os.path.exists(a.data):
        with open(a.data, "w", encoding="ascii") as out:
            subprocess.run([a.bench, "--seed", a.seed, "--each", a.each, "--seconds", a.seconds],
                           stdout=out, check=True)
    problems = read(a.data)
    commit = subprocess.run(["git", "-C", a.source, "rev-parse", "--short", "HEAD"],
                            capture_output=True, text=True, check=False).stdout.strip()
    group = families_in_groups(problems, 9)
    print(f"{len(problems)} problems of {len(group)} families, seeds {problems[0]['seed']} to "
          f"{problems[-1]['seed']}, commit {commit}.")
    table("Families held out whole, a ninth of them at a time.", problems,
          lambda p: group[p["family"]])
    table("Families seen, other seeds.", problems, lambda p: p["seed"])


main()
