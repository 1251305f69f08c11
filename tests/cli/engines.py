"""The trace names every engine that was asked, for which part, with which budget, and how it ended.
usage: engines.py FMB"""

import json
import pathlib
import random
import subprocess
import sys
import tempfile

import under

fmb = under.command(sys.argv[1])
KEYS = ["event", "seconds", "name", "task", "part", "columns", "rows", "budget", "unit", "left",
        "ended", "spent"]
ENDS = {"answered", "gave up", "paused", "unsuitable", "limit"}
seen = {}


def system(n, m, terms):
    """m rows of so many terms over n variables, around the origin."""
    draw = random.Random(n * m + terms)
    rows = [" ".join(f"{draw.choice([-1, 1]) * draw.randint(1, 9):+d} x{v}"
                     for v in draw.sample(range(n), terms)) + f" <= {draw.randint(1, 50)}"
            for _ in range(m)]
    return "\n".join([f"vars: {' '.join(names(n))}", *rows, ""])


def names(n):
    return [f"x{i}" for i in range(n)]


def points(n, m, zeros, corner=0):
    """m points in n dimensions, a share of whose coordinates is 0; or, with a corner, within a
    simplex, and its corners."""
    draw = random.Random(n * m)
    least = 0 if corner else -99
    some = [[0 if draw.random() < zeros else draw.randint(least, 99) for _ in range(n)]
            for _ in range(m)]
    some += [[corner * (i == j) for j in range(n)] for i in range(n + 1) if corner]
    rows = [" ".join(map(str, [1, *x])) for x in some]
    m = len(rows)
    return "\n".join(["V-representation", "begin", f"{m} {n + 1} rational", *rows, "end", ""])


def look(e, parts, last):
    """An engine that gave up or paused had a budget, and another one goes on; an event without a part is
    about the system as a whole."""
    assert [key for key in KEYS if key in e] == list(e), e
    assert e["ended"] in ENDS and e["columns"] > 0 and e["rows"] >= 0, e
    assert ("budget" in e) == ("unit" in e) and 1 <= e.get("part", 1) <= parts, e
    assert e["ended"] not in ("gave up", "paused") or "budget" in e, e
    assert not last or e["ended"] in ("answered", "limit"), e
    seen.setdefault((e["name"], e["task"]), set()).add(e["ended"])


def ask(folder, text, *words, ending="fmb", parts=1):
    (folder / f"in.{ending}").write_text(text)
    run = subprocess.run([*fmb, words[0], str(folder / f"in.{ending}"), *words[1:], "--quiet",
                          "--trace", str(folder / "trace")], capture_output=True, text=True)
    assert run.returncode in (0, 1, 2), f"{words}: {run}"
    events = [json.loads(line) for line in (folder / "trace").read_text().splitlines()]
    tries = [e for e in events if e["event"] == "engine"]
    assert tries, words
    for e in tries:
        look(e, parts, e is tries[-1])
    return [(e["name"], e["task"], e.get("part"), e["ended"]) for e in tries]


def keep(n):
    return "--keep", ",".join(names(n))


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    small = system(4, 8, 2)
    assert ask(folder, "x + y <= 1\n z >= 2\n", "solve", "--method=lp", parts=2) == [
        ("oracle", "verdict", 1, "answered"), ("oracle", "verdict", 2, "answered")]
    assert ask(folder, system(6, 20, 3), "solve", "--method=fm", "--max-rows=1")[-1][3] == "limit"
    ask(folder, system(6, 8, 5), "solve")
    ask(folder, small, "bounds")
    ask(folder, small, "bounds", "--method=fm")
    ask(folder, system(40, 60, 5), "bounds", "--threads=2")
    ask(folder, small, "optimize", "--max=x0")
    ask(folder, small, "optimize", "--max=x0", "--method=fm")
    ask(folder, system(4, 40, 3), "reduce")
    for n, m, terms in ((3, 10, 2), (10, 30, 10)): # flat
        ask(folder, system(n, m, terms) + " + ".join(names(n)) + " = 0\n", "reduce")
    ask(folder, small, "vertices")
    ask(folder, system(3, 80, 2), "vertices")
    ask(folder, points(3, 9, 0), "hull", ending="ext")
    for zeros in (0, 0.5):
        ask(folder, points(9, 200, zeros, 999), "hull", ending="ext")
    for n, m, terms, kept in ((3, 20, 2, 2), (6, 8, 6, 5), (6, 20, 2, 3), (4, 20, 3, 3),
                              (8, 8, 8, 1), (3, 8, 2, 1), (4, 8, 2, 2), (3, 8, 3, 2), (5, 24, 2, 2), (7, 30, 5, 5)):
        ask(folder, system(n, m, terms), "project", *keep(kept))
    for method in ("dd", "hull", "fm"):
        ask(folder, small, "project", *keep(2), f"--method={method}")

WANTED = {"verdict": {"oracle", "elimination"}, "ends": {"oracle", "oracles", "elimination"},
          "optimum": {"oracle", "elimination"}, "rows": {"ray shooting", "oracle"},
          "rays": {"double description", "hull of the polar"},
          "facets": {"double description", "sparse double description", "section"},
          "projection": {"elimination", "bounded elimination", "recession direction",
                         "double description", "support queries"}}
missing = {(name, task) for task in WANTED for name in WANTED[task]} ^ set(seen)
silent = [what for what, ended in seen.items() if "answered" not in ended]
assert not missing, f"not seen, or not expected: {missing}"
assert not silent, f"never answered: {silent}"
assert set().union(*seen.values()) == ENDS, seen
print("seen:", *(f"{name} ({task})" for name, task in sorted(seen)), sep="\n  ")
