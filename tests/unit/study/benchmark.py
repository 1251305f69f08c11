"""fmb-qualify benchmark from outside: the bytes of the version, wherever it is built; digests that fmb finds, too;
what is said of mistakes. usage: benchmark.py FMB_QUALIFY FMB [PAGE]; with the page that says the
digest of the whole manifest all of it is written."""

import csv
import hashlib
import json
import pathlib
import subprocess
import sys
import tempfile

qualify, fmb = sys.argv[1:3]
# Families that are quick, one of each kind: frames, verdicts, projections with equations and strict rows.
FAMILIES = "frames-moving,frames-simplices,value,octagon,schedule,flow,slice,cone,conflict,conflict-sparse,none,strict,long"
# Of all files of these families but README.md, in the order of their names: FMB-2026.1 is these bytes.
DIGEST = "e280cb0123d5fefaa514b29a11c6bf67331fe1c1e218ca1df410de403ba761de"
faults = []


def expect(good, what):
    if not good:
        faults.append(what)


def run(*words):
    return subprocess.run(words, capture_output=True, text=True)


def digest_of(folder):
    digest = hashlib.sha256()
    for path in sorted(set(folder.iterdir()) - {folder / "README.md"}):
        digest.update(path.name.encode() + b"\n" + path.read_bytes())
    return digest.hexdigest()


def agrees(folder, line):
    """Does fmb find the answer of that line of the manifest?"""
    path = str(folder / line["name"]) + ".ine"
    facts = json.loads((folder / (line["name"] + ".json")).read_text())
    expect(facts["answer"]["sha256"] == line["sha256"] and facts["rows"] == int(line["rows"]), f"{line}: JSON differs")
    found = run(fmb, "project", path, "--to", "ine").stdout if line["kept"] != "0" else \
        run(fmb, "solve", path).stdout.partition("\n")[0] + "\n"
    expect(hashlib.sha256(found.encode()).hexdigest() == line["sha256"], f"{line}: fmb says {found}")


def whole(home, page):
    made = run(qualify, "benchmark", str(home))
    expect(made.returncode == 0 and not made.stderr, f"benchmark: {made}")
    digest = hashlib.sha256((home / "manifest.csv").read_bytes()).hexdigest()
    expect(digest in page.read_text(), f"{page} does not have {digest}")


def part(home):
    made = run(qualify, "benchmark", str(home), "--families", FAMILIES)
    expect(made.returncode == 0 and not made.stderr, f"benchmark: {made}")
    with open(home / "manifest.csv", encoding="utf-8", newline="") as f:
        lines = list(csv.DictReader(f))
    expect(len(lines) == 15 * len(FAMILIES.split(",")), f"{len(lines)} problems")
    expect(len({line["sha256"] for line in lines if line["kept"] != "0"}) > 100, "answers are the same")
    expect(digest_of(home) == DIGEST, f"other bytes: {digest_of(home)}")
    for line in lines[::7]:
        agrees(home, line)
    expect("CC0" in (home / "README.md").read_text(), "no licence")


def mistakes(home):
    expect(run(qualify, "benchmark").returncode == 64, "no folder")
    expect(run(qualify, "benchmark", "--families", "nothing", str(home)).returncode == 64, "no such family")
    expect(run(qualify, "benchmark", "/dev/null/set").returncode == 74, "a folder that cannot be")


with tempfile.TemporaryDirectory() as name:
    if len(sys.argv) > 3:
        whole(pathlib.Path(name) / "set", pathlib.Path(sys.argv[3]))
    else:
        part(pathlib.Path(name) / "set")
        mistakes(pathlib.Path(name) / "set")
print("\n".join(faults) or "benchmark: no faults")
sys.exit(bool(faults))
