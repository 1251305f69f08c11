"""fmb-validate from outside: exit codes, the table, JSON, shards and threads, Ctrl-C, the man page.
usage: validate.py FMB_VALIDATE MAN_PAGE"""

import json
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

import watched

program, man_page = sys.argv[1], pathlib.Path(sys.argv[2])
CASES = ["2d-static", "2d-dynamic", "3d-static", "3d-dynamic"]
# Of pairs that meet [%], as the article found it.
SHARE = dict(zip(CASES, (23.35, 37.22, 15.75, 26.19)))
faults = []


def expect(good, what):
    if not good:
        faults.append(what)


def run(*args):
    return subprocess.run([program, *args], capture_output=True, text=True)


def counts(*args):
    """What is counted, without the time and the share that was asked for."""
    got = run("--json", "-", *args)
    expect(got.returncode == 0 and not got.stderr, f"{args}: {got.returncode} {got.stderr}")
    report = json.loads(got.stdout)
    expect(report["complete"] and report["disagreements"] == 0, f"{args}: {report}")
    return report["cases"]


def exit_codes(folder):
    for args, code in ((["2d"], 64), (["0d-static"], 64), (["17d-static"], 64), (["--dim", "0"], 64),
                       (["--dim", "17"], 64), (["--pairs", "0"], 64), (["--pairs", "-1"], 64),
                       (["--families", "easy"], 64), (["--seed", "x"], 64), (["--sample", "2"], 64), (["--textbook", "-1"], 64),
                       (["--shard", "3/2"], 64), (["--shard", "0/2"], 64), (["--shard", "1"], 64),
                       (["--seed", str(1 << 63)], 64), (["--families", ","], 64), (["--dim", ""], 64),
                       (["--simd", "mmx"], 64), (["--threads", "0"], 64), (["--axes", "3,3", "--dim", "2"], 64),
                       (["--pairs", "1", "--json", str(folder)], 74), (["--nonsense"], 64),
                       (["--pairs", "1", "--failures", str(folder / "no" / "x")], 74),
                       (["--version"], 0), (["--help"], 0)):
        got = run(*args)
        expect(got.returncode == code, f"{args}: exit code {got.returncode}, not {code}")
        if code == 64 and len(args) > 1:
            expect(f": {args[0]}: " in got.stderr, f"{args}: which option? {got.stderr}")


def instructions():
    """Kernels that this processor or this build lacks are told from what is wrong elsewhere."""
    for level in ("avx2", "avx512"):
        got = run("--simd", level, "--pairs", "1", "2d-static")
        told = f": --simd: this processor, or this build of the library, has no {level}\n" in got.stderr
        lacking = got.returncode == 64 and told
        expect(lacking or got.returncode == 0, f"--simd {level}: {got.returncode} {got.stderr}")


def table():
    got = run("--pairs", "500")
    lines = got.stdout.splitlines()
    expect(got.returncode == 0 and not got.stderr, f"table: {got.returncode} {got.stderr}")
    expect(len(lines) == 5 and len({len(line) for line in lines}) == 1,
           "the table does not line up:\n" + got.stdout)
    expect([line.split()[0] for line in lines[1:]] == CASES, "cases of the table")
    for line in lines[1:]:
        _, family, tested, meeting, apart, share, *_, wrong = line.split()
        expect(family == "article" and tested == "500" and wrong == "0", line)
        expect(int(meeting) + int(apart) == 500 and float(share) == int(meeting) / 5, line)


def shares():
    """Within five standard deviations; the whole run, of 1,000,000, is far closer."""
    for case in counts("--pairs", "20000"):
        found = 100 * case["meeting"] / case["tested"]
        expect(abs(found - SHARE[case["case"]]) < 1.7, f"{case['case']}: {found} % meet")
        expect(case["exact"] > 100 and case["touching"] == 0, f"{case['case']}: {case}")


def add_up(parts):
    total = parts[0]
    for part in parts[1:]:
        for case, more in zip(total, part):
            for key, n in more.items():
                if key == "faults":
                    case[key] = {name: case[key][name] + n[name] for name in n}
                elif key == "excess":
                    case[key] = max(case[key], n)
                elif not isinstance(n, str):
                    case[key] += n
    return total


def shards_and_threads():
    args = ["--pairs", "601", "2d-dynamic", "3d-static", "--families", "article,near,lattice",
            "--sample", "0.2"]
    whole = counts(*args)
    expect([(c["case"], c["family"]) for c in whole] ==
           [(c, f) for c in ("2d-dynamic", "3d-static") for f in ("article", "lattice", "near")],
           "the order of cases and families")
    held = lambda share: sum(c["textbook"] + c["textbook_left"] for c in counts(*args, "--textbook", share))
    expect(held("0") == 0 < held("0.3") < held("1") == sum(c["exact"] for c in whole), "--textbook")
    expect(add_up([counts(*args, "--shard", f"{i}/3") for i in (1, 2, 3)]) == whole, "shards")
    expect(counts(*args, "--threads", "3") == whole, "threads")
    expect(counts(*args, "--simd", "plain") == whole, "plain kernels say the same")
    expect(counts(*args, "--seed", "2") != whole, "another seed")


