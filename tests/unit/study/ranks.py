"""fmb-validate by mpirun: the counts of one process, to the byte; a rank that is lost ends the run, and nothing is
written. Skipped where there is no mpirun, or the program was built without MPI.
usage: ranks.py FMB_VALIDATE"""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

program = sys.argv[1]
# Where tests run as root in a container of few cores; leaks that a sanitizer finds are MPI's own.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
               "ASAN_OPTIONS": "detect_leaks=0"}
faults = []


def expect(good, what):
    if not good:
        faults.append(what)


def launch(ranks, *args):
    return subprocess.Popen(["mpirun", "-n", str(ranks), program, *args], env=ENVIRONMENT, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True)


def report(path):
    return re.sub(r'"seconds": ?[^,]*,', "", path.read_text())


def same_counts(folder):
    args = ["--pairs", "301", "2d-static", "--families", "article,near", "--sample", "0.1"]
    alone = folder / "alone"
    subprocess.run([program, *args, "--json", str(alone)], check=True, stdout=subprocess.DEVNULL)
    for ranks, threads in ((2, "1"), (3, "2")):
        path = folder / f"ranks{ranks}"
        child = launch(ranks, *args, "--threads", threads, "--json", str(path))
        text, errors = child.communicate(timeout=200)
        expect(child.returncode == 0, f"{ranks} ranks: {child.returncode} {errors}")
        expect(len(text.splitlines()) == 3, f"{ranks} ranks: one table, not {text}")
        expect(path.exists() and report(path) == report(alone), f"{ranks} ranks: other counts than one process")


def ranks_of(child):
    tasks = pathlib.Path(f"/proc/{child.pid}/task").glob("*/children")
    return [int(pid) for task in tasks for pid in task.read_text().split()]


def lost_rank(folder):
    path = folder / "lost"
    path.write_text("before")
    child = launch(2, "--pairs", "1000000000", "--json", str(path))
    end = time.monotonic() + 60
    while len(ranks_of(child)) < 2 and time.monotonic() < end:
        time.sleep(0.1)
    time.sleep(2)
    os.kill(ranks_of(child)[-1], signal.SIGKILL)
    text, _ = child.communicate(timeout=100)
    expect(child.returncode not in (0, 1, 2), f"a lost rank: exit code {child.returncode}")
    expect(text == "" and path.read_text() == "before", "a lost rank: something was written")


if not shutil.which("mpirun"):
    print("ranks: no mpirun here")
    sys.exit(77)
_, said = launch(2, "--pairs", "1", "2d-static").communicate(timeout=200)
if "built without MPI" in said:
    print("ranks: built without MPI")
    sys.exit(77)
with tempfile.TemporaryDirectory() as name:
    same_counts(pathlib.Path(name))
    lost_rank(pathlib.Path(name))
print("\n".join(faults) or "ranks: no faults")
sys.exit(1 if faults else 0)
