"""Who is ahead in an experiment (`fmb-qualify run`): a page of Markdown, from its lines of CSV alone.
usage: leaderboard.py PAGE.md RUNS.csv [ENTRY.csv...]

Entries are ways that were counted elsewhere on the same problems, within the same limit of rows (fmb.lab.experiment).

What was stopped by a limit is worse than all that was decided, and equal to what was stopped as well: so ranks and medians stand as
they are, however high the limit would have been. A way with a wrong answer is out, with the system that shows it."""

import collections
import pathlib
import sys

from plots import PROBLEM, np, read, stats

MEASURES = {"made": "rows made", "held": "most rows", "seconds": "time"}


class Way:
    """Everything that is measured alike: a method, with rules and an order if it has any. What decides about its place is the
    run with proofs; the one without says what they cost."""

    def __init__(self, key):
        self.method, self.rules, self.order = key
        self.run = collections.defaultdict(dict)
        self.rank, self.factor = {}, {}

    def main(self):
        return self.run["all"] if "all" in self.run else next(iter(self.run.values()))

    def cost(self, problem, measure):
        """Infinite unless decided; counts begin with 1, so that none made is nothing to divide by."""
        line = self.main().get(problem)
        if line is None or line["timed" if measure == "seconds" else "outcome"] != "decided":
            return np.inf
        return float(line[measure]) + (measure != "seconds")

    def is_timed(self):
        return any(line["timed"] != "no" for line in self.main().values())

    def solved(self):
        return sum(line["outcome"] == "decided" for line in self.main().values())

    def wrong(self):
        return [line for lines in self.run.values() for line in lines.values() if "wrong" in (line["outcome"], line["timed"])]

    def price(self):
        """Time with proofs over time without: the median over the problems that were decided with and without; nan without any."""
        all_of, none = self.run.get("all", {}), self.run.get("none", {})
        both = [p for p in all_of if p in none and all_of[p]["timed"] == none[p]["timed"] == "decided" and float(none[p]["seconds"]) > 0]
        return np.median([float(all_of[p]["seconds"]) / float(none[p]["seconds"]) for p in both]) if both else np.nan


def gather(lines):
    ways, problems = {}, {}
    for line in lines:
        if line["outcome"] == "unknown":
            continue
        key = line["method"], line["rules"], line["order"]
        problem = tuple(line[name] for name in PROBLEM)
        problems[problem] = line
        ways.setdefault(key, Way(key)).run[line["evidence"]][problem] = line
    return list(ways.values()), list(problems)


def same_way(line):
    return line["method"], line["rules"], line["order"], line["evidence"]


def entry(path, runs):
    """The lines of ways that are not in `runs`. The problems have to be its problems, within its limit of rows; and where a way is
    in both, its counts have to be the same, or something else was counted."""
    known = {(same_way(line), tuple(line[name] for name in PROBLEM)): line for line in runs}
    ways, limits = {way for way, _ in known}, {line["max_rows"] for line in runs}
    problems = {problem for _, problem in known}
    new = []
    for line in read(path):
        way, problem = same_way(line), tuple(line[name] for name in PROBLEM)
        where = f"fmb-qualify: {path}: {line['rules']}, {line['order']} on {'-'.join(problem[:3])}"
        if problem not in problems:
            sys.exit(f"{where}: no problem of the runs beside which it is to stand")
        if line["max_rows"] not in limits:
            sys.exit(f"{where}: {line['max_rows']} rows at most, expected {', '.join(sorted(limits))}")
        same = known.get((way, problem), line)
        if way not in ways:
            new.append(line)
        elif line["outcome"] == same["outcome"] == "decided" and line["made"] != same["made"]:
            sys.exit(f"{where}: {line['made']} rows made, expected {same['made']}")
    return new


def rank(ways, problems, measure):
    """Mean rank among these ways, and the median of the factor over the least of them; infinite where half are not solved."""
    costs = np.array([[way.cost(problem, measure) for problem in problems] for way in ways])
    least = costs.min(axis=0)
    known = np.isfinite(least)
    ranks = stats.rankdata(costs, axis=0).mean(axis=1)
    factors = np.median(costs[:, known] / least[known], axis=1) if known.any() else np.full(len(ways), np.nan)
    for way, mean, factor in zip(ways, ranks, factors):
        way.rank[measure], way.factor[measure] = mean, factor


