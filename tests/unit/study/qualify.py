"""fmb-qualify from outside: exit codes, files, the same counts from the same seed, Ctrl-C; the report
holds every figure.
usage: qualify.py FMB_QUALIFY MAN_PAGE [TWO_CLOCKS] [every]: a library that two_clocks.c makes; the one report of every study alone"""

import csv
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

import watched

program, man_page = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
two_clocks = next((os.path.abspath(word) for word in sys.argv[3:] if word != "every"), None)
faults = []
STUDIES = ["table1", "article", "near", "touching", "slender", "mesh", "faces", "boxes", "scaling", "rules", "peers", "bunny"]
# The Python in front may lack what draws: then the system's.
if subprocess.run(["python3", "-c", "import matplotlib"], capture_output=True).returncode != 0:
    os.environ["PATH"] = "/usr/bin:" + os.environ["PATH"]
DRAWS = subprocess.run(["python3", "-c", "import matplotlib"], capture_output=True).returncode == 0
SMALL = ["--dim", "2", "--pairs", "2", "--rules", "kohler", "--rules", "kohler,box", "--passes", "1"]


def expect(good, what):
    if not good:
        faults.append(what)


def run(*args, env=None):
    return subprocess.run([program, "rules", *args], capture_output=True, text=True, env=env)


def counts(folder):
    """rules-runs.csv without the time."""
    with open(folder / "rules-runs.csv", newline="") as f:
        return [row[:-1] for row in csv.reader(f)]


def exit_codes(folder):
    bad = folder / "bad.fmb"
    bad.write_text("x <= <= 1\n")
    for args, code in ((["nonsense"], 64), (["all", "nonsense"], 64), (["--pairs", "0"], 64),
                       (["all", "--simd", "best"], 64), (["rules", "--dim", "x"], 64),
                       (["rules", "--pairs", "0"], 64), (["rules", "--orders", "best"], 64),
                       (["rules", "--family", "huge"], 64), (["rules", "--kinds", "CX"], 64),
                       (["rules", "--motion", "slow"], 64), (["rules", "--meeting", "maybe"], 64),
                       (["rules", str(folder / "none.fmb")], 66), (["bunny", str(folder / "none.ply")], 66),
                       (["bunny", str(bad)], 65), (["mesh", str(bad)], 65), (["bunny", "a", "b"], 64), (["rules", str(bad)], 65),
                       (["rules", *SMALL, "--out", str(bad / "x")], 74),
                       (["all", "--out", str(bad / "x")], 74), (["all", "--out", str(bad)], 74),
                       (["--version"], 0), (["--help"], 0), (["rules", "--help"], 0)):
        got = subprocess.run([program, *args], capture_output=True, text=True)
        expect(got.returncode == code, f"{args}: exit code {got.returncode}, not {code}")
        for option in [word for word in args if code == 64 and word.startswith("--")]:
            expect(f": {option}: " in got.stderr, f"{args}: which option? {got.stderr}")


def report(folder):
    first, second, third = folder / "1", folder / "2", folder / "3"
    for out, seed in ((first, "5"), (second, "5"), (third, "6")):
        got = run(*SMALL, "--seed", seed, "--out", str(out))
        expect(got.returncode == 0 and not got.stderr, f"report: {got.returncode} {got.stderr}")
    expect(counts(first) == counts(second), "the same seed gives other counts")
    expect(counts(first) != counts(third), "another seed gives the same counts")
    rows = counts(first)
    expect(len({len(row) for row in rows}) == 1, "lines of runs.csv differ in length")
    expect(len(rows) == 1 + 16 * 2 * 3 * 2, f"{len(rows)} lines in runs.csv")
    table = json.loads((first / "report.json").read_text())
    expect(table["complete"] and len(table["classes"]) == 16 * 3 * 2, "report.json")
    expect(all(c["wrong"] == 0 and c["n"] == 2 for c in table["classes"]), "report.json: counts")
    with open(first / "rules-classes.csv", newline="") as f:
        expect(len(list(csv.DictReader(f))) == 16 * 3 * 2, "rules-classes.csv")
    for name in ("rows", "time"):
        for ending in ("svg", "pdf") if DRAWS else ():
            path = first / f"rules-{name}.{ending}"
            expect(path.exists() and path.stat().st_size > 0, f"{path.name} is missing")


