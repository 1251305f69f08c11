"""A signal, or the end of its time, ends a command, whatever it is at: reading, asking, or writing. Tells how
soon, in time of the processor, which is less than that on the wall; that is a figure, and no fault, as it
depends on the machine. usage: prompt.py FMB"""

import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import default_signals  # noqa: F401

fmb = sys.argv[1]
AFTER = 0.3  # [s] the signal, or the limit
# As users run it: a test runner may have the C library fill whatever is allocated or freed, and of a
# pair in R^10000 that is gigabytes, most of which the command never touches.
ENVIRONMENT = {k: v for k, v in os.environ.items() if k != "MALLOC_PERTURB_"}
faults, figures = [], []
sys.set_int_max_str_digits(0)


def write_intervals(path, dim):
    """Each end of each variable has a proof with a point that has no zero."""
    path.write_text("".join(f"x{j} >= 1\nx{j} <= {j + 1}\n" for j in range(dim)))


def write_chain(path, dim):
    """x0 >= 0, each variable between two sums of those beside it: one piece, nothing substituted."""
    rows = ["x0 >= 0", f"x{dim - 1} <= 7"]
    for j in range(dim - 1):
        k = (j * 7919 + 13) % (dim - 1)
        rows.append(f"x{j} + {j % 5 + 1} x{j + 1} - x{k} <= {j % 11 + 3}")
        rows.append(f"{j % 3 + 2} x{j} - x{j + 1} + x{k} >= -{j % 7 + 1}")
    path.write_text("\n".join(rows) + "\n")


def write_big(path, rows, ine):
    """So many rows that reading them takes seconds."""
    with open(path, "w") as out:
        if ine:
            out.write(f"H-representation\nbegin\n {rows} 6 rational\n")
        for i in range(rows):
            if ine:
                out.write(f" {i} 1 -2 {i % 17} -1/{i % 5 + 1} 3\n")
            else:
                out.write(f"x + 2 y - {i % 17} z - 1/{i % 5 + 1} u + 3 v <= {i}\n")
        if ine:
            out.write("end\n")


def write_cuboids(path, dim):
    """Two, of which each edge has two numbers that are not 0."""
    def edges(step):
        return [[1 if j == i else 0.25 if j == (i + step) % dim else 0 for j in range(dim)]
                for i in range(dim)]
    a, b = ({"type": "cuboid", "orig": [o] * dim, "comp": edges(s)} for o, s in ((0, 1), (0.5, 3)))
    path.write_text(json.dumps({"A": a, "B": b}) + "\n")


def write_long_cuboids(path, dim, digits):
    """Two, all of whose numbers are so long."""
    def edges(step):
        return [[f"{3 ** (2 * digits) // (i * j + step) % 10 ** digits}" for j in range(dim)]
                for i in range(dim)]
    a, b = ({"type": "cuboid", "orig": [o] * dim, "comp": edges(s)} for o, s in ((0, 1), (5, 3)))
    path.write_text(json.dumps({"A": a, "B": b}) + "\n")


def write_points(path, dim):
    point = {"type": "cuboid", "orig": [0.5] * dim, "comp": []}
    path.write_text(json.dumps({"A": point, "B": point}) + "\n")


def write_proof(path, dim, claims):
    """About the intervals: true claims, each with a point that has no zero."""
    point = "".join(f"point x{j} 1\n" for j in range(dim))
    with open(path, "w") as out:
        out.write(f"fmb-proof 2\nsystem {2 * dim} rows {dim} variables\n")
        for _ in range(claims):
            out.write("claim feasible\n" + point + "end\n")
        out.write(f"claims {claims}\n")


def used(pid):
    """Time of the processor [s] that the process has had, also while it waits to be waited for."""
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK"), fields[0] == "Z"


