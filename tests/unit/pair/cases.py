#!/usr/bin/env python3
"""All recorded pairs of frames through `fmb intersect`: verdicts, open and closed, in both orders,
with every kind of boxes; boxes as recorded, in rationals, and doubles that contain them.

usage: cases.py FMB CASES. Exit: 0, 1 if anything is wrong, 77 if the cases are absent.
"""

import json
import os
import subprocess
import sys
from fractions import Fraction

SKIP = 77
VERDICT = {"sat": "feasible", "unsat": "infeasible"}
faults = []


def fault(where, text):
    faults.append(f"{where}: {text}")


def ask(fmb, lines, *options):
    text = "".join(json.dumps(line) + "\n" for line in lines)
    run = subprocess.run([fmb, "intersect", "-", "--json", *options], input=text,
                         capture_output=True, text=True, timeout=300)
    reply = json.loads(run.stdout)
    meeting = sum(p["verdict"] == "feasible" for p in reply["pairs"])
    counts = (reply["tested"], reply["meeting"], reply["undecided"])
    if counts != (len(lines), meeting, 0) or run.returncode != (0 if meeting else 1):
        fault(options, f"counts {counts}, exit code {run.returncode}")
    return reply["pairs"]


def number(text):
    """A rational in a string, or the exact value of a double."""
    return Fraction(text)


def box_of(pair):
    """World, then time."""
    ends = pair["world"] + ([pair["time"]] if "time" in pair else [])
    return [[number(lower), number(upper)] for lower, upper in ends]


def is_witness(line, pair):
    """Is the witness where A and B say, at its time? By its coordinates in the frames, where they
    have all axes and are not flat; those of B lie in `inside`."""
    point = [number(x) for x in pair["witness"]]
    time = number(pair.get("witness_time", "0"))
    return 0 <= time <= 1 and all(holds(line[k], point, time) for k in "AB")


def holds(frame, point, time):
    speed = frame.get("vel") or [0] * len(point)
    right = [x - number(o) - time * number(v) for x, o, v in zip(point, frame["orig"], speed)]
    rows = [[number(axis[j]) for axis in frame["comp"]] + [right[j]] for j in range(len(point))]
    inside = solve(rows)
    low = all(c >= 0 for c in inside)
    return low and (sum(inside) <= 1 if frame["type"] != "cuboid" else max(inside) <= 1)


def solve(rows):
    """Gauss and Jordan, in rationals; the matrix is regular."""
    n = len(rows)
    for c in range(n):
        p = next(i for i in range(c, n) if rows[i][c] != 0)
        rows[c], rows[p] = rows[p], rows[c]
        rows[c] = [x / rows[c][c] for x in rows[c]]
        for i in range(n):
            if i != c:
                rows[i] = [x - rows[i][c] * y for x, y in zip(rows[i], rows[c])]
    return [row[n] for row in rows]


def judge_exact(line, pair, truth):
    if pair["verdict"] != "feasible":
        return
    if "bbox" in truth and box_of(pair) != [[number(e) for e in ends] for ends in truth["bbox"]]:
        fault(line["id"], f"box {pair['world']}, recorded {truth['bbox']}")
    if not is_witness(line, pair):
        fault(line["id"], f"{pair['witness']} is no common point")


def judge_outward(line, pair, truth):
    """Contains the recorded box, and is larger by 1e-12 of the largest number at most."""
    if pair["verdict"] != "feasible" or "bbox" not in truth:
        return
    largest = max(sum(abs(number(x)) for x in column) for f in (line["A"], line["B"])
                  for column in zip(f["orig"], *f["comp"], f.get("vel") or f["orig"]))
    for (lower, upper), recorded in zip(box_of(pair), truth["bbox"]):
        inner = [number(e) for e in recorded]
        slack = max(largest, 1) * Fraction(1, 10**12)
        if not (inner[0] - slack <= lower <= inner[0] and inner[1] <= upper <= inner[1] + slack):
            fault(line["id"], f"outward {float(lower)}, {float(upper)}, recorded {recorded}")


JUDGES = {"exact": judge_exact, "outward": judge_outward, "none": lambda *_: None}


def swapped(line):
    return {**line, "A": line["B"], "B": line["A"]}


def play(fmb, lines, truths):
    for contact in ("closed", "open"):
        for boxes, judge in JUDGES.items():
            for order in (lambda line: line, swapped):
                asked = [order(line) for line in lines]
                pairs = ask(fmb, asked, "--contact", contact, "--boxes", boxes)
                for line, pair, truth in zip(asked, pairs, truths):
                    if pair["id"] != line["id"] or pair["verdict"] != VERDICT[truth[contact]]:
                        fault(line["id"], f"{contact}, {boxes}: {pair['verdict']}")
                    if contact == "closed":
                        judge(line, pair, truth)


def main():
    fmb, cases = sys.argv[1:]
    folder = os.path.join(cases, "geom")
    if not os.path.isdir(folder):
        print(f"skipped: no cases at {folder}")
        return SKIP
    with open(os.path.join(folder, "answers.json"), encoding="utf-8") as f:
        answers = json.load(f)
    tested = 0
    for name in sorted(os.listdir(folder)):
        if name.startswith("frames_") and name.endswith(".jsonl"):
            with open(os.path.join(folder, name), encoding="utf-8") as f:
                lines = [json.loads(line) for line in f]
            play(fmb, lines, [answers[f"geom/{name}#{line['id']}"] for line in lines])
            tested += len(lines)
    print("\n".join(faults) or f"{tested} pairs: as recorded")
    return 1 if faults or tested == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