def bare_numbers(folder):
    """Programs read the CSV: a number is a number, whatever the table says of it."""
    for path in (folder / "1").glob("*.csv"):
        with open(path, newline="") as f:
            titles, *rows = list(csv.reader(f))
        expect(rows and all(len(row) == len(titles) for row in rows), f"{path.name}: lines differ in length")
        for row in rows:
            for title, field in zip(titles, row):
                expect(not re.match(r"[-+]?[0-9.]", field) or re.fullmatch(r"[-+]?[0-9.]+(e[-+]?[0-9]+)?", field),
                       f"{path.name}: {title}: {field}")
                expect(not re.search(r"[%\u00a0]", field) and field != "-", f"{path.name}: {title}: {field}")


def without_tools(folder):
    """Without matplotlib the report has no pictures, without Python there is none; numbers are there."""
    bare = folder / "bare" / "matplotlib.py"
    bare.parent.mkdir()
    bare.write_text("raise ImportError(name='matplotlib')\n")
    out = folder / "plain"
    got = run(*SMALL, "--out", str(out), env={**os.environ, "PYTHONPATH": str(bare.parent)})
    expect(got.returncode == 0 and got.stderr.count("has no ") == 1, got.stderr)
    expect(got.stderr.count("\n") == 1, f"matplotlib is missed more than once: {got.stderr}")
    expect(not list(out.glob("*.svg")) and "Not drawn: python3 has no" in (out / "report.html").read_text(), "nothing said of it")
    out = folder / "plainer"
    got = run(*SMALL, "--out", str(out), env={**os.environ, "PATH": str(folder)})
    expect(got.returncode == 0 and "python3 is not installed" in got.stderr and got.stderr.count("\n") == 1, got.stderr)
    expect((out / "report.json").exists() and (out / "rules-classes.csv").exists() and
           not (out / "report.html").exists(), "without Python")
    got = run(*SMALL, "--passes", "0", "--out", str(folder / "timeless"))
    expect(got.returncode == 0 and not got.stderr, f"no time: {got.returncode} {got.stderr}")


def machine():
    """What a paper cites; who had to wait is told: by the time, and by clocks of which one on the wall stands
    still, or shows that hours went by for each second of the processor."""
    args = [program, "near", "--json", "--pairs", "200", "--passes", "3"]
    clocks = [({}, None)]
    if two_clocks:
        clocks += [({"LD_PRELOAD": two_clocks, "WALL_STEP": step}, busy) for step, busy in (("0", False), ("3600", True))]
    for clock, busy in clocks:
        found = json.loads(subprocess.run(args, capture_output=True, text=True, env={**os.environ, **clock}).stdout)
        m = found["machine"]
        expect(m["cores"] >= 1 and m["memory_bytes"] > 1 << 20 and m["load"] >= 0, f"machine: {m}")
        expect(re.match(r"(gcc|clang) \d+\.", m["compiler"]) and "-O" in m["flags"], f"machine: {m}")
        expect(m["cpu"] and m["os"] and m["kernel"] == os.uname().release, f"machine: {m}")
        warned = any("repeat the study" in part.get("text", "") for part in found["page"])
        expect(warned == (found["wall_seconds"] > 1.1 * found["cpu_seconds"]), f"busy? {found['wall_seconds']}")
        expect(busy is None or warned == busy, f"{clock}: {found['wall_seconds']} s, {found['cpu_seconds']} s")


def no_contradictions(cell):
    """Who divides the times beside a ratio finds the ratio, within its interval."""
    for part, ways in ((cell, ("fmb", "sat", "fmb_over_sat")), (cell, ("sat_plain", "sat", "sat_plain_over_sat")),
                       (cell["one_a_call"], ("fmb", "sat", "fmb_over_sat")),
                       (cell["repeated"], ("fmb", "sat", "fmb_over_sat"))):
        over, ratio = part[ways[0] + "_ns"] / part[ways[1] + "_ns"], part[ways[2]]
        expect(abs(over / ratio["ratio"] - 1) < 1e-9, f"{ways}: {over}, {ratio}")
        expect(ratio["least"] <= ratio["low"] <= ratio["ratio"] <= ratio["high"] <= ratio["most"], f"{ways}: {ratio}")


