#!/usr/bin/env python3
"""Projections of the collected elimination problems (fm, proj2), each proved whole, as one table.

Each is projected with and without its proof, both within --seconds [s]; the proof must be accepted for
the projection that came without it. CPU times are those of whole processes [ms].

The bar: no proof is rejected, and every bounded projection of at most --rows rows is certified whole.
Exit: 0, 1 if the bar is broken, 77 if the cases are absent.
"""

import argparse
import os
import re
import resource
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
SKIP = 77


def options():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    p.add_argument("--fmb", required=True, help="the program under test")
    p.add_argument("--cases", default=os.path.join(HERE, "../../../../shared/cases"))
    p.add_argument("--only", metavar="PATTERN", default="", help="problems whose name contains it")
    p.add_argument("--seconds", type=float, default=20.0, help="limit of one question")
    p.add_argument("--rows", type=int, default=200, help="rows of a projection that the bar is about")
    p.add_argument("--all", action="store_true", help="a line for each problem, not only for odd ones")
    return p.parse_args()


def problems(cases):
    """(name, file, variables kept)"""
    for folder in "fm", "proj2":
        with open(os.path.join(cases, folder, "manifest.txt"), encoding="utf-8") as manifest:
            for words in map(str.split, manifest):
                if len(words) >= 6:
                    yield words[0], os.path.join(cases, folder, words[0] + ".ine"), int(words[5])


def run(*args):
    """What it printed, its exit code, its CPU time [ms]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    p = subprocess.run(args, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return p.stdout, p.returncode, 1e3 * (after.ru_utime - before.ru_utime)


def is_bounded(fmb, image):
    return "inf" not in run(fmb, "bounds", image)[0]


def examine(o, folder, name, file, kept):
    """True unless the problem breaks the bar; and whether it is whole."""
    image, proof = os.path.join(folder, "image.ine"), os.path.join(folder, "proof")
    question = [o.fmb, "project", file, "--keep", ",".join(f"x{j + 1}" for j in range(kept)),
                "--to", "ine", "--max-seconds", str(o.seconds)]
    text, plain_code, plain = run(*question)
    with open(image, "w", encoding="utf-8") as out:
        out.write(text)
    code, proved = run(*question, "--proof", proof)[1:]
    said, judged, checked = run(o.fmb, "check", file, proof, "--expect", "whole=" + image)
    rows = int((re.search(r"begin\s+(\d+)", text) or [0, 0])[1])
    whole, accepted = judged == 0, said.startswith("accepted")
    due = code != 2 and rows <= o.rows and (whole or is_bounded(o.fmb, image))
    good = code == plain_code and accepted and (whole or not due)
    if o.all or not good or not whole:
        print(f"{name:22} {rows:5} rows {plain:7.0f} {proved:7.0f} {checked:7.0f} ms  "
              f"{'whole' if whole else 'outward only' if accepted else 'rejected'}"
              f"{'' if good else '  BAR BROKEN'}", flush=True)
    return good, whole


def main():
    o = options()
    if not os.path.isdir(os.path.join(o.cases, "proj2")):
        print(f"{o.cases}: no cases")
        return SKIP
    with tempfile.TemporaryDirectory() as folder:
        found = [examine(o, folder, *p) for p in problems(o.cases) if o.only in p[0]]
    broken = sum(not good for good, _ in found)
    print(f"{len(found)} projections, {sum(whole for _, whole in found)} proved whole, "
          f"{broken} break the bar")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
