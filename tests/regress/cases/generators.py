#!/usr/bin/env python3
"""`fmb vertices`, then `fmb hull`, over the collected H-representations: the same set must come back
as `fmb reduce` leaves, row by row, and every generator satisfies the rows of the file.

A file that takes any of the three more than --seconds is counted as undecided. Exit: 0, 1 if
anything is wrong or crashed, 77 if the cases are absent.
"""

import argparse
import os
import subprocess
import sys
import tempfile

import rows as exact

HERE = os.path.dirname(os.path.abspath(__file__))
SKIP, UNDECIDED, GENERATORS_LOOKED_AT = 77, 2, 300


def options():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    p.add_argument("--fmb", required=True, help="the program under test")
    p.add_argument("--cases", default=os.path.join(HERE, "../../../../shared/cases"))
    p.add_argument("--only", metavar="PATTERN", help="files whose name contains it")
    p.add_argument("--seconds", type=float, default=10.0, help="limit of one command")
    return p.parse_args()


def run(fmb, args, seconds):
    """(exit code, output); code None: too long."""
    try:
        done = subprocess.run([fmb, *args], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                              timeout=seconds)
    except subprocess.TimeoutExpired:
        return None, ""
    return done.returncode, done.stdout


def closed(rows):
    return [(a, "<=" if rel == "<" else rel, b) for a, rel, b in rows]


def read_generators(text):
    """(kind, numbers) of a V-representation: 1 a vertex, 0 a ray, "line"."""
    lines = [line.split() for line in text.splitlines()]
    begin = next(i for i, words in enumerate(lines) if words and words[0] == "begin")
    straight = next((words[2:] for words in lines if words and words[0] == "linearity"), [])
    table = [[exact.Fraction(w) for w in words] for words in lines[begin + 2 : -1]]
    return [("line" if str(i) in straight else int(g[0]), g[1:]) for i, g in enumerate(table, 1)]


def broken_by(generator, rows):
    kind, x = generator
    for a, rel, b in rows:
        value = sum(c * v for c, v in zip(a, x) if c) - (b if kind == 1 else 0)
        if value > 0 or (value != 0 and (rel == "=" or kind == "line")):
            return True
    return False


def judge(opts, path, folder):
    """None, "undecided", or what is wrong."""
    code, ext = run(opts.fmb, ["vertices", path], opts.seconds)
    if code in (None, UNDECIDED):
        return "undecided"
    least, reduced = run(opts.fmb, ["reduce", path, "--to", "ine"], opts.seconds)
    if least in (None, UNDECIDED):
        return "undecided"
    if code != 0 or least != 0:
        return None if code == least == 1 else f"exit {code}, reduce {least}"
    given = os.path.join(folder, "generators.ext")
    with open(given, "w", encoding="utf-8") as f:
        f.write(ext)
    code, hull = run(opts.fmb, ["hull", given, "--to", "ine"], opts.seconds)
    if code is None:
        return "undecided"
    if code != 0:
        return f"hull: exit {code}"
    truth = closed(exact.read_ine(reduced))
    if any(broken_by(g, truth) for g in read_generators(ext)[:GENERATORS_LOOKED_AT]):
        return "a generator breaks a row"
    return None if exact.canonical(truth) == exact.canonical(exact.read_ine(hull)) else "other rows"


def main():
    opts = options()
    folder = os.path.join(opts.cases, "cdd")
    if not os.path.isdir(folder):
        print("the collected cases are absent:", folder)
        return SKIP
    names = [n for n in sorted(os.listdir(folder)) if n.endswith(".ine") and (opts.only or "") in n]
    count = {"same": 0, "undecided": 0, "wrong": 0}
    with tempfile.TemporaryDirectory() as scratch:
        for name in names:
            why = judge(opts, os.path.join(folder, name), scratch)
            kind = "same" if why is None else why if why == "undecided" else "wrong"
            count[kind] += 1
            if why:
                print(f"{name}: {why}", flush=True)
    print(f"{len(names)} files: " + ", ".join(f"{n} {kind}" for kind, n in count.items()))
    return 1 if count["wrong"] or count["same"] == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