def lasts(words, stop_by_signal=False):
    """Time of the processor that the command had, and how much of that behind the signal [s]."""
    with tempfile.TemporaryFile("w+") as errors:
        run = subprocess.Popen([fmb, *map(str, words)], stdout=subprocess.DEVNULL, stderr=errors, env=ENVIRONMENT)
        before, over = 0, not stop_by_signal
        while not over and before < AFTER:
            time.sleep(0.001)
            before, over = used(run.pid)
        if stop_by_signal and not over:
            run.send_signal(signal.SIGTERM)
        _, status, resources = os.wait4(run.pid, 0)
        run.returncode = os.waitstatus_to_exitcode(status)
        if run.returncode not in (0, 1, 2, -signal.SIGTERM):
            errors.seek(0)
            faults.append(f"{words[0]}: exit code {run.returncode}: {errors.read()}")
    whole = resources.ru_utime + resources.ru_stime
    return whole, whole - before


def tell(what, how, late):
    figures.append(f"{late:7.3f} s after the {how}: {what}")


def expect_prompt(what, words, limits=1):
    """limits: how many of them the command has, one after the other. Time to read the input, which
    no limit is about, is that of a query that ends at once."""
    tell(what, "signal", lasts(words, True)[1])
    if limits > 0:
        reading = lasts([*words, "--max-seconds", "0.001"])[0]
        whole = lasts([*words, "--max-seconds", str(AFTER)])[0]
        tell(what, "limit", whole - reading - limits * AFTER)


def write_long_rows(path, dim, digits):
    """A polytope all of whose numbers are so long."""
    number = lambda k: 3 ** (2 * digits) // (2 * k + 1) % 10 ** digits + 1
    path.write_text("".join(" + ".join(f"{number(7 * i + j)} x{j}" for j in range(dim)) + f" <= {number(99 + i)}\n" +
                            f"x{i % dim} >= -1/{number(i)}\n" for i in range(2 * dim)))


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    intervals, chain, proof = folder / "i.fmb", folder / "c.fmb", folder / "i.proof"
    write_intervals(intervals, 5000)
    write_chain(chain, 3000)
    write_proof(proof, 5000, 300)
    for name, ine in (("big.fmb", False), ("big.ine", True)):
        write_big(folder / name, 1000000, ine)
        expect_prompt(f"reading {name}", ["convert", folder / name, "--to", "fmb"], limits=0)
        (folder / name).unlink()
    expect_prompt("bounds", ["bounds", intervals])
    expect_prompt("bounds with a proof", ["bounds", intervals, "--proof", folder / "out"])
    left = [p.name for p in folder.iterdir() if p.name.startswith("out.")]
    if left:
        faults.append(f"a half written proof stays: {left}")
    for command in ("solve", "bounds", "reduce"):
        expect_prompt(command + " of a chain", [command, chain])
        expect_prompt(command + " of a chain, --proof",
                      [command, chain, "--proof", folder / "out"])
        for method in ("fm", "lp"):
            expect_prompt(f"{command} of a chain, {method}", [command, chain, "--method", method])
    expect_prompt("project of a chain", ["project", chain, "--keep", "x0,x1"])
    expect_prompt("project of a chain, most kept",
                  ["project", chain, "--keep", ",".join(f"x{j}" for j in range(0, 3000, 2))])
    expect_prompt("check", ["check", intervals, proof], limits=0)
    expect_prompt("check, listed", ["check", intervals, proof, "--list"], limits=0)
    write_cuboids(folder / "pair", 3000)
    expect_prompt("reading two cuboids in R^3000", ["intersect", folder / "pair"], limits=0)
    for write, what, dim in ((write_cuboids, "cuboids", 1000), (write_points, "points", 10000)):
        write(folder / "pair", dim)
        for boxes in ("exact", "outward", "none"):
            expect_prompt(f"intersect {what} in R^{dim}, --boxes {boxes}",
                          ["intersect", folder / "pair", "--boxes", boxes],
                          limits=1 if boxes == "none" else 2)
    write_long_cuboids(folder / "pair", 32, 2000)
    expect_prompt("intersect cuboids in R^32, long numbers",
                  ["intersect", folder / "pair", "--boxes", "none"])

    for digits in (2000, 50000):
        write_long_rows(folder / "long.fmb", 6, digits)
        for command in (["vertices"], ["bounds"], ["reduce"], ["project", "--keep", "x0,x1"]):
            expect_prompt(f"{command[0]}, numbers of {digits} digits", [command[0], folder / "long.fmb", *command[1:]])

print("\n".join(figures + faults))
sys.exit(bool(faults))
