"""check_proof.py SYSTEM.ine PROOF: judge a proof (docs/proof-format.md) by Python's rationals alone."""
import shlex
import sys
from collections import defaultdict
from fractions import Fraction as Q

from check_steps import whole_by_steps
from check_whole import whole

RELATION = {"linearity": "=", "strict_inequality": "<"}


def read(ine, proof):  # rows {number: (left, relation, right)}, claims [(heading, numbers by part)]
    lines, claims, complete = [line.split() for line in open(ine)], [], False
    rel = {int(i): RELATION[l[0]] for l in lines if l and l[0] in RELATION for i in l[2:]}
    body = enumerate(lines[lines.index(["begin"]) + 2:lines.index(["end"])], 1)
    for word, *rest in filter(None, (shlex.split(line, comments=True) for line in open(proof))):
        if word == "claim":
            claims.append((rest, defaultdict(lambda: defaultdict(int))))
        elif word == "claims":
            complete = int(rest[0]) == len(claims)
        elif word in ("row", "reverse", "term", "point", "ray", "step", "implied"):
            claims[-1][1][word][int(rest[0].lstrip("x"))] = Q(rest[1])
    rows = {i: ([-Q(c) for c in r[1:]], rel.get(i, "<="), Q(r[0])) for i, r in body}
    return rows, claims if complete else []


def keeps(rows, x, direction=False):
    sides = [(sum(a * x[j] for j, a in enumerate(left, 1)) - (0 if direction else right), rel)
             for left, rel, right in rows.values()]
    return all(side < 0 and rel != "=" or side == 0 and rel != "<" for side, rel in sides)


def reverse(row):
    return [-a for a in row[0]], "<=", -row[2]


def proves(rows, p, goal):
    left, rel, right = goal
    if rel == "=":
        back = {"row": p["reverse"]}
        return proves(rows, p, (left, "<=", right)) and proves(rows, back, reverse(goal))
    allowed = all(i in rows and (m >= 0 or rows[i][1] == "=") for i, m in p["row"].items())
    used = [(m, *rows[i]) for i, m in p["row"].items()] if allowed else []
    slack = right - sum(m * b for m, _, _, b in used)
    strict = rel == "<=" or any(m > 0 and sign == "<" for m, _, sign, _ in used)
    return (allowed and left == [sum(m * a[j] for m, a, _, _ in used) for j in range(len(left))]
            and (slack > 0 or slack == 0 and strict))


def judge(rows, claims):
    dim, feasible = len(rows[1][0]), False
    gone = [int(head[1]) if head[0] == "redundant" else None for head, _ in claims]
    flat = [int(head[1]) if head[0] == "equality" else None for head, _ in claims]
    closed = {i: (a, "=" if rel == "=" else "<=", b) for i, (a, rel, b) in rows.items()}
    final = {i: (a, "=" if i in flat else rel, b) for i, (a, rel, b) in rows.items()}
    for n, ((kind, *head), p) in sorted(enumerate(claims), key=lambda c: (c[1][0] != ["feasible"], c[1][0][0] == "whole")):
        good = None
        if kind in ("equality", "redundant", "irredundant"):
            i = int(head[0])
            stay = {k: r for k, r in final.items() if k not in gone and k != i}
            later = {k: rows[k] for k in gone[n + 1:] if k and k not in gone[:n + 1]}
        if kind in ("bound", "unbounded"):
            sign = 1 if head[0] == "upper" else -1
            if len(head) == (4 if kind == "bound" else 2):  # of one variable
                p["term"][int(head.pop(1).lstrip("x"))] = 1
            form = [sign * p["term"].get(k, 0) for k in range(1, dim + 1)]
            at = {k: sum(c * p[k][j] for j, c in enumerate(form, 1)) for k in ("point", "ray")}
        if kind == "feasible":
            good = feasible = keeps(rows, p["point"])
        elif kind == "infeasible":
            good = proves(rows, p, ([0] * dim, "<", 0))
        elif kind == "bound":
            rel, value = head[1].replace(">", "<"), sign * Q(head[2])
            good = (proves(rows, p, (form, rel, value)) and at["point"] == value
                    and (feasible or rel == "<=")
                    and keeps(rows if rel == "<=" else closed, p["point"]))
        elif kind == "unbounded":
            good = feasible and keeps(closed, p["ray"], True) and at["ray"] > 0
        elif kind == "implied":
            terms = [p["term"].get(k, 0) for k in range(1, dim + 1)]
            good = proves(rows, p, (terms, head[0], Q(head[1])))
        elif kind == "equality":
            known = {k: final[k] if k in flat[:n] else r for k, r in rows.items()}
            good = rows[i][1] != "<" and proves(known, p, reverse(rows[i]))
        elif kind == "redundant":
            good = proves({**stay, **later}, p, rows[i])
        elif kind == "irredundant":
            good = keeps(stay, p["point"]) and not keeps({i: final[i]}, p["point"])
        elif kind == "corner":
            ray = any(p["ray"].values())
            good = keeps(closed, p["ray" if ray else "point"], ray) and not (ray and any(p["point"].values()))
        elif kind == "whole":  # the claims that it leans on have been judged
            by = whole_by_steps if any(p["step"].values()) else whole
            good = by(rows, claims, [int(name.lstrip("x")) for name in head], p["step"])
        elif kind == "follows":
            said = {k: ([q["term"].get(j, 0) for j in range(1, dim + 1)], h[1], Q(h[2]))
                    for k, (h, q) in enumerate(claims, 1) if h[0] == "implied"}
            goal = ([p["term"].get(k, 0) for k in range(1, dim + 1)], head[0], Q(head[1]))
            good = head[0] != "=" and proves(said, {"row": p["implied"]}, goal)
        if not good:
            return f"claim {n + 1} does not hold"
    return "accepted" if claims else "there is no claim, or some are missing"


if __name__ == "__main__":
    answer = judge(*read(sys.argv[1], sys.argv[2]))
    print(answer)
    sys.exit(answer != "accepted")
