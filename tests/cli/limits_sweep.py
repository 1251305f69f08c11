"""Every command under every limit, as text and as JSON: an answer that is not finished is never
exit 0 or 1, standard error says what was reached, and standard output can be read by the command
that reads such files, or is empty. A run that finishes in spite of its limit gives the whole
answer. Nothing here depends on a clock: whichever end a run comes to, it has to hold.
usage: limits_sweep.py FMB EXAMPLES"""

import collections
import json
import os
import random
import re
import signal
import subprocess
import sys
import tempfile
import threading

import default_signals  # noqa: F401

FMB, EXAMPLES = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
LEAST = 400  # combinations
WORDS = re.compile(r"\((time|bytes|rows|cancelled)\)")

pick = random.Random(3)
faults, ends = [], collections.Counter()


def dense(n, m):
    """Random rows around the origin: no symmetry, and full of vertices."""
    rows = [" + ".join(f"{pick.randint(-9, 9)} x{j}" for j in range(n)) for _ in range(m)]
    return "".join(f"{row} <= {pick.randint(1, 9)}\n" for row in rows).replace("+ -", "- ")


def frames(n):
    def frame():
        return {"type": pick.choice(("cuboid", "simplex")),
                "orig": [pick.randint(-9, 9) for _ in range(3)],
                "comp": [[pick.randint(-9, 9) for _ in range(3)] for _ in range(3)]}
    return "".join(json.dumps({"A": frame(), "B": frame()}) + "\n" for _ in range(n))


def mesh(n):
    points = "".join(" ".join(str(pick.randint(-9, 9)) for _ in range(3)) + "\n"
                     for _ in range(3 * n))
    cells = "".join(f"3 {3 * i} {3 * i + 1} {3 * i + 2}\n" for i in range(n))
    return f"OFF\n{3 * n} {n} 0\n{points}{cells}"


def call(*words, text=None, stop=None):
    """What the command makes of it; stop: a signal, and how long until it is sent."""
    with subprocess.Popen([FMB, *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE) as p:
        timer = threading.Timer(stop[1], p.send_signal, [stop[0]]) if stop else None
        if timer:
            timer.start()
        out, err = p.communicate(text)
        if timer:
            timer.cancel()
            timer.join()
    return p.returncode, out.decode(), err.decode()


# ---- what is asked -----------------------------------------------------------------------------

# The words of a command; limits that it must have; who reads its text, or None.
Case = collections.namedtuple("Case", "words limits reader")
SOLVER = ("seconds", "bytes", "rows")
CONVERT = ("convert", "-", "--to", "smt2")
CASES = {
    "solve": Case(("solve", "d5.fmb", "--method", "fm"), SOLVER, None),
    "check": Case(("check", "d6.fmb", "d6.proof"), (), None),
    "project": Case(("project", "d6.fmb", "--keep", "x0,x1,x2"), SOLVER, CONVERT),
    "bounds": Case(("bounds", "d8.fmb"), SOLVER, None),
    "reduce": Case(("reduce", "d8.fmb"), SOLVER, CONVERT),
    "optimize": Case(("optimize", "d8.fmb", "--max", "x0 + x1"), SOLVER, None),
    "vertices": Case(("vertices", "d6.fmb"), SOLVER, ("hull", "-", "--max-bytes", "1000")),
    "cube": Case(("vertices", "cube.fmb"), SOLVER, ("hull", "-", "--max-bytes", "1000")),
    "hull": Case(("hull", "d6.ext"), SOLVER, CONVERT),
    "union": Case(("hull", "d3.fmb", "e3.fmb"), SOLVER, CONVERT),
    "sum": Case(("sum", "d3.fmb", "e3.fmb"), SOLVER, CONVERT),
    "image": Case(("image", "d6.fmb", "turn.map"), SOLVER, CONVERT),
    "intersect": Case(("intersect", "pairs.jsonl"), ("seconds", "bytes"), None),
    "mesh": Case(("mesh", "mesh.off"), ("seconds", "bytes"), None),
    "convert": Case(("convert", "d8.fmb", "--to", "smt2"), (), CONVERT),
}
LIMITS = {
    "seconds": ("0.0000001", "0.0005", "0.002", "0.005", "0.02", "0.05"),
    "bytes": ("1", "1000", "10000", "30000", "100000", "300000", "1000000"),
    "rows": ("1", "2", "10", "50", "300", "2000"),
    "input": ("1", "60", "300"),
}
SIGNALS = [(number, wait) for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP,
                                         signal.SIGXCPU)
           for wait in (0.003, 0.006, 0.015)]