def number(x):
    return "–" if np.isnan(x) else "∞" if np.isinf(x) else f"{x:.2f}" if x < 10 else f"{x:.3g}"


def table(heads, rows):
    return "\n".join(["| " + " | ".join(heads) + " |", "|" + "|".join(" --- " if head in ("rules", "order", "method") else " ---: "
                                                                         for head in heads) + "|",
                      *("| " + " | ".join(row) + " |" for row in rows)]) + "\n"


def elimination(ways, problems):
    for way in ways:
        way.rank["seconds"] = way.factor["seconds"] = np.nan
    for measure in MEASURES:
        rank([way for way in ways if measure != "seconds" or way.is_timed()], problems, measure)
    rows = []
    for place, way in enumerate(sorted(ways, key=lambda way: (way.rank["made"], way.rank["held"])), 1):
        cells = [f"{number(way.rank[measure])} ({number(way.factor[measure])})" if way.is_timed() or measure != "seconds" else "–"
                 for measure in MEASURES]
        rows.append([str(place), way.rules.replace(",", ", "), way.order, str(way.solved()), *cells, number(way.price())])
    return table(["", "rules", "order", "solved", *MEASURES.values(), "proofs"], rows)


def methods(ways, problems):
    """Each method, elimination in the way that is first by time, beside the others."""
    others = [way for way in ways if way.method != "fm"]
    rules = sorted((way for way in ways if way.method == "fm" and way.is_timed()), key=lambda way: way.rank["seconds"])
    if not others or not rules:
        return ""
    shown = [rules[0], *others]
    rank(shown, problems, "seconds")
    best = np.min([[way.cost(p, "seconds") for p in problems] for way in shown], axis=0)
    rows = []
    for way in sorted(shown, key=lambda way: way.rank["seconds"]):
        first = sum(np.isfinite(way.cost(p, "seconds")) and way.cost(p, "seconds") <= least for p, least in zip(problems, best))
        rows.append([f"`{way.method}`" + (f" {way.rules}, {way.order}" if way.rules else ""), str(way.solved()), str(first),
                     number(way.rank["seconds"]), number(way.factor["seconds"]), number(way.price())])
    return ("\n## Beside other methods\n\nBy time: how often a method was the fastest, its mean rank, its median factor over the fastest "
            "of these on the same problem.\n\n" + table(["method", "solved", "fastest", "rank", "factor", "proofs"], rows))


def disqualified(ways):
    text = ""
    for way in ways:
        lines = way.wrong()
        if lines:
            shown = next((line["system"] for line in lines if line["system"]), "")
            text += (f"\n**{way.rules or way.method}, {way.order}**: {len(lines)} wrong answers, the first on "
                     f"{'-'.join(lines[0][key] for key in PROBLEM[:3])}. With any row less it would be right:\n\n```text\n" +
                     shown.replace(";", "\n").strip() + "\n```\n")
    return "\n## Disqualified\n" + text if text else "\n## Disqualified\n\nNobody: there was no wrong answer.\n"


def main(page, path, *entries):
    lines = read(path)
    ways, problems = gather(lines + [line for other in entries for line in entry(other, lines)])
    good = [way for way in ways if not way.wrong()]
    rules = [way for way in good if way.method == "fm"]
    facts = {key: ", ".join(sorted({line[key] for line in lines})) for key in
             ("plan", "version", "commit", "machine", "max_rows", "max_seconds", "passes")}
    families = len({problem[0] for problem in problems})
    text = (f"Library {facts['version']} ({facts['commit']}), plan {facts['plan']}, {facts['machine']}; {len(problems)} problems of "
            f"{families} families; limits of {facts['max_rows']} rows and {facts['max_seconds']} s a problem; {facts['passes']} timed "
            f"passes.\n\n## Elimination\n\n" + (elimination(rules, problems) if rules else "No rules.\n") + methods(good, problems) +
            disqualified(ways))
    before, begin, rest = pathlib.Path(page).read_text().partition("<!-- begin -->\n") if pathlib.Path(page).exists() else ("", "", "")
    _, end, after = rest.partition("<!-- end -->\n")
    pathlib.Path(page).write_text(f"{before}{begin}{text}{end}{after}" if end else "# Leaderboard\n\n" + text)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
