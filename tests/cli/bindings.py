#!/usr/bin/env python3
"""A program of docs/examples/bindings says what it should, and is short: bindings.py SOURCE COMMAND
[ARGUMENT...]. Of Python, ends with 77 where cffi or gcc is missing."""

import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys

LINES, COLUMNS = 30, 100
# Neither code nor statements: blank lines, comments, docstrings of a line, what is included, braces alone.
NO_CODE = re.compile(r'\s*($|//|#|\*|/\*|[{}];?$|import |from |""")')


def run(right):
    return subprocess.run(sys.argv[2:] + [right], capture_output=True, text=True, timeout=100)


def answer(right):
    done = run(right)
    if done.returncode != 0:
        sys.exit(f"ended with {done.returncode}: {done.stderr}")
    return done.stdout.splitlines()


def wrong_with_source(path):
    lines = path.read_text().splitlines()
    if (code := sum(not NO_CODE.match(line) for line in lines)) > LINES:
        yield f"{code} lines of code"
    for number, line in enumerate(lines, 1):
        if len(line) > COLUMNS:
            yield f"line {number} has {len(line)} columns"
        if "gmp" in line:
            yield f"line {number} needs GMP"


def wrong_answers():
    """The ring says x1 <= x2 <= ... <= x100 <= x1 + RIGHT."""
    for right in ("5", "0.75"):
        first, *shadow = answer(right)
        word, low, second, dots, high = first.split()
        good = word == "feasible:" and dots == "..."
        if not good or not float(low) <= float(second) <= float(high) <= float(low) + float(right):
            yield first
        if sorted(shadow) != ["+1 x1 -1 x51 <= 0", "+1 x51 -1 x100 <= 0",
                              {"5": "-1 x1 +1 x100 <= 5", "0.75": "-4 x1 +4 x100 <= 3"}[right]]:
            yield shadow
    if (said := answer("-1")) != ["infeasible: 100 rows, up to row 19999", "<= -1"]:
        yield said
    refused = run("nan")
    if refused.returncode == 0 or "row 19999: right side is nan" not in refused.stderr:
        yield refused.stderr


def main():
    source = pathlib.Path(sys.argv[1])
    if source.suffix == ".py" and not (importlib.util.find_spec("cffi") and shutil.which("gcc")):
        return 77
    wrong = [*wrong_with_source(source), *wrong_answers()]
    return f"not expected: {wrong}" if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
