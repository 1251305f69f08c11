"""Measure libfmb beside other tools, into the CSV files of a folder: measure.py BUILD OUT [NAME...]

Each name (projections, verdicts, vertices, hulls, pairs, shapes, faults, programs, symbols) is a file NAME.csv; without names,
all are made. BUILD is a release build with the benchmarks and the Python package (bench/README.md). Libraries that are not there
are left out. machine.csv says where it was."""

import csv
import datetime
import json
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]
# Families and sizes of bench-peers, of which each is a matter of milliseconds for somebody.
POLYTOPES = ("cube:8 cross:6 cyclic:4:12 cyclic:6:16 permutahedron:5 metric:5 cut:5 assignment:4 sphere:3:100 sphere:4:60 "
             "sphere:6:40 small:6:25 blocking:6:20 slice:8 lattice:4:60 zonotope:4:8 product:6:24").split()


def write(out, name, head, rows):
    """A CSV file; machine.csv gets the records of the programs that told of the machine."""
    with open(out / f"{name}.csv", "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerows([head, *rows])


def told(*command):
    """What a program prints as JSON."""
    return json.loads(subprocess.run(list(map(str, command)), capture_output=True, text=True, check=True).stdout)


def peers(build, *options):
    """A row for each problem of bench-peers, with the time of each driver in microseconds, if it ended."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "peers.json")
        subprocess.run([build / "bench/peers/bench-peers", "--quick", "--seconds", "1", "--seed", "2026", "--json", file,
                        *options], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
        lines = json.loads(file.read_text())["lines"]
    drivers = sorted({driver for line in lines for driver in line["drivers"]} - {"fmb"})
    times = lambda line, driver: (lambda o: f"{o['us']:.3f}" if o and o["end"] == "done" else "")(
        line["drivers"].get(driver))
    return (["problem", "variables", "rows", "kept", "fmb", *drivers],
            [[line["problem"], line["n"], line["m"], line["keep"], times(line, "fmb"),
              *(times(line, driver) for driver in drivers)] for line in lines])


def pairs(build):
    """Pairs of frames: elimination beside separating axes, in nanoseconds."""
    study = told(build / "apps/fmb-qualify/fmb-qualify", "table1", "--json", "--pairs", "8192")
    return (["case", "pair", "meeting", "fmb_ns", "sat_ns"],
            [[cell["case"], cell["pair"], "yes" if cell["meeting"] else "no",
              f"{cell['fmb_ns']:.2f}", f"{cell['sat_ns']:.2f}"] for cell in study["cells"]])


def shapes(build):
    """The same pairs asked other libraries, in nanoseconds, and how many of their answers were wrong."""
    study = told(build / "apps/fmb-qualify/fmb-qualify", "peers", "--json", "--pairs", "1024")
    return (["cell", "peer", "ns", "wrong"],
            [[line["cell"], line["peer"], f"{line['ns']:.1f}", line.get("wrong", "")] for line in study["times"]])


def faults(build):
    """Wrong answers by families of pairs, most of which are hard: nearly touching, flat, far away, of many sizes."""
    study = told(build / "apps/fmb-qualify/fmb-qualify", "peers", "--json", "--pairs", "1024")
    names = ["family", "peer", "queries", "false_meet", "false_apart", "unknown"]
    return names, [[line[name] for name in names] for line in study["faults"]]


def least(ask, turns):
    """The least processor time of some turns, in milliseconds, and the last answer."""
    best = float("inf")
    for _ in range(turns):
        begun = time.process_time()
        answer = ask()
        best = min(best, time.process_time() - begun)
    return 1e3 * best, answer


def programs(_build):
    """Sparse linear programs with a known feasible point, by SciPy's HiGHS and with a proof, in milliseconds."""
    import numpy
    import scipy.optimize
    import scipy.sparse
    from fmb.bridges import linprog
    rows = []
    for m, n in ((10, 5), (40, 20), (160, 80), (640, 320), (1280, 640)):
        draw = numpy.random.default_rng(m)
        A = scipy.sparse.random(m, n, min(1, 8 / n), "csr", random_state=m, data_rvs=lambda k: draw.integers(-9, 10, k))
        A.eliminate_zeros()
        inside = draw.integers(0, 5, n)
        b = A @ inside + draw.integers(1, 9, m)
        c = draw.integers(-9, 10, n)
        turns = 5 if m < 500 else 2
        theirs, found = least(lambda: scipy.optimize.linprog(c, A, b, bounds=(0, 10), method="highs"), turns)
        ours, proved = least(lambda: linprog(c, A, b, bounds=(0, 10)), turns)
        check, judged = least(lambda: proved.exact.proof.check(), turns)
        assert judged and abs(found.fun - proved.fun) < 1e-6 * max(1, abs(found.fun))
        rows.append([m, n, f"{theirs:.3f}", f"{ours:.3f}", f"{check:.3f}"])
    return ["rows", "variables", "highs_ms", "fmb_ms", "check_ms"], rows


def symbols(_build):
    """Rows in one variable, which is what SymPy's own solver takes, in milliseconds."""
    import fmb
    import sympy
    rows = []
    for m in (2, 8, 32):
        x, own = sympy.Symbol("x", real=True), fmb.vars("x")[0]
        theirs, _ = least(lambda: sympy.reduce_inequalities(
            [(i + 1) * x <= 100 + i for i in range(m // 2)] + [(i + 1) * x >= i for i in range(m // 2)], x), 2)
        ours, _ = least(lambda: fmb.bounds(
            [(i + 1) * own <= 100 + i for i in range(m // 2)] + [(i + 1) * own >= i for i in range(m // 2)]), 20)
        rows.append([m, f"{theirs:.3f}", f"{ours:.4f}", sympy.__version__])
    return ["rows", "sympy_ms", "fmb_ms", "version"], rows


STUDIES = {
    "projections": lambda build: peers(build, "--families", "--each", "1"),
    "verdicts": lambda build: peers(build, "--decide", "--families", "--each", "1"),
    "vertices": lambda build: peers(build, "--vertices", *POLYTOPES),
    "hulls": lambda build: peers(build, "--hull", *POLYTOPES),
    "pairs": pairs, "shapes": shapes, "faults": faults, "programs": programs, "symbols": symbols,
}


def machine(build):
    """Where it was, as bench-tiny tells."""
    record = told(build / "bench/bench-tiny", "--json", "--passes=1", "--pairs=14")
    record.pop("lines")
    record.pop("passes")
    return ["what", "value"], [["date", datetime.date.today().isoformat()], *record.items()]


def main():
    build, out = map(pathlib.Path, sys.argv[1:3])
    build, out = build.resolve(), out.resolve()
    sys.path.insert(0, str(build / "bindings/python"))
    for name in sys.argv[3:] or STUDIES:
        write(out, name, *STUDIES[name](build))
        print(name, flush=True)
    write(out, "machine", *machine(build))


if __name__ == "__main__":
    main()
