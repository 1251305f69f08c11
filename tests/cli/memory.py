"""Under --max-bytes no command grows to more than 1.2 of it, reading included, whatever it is given.
A process that waits for its input tells how large one is that holds nothing.
usage: memory.py FMB"""

import multiprocessing
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

os.environ.pop("MALLOC_PERTURB_", None)  # meson sets it, and it fills memory that nobody would touch
fmb = os.path.abspath(sys.argv[1])
LIMIT, MOST = 32_000_000, 1.2
draw = random.Random(1)


def write(path, *lines):
    path.write_text("\n".join([*lines, ""]))


def make_inputs(folder):
    """Rows of few and of many terms in every format, points and cells, for some of which the limit
    is too low, as it is for what is asked about others."""
    pairs = [f"x{draw.randrange(2000)} + x{draw.randrange(2000)} <= {i}" for i in range(40000)]
    write(folder / "rows.fmb", *pairs)
    for ending in ("smt2", "mps", "lp"):
        with open(folder / f"rows.{ending}", "w") as out:
            subprocess.run([fmb, "convert", folder / "rows.fmb", "--to", ending], stdout=out, check=True)
    write(folder / "many.fmb", *pairs * 6)
    wide = [f"{i} {' '.join(str(draw.randint(-99, 99)) for _ in range(8))}" for i in range(60000)]
    write(folder / "wide.ine", "H-representation", "begin", "60000 9 rational", *wide, "end")
    long = [f"{'7' * 2000} x{i} + y <= {'3' * 2000}" for i in range(4000)]
    write(folder / "long.fmb", *long)
    points = [f"1 {' '.join(str(draw.randint(-9999, 9999)) for _ in range(3))}" for _ in range(120000)]
    for name in ("p", "q"):
        write(folder / f"{name}.ext", "V-representation", "begin", "120000 4 rational", *points, "end")
    corners = [f"{draw.random()} {draw.random()} {draw.random()}" for _ in range(100000)]
    cells = [f"3 {i} {(i + 1) % 100000} {(i + 2) % 100000}" for i in range(100000)]
    write(folder / "mesh.off", "OFF", "100000 100000 0", *corners, *cells)
    write(folder / "map", "u = x1")
    write(folder / "proof", "fmb-proof 5")


def size_of_nothing():
    """[bytes] Of a process that has begun, and waits."""
    with subprocess.Popen([fmb, "solve", "-"], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as p:
        stat = pathlib.Path(f"/proc/{p.pid}/status")
        while "S (sleeping)" not in stat.read_text():
            time.sleep(0.01)
        size = int(re.search(r"VmHWM:\s+(\d+)", stat.read_text())[1]) * 1024
        p.stdin.close()
    return size


def growth(folder, words, least, limit=LIMIT):
    """How much more a command took than nothing, over the limit; its exit code and last words."""
    with open(folder / "words", "w+") as err, open(folder / "answer", "w") as out:
        p = subprocess.Popen([fmb, *words, "--max-bytes", str(limit), "--max-seconds", "2"],
                             cwd=folder, stdout=out, stderr=err)
        _, status, used = os.wait4(p.pid, 0)
        p.returncode = os.waitstatus_to_exitcode(status)
        err.seek(0)
        last = err.read().splitlines()[-1:]
    return (used.ru_maxrss * 1024 - least) / limit, p.returncode, "".join(last)


def is_readable(path):
    return path.stat().st_size == 0 or subprocess.run(
        [fmb, "convert", path, "--to", "fmb"], stdout=subprocess.DEVNULL).returncode == 0


def near_the_input(folder, words, least):
    """Faults under limits from a little less than what the input takes up to three times that: what
    is known at a limit is not held twice, and can be read."""
    refused, unfinished = 0, 0
    for limit in range(12_000_000, 44_000_000, 4_000_000):
        times, code, last = growth(folder, words, least, limit)
        print(f"{' '.join(words):24} {limit:9} {times:5.2f}  {code}  {last[:60]}")
        if times > MOST or code not in (0, 1, 2) or not is_readable(folder / "answer"):
            yield f"{' '.join(words)}: {times:.2f} of {limit}, exit {code}: {last}"
        refused += "the input alone" in last
        unfinished += code == 2 and "the input alone" not in last
    if refused == 0 or unfinished == 0:
        yield f"{' '.join(words)}: {refused} inputs refused, {unfinished} answers unfinished"


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    maker = multiprocessing.Process(target=make_inputs, args=(folder,))
    maker.start() # as a child begins with the size of its parent, which so stays small
    maker.join()
    least = size_of_nothing()
    faults, refused = [], 0
    for words in (("solve", "rows.fmb"), ("solve", "rows.smt2"), ("solve", "rows.mps"),
                  ("solve", "rows.lp"), ("solve", "many.fmb"), ("solve", "long.fmb"),
                  ("bounds", "wide.ine"), ("optimize", "wide.ine", "--max", "x1"),
                  ("reduce", "wide.ine"), ("vertices", "wide.ine"),
                  ("project", "wide.ine", "--keep", "x1,x2"), ("image", "wide.ine", "map"),
                  ("hull", "p.ext"), ("sum", "p.ext", "q.ext"), ("mesh", "mesh.off"),
                  ("check", "many.fmb", "proof")):
        times, code, last = growth(folder, words, least)
        print(f"{' '.join(words):32} {times:5.2f}  {code}  {last[:60]}")
        refused += "the input alone" in last
        if times > MOST or code not in (0, 1, 2):
            faults.append(f"{' '.join(words)}: {times:.2f} of the limit, exit {code}: {last}")
        if "the input alone" in last and code != 2:
            faults.append(f"{' '.join(words)}: exit {code}: {last}")
    for words in (("reduce", "wide.ine"), ("image", "wide.ine", "map"), ("reduce", "long.fmb")):
        faults += near_the_input(folder, words, least)
    if not 3 <= refused <= 12:
        faults.append(f"{refused} inputs alone were too large: the test wants both kinds")
print("\n".join(faults) or "within the limit")
sys.exit(bool(faults))