def merged(folder):
    """The files of all shards make what one run makes, to the byte; anything else is refused."""
    args = ["--pairs", "301", "2d-dynamic", "3d-static", "--families", "article,near", "--sample", "0.2", "--boxes"]
    parts = [str(folder / f"part{i}") for i in (1, 2, 3)]
    for i, part in enumerate(parts):
        run(*args, "--shard", f"{i + 1}/3", "--json", part)
    once, whole = run("--json", "-", *args).stdout, run("--json", "-", "--merge", *reversed(parts))
    expect(whole.returncode == 0 and not whole.stderr, f"--merge: {whole}")
    bare = lambda text: re.sub(r'"seconds": ?[^,]*,', "", text)
    expect(bare(once) == bare(whole.stdout) and '"cases"' in bare(once), f"--merge: {whole.stdout} instead of {once}")
    expect(run("--merge", *parts).stdout.splitlines()[1:] == run(*args).stdout.splitlines()[1:], "--merge: the table")
    other = str(folder / "other")
    run(*args, "--shard", "3/3", "--seed", "2", "--json", other)
    for words, code in ((parts[:2], 65), ([*parts[:2], parts[0]], 65), ([*parts[:2], other], 65), ([], 64),
                        ([*parts[:2], str(folder / "none")], 66), ([program], 65)):
        got = run("--merge", *words)
        expect(got.returncode == code and got.stderr.count("\n") == 1, f"--merge {words}: {got.returncode} {got.stderr}")
    wrong = json.loads(pathlib.Path(parts[0]).read_text())
    wrong["cases"][0]["disagreeing"] += 1
    pathlib.Path(parts[0]).write_text(json.dumps(wrong))
    expect(run("--merge", *parts).returncode == 1, "a disagreement of a shard is forgotten")


def every_family():
    args = ["--families", "all", "--pairs", "25", "--boxes", "--textbook", "1"]
    for case in counts(*args, "2d-static", "3d-dynamic"):
        expect(case["exact"] == 25 or case["family"] == "article", f"{case} is not held to exact")
        expect(case["boxes"] == case["meeting"] or case["family"] == "article", f"{case}: boxes")
        expect(case["excess"] <= 1e-12, f"{case}: excess")
        expect(case["textbook"] == case["exact"] and case["textbook_left"] == 0, f"{case}: textbook")
    for case in counts("--families", "near,degenerate", "--pairs", "10", "--dim", "1,4", "--textbook", "1"):
        expect(case["exact"] == 10 == case["textbook"] + case["textbook_left"], str(case))
    counts("--families", "lattice,touching", "--axes", "2,1", "--pairs", "40", "3d-static")


def files(folder):
    report, failures = folder / "report.json", folder / "failures.jsonl"
    got = run("--pairs", "50", "2d-static", "--json", str(report), "--failures", str(failures))
    expect(got.returncode == 0 and "2d-static" in got.stdout, "table beside files")
    expect(json.loads(report.read_text())["cases"][0]["tested"] == 50, "report.json")
    expect(failures.read_text() == "", "failures that are none")


def unwritable(folder):
    """It is noticed at once, not after an hour."""
    for option in ("--json", "--failures"):
        got = subprocess.run([program, "--pairs", "1000000000000", option, str(folder)],
                             capture_output=True, text=True)
        expect(got.returncode == 74 and not got.stdout and
               got.stderr == f"fmb-validate: {folder}: Is a directory\n", f"{option}: {got}")


def seeds():
    for seed in (0, (1 << 63) - 1):
        got = run("--json", "-", "--pairs", "1", "--seed", str(seed), "2d-static")
        expect(json.loads(got.stdout)["seed"] == seed, f"seed {seed}: {got.stdout}")


def interrupted():
    run = watched.Watched([program, "--pairs", "1000000000", "--threads", "2", "--json", "-"])
    run.at_work()
    run.child.send_signal(signal.SIGINT)
    code, text, errors = run.end()
    expect(code == 2 and not errors, f"Ctrl-C: {code} {errors}")
    report = json.loads(text)
    expect(not report["complete"] and report["disagreements"] == 0, f"Ctrl-C: {report}")
    expect(report["cases"][0]["tested"] > 0 == report["cases"][3]["tested"], f"Ctrl-C: {report}")


def documented():
    options = set(re.findall(r"--([a-z-]+)", run("--help").stdout)) - {"help", "usage", "version"}
    text = man_page.read_text().replace("\\-", "-")
    for option in options:
        expect(f"--{option}" in text, f"the man page does not tell --{option}")


with tempfile.TemporaryDirectory() as name:
    here = pathlib.Path(name)
    exit_codes(here)
    instructions()
    table()
    shares()
    shards_and_threads()
    merged(here)
    every_family()
    files(here)
    unwritable(here)
    seeds()
    interrupted()
    documented()
print("\n".join(faults) or "fmb-validate: no faults")
sys.exit(1 if faults else 0)
