"""Rules of others, judged: numbers to check; the sound ones are right on random systems, alone and with others; and
each that is not sound goes wrong on its system in rival_rules/. docs/rivals.md has the table.
usage: rival_rules.py FMB_QUALIFY RIVALS [SYSTEMS [SEED]]"""

import csv
import json
import pathlib
import random
import subprocess
import sys
import tempfile

qualify, library = sys.argv[1:3]
systems = int(sys.argv[3]) if len(sys.argv) > 3 else 60
seed = int(sys.argv[4]) if len(sys.argv) > 4 else 1
# Not sound ones are counted on random systems, too.
SOUND = ["bastrakov-zolotykh", "chernikov-sets", "imbert-first", "quasi-syntactic", "raytracing", "test-cone"]
UNSOUND = ["imbert-printed", "linarith", "simon-king"]
MIXED = ["test-cone,kohler", "raytracing,chernikov", "quasi-syntactic,imbert-first", "bastrakov-zolotykh,box"]
# Numbers to check, from the heads of the files: rows after each round of |x1| + ... + |x4| <= 1.
DIAMOND = {"none": [56, 244, 5870], "kohler": [56, 24, 48], "imbert": [56, 24, 28], "imbert-first": [56, 24, 48],
           "chernikov-sets": [56, 24, 28], "bastrakov-zolotykh": [56, 24, 28], "quasi-syntactic": [26, 16, 2],
           "raytracing": [8, 4, 2], "test-cone": [8, 4, 2], "simon-king": [16, 11, 5]}
MOST_FILES = 1000 # fmb-qualify rules takes so many at once
faults = []


def expect(good, what):
    if not good:
        faults.append(what)


def study(files, sets, *words):
    """The report of all sets of rules on these files."""
    rules = [word for s in sets for word in ("--rules", s)]
    got = subprocess.run([qualify, "rules", *map(str, files), "--rule-library", library, *rules, "--passes", "0", "--json",
                          "--presolve", "none", "--max-rows", "3000", *words], capture_output=True, text=True)
    if got.returncode not in (0, 1):
        sys.exit(got.stderr)
    return json.loads(got.stdout)


def add_counts(found, report):
    """By set of rules: answers, those stopped, wrong ones."""
    for line in (c for key, lines in report.items() if key.startswith("order-") for c in lines):
        n, stopped, wrong = found.get(line["rules"], (0, 0, 0))
        found[line["rules"]] = (n + line["n"], stopped + line["stopped"], wrong + line["wrong"])


def draw(chance, folder, i):
    """A small system with many ties, some strict rows and equations."""
    dim, largest = chance.randint(2, 5), chance.choice((1, 1, 2, 3))
    relations = chance.choice((["<="], ["<="], 6 * ["<="] + ["<", "="]))
    lines = ["vars: " + " ".join(f"x{j}" for j in range(dim))]
    for _ in range(chance.randint(dim + 1, 10)):
        row = " + ".join(f"{chance.randint(-largest, largest)} x{j}" for j in range(dim))
        lines.append(f"{row} {chance.choice(relations)} {chance.randint(-1, largest)}")
    path = folder / f"{i}.fmb"
    path.write_text("\n".join(lines) + "\n")
    return path


def judge_random(folder):
    chance, found = random.Random(seed), {}
    for first in range(0, systems, MOST_FILES):
        files = [draw(chance, folder, i) for i in range(min(MOST_FILES, systems - first))]
        add_counts(found, study(files, SOUND + MIXED + UNSOUND, "--orders", "given,min"))
    for name, (n, stopped, wrong) in sorted(found.items()):
        print(f"{name}: {n} answers, {stopped} stopped, {wrong} wrong")
        expect(name in UNSOUND or (n == 2 * systems and wrong == 0), f"{name}: {wrong} of {n} are wrong")


def judge_unsound():
    """Each goes wrong on its system, where a right one does not."""
    for name in UNSOUND:
        system = pathlib.Path(__file__).parent / "rival_rules" / f"{name}.fmb"
        report = study([system], [name, "kohler"], "--orders", "given")
        found = {}
        add_counts(found, report)
        expect(found[name][2] == 1 and found["kohler"][2] == 0, f"{name} is right on {system.name}: {found}")


def count_diamond(folder):
    """Rows after each round of |x1| + ... + |x4| <= 1, as written in 16 rows."""
    signs = [[1 - 2 * (i >> j & 1) for j in range(4)] for i in range(16)]
    system, plan, lines = folder / "diamond.fmb", folder / "plan.json", folder / "runs.csv"
    system.write_text("vars: a b c d\nproject: d\n" +
                      "".join(" + ".join(f"{s} {v}" for s, v in zip(row, "abcd")) + " <= 1\n" for row in signs))
    plan.write_text(json.dumps({"rules": list(DIAMOND), "orders": ["given"], "families": [], "files": [str(system)],
                                "presolve": "none", "passes": 0, "rule-library": library}))
    subprocess.run([qualify, "run", plan, "--out", lines], check=True, capture_output=True)
    for line in csv.DictReader(lines.read_text().splitlines()):
        found = [int(n) for n in line["rounds"].split()]
        expect(found == DIAMOND[line["rules"]], f"{line['rules']} leaves {found} rows")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as name:
        count_diamond(pathlib.Path(name))
        judge_unsound()
        judge_random(pathlib.Path(name))
    print("\n".join(faults) or "rules of others: no faults")
    sys.exit(bool(faults))
