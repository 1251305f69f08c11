#!/usr/bin/env python3
"""Every file of the collected cases through the fmb command, against the recorded answers.

Each file has --seconds [s] for all that is asked of it together: its questions (verdict, box,
reduce, project, optimum, in this order) run one after another, each with --max-seconds set to what the
earlier ones left over; a question that finds nothing left is undecided. Checking the proofs is not
part of the limit; its time stands in a column of its own. A query that runs more than --grace [s]
beyond its limit is killed and counts as crashed. A file is decided when all its questions are
answered. Exit: 0, 1 if anything is wrong or crashed, 77 if the cases are absent.
"""

import argparse
import concurrent.futures
import json
import os
import sys
import tempfile
import time

import families
from ask import Fmb
from questions import ANSWERED, CRASHED, UNDECIDED, WRONG, Ask

HERE = os.path.dirname(os.path.abspath(__file__))
SKIP = 77
GROUPS = {name: [getattr(families, name)] for name in families.FAMILIES}
GROUPS["smt"].append(families.smt_other)
TITLES = {"smt_other": "smt (not pure)"}


def options():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    p.add_argument("--fmb", required=True, help="the program under test")
    p.add_argument("--cases", default=os.path.join(HERE, "../../../shared/cases"))
    p.add_argument("--family", action="append", choices=families.FAMILIES, help="may be repeated")
    p.add_argument("--only", metavar="PATTERN", help="files whose name contains it")
    p.add_argument("--kind", help="only questions of this kind: verdict, box, reduce, project, optimum")
    p.add_argument("--seconds", type=float, default=10.0, help="limit per file")
    p.add_argument("--grace", type=float, default=5.0, help="beyond a limit: a crash")
    p.add_argument("--max-bytes", type=int, default=2 << 30)
    p.add_argument("-j", type=int, default=2, help="files at once")
    p.add_argument("--json", metavar="FILE", help="all details")
    return p.parse_args()


def run_case(fmb, case, folder, opts):
    name, path, asked = case
    ask = Ask(fmb, path, name, folder, opts.seconds)
    results = []
    for kind, question in asked:
        if opts.kind and kind != opts.kind:
            continue
        before, begin = ask.check_seconds, time.monotonic()
        try:
            outcome, note = question(ask)
        except (KeyError, TypeError, ValueError, AttributeError) as e:
            outcome, note = WRONG, f"reply not understood: {type(e).__name__}: {e}"
        check = ask.check_seconds - before
        results.append({"kind": kind, "outcome": outcome, "note": note, "check_seconds": check,
                        "seconds": time.monotonic() - begin - check})
    return {"name": name, "questions": results, "seconds": ask.query_seconds,
            "check_seconds": ask.check_seconds}


def outcome_of(case):
    """The worst thing that happened to a file."""
    seen = {r["outcome"] for r in case["questions"]}
    return next(o for o in (CRASHED, WRONG, UNDECIDED, ANSWERED) if o in seen)


def run_all(fmb, groups, folder, opts):
    """{title: list of finished cases}"""
    done = {}
    with concurrent.futures.ThreadPoolExecutor(opts.j) as pool:
        waiting = {}
        for reader in groups:
            title = TITLES.get(reader.__name__, reader.__name__)
            done[title] = []
            for case in reader(opts.cases, folder):
                if opts.only is None or opts.only in case[0]:
                    waiting[pool.submit(run_case, fmb, case, folder, opts)] = title
        total = len(waiting)
        for n, future in enumerate(concurrent.futures.as_completed(waiting), 1):
            case = future.result()
            if case["questions"]:
                done[waiting[future]].append(case)
            if sys.stderr.isatty():
                print(f"\r{n}/{total} {case['name'][:60]:60}", end="", file=sys.stderr)
    if sys.stderr.isatty():
        print("\r" + " " * 75, end="\r", file=sys.stderr)
    return {title: sorted(cases, key=lambda c: c["name"]) for title, cases in done.items() if cases}


def print_table(done):
    head = ("family", "files", "decided", "%", "undecided", "wrong", "crashed", "seconds",
            "slowest", "checking")
    print("{:15}{:>7}{:>9}{:>7}{:>11}{:>7}{:>9}{:>10}{:>9}{:>10}".format(*head))
    for title, cases in done.items():
        count = {o: sum(outcome_of(c) == o for c in cases)
                 for o in (ANSWERED, UNDECIDED, WRONG, CRASHED)}
        print("{:15}{:7}{:9}{:7.1f}{:11}{:7}{:9}{:10.1f}{:9.1f}{:10.1f}".format(
            title, len(cases), count[ANSWERED], 100 * count[ANSWERED] / len(cases),
            count[UNDECIDED], count[WRONG], count[CRASHED], sum(c["seconds"] for c in cases),
            max(c["seconds"] for c in cases), sum(c["check_seconds"] for c in cases)))


def print_kinds(done):
    print("\n{:15}{:10}{:>7}{:>10}{:>11}{:>7}{:>9}{:>10}".format(
        "family", "question", "asked", "answered", "undecided", "wrong", "crashed", "seconds"))
    for title, cases in done.items():
        asked = [r for c in cases for r in c["questions"]]
        for kind in dict.fromkeys(r["kind"] for r in asked):
            mine = [r for r in asked if r["kind"] == kind]
            count = {o: sum(r["outcome"] == o for r in mine)
                     for o in (ANSWERED, UNDECIDED, WRONG, CRASHED)}
            print("{:15}{:10}{:7}{:10}{:11}{:7}{:9}{:10.1f}".format(
                title, kind, len(mine), count[ANSWERED], count[UNDECIDED], count[WRONG],
                count[CRASHED], sum(r["seconds"] for r in mine)))


def print_details(done):
    """Everything that is not answered, worst first; then whose irredundant sizes are ours."""
    tools = {}
    for outcome in (CRASHED, WRONG, UNDECIDED):
        listed = [(c["name"], r) for cases in done.values() for c in cases
                  for r in c["questions"] if r["outcome"] == outcome]
        if listed:
            print(f"\n{outcome}:")
        for name, r in listed:
            print(f"  {name}  {r['kind']}: {r['note']} ({r['seconds']:.1f} s)")
    for r in (r for cases in done.values() for c in cases for r in c["questions"]):
        if r["outcome"] == ANSWERED and r["note"].startswith("as "):
            tools[r["note"]] = tools.get(r["note"], 0) + 1
    if tools:
        print("\nirredundant sizes: " + ", ".join(f"{n} {t}" for t, n in sorted(tools.items())))


def main():
    opts = options()
    if not os.path.isdir(opts.cases):
        print(f"skipped: no cases at {opts.cases}")
        return SKIP
    groups = [r for name in opts.family or families.FAMILIES for r in GROUPS[name]]
    with tempfile.TemporaryDirectory(prefix="fmb-cases-") as folder:
        done = run_all(Fmb(opts.fmb, opts.grace, opts.max_bytes), groups, folder, opts)
    print_table(done)
    print_kinds(done)
    print_details(done)
    if opts.json:
        with open(opts.json, "w", encoding="utf-8") as f:
            json.dump({"seconds": opts.seconds, "families": done}, f, indent=1)
    bad = any(outcome_of(c) in (WRONG, CRASHED) for cases in done.values() for c in cases)
    return 1 if bad or not done else 0


if __name__ == "__main__":
    sys.exit(main())
