"""check_steps.py: judge a claim `whole` that has steps (docs/proof-format.md) by Python's rationals and sets alone."""
from fractions import Fraction as Q


def plus(p, a, q, b):
    return [a * x + b * y for x, y in zip(p, q)]


def eliminate(rows, v):  # [(numbers, right side last; relation; numbers of inequalities)]
    equality = next((r for r in rows if r[1] == "=" and r[0][v]), None)
    if equality:
        rows.remove(equality)
        return [(plus(r[0], 1, equality[0], -r[0][v] / equality[0][v]), *r[1:]) for r in rows]
    stay = [r for r in rows if not r[0][v]]
    pairs = [(p, q, p[2] | q[2]) for p in rows if p[0][v] > 0 for q in rows if q[0][v] < 0]
    for p, q, of in sorted(pairs, key=lambda pair: len(pair[2])):
        if not any(r[1] != "=" and r[2] <= of for r in stay):
            rel = "<" if "<" in (p[1], q[1]) else "<="
            stay.append((plus(p[0], -q[0][v], q[0], p[0][v]), rel, of))
    return stay


def says(said, row):  # is said, as numbers and a relation, a multiple of row and as tight?
    (a, rel), (b, wanted) = said, row
    first = next((j for j, x in enumerate(b[:-1]) if x), None)
    if first is None or not a[first] or a[first] / b[first] < 0:
        return False
    factor = b[first] / a[first]
    slack = b[-1] - factor * a[-1]
    return (all(factor * x == y for x, y in zip(a[:-1], b[:-1]))
            and (slack > 0 or slack == 0 and (rel == "<" or wanted != "<")))


def whole_by_steps(rows, claims, kept, steps):
    dim = len(next(iter(rows.values()))[0])
    steps = {j: number for j, number in steps.items() if number}
    if set(steps) & set(kept):
        return False
    left = [([Q(x) for x in a] + [b], rel, frozenset() if rel == "=" else frozenset([i]))
            for i, (a, rel, b) in rows.items()]
    for v in sorted(steps, key=lambda j: steps[j]):
        left = eliminate(left, v - 1)
    about_kept = [all(j in kept or not a for j, a in p["term"].items()) for _, p in claims]
    said = []
    for n, ((kind, *head), p) in enumerate(claims):
        if kind in ("implied", "follows") and about_kept[n] and all(about_kept[i - 1] for i in p["implied"]):
            numbers = [p["term"].get(j, 0) for j in range(1, dim + 1)] + [Q(head[1])]
            said.append((numbers, head[0]))
            if head[0] == "=":
                said.append(([-x for x in numbers], "="))
    for numbers, rel, _ in left:
        for sign in (1, -1) if rel == "=" else (1,):
            row = [sign * x for x in numbers]
            if any(x and j not in kept for j, x in enumerate(row[:-1], 1)):
                return False
            if not any(row[:-1]):
                if not (row[-1] > 0 or row[-1] == 0 and rel != "<"):
                    return False
            elif not any(says(s, (row, rel)) for s in said):
                return False
    return True
