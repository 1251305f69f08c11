"""Rules from a shared object: fmb-qualify counts their wrong answers, fmb uses them, and says what is
wrong with a file that is none.
usage: rule_library.py FMB_QUALIFY FMB SAME_ROWS LIAR BADLY_NAMED"""

import json
import pathlib
import subprocess
import sys
import tempfile

qualify, fmb, same_rows, liar, badly_named = sys.argv[1:]
faults = []
SMALL = ["--dim", "2", "--motion", "static", "--kinds", "CC", "--pairs", "6", "--orders", "given",
         "--passes", "0"]
# x and y are pressed together until nothing is left.
EMPTY = "vars: x y z\nx + y <= 1\nx - y <= 0\ny - x <= 0\nx >= 1\nz <= 5\n-z <= x\n"


def expect(good, what):
    if not good:
        faults.append(what)


def run(*words):
    return subprocess.run(words, capture_output=True, text=True)


def wrong(library, *sets):
    """Wrong answers by set of rules, and the exit code."""
    words = [word for s in sets for word in ("--rules", s)]
    got = run(qualify, "rules", *SMALL, "--rule-library", library, *words, "--json")
    found = {}
    for line in json.loads(got.stdout)["classes"]:
        found[line["rules"]] = found.get(line["rules"], 0) + line["wrong"]
        expect(line["refused"] == 0 and line["n"] > 0, f"{library}: {line}")
    return found, got.returncode


def studies():
    found, code = wrong(same_rows, "same-rows", "same-rows,kohler", "kohler")
    expect(code == 0 and found == {"none": 0, "same-rows": 0, "same-rows,kohler": 0, "kohler": 0}, f"honest: {found}")
    found, code = wrong(liar, "liar", "kohler")
    expect(code == 1 and found["liar"] > 0 == found["none"] == found["kohler"], f"liar: {found}")
    found, _ = wrong(liar)
    expect(found["liar"] > 0 and "imbert,box" in found, f"without --rules: {found}")


def smallest(folder):
    """The first wrong answer comes with a system of which no row can be left out; right ones with none."""
    words = [qualify, "rules", *SMALL, "--rule-library", liar, "--json"]
    told = json.loads(run(*words, "--rules", "liar", "--out", folder).stdout)["wrong_system"]
    file = folder / "rules-wrong.fmb"
    expect([line["row"] for line in told] == file.read_text().splitlines(), f"{told}")
    lines = file.read_text().splitlines()
    expect(lines[0] == "vars: c1 c2" and lines[1] == "project: c2" and 2 < len(lines) < 8, f"{lines}")
    for k in range(2, len(lines)):
        file.write_text("\n".join(lines[:k] + lines[k + 1:]) + "\n")
        got = run(qualify, "rules", file, *SMALL[8:], "--rule-library", liar, "--rules", "liar")
        expect(got.returncode == 0, f"without {lines[k]}: {got}")
    expect("wrong_system" not in json.loads(run(*words, "--rules", "kohler").stdout), "right ones")


def command(folder):
    file = folder / "empty.fmb"
    file.write_text(EMPTY)
    words = [fmb, "solve", file, "--method", "fm", "--presolve", "none", "--order", "given", "--json"]
    for library, rules, code in ((same_rows, "same-rows,kohler", 1), (same_rows, "same-rows", 1), (liar, "liar", 0)):
        got = run(*words, "--rule-library", library, "--rules", rules)
        expect(got.returncode == code and not got.stderr, f"{rules}: {got.returncode} {got.stderr}")
    proof = folder / "proof"
    run(*words[:-1], "--rule-library", liar, "--rules", "liar", "--proof", proof)
    checked = run(fmb, "check", file, proof)
    expect(checked.returncode == 1 and "violates" in checked.stdout + checked.stderr, f"the checker believes it: {checked}")
    got = run(*words, "--rule-library", same_rows, "--rules", "mine")
    expect(got.returncode == 64 and "same-rows" in got.stderr, got.stderr)


def orders(folder):
    """An order of the library's beside those that are built in: fewer rows than in the given one."""
    got = run(qualify, "rules", "--dim", "3", *SMALL[2:8], "--orders", "given,look-ahead", "--passes", "0",
              "--rule-library", same_rows, "--rules", "kohler", "--json", "--out", folder)
    found = json.loads(got.stdout)
    expect(got.returncode == 0 and found["orders"] == ["given", "look-ahead"], f"orders: {got}")
    expect(found["order-look-ahead"] and not any(line["wrong"] for line in found["order-look-ahead"]), "look-ahead")
    expect(",look-ahead," in (folder / "rules-runs.csv").read_text(), "no runs of look-ahead")
    file = folder / "thin.fmb"
    file.write_text("".join(f"x{i} + x{j} <= {i + j}\n{i} - x{i} <= x{j}\n" for i in range(1, 7) for j in range(i)))
    words = [fmb, "solve", file, "--method", "fm", "--presolve", "none"]
    got = run(*words, "--order", "look-ahead", "--rule-library", same_rows)
    expect(got.returncode in (0, 1) and not got.stderr, f"look-ahead: {got}")
    for library, word, why in ((liar, "lost", "not on offer"), (same_rows, "mine", "given|min|fill|look-ahead, found 'mine'")):
        got = run(*words, "--order", word, "--rule-library", library)
        expect(got.returncode == 64 and why in got.stderr, f"--order {word}: {got}")
        got = run(qualify, "rules", *SMALL, "--orders", word, "--rule-library", library)
        expect(got.returncode == 64 and why in got.stderr, f"--orders {word}: {got}")


def faulty(folder):
    text = folder / "text.so"
    text.write_text(100 * "no library\n")
    for path, why in ((folder / "none.so", "No such file"), ("none.so", "as ./mine.so"), (text, "invalid ELF header"),
                      (badly_named, "one that the library uses")):
        for words in ([qualify, "rules", *SMALL], [fmb, "solve", "-"]):
            got = run(*words, "--rule-library", path)
            expect(got.returncode == 66 and why in got.stderr and got.stderr.count("\n") == 1, f"{path}: {got}")


with tempfile.TemporaryDirectory() as name:
    studies()
    smallest(pathlib.Path(name))
    command(pathlib.Path(name))
    orders(pathlib.Path(name))
    faulty(pathlib.Path(name))
print("\n".join(faults) or "rule library: no faults")
sys.exit(bool(faults))