def tables():
    got = run(*SMALL, "--orders", "pairs")
    lines = got.stdout.partition("Order pairs\n\n")[2].partition("\n\n")[0].splitlines()
    expect(len(lines) == 1 + 2 * 3 and len({len(line) for line in lines}) == 1,
           "the table does not line up:\n" + "\n".join(lines))
    expect("pays in time from" in got.stdout and "Counts of the best rules" in got.stdout, "a section is missing")
    expect("wanted" not in got.stdout and "bar" not in got.stdout.split(), "goals of the house")
    detail = run(*SMALL, "--orders", "pairs", "--detail").stdout
    expect("D2 static CT apart" in detail, "--detail")
    printed = json.loads(run(*SMALL, "--json").stdout)
    expect(printed["study"] == "rules", "--json")


def stopped():
    """No rules and few rows: stopped, the same each time, and not an error."""
    args = ["--dim", "4", "--kinds", "CC", "--meeting", "yes", "--pairs", "2", "--max-rows", "40",
            "--rules", "none", "--json", "--passes", "0", "--orders", "pairs"]
    first, second = json.loads(run(*args).stdout), json.loads(run(*args).stdout)
    expect(first["classes"] == second["classes"] and all(c["stopped"] == 2 for c in first["classes"]), "stopped")


def merged(folder):
    """The runs of all shards make the counts of one run, to the byte; anything else is refused."""
    file = folder / "square.fmb"
    file.write_text("x + y <= 1\n-x <= 0\n-y <= 0\n")
    args = [*SMALL, "--orders", "pairs", "--pairs", "5", str(file)]
    parts = [str(folder / f"part{i}") for i in (1, 2, 3)]
    for i, part in enumerate(parts):
        pathlib.Path(part).write_text(run(*args, "--shard", f"{i + 1}/3", "--json").stdout)
    file.unlink()
    got = run("--merge", "--json", *parts[1:], parts[0])
    expect(got.returncode == 0 and not got.stderr, f"--merge: {got.returncode} {got.stderr}")
    file.write_text("x + y <= 1\n-x <= 0\n-y <= 0\n")
    once, whole = run(*args, "--json").stdout, got.stdout
    counts = lambda text: re.search(r'^  "classes": \[.*?^  \]', text, re.M | re.S)[0]
    expect(counts(once) == counts(whole) and len(counts(once)) > 10000, "--merge: other counts than in one run")
    timed = json.loads(whole)["times"]
    expect(any(t["timed"] > 0 and t["time_median"]["ratio"] > 0 for t in timed), "--merge: no times")
    other = folder / "other"
    other.write_text(run(*args, "--seed", "2", "--shard", "3/3", "--json").stdout)
    for words, code in ((parts[:2], 65), ([*parts[:2], parts[0]], 65), ([*parts[:2], str(other)], 65), ([], 64),
                        ([*parts[:2], str(folder / "none")], 66), ([str(file)], 65)):
        got = run("--merge", *words)
        expect(got.returncode == code and got.stderr.count("\n") == 1, f"--merge {words}: {got.returncode} {got.stderr}")
    expect(run("--shard", "4/3").returncode == 64, "--shard 4/3")


def files(folder):
    """Which variables stay: the last one, or what the file asks for."""
    last, asked = folder / "last.fmb", folder / "asked.ine"
    last.write_text("x + y + z <= 1\n-x <= 0\n-y <= 0\n-z <= 0\n")
    asked.write_text("asked\n* keep 2\nH-representation\nbegin\n4 4 integer\n1 -1 -1 -1\n0 1 0 0\n"
                     "0 0 1 0\n0 0 0 1\nend\n")
    got = run(str(last), str(asked), "--rules", "kohler", "--json", "--orders", "pairs")
    rows = {(c["systems"], c["rules"]): c for c in json.loads(got.stdout)["classes"]}
    expect(rows[str(last), "none"]["made"] == 2 and rows[str(asked), "none"]["made"] == 1,
           f"files: {rows}")
    text = run(str(last), "--rules", "kohler").stdout
    expect("files" in text and "Counts" not in text, "a report on files")


def interrupted(folder):
    out = folder / "half"
    run = watched.Watched([program, "rules", "--pairs", "200", "--out", str(out)])
    run.at_work()
    run.child.send_signal(signal.SIGINT)
    code, text, errors = run.end()
    expect(code == 2 and "Interrupted" in text, f"Ctrl-C: {code} {errors}")
    expect(not json.loads((out / "report.json").read_text())["complete"], "Ctrl-C: report.json")


