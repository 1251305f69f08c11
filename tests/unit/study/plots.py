"""fmb-qualify plots: figures, table and page of an experiment, and mistakes. The Python in front may lack what draws.
With "every": drawn twice, the same bytes.
usage: plots.py FMB_QUALIFY [every]"""

import csv
import json
import lzma
import os
import pathlib
import re
import subprocess
import sys
import tempfile

qualify, every = sys.argv[1], sys.argv[2:] == ["every"]
PLAN = {"rules": ["none", "kohler", "kohler,box"], "methods": ["fm", "dd"], "families": ["dense", "frames-moving", "schedule"],
        "sizes": [1, 2], "seeds": [1, 2], "passes": 1, "limits": {"rows": 100, "seconds": 20}}
FIGURES = "cactus profile-time profile-rows critical-time critical-rows rounds growth heat".split()
faults = []


def expect(good, what):
    if not good:
        faults.append(what)


def run(*words):
    """With the system's Python where the one in front cannot draw."""
    return subprocess.run([qualify, *map(str, words)], capture_output=True, text=True,
                          env={**os.environ, "PATH": "/usr/bin:" + os.environ["PATH"], "MPLCONFIGDIR": str(home)})


def write(name, lines):
    with open(home / name, "w", encoding="utf-8", newline="") as f:
        writer = csv.DictWriter(f, lines[0])
        writer.writeheader()
        writer.writerows(lines)
    return home / name


def entries(lines):
    """Rules that were counted elsewhere have a place, without a time; counts that are others, and other problems, are refused."""
    counted = [{**line, "rules": "mine", "timed": "no", "plan": "python"} for line in lines if line["rules"] == "kohler"]
    again = [{**line, "timed": "no"} for line in lines if line["rules"] == "none"]
    page = home / "entry.md"
    made = run("leaderboard", home / "runs.csv", write("entry.csv", counted + again), "-o", page)
    rows = dict(re.findall(r"^\| \d+ \| ([\w, ]+) \| \w+ \| (.*) \|$", page.read_text(), re.M)) if made.returncode == 0 else {}
    cells = {name: row.split(" | ") for name, row in rows.items()}
    expect(cells and cells["mine"][:3] == cells["kohler"][:3] and cells["mine"][3] == "–" != cells["kohler"][3], f"entry: {made} {cells}")
    other = next(line for line in again if line["outcome"] == "decided")
    for wrong in ({"made": int(other["made"]) + 1}, {"family": "mine"}, {"max_rows": 5}):
        refused = run("leaderboard", home / "runs.csv", write("wrong.csv", [{**other, **wrong}]), "-o", home / "none.md")
        expect(refused.returncode == 70 and "wrong.csv: none" in refused.stderr and not (home / "none.md").exists(), f"{wrong}: {refused}")


def leaderboard(decided):
    """Of what was found above; then with an answer turned wrong, whose rules are out."""
    page, system = home / "page.md", "vars: x;x <= 1;x >= 2;"
    page.write_text("before\n<!-- begin -->\nold\n<!-- end -->\nbehind\n")
    made = run("leaderboard", home / "runs.csv", "-o", page)
    text = page.read_text()
    expect(made.returncode == 0 and not made.stderr, f"leaderboard: {made}")
    expect(text.startswith("before\n") and text.endswith("behind\n") and "old" not in text, "what stands around the table is lost")
    places = re.findall(r"^\| \d+ \| ([\w, ]+) \| (\w+) \| (\d+) \|", text, re.M)
    expect({name for name, _, _ in places} == {"none", "kohler", "kohler, box"}, f"places: {places}")
    expect(("kohler", "pairs", str(decided)) in places and places[-1][0] == "none", f"places: {places}")
    expect("nan" not in text and "Nobody" in text, "leaderboard: who is out?")
    lines = list(csv.DictReader((home / "runs.csv").open(newline="")))
    entries(lines)
    liar = next(line for line in lines if line["rules"] == "kohler,box")
    liar.update(outcome="wrong", system=system)
    with lzma.open(home / "lies.csv.xz", "wt", newline="") as f:
        writer = csv.DictWriter(f, lines[0])
        writer.writeheader()
        writer.writerows(lines)
    expect(run("leaderboard", home / "lies.csv.xz", "-o", home / "lies.md").returncode == 0, "leaderboard, compressed")
    text = (home / "lies.md").read_text()
    expect("kohler, box" not in text and "**kohler,box, pairs**: 1 wrong" in text and system.replace(";", "\n") in text,
           "a wrong answer does not disqualify")


with tempfile.TemporaryDirectory() as name:
    home = pathlib.Path(name)
    (home / "plan.json").write_text(json.dumps(PLAN))
    expect(run("run", home / "plan.json", "-o", home / "runs.csv").returncode == 0, "run")
    drawn = run("plots", home / "runs.csv", "-o", home / "figures")
    if "figures need" in drawn.stderr:
        print("matplotlib, numpy or scipy is missing")
        sys.exit(77)
    expect(drawn.returncode == 0 and not drawn.stderr, f"plots: {drawn}")
    for figure in FIGURES:
        for ending in ("svg", "pdf"):
            path = home / "figures" / f"{figure}.{ending}"
            expect(path.exists() and path.stat().st_size > 2000, f"{path.name} is missing, or empty")
    page = (home / "figures" / "report.html").read_text()
    expect(re.findall(r'src="([\w-]+)\.svg"', page) and "nan" not in page, "report.html")
    with open(home / "runs.csv", encoding="utf-8", newline="") as f:
        decided = sum(line["rules"] == "kohler" and line["outcome"] == "decided" for line in csv.DictReader(f))
    expect(f"kohler & {decided} &" in (home / "figures" / "table.tex").read_text(), "table.tex counts otherwise")
    if every:
        run("plots", home / "runs.csv", "-o", home / "again")
        for figure in FIGURES:
            one, two = ((home / folder / f"{figure}.svg").read_bytes() for folder in ("figures", "again"))
            expect(one == two, f"{figure}: other bytes from the same CSV")
    expect(run("plots", home / "missing.csv").returncode == 66, "no CSV")
    leaderboard(decided)
print("\n".join(faults) or "plots: no faults")
sys.exit(bool(faults))
