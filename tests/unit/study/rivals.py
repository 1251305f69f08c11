"""fmb-qualify boxes, scaling, peers from outside: counts, files, the same from the same seed.
usage: rivals.py FMB_QUALIFY"""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

program = sys.argv[1]
faults = []
# The Python in front may lack what draws: then the system's.
if subprocess.run(["python3", "-c", "import matplotlib"], capture_output=True).returncode != 0:
    os.environ["PATH"] = "/usr/bin:" + os.environ["PATH"]


def expect(good, what):
    if not good:
        faults.append(what)


def run(*args):
    got = subprocess.run([program, *args, "--quiet"], capture_output=True, text=True)
    expect(got.returncode == 0 and not got.stderr, f"{args}: {got.returncode} {got.stderr}")
    return got.stdout


def table(*args):
    return json.loads(run(*args, "--json"))


def boxes(folder):
    args = ["boxes", "--pairs", "40", "--passes", "1"]
    first, second, third = table(*args), table(*args), table(*args, "--seed", "2")
    expect(first["sizes"] == second["sizes"], "boxes: the same seed gives other boxes")
    expect(first["sizes"] != third["sizes"], "boxes: another seed gives the same boxes")
    expect(first["wrong"] == 0 and len(first["times"]) == 5, "boxes: counts")
    sizes = {(c["case"], c["box"]): c for c in first["sizes"]}
    expect(len(sizes) == 5 * 8, f"boxes: {len(sizes)} lines")
    for (case, box), c in sizes.items():
        if box.startswith("ours"):
            expect(c["holds_percent"] == 100 and c["max"] < 1 + 1e-6, f"boxes: {case}, {box}: {c}")
        expect(c["min"] <= c["median"] <= c["max"], f"boxes: {case}, {box}: order")
    for case in ("2d-static", "3d-static"):
        expect(sizes[case, "article"]["median"] > 2 * sizes[case, "article, mended"]["median"],
               f"boxes: {case}: the article's boxes")
    run(*args, "--out", str(folder))
    with open(folder / "boxes-sizes.csv", newline="") as f:
        expect(len(list(csv.reader(f))) == 41, "boxes-sizes.csv")


def scaling():
    cells = table("scaling", "--pairs", "32", "--passes", "1")["cells"]
    expect({(c["dim"], c["motion"], c["pair"]) for c in cells} ==
           {(d, m, p) for d in range(2, 9) for m in ("static", "dynamic")
            for p in ("CC", "CT", "TT")}, "scaling: cells")
    for c in cells:
        expect(c["wrong"] == 0 and c["bad_boxes"] == 0 and c["checked"] == c["queries"],
               f"scaling: {c}")
        expect(0 < c["meeting"] < c["queries"] and c["fmb_ns"] > 0, f"scaling: {c}")
        if c["lp_ns"]:
            over = c["fmb_beside_lp_ns"] / c["lp_ns"]
            expect(abs(over / c["fmb_over_lp"]["ratio"] - 1) < 1e-9, f"scaling: {c}")
    expect(cells[-1]["rows"] > cells[0]["rows"], "scaling: rows")


def peers(folder):
    found = table("peers", "--pairs", "60", "--passes", "1")
    expect({"FMB", "SAT", "Ganovelli", "Seidel", "article"} <= set(found["peers"]), "peers: names")
    boxes = {"FCL OBB", "FCL box", "ODE box"}
    expect({(c["cell"], c["peer"]) for c in found["times"]} ==
           {(f"{kind} {verdict}", peer) for kind in ("CC", "CT", "TT", "boxes") for verdict in ("meet", "apart")
            for peer in found["peers"] if (peer not in boxes or kind == "boxes") and
            (peer != "Ganovelli" or kind == "TT")}, "peers: times")
    for c in found["times"]:
        expect(c["over_fmb"]["low"] <= c["over_fmb"]["ratio"] <= c["over_fmb"]["high"], f"peers: {c}")
        expect(c["wrong"] == 0 or c["peer"] not in {"FMB", "SAT", *boxes}, f"peers: {c}")
    for c in found["faults"]:
        if c["peer"] in ("FMB", "SAT"):
            expect(c["false_meet"] + c["false_apart"] + c["unknown"] == 0 and
                   c["touching"] == c["touching_meet"], f"peers: {c}")
        if c["family"] == "article":
            expect(c["queries"] > 0 and c["peer"].startswith("FCL") or
                   c["false_meet"] + c["false_apart"] == 0, f"peers: {c}")
    expect(any(c["touching"] for c in found["faults"]), "peers: nothing touches")
    text = run("peers", "--pairs", "60", "--passes", "1", "--out", str(folder))
    expect(("Built without" in text) == bool(found["missing"]), "peers: what is missing")
    expect("WARNING" not in text, "peers: a library prints")


with tempfile.TemporaryDirectory() as name:
    root = pathlib.Path(name)
    boxes(root / "boxes")
    scaling()
    peers(root / "peers")
for fault in faults:
    print(fault)
sys.exit(1 if faults else 0)