def study(name, *args, pairs=8):
    got = subprocess.run([program, name, "--pairs", str(pairs), "--passes", "1", *args],
                         capture_output=True, text=True)
    expect(got.returncode == 0 and not got.stderr, f"{name} {args}: {got.returncode} {got.stderr}")
    return got.stdout


def cells(name, *args):
    """The cells of a study of verdicts, by case, pair and meeting."""
    printed = json.loads(study(name, "--json", *args))
    expect(printed["machine"] and printed["complete"], f"{name}: machine, complete")
    return {(c["case"], c["pair"], c["meeting"]): c for c in printed["cells"]}


def verdicts():
    """24 cells, in which FMB and SAT agree; those that meet have boxes that meet."""
    table, near, faces = cells("table1"), cells("near"), cells("faces")
    expect(set(table) == set(near) == {(f"{d}d-{m}", p, meets) for d in (2, 3)
                                       for m in ("static", "dynamic") for p in ("CC", "CT", "TT")
                                       for meets in (True, False)}, "cells")
    expect(set(faces) == {key for key in table if key[0] == "3d-static"}, "cells of faces")
    touching, slender, mesh = cells("touching"), cells("slender"), cells("mesh")
    expect(set(mesh) == {key for key in table if key[0].startswith("3d")}, "cells of mesh")
    expect(all((cell["exact_share"] > 0) >= key[2] for key, cell in mesh.items() if key[1] == "TT"), "no neighbours touch")
    expect(set(touching) == set(slender) == set(table), "cells of touching, of slender")
    expect(max(cell["exact_share"] for cell in touching.values()) > 0, "no pair touches")
    expect(sum(cell["exact_share"] for cell in slender.values()) < 0.05 * len(slender), "slender frames are left open")
    for cell in [*table.values(), *near.values(), *touching.values(), *slender.values(), *mesh.values(), *faces.values()]:
        expect(cell["queries"] == 8 and cell["different"] == 0 <= cell["exact_share"] <= 1 and
               min(cell["fmb_ns"], cell["sat_ns"], cell["sat_plain_ns"]) > 0, str(cell))
        no_contradictions(cell)
    drawn = {key: cell["drawn"] for key, cell in table.items()}
    expect(drawn == {key: c["drawn"] for key, c in cells("table1").items()}, "the same seed")
    expect(drawn != {key: c["drawn"] for key, c in cells("table1", "--seed", "2").items()},
           "another seed")
    for key, cell in near.items():
        expect(cell["drawn"] == drawn[key] if key[2] else cell["drawn"] >= drawn[key], f"near {key}")
    expect(sum(c["drawn"] for c in near.values()) > sum(drawn.values()), "near is like table1")


def article():
    """The published ratios; verdicts of ours are right, and no choice loses."""
    found = cells("article")
    expect(len(found) == 24 and found[("3d-static", "TT", True)]["published"] == 0.24, "article: cells")
    for cell in found.values():
        repeated = cell["repeated"]
        expect(cell["asked"]["wrong"] == cell["packed"]["wrong"] == 0, f"article: {cell}")
        expect(0 < repeated["least"] <= repeated["mean"] <= repeated["most"], f"article: {repeated}")
    for choice in json.loads(study("article", "--json"))["choices"]:
        expect(-1e-9 <= choice["by_kind_percent"] <= choice["by_verdict_percent"] + 1e-9 < 100, f"article: {choice}")


def html_figures(folder):
    """Names of the figures that report.html holds; each is a picture with lines in it."""
    text = (folder / "report.html").read_text()
    for name in re.findall(r'href="([\w.-]+\.\w+)"', text):
        expect((folder / name).exists(), f"report.html: {name} is missing")
    pictures = re.findall(r"<svg.*?</svg>", text, re.S)
    names = []
    for picture in pictures:
        tree = xml.etree.ElementTree.fromstring(picture)
        names += [e.get("id") for e in tree.iter() if e.get("id")]
        expect(sum(1 for e in tree.iter() if e.tag.endswith("}path")) > 10, "a picture without lines")
    expect(len(names) == len(set(names)), "names of one picture clash with those of another")
    expect(text.count("<figure>") == len(pictures) and "Not drawn" not in text, "a figure is missing")
    expect("src=" not in text and "http" not in re.sub(r'xmlns(:\w+)?="[^"]*"', "", text), "not one file")
    return set(re.findall(r'href="([\w-]+)\.svg"', text))


