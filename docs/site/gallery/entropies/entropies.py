"""The elemental Shannon inequalities of so many random variables: entropies.py A B C > three.fmb

hAB is the joint entropy of A and B. All Shannon inequalities are sums of these rows, which no
smaller set replaces (Yeung 1997)."""

import itertools
import sys

names = sys.argv[1:]


def h(*subset):
    """The entropy of a set of variables, with its name in one order."""
    return "h" + "".join(sorted(subset)) if subset else "0"


subsets = [s for k in range(1, len(names) + 1) for s in itertools.combinations(names, k)]
print("vars:", *(h(*s) for s in subsets))
for x in names:
    rest = [y for y in names if y != x]
    print(f"H({x}|{''.join(rest)}): {h(*names)} - {h(*rest)} >= 0")
for x, y in itertools.combinations(names, 2):
    others = [z for z in names if z not in (x, y)]
    for k in range(len(others) + 1):
        for z in itertools.combinations(others, k):
            given = "|" + "".join(z) if z else ""
            print(f"I({x},{y}{given}): {h(x, *z)} + {h(y, *z)} - {h(x, y, *z)} - {h(*z)} >= 0")
