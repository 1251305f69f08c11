#!/usr/bin/env python3
"""Cones of entropies projected, and their rows by classes under the published symmetries (the lines
"#>>" of cases/entropy): as many rows as published, and the classes that a few lines of Python find.

Exit: 0, 1 on a difference, 77 if the cases are absent.
"""

import argparse
import fractions
import json
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROWS = {"2x2-fin-08D": 16, "323-1-fin": 16, "3x2-fin-08D": 104, "3s2-fin-09D": 164, "424-1-fin": 35}


def published(path):
    """Names of the kept variables; the symmetries, each a dictionary of letters."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    names = next(line for line in lines if line.startswith("#::")).split()[1:]
    rules = re.findall(r"(\w+)<>(\w+)", next(line for line in lines if line.startswith("#>>")))
    return [n for n in names if n != "_"], [dict(zip(a, b)) for a, b in rules]


def with_names(ine, names, to):
    with open(ine, encoding="utf-8") as file, open(to, "w", encoding="utf-8") as out:
        out.write("".join(f'* x{j} is "{name}"\n' for j, name in enumerate(names, 1)) + file.read())


def echelon(equalities):
    """(place of the leading 1, row), reduced."""
    found = []
    for row in equalities:
        row = reduced(row, found)
        place = next((j for j, a in enumerate(row) if a), None)
        if place is None:
            continue
        row = [a / row[place] for a in row]
        found = [(p, [a - r[place] * b for a, b in zip(r, row)]) for p, r in found]
        found.append((place, row))
    return found


def reduced(row, equalities):
    for place, equality in equalities:
        factor = row[place]
        row = [a - factor * b for a, b in zip(row, equality)]
    return row


def key(row, equalities):
    """The same for rows that say the same beside the equalities."""
    row = reduced(row, equalities)
    size = next((abs(a) for a in row if a), 1)
    return tuple(a / size for a in row)


def classes(names, rules, rows):
    """The sets of rows, numbered from 1, by closing each row's images."""
    letters = lambda name: "".join(sorted(re.sub(r"\W", "", name[1:])))
    place = {letters(name): j for j, name in enumerate(names)}
    images = [[place["".join(sorted(rule.get(c, c) for c in letters(n)))] for n in names] for rule in rules]
    plain = [[fractions.Fraction(a) for a in row["coefficients"]] for row in rows]
    equalities = echelon([a for a, row in zip(plain, rows) if row["relation"] == "="])
    number = {key(a, equalities): i for i, (a, row) in enumerate(zip(plain, rows), 1)
              if row["relation"] != "="}
    found = [{i} for i, row in enumerate(rows, 1) if row["relation"] == "="]
    while number:
        wanted, seen = [next(iter(number))], {}
        while wanted:
            row = wanted.pop()
            if row in seen:
                continue
            seen[row] = number.pop(row)
            for image in images:
                moved = [0] * len(row)
                for j, a in enumerate(row):
                    moved[image[j]] = a
                wanted.append(key(moved, equalities))
        found.append(set(seen.values()))
    return found


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    p.add_argument("--fmb", required=True, help="the program under test")
    p.add_argument("--cases", default=os.path.join(HERE, "../../../../shared/cases"))
    o = p.parse_args()
    folder = os.path.join(o.cases, "entropy")
    if not os.path.isdir(folder):
        print(f"{folder} is absent")
        return 77
    faults = 0
    with tempfile.TemporaryDirectory() as scratch:
        for case, expected in ROWS.items():
            text = os.path.join(folder, case + ".rows.txt")
            names, rules = published(text)
            named = os.path.join(scratch, case + ".ine")
            with_names(os.path.join(folder, case + ".ine"), names, named)
            run = subprocess.run([o.fmb, "project", named, "--json", f"--classes={text}"],
                                 capture_output=True, text=True)
            answer = json.loads(run.stdout) if run.returncode == 0 else {"rows": [], "classes": []}
            told = sorted(sorted(c["rows"]) for c in answer["classes"] if len(c["rows"]) > 0)
            known = sorted(sorted(c) for c in classes(names, rules, answer["rows"]))
            equalities = {i for i, row in enumerate(answer["rows"], 1) if row["relation"] == "="}
            known = [c for c in known if not set(c) <= equalities]
            told = [c for c in told if not set(c) <= equalities]
            good = len(answer["rows"]) == expected and told == known
            print(f"{case}: {len(answer['rows'])} rows, {len(told)} classes", "" if good else f"WRONG {run.stderr}")
            faults += not good
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
