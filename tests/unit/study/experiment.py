"""fmb-qualify run and merge: the same counts after a kill, from two shards and once more; wrong answers and mistakes.
What proofs cost, and rules
against themselves. usage: experiment.py FMB_QUALIFY LIAR"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile
import time

qualify, liar = sys.argv[1:]
PLAN = {"rules": ["none", "kohler", "kohler,box"], "orders": ["pairs", "given"], "methods": ["fm", "dd"],
        "families": ["dense", "frames-moving", "conflict"], "sizes": [1, 2], "seeds": [1, 4],
        "digits": [0, 3], "density": [100, 60], "passes": 1, "limits": {"rows": 500, "seconds": 20}}
WAYS = 2 * 3 + 1
faults = []


def expect(good, what):
    if not good:
        faults.append(what)


def run(*words):
    return subprocess.run([qualify, *map(str, words)], capture_output=True, text=True)


def write(folder, **changes):
    path = folder / "plan.json"
    path.write_text(json.dumps({**PLAN, **changes}))
    return path


def counts(text):
    """All but the time."""
    return [{k: v for k, v in line.items() if k != "seconds"} for line in csv.DictReader(text.splitlines())]


def whole(folder):
    plan = write(folder)
    expect(run("run", plan).returncode == 0, "run")
    text = (folder / "plan.csv").read_text()
    lines = counts(text)
    expect(len(lines) == 3 * 2 * 2 * 2 * 2 * WAYS, f"{len(lines)} lines")
    expect({line["outcome"] for line in lines} == {"decided", "stopped"}, "outcomes")
    expect(all(float(line["seconds"]) > 0 for line in csv.DictReader(text.splitlines())), "seconds")
    expect({line["method"] for line in lines if not line["rules"]} == {"dd"}, "dd has no rules")
    expect(any(line["rounds"].count(" ") > 1 for line in lines), "rounds")
    return plan, lines


def again(folder, plan, lines):
    text = (folder / "plan.csv").read_text()
    for size in (0, 10, len(text) // 3, len(text) - 5):  # what a kill leaves
        (folder / "torn.csv").write_text(text[:size])
        expect(run("run", plan, "-o", folder / "torn.csv").returncode == 0, f"torn at {size}")
        expect(counts((folder / "torn.csv").read_text()) == lines, f"torn at {size}: other lines")
    for k in (1, 2):
        expect(run("run", plan, "--shard", f"{k}/2", "-o", folder / f"{k}.csv").returncode == 0, f"shard {k}")
    merged = run("merge", folder / "2.csv", folder / "1.csv")
    expect(counts(merged.stdout) == lines, "shards: other lines")
    expect(run("merge", folder / "1.csv", folder / "plan.csv").returncode == 65, "a block twice")


def killed(folder, lines):
    out = folder / "killed.csv"
    with subprocess.Popen([qualify, "run", folder / "plan.json", "-o", out]) as process:
        while process.poll() is None and (not out.exists() or out.stat().st_size < 3000):
            time.sleep(0.001)
        process.kill()
    expect(run("run", folder / "plan.json", "-o", out).returncode == 0, "after a kill")
    expect(counts(out.read_text()) == lines, "after a kill: other lines")


def mistakes(folder):
    for change in ({"rules": "none"}, {"sizes": [6]}, {"families": ["nothing"]}, {"colour": 1}, {"methods": ["guess"]},
                   {"evidence": ["some"]}, {"limits": {"rows": "many"}}, {"question": "why"}, {"seeds": []}):
        expect(run("run", write(folder, **change)).returncode == 65, f"{change} is taken")
    expect(run("run", folder / "missing.json").returncode == 66, "no plan")
    expect(run("run", write(folder, orders=["mine"])).returncode == 64, "no such order")
    expect(run("run", write(folder, seeds=[1]), "-o", folder / "1.csv").returncode == 65, "results of another plan")


def wrong(folder):
    system = folder / "empty.fmb"
    system.write_text("vars: x y z\nx + y <= 1\nx - y <= 0\ny - x <= 0\nx >= 1\nz <= 5\n-z <= x\n")
    plan = write(folder, **{"rule-library": liar, "rules": ["liar"], "families": [], "files": [str(system)],
                            "presolve": "none", "methods": ["fm"], "digits": [0], "density": [100]})
    found = run("run", plan, "-o", folder / "wrong.csv")
    expect(found.returncode == 1 and "wrong answers" in found.stderr, f"a liar: {found}")
    lines = counts((folder / "wrong.csv").read_text())
    shown = {line["outcome"]: line["system"] for line in lines}
    expect("wrong" in shown, "a liar: no line")
    expect("<= " in shown.get("wrong", "") and shown["wrong"].count(";") < system.read_text().count("\n") + 2, f"a liar: {shown}")
    plan = write(folder, **{"rule-library": liar, "rules": ["kohler"], "orders": ["lost"], "methods": ["fm"],
                            "families": ["dense"], "sizes": [1]})
    found = run("run", plan, "-o", folder / "lost.csv")
    expect(found.returncode == 64 and "not on offer" in found.stderr, f"a lost order: {found}")


def evidence(folder):
    plan = write(folder, evidence=["all", "none"], families=["dense"], methods=["fm"], passes=0)
    expect(run("run", plan, "-o", folder / "evidence.csv").returncode == 0, "evidence")
    lines = counts((folder / "evidence.csv").read_text())
    kinds = [[{k: v for k, v in line.items() if k != "evidence"} for line in lines if line["evidence"] == kind]
             for kind in ("all", "none")]
    expect(kinds[0] and [line["made"] for line in kinds[0]] == [line["made"] for line in kinds[1]], "evidence changes counts")


def bias():
    found = run("bias", "--repetitions", "2", "--passes", "1")
    lines = list(csv.DictReader(found.stdout.splitlines()))
    expect(found.returncode == 0 and len(lines) == 2 and "of 2 intervals" in found.stderr, f"bias: {found}")
    for line in lines:
        expect(int(line["systems"]) > 40, f"bias: {line}")
        for of in ("total", "median"):
            expect(0 < float(line[of + "_low"]) <= float(line[of]) <= float(line[of + "_high"]), f"bias: {line}")


with tempfile.TemporaryDirectory() as name:
    home = pathlib.Path(name)
    plan_of_all, lines_of_all = whole(home)
    again(home, plan_of_all, lines_of_all)
    killed(home, lines_of_all)
    mistakes(home)
    wrong(home)
    evidence(home)
    bias()
print("\n".join(faults) or "experiment: no faults")
sys.exit(bool(faults))
