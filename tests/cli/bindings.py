#!/usr/bin/env python3
"""A program of docs/examples/bindings says what it should: bindings.py COMMAND [ARGUMENT...]."""

import subprocess
import sys

SHADOW = {"+3 x1 +1 x3 <= 6", "-1 x3 <= 0"}


def answer(right):
    done = subprocess.run(sys.argv[1:] + [right], capture_output=True, text=True, timeout=100)
    if done.returncode == 77:
        sys.exit(77)
    if done.returncode != 0:
        sys.exit(f"ended with {done.returncode}: {done.stderr}")
    return done.stdout.splitlines()


def main():
    first, *shadow = answer("0")
    word, *numbers = first.split()
    wrong = [] if set(shadow) == SHADOW else [shadow]
    # The ring says that all of its variables are equal.
    if word != "feasible:" or len(numbers) != 4 or len(set(numbers) - {"..."}) != 1:
        wrong.append(first)
    *conflict, third, fourth = answer("-1")
    if conflict != ["infeasible: 100 rows in conflict", "1 * row 0", "1 * row 19999"]:
        wrong.append(conflict)
    if {third, fourth} != SHADOW:
        wrong.append([third, fourth])
    return f"not expected: {wrong}" if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
