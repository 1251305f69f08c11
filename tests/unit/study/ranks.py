"""fmb-validate, fmb mesh and fmb-qualify by mpirun: the counts of one process, to the byte; a rank that is lost ends
the run, and nothing is written. Skipped where there is no mpirun, or the programs were built without MPI.
With "every": all studies, and an experiment whose ranks are killed.
usage: ranks.py FMB_VALIDATE FMB FMB_QUALIFY [every]"""

import csv
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

validate, fmb, qualify = sys.argv[1:4]
every = sys.argv[4:] == ["every"]
# Where tests run as root in a container of few cores; leaks that a sanitizer finds are MPI's own.
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
               "OMPI_MCA_mpi_yield_when_idle": "1",  # other tests run beside
               "ASAN_OPTIONS": "detect_leaks=0"}
faults = []


def expect(good, what):
    if not good:
        faults.append(what)


def launch(ranks, *args):
    return subprocess.Popen(["mpirun", "-n", str(ranks), *args], env=ENVIRONMENT, stdin=subprocess.PIPE,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def finish(child, given=None):
    text, errors = child.communicate(given)
    return child.returncode, text, errors


def report(path):
    return re.sub(r'"seconds": ?[^,]*,', "", path.read_text())


def same_counts(folder):
    args = ["--pairs", "301", "2d-static", "--families", "article,near", "--sample", "0.1"]
    alone = folder / "alone"
    subprocess.run([validate, *args, "--json", str(alone)], check=True, stdout=subprocess.DEVNULL)
    for ranks, threads in ((2, "1"), (3, "2")):
        path = folder / f"ranks{ranks}"
        code, text, errors = finish(launch(ranks, validate, *args, "--threads", threads, "--json", str(path)))
        expect(code == 0, f"{ranks} ranks: {code} {errors}")
        expect(len(text.splitlines()) == 3, f"{ranks} ranks: one table, not {text}")
        expect(path.exists() and report(path) == report(alone), f"{ranks} ranks: other counts than one process")


def ranks_of(child):
    tasks = pathlib.Path(f"/proc/{child.pid}/task").glob("*/children")
    return [int(pid) for task in tasks for pid in task.read_text().split()]


def at_work(pid):
    """It catches SIGINT, as our programs do from when they begin to when they end."""
    caught = re.search(r"^SigCgt:\s*(\w+)", pathlib.Path(f"/proc/{pid}/status").read_text(), re.M)
    return caught and int(caught[1], 16) >> signal.SIGINT - 1 & 1


def sheets(side):
    """OFF: a sheet of triangles, and the same a quarter turned through it."""
    points, faces = [], []
    for sheet in range(2):
        first = len(points)
        for i in range(side * side):
            x, y = i % side - side / 2 + 0.25, i // side
            points.append(f"{x} {y} 0" if sheet == 0 else f"0 {y} {x}")
        for i in range(side * (side - 1)):
            if i % side < side - 1:
                faces += [f"3 {first + i} {first + i + 1} {first + i + side}",
                          f"3 {first + i + side + 1} {first + i + side} {first + i + 1}"]
    return "\n".join([f"OFF {len(points)} {len(faces)} 0", *points, *faces, ""])


def same_hits(folder):
    path = folder / "sheets.off"
    path.write_text(sheets(14))
    trees = subprocess.run([fmb, "mesh", path], capture_output=True, text=True).stdout.splitlines()
    for more in ([], ["--json"], ["--neighbours", "--threads", "2"], ["--max-bytes", "100"]):
        alone = subprocess.run([fmb, "mesh", path, "--all-pairs", *more], capture_output=True, text=True)
        code, text, errors = finish(launch(3, fmb, "mesh", path, "--all-pairs", *more))
        expect(code == alone.returncode, f"mesh {more}: {code} {errors}")
        expect("--max-bytes" in more or text == alone.stdout, f"mesh {more}: {text} by ranks, {alone.stdout} by one")
        expect(more or (text.splitlines()[:-1] == trees[:-1] and len(trees) > 20), f"pairs {text}, trees {trees}")
    code, text, _ = finish(launch(2, fmb, "mesh", "-", "--all-pairs"), path.read_text())
    expect(code == 0 and text.splitlines()[:-1] == trees[:-1], "mesh of standard input")
    for args, wanted in ((["mesh", path], 64), (["mesh", folder / "none", "--all-pairs"], 66)):
        code, text, errors = finish(launch(2, fmb, *args))
        expect(code == wanted and text == "" and errors.count("fmb:") == 1, f"{args}: {code} {text} {errors}")


def counts(study):
    """What is no time, nor says where it was measured."""
    if isinstance(study, dict):
        return {key: counts(value) for key, value in study.items()
                if key not in ("machine", "processes", "page", "seconds", "load") and not isinstance(value, float)}
    return [counts(value) for value in study if not isinstance(value, float)] if isinstance(study, list) else study


def same_studies(folder):
    more = (("article", 4), ("peers", 4), ("scaling", 2), ("bunny", 10000)) if every else ()
    for study, pairs in (("faces", 30), *more):
        args = [qualify, study, "--pairs", str(pairs), "--passes", "1", "--json"]
        alone = subprocess.run(args, capture_output=True, text=True)
        out = folder / study
        code, text, errors = finish(launch(2, *args, "--out", str(out)))
        expect(code == alone.returncode == 0, f"{study}: {code} {errors}, alone {alone.returncode} {alone.stderr}")
        one, many = json.loads(alone.stdout), json.loads(text or "{}")
        expect(counts(one) == counts(many), f"{study}: other counts by two processes")
        expect(many.get("processes") == 2, f"{study}: who took part?")
        expect((out / "report.json").exists(), f"{study}: no report")
    code, text, errors = finish(launch(2, qualify, "rules", "--dim", "2", "--pairs", "1", "--rules", "kohler", "--json"))
    expect(code == 0 and json.loads(text)["complete"], f"rules, by rank 0 alone: {code} {errors}")
    folder.joinpath("file").write_text("")
    code, text, _ = finish(launch(2, qualify, "faces", "--pairs", "1", "--out", str(folder / "file")))
    expect(code == 74 and text == "", f"no folder: {code} {text}")


def runs(path):
    """Lines of an experiment by block, without the time."""
    merged = subprocess.run([qualify, "merge", path], capture_output=True, text=True)
    return [{**line, "seconds": ""} for line in csv.DictReader(merged.stdout.splitlines())]


def same_experiment(folder):
    """Two and three ranks, one of them after a kill of all, leave the lines of one process."""
    plan = folder / "plan.json"
    plan.write_text(json.dumps({"rules": ["none", "kohler"], "sizes": [1], "seeds": [1], "passes": 1, "limits": {"rows": 300, "seconds": 20}}))
    alone = folder / "alone.csv"
    subprocess.run([qualify, "run", plan, "--out", alone], check=True)
    wanted = runs(alone)
    expect(len(wanted) > 70, "no lines")
    for ranks in (2, 3):
        out = folder / f"by{ranks}.csv"
        if ranks == 3:
            out.write_bytes(alone.read_bytes()[:len(alone.read_bytes()) // 2])
        code, _, errors = finish(launch(ranks, qualify, "run", plan, "--out", out))
        expect(code == 0 and runs(out) == wanted, f"{ranks} ranks: other lines than one process; {code} {errors}")
    refused(66, "plan.json: No such", "no plan", qualify, "run", folder / "none" / "plan.json")
    refused(74, "none.csv", "no folder for results", qualify, "run", plan, "--out", folder / "none" / "none.csv")
    refused(74, "none.json", "no folder for counts", validate, "2d-static", "--json", folder / "none" / "none.json")
    plan.write_text("{}}")
    refused(65, "plan.json:1", "a bad plan", qualify, "run", plan, "--out", folder / "none.csv")


def refused(wanted, said, what, *args):
    """What cannot begin is told once, and all ranks end in good order."""
    code, text, errors = finish(launch(2, *args))
    expect(code == wanted and text == "" and errors.count(said) == 1, f"{what}: {code} {text} {errors}")
    expect("MPI_ABORT" not in errors, f"{what}: some rank ended all others: {errors}")


def killed_experiment(folder):
    """SIGKILL for both ranks in the midst of it; then again."""
    plan, out, alone = folder / "long.json", folder / "long.csv", folder / "short.csv"
    plan.write_text(json.dumps({"rules": ["none", "kohler"], "sizes": [1, 2], "seeds": [1, 2], "passes": 1,
                                "limits": {"rows": 1000, "seconds": 20}}))
    subprocess.run([qualify, "run", plan, "--out", alone], check=True)
    child = launch(2, qualify, "run", plan, "--out", out)
    while child.poll() is None and not out.exists():
        time.sleep(0.01)
    for pid in ranks_of(child):
        os.kill(pid, signal.SIGKILL)
    finish(child)
    code, _, errors = finish(launch(2, qualify, "run", plan, "--out", out))
    expect(code == 0 and runs(out) == runs(alone), f"after a kill: {code} {errors}")


def lost_rank(folder):
    path = folder / "lost"
    path.write_text("before")
    for args in ([validate, "--pairs", "1000000000", "--json", str(path)],
                 [qualify, "near", "--pairs", "1000000", "--json", "--out", str(folder / "lost-study")]):
        child = launch(2, *args)
        while child.poll() is None and not (len(ranks_of(child)) == 2 and all(map(at_work, ranks_of(child)))):
            time.sleep(0.01)
        os.kill(ranks_of(child)[-1], signal.SIGKILL)
        code, text, _ = finish(child)
        expect(code not in (0, 1, 2), f"a lost rank: exit code {code}")
        expect(text == "" and path.read_text() == "before", "a lost rank: something was written")
        expect(not (folder / "lost-study" / "report.json").exists(), "a lost rank: half a report")


if not shutil.which("mpirun"):
    print("ranks: no mpirun here")
    sys.exit(77)
_, _, said = finish(launch(2, validate, "--pairs", "1", "2d-static"))
if "built without MPI" in said:
    print("ranks: built without MPI")
    sys.exit(77)
with tempfile.TemporaryDirectory() as name:
    same_counts(pathlib.Path(name))
    same_hits(pathlib.Path(name))
    same_studies(pathlib.Path(name))
    same_experiment(pathlib.Path(name))
    if every:
        killed_experiment(pathlib.Path(name))
    lost_rank(pathlib.Path(name))
print("\n".join(faults) or "ranks: no faults")
sys.exit(1 if faults else 0)