def opens_with_results(text):
    """A sentence a study and no table before what is folded; and a page for phones."""
    sections = re.findall(r"<section>.*?</section>", text, re.S)
    expect('name="viewport"' in text and len(sections) == len(STUDIES), "sections of report.html")
    for section in sections:
        first, folded, behind = section.partition("<details>")
        told = re.search(r'<p class="outcome">([^<]{20,})</p>', first)
        expect(told and "nan" not in told[1], f"what came out: {first[:200]}")
        expect(folded and "<table>" not in first and behind.rstrip().endswith("</details>\n</section>"), "tables are not folded")


def one_report(folder):
    out = folder / "table1"
    text = study("table1", "--out", str(out))
    expect("one pair again and again" in text, "table1: a table is missing")
    for name in ("cells", "single", "repeated"):
        with open(out / f"table1-{name}.csv", newline="") as f:
            expect(len(list(csv.reader(f))) == 25, f"table1-{name}.csv")
    expect(len(json.loads((out / "report.json").read_text())["cells"]) == 24, "table1: report.json")
    if DRAWS:
        expect(html_figures(out) == {"table1-ratio"}, "figures of table1")


def whole_report(folder):
    out = folder / "all"
    study("all", "--out", str(out))
    text = (out / "report.html").read_text()
    found = [s["study"] for s in json.loads((out / "report.json").read_text())["studies"]]
    expect(found == STUDIES, f"studies: {found}")
    expect(re.findall(r'<h2 id="(\w+)"', text) == found == re.findall(r'<a href="#(\w+)"', text),
           "sections of report.html")
    opens_with_results(text)
    if DRAWS:
        drawn = {name.partition("-")[0] for name in html_figures(out)}
        expect(drawn == set(STUDIES), f"studies with figures: {sorted(drawn)}")


def scan():
    """The article's study: the list that brute force found once."""
    cases = man_page.resolve().parents[3] / "shared/cases/geom"
    if not (cases / "bun_zipper.ply").exists():
        print("no collected cases here: the scan was not asked about")
        return
    wanted = json.loads((cases / "bunny_mirror.json").read_text())["faces_of_A_that_meet"]
    found = json.loads(study("bunny", str(cases / "bun_zipper.ply"), "--json"))
    expect(found["faces_of_A_that_meet"] == wanted and found["wrong"] == 0, "bunny: faces that meet")


def interrupted_all(folder):
    """What is complete is in the report; without --out it is in fmb-report."""
    run = watched.Watched([program], cwd=folder)
    run.at_work()
    run.child.send_signal(signal.SIGINT)
    code, _, errors = run.end()
    expect(code == 2 and not errors, f"Ctrl-C: {code} {errors}")
    table = json.loads((folder / "fmb-report" / "report.json").read_text())
    expect(table["study"] == "table1" and not table["complete"], "Ctrl-C: fmb-report/report.json")
    expect("Interrupted" in (folder / "fmb-report" / "report.html").read_text(), "Ctrl-C: nothing said")


def documented():
    text = man_page.read_text().replace("\\-", "-")
    wanted = {"--usage"}
    for name in ("all", *STUDIES, "benchmark", "run", "merge", "bias", "plots", "leaderboard"):
        help_text = subprocess.run([program, name, "--help"], capture_output=True, text=True).stdout
        wanted |= set(re.findall(r"^ +(?:-\w, |-\?, )?(--[a-z-]+)", help_text, re.M))
        expect(re.search(rf"^\.B \"?fmb-qualify {name}\b|^\.B {name}$", text, re.M),
               f"man page: {name} is missing")
    wanted -= {"--usage"}
    found = set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text))
    expect(len(wanted) > 15, "--help was not understood")
    expect(wanted <= found, f"man page: {sorted(wanted - found)} missing")
    expect(found <= wanted | {"--usage"}, f"man page: {sorted(found - wanted)} are no options")


with tempfile.TemporaryDirectory() as name:
    root = pathlib.Path(name)
    if "every" in sys.argv[3:]:
        whole_report(root)
    else:
        exit_codes(root)
        report(root)
        bare_numbers(root)
        without_tools(root)
        machine()
        tables()
        stopped()
        files(root)
        merged(root)
        interrupted(root)
        verdicts()
        article()
        one_report(root)
        scan()
        interrupted_all(root)
        documented()
print("\n".join(faults) or "fmb-qualify: no faults")
sys.exit(bool(faults))