def write_files(folder):
    files = {"d5.fmb": dense(5, 16), "d8.fmb": dense(8, 30), "d6.fmb": dense(6, 24),
             "d3.fmb": dense(3, 12), "e3.fmb": dense(3, 12), "pairs.jsonl": frames(12),
             "mesh.off": mesh(30), "turn.map": "u = x0 + 2 x1\nv = x1 - x2 + x3\nw = x0 - x3\n",
             "cube.fmb": "".join(f"0 <= x{i} <= 1\n" for i in range(8))}
    for name, text in files.items():
        with open(name, "w") as f:
            f.write(text)
    with open("d6.ext", "w") as f:
        f.write(call("vertices", "d6.fmb")[1])
    call("bounds", "d6.fmb", "--proof", "d6.proof")


def limits_of(case):
    _, text, _ = call(case.words[0], "--help")
    for name, values in LIMITS.items():
        if f"--max-{name}=" in text:
            yield from ((f"--max-{name}", value) for value in values)
        elif name in case.limits:
            faults.append(f"{case.words[0]}: no --max-{name}")


# ---- what comes back ---------------------------------------------------------------------------

def content(out, as_json):
    """The answer without what differs from run to run."""
    if not as_json:
        return sorted(out.splitlines())
    answer = json.loads(out)
    answer.pop("stats", None)
    for key in ("rows", "vertices", "rays"):
        if key in answer:
            answer[key].sort(key=json.dumps)
    return answer


readable = {}


def can_be_read(case, out):
    key = (case.reader, out)
    if key not in readable:
        readable[key] = call(*case.reader, text=out.encode())[0] in (0, 1, 2)
    return readable[key]


def judge(case, words, as_json, whole, reply):
    code, out, err = reply

    def expect(condition, what):
        if not condition:
            faults.append(f"{' '.join(words)}: {what}\n  exit {code}, {out[:200]!r}, {err[:200]!r}")

    ends[code] += 1
    if code in (0, 1):
        expect(code == whole[0], f"the whole answer is exit {whole[0]}")
        if case.words[0] != "solve":  # of many points one
            expect(content(out, as_json) == content(whole[1], as_json), "not the whole answer")
    elif code == 2:
        expect(WORDS.search(err), "standard error does not say why")
        if out and as_json:
            expect(content(out, True), "no JSON")
        elif out and case.reader:
            expect(can_be_read(case, out), "nobody can read this")
    elif code < 0:  # by a signal, which is no answer
        expect("signal" in words, "it died")
    else:
        expect(code == 65 and "--max-input" in words, "a limit is no mistake")
        if case.words[0] == "intersect":  # what was found of the lines before
            expect(json.loads(out) if as_json else "tested" in out, "nobody can read this")
        else:
            expect(out == "", "half an answer")
        expect("limit" in err, "standard error does not say why")


def sweep(case, as_json):
    words = [*case.words, *(["--json"] if as_json else [])]
    whole = call(*words)
    if whole[0] not in (0, 1):
        faults.append(f"{' '.join(words)}: exit {whole[0]}, {whole[2]}")
        return
    for limit in limits_of(case):
        judge(case, [*words, *limit], as_json, whole, call(*words, *limit))
    for number, wait in SIGNALS:
        shown = [*words, "signal", signal.Signals(number).name, str(wait)]
        judge(case, shown, as_json, whole, call(*words, stop=(number, wait)))


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    write_files(folder)
    for case in CASES.values():
        for as_json in (False, True):
            if not as_json or case.words[0] != "convert":
                sweep(case, as_json)
    os.chdir(EXAMPLES)

total = sum(ends.values())
if total < LEAST:
    faults.append(f"only {total} combinations")
for code in (0, 2, 65):
    if ends[code] == 0:
        faults.append(f"no run ended with {code}")
print("\n".join(faults))
print(f"limits: {total} combinations, {len(faults)} faults; exits {dict(sorted(ends.items()))}")
sys.exit(bool(faults))
