"""check_whole.py: judge a claim `whole` (docs/proof-format.md) by Python's rationals and sets alone."""
from fractions import Fraction as Q


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def rank(rows):
    rows, found = [[Q(a) for a in row] for row in rows], 0
    for c in range(len(rows[0]) if rows else 0):
        pivot = next((row for row in rows[found:] if row[c]), None)
        if pivot:
            rows.remove(pivot)
            rows.insert(found, pivot)
            found += 1
            for row in rows[found:]:
                row[:] = [a - row[c] / pivot[c] * b for a, b in zip(row, pivot)]
    return found


def is_opposite(v, w):
    return rank([v, w]) <= 1 and (dot(v, w) < 0 or not any(v))


def whole(rows, claims, kept, _):  # rows and claims as check_proof.read gives them; kept: variables
    forms, equations, corners = [([0] * len(kept) + [1], True)], [], []  # t >= 0, not at infinity
    for (kind, *head), p in claims:
        if kind == "implied" and {j for j, a in p["term"].items() if a} <= set(kept):
            form = [-p["term"].get(j, 0) for j in kept] + [Q(head[1])]
            if head[0] == "=":
                equations.append(form)
            else:
                forms.append((form, head[0] == "<"))
        if kind == "corner":
            corners.append((p["ray"], 0) if any(p["ray"].values()) else (p["point"], 1))
    vectors = [[x.get(j, 0) for j in kept] + [t] for x, t in corners]
    zero = [frozenset(g for g, v in enumerate(vectors) if dot(form, v) == 0) for form, _ in forms]
    inside = [{g for g, (x, t) in enumerate(corners)
               if sum(a * x.get(j, 0) for j, a in enumerate(left, 1)) < right * t}
              for left, rel, right in rows.values() if rel == "<"]
    free = frozenset.intersection(*zero)
    directions = [vectors[g] for g in free]

    def shown(f):
        return any(f <= z for z, (_, strict) in zip(zero, forms) if strict) or all(f & i for i in inside)

    def closed(f, dimension):
        if dimension < 2 or not shown(f):
            return dimension == 1 and len(f) == 1 and shown(f)
        cuts = {f & z for z in zero} - {f, frozenset()}
        facets = [c for c in cuts if not any(c < d for d in cuts)]
        return (len(facets) > 1 and all(closed(m, dimension - 1) for m in facets)
                and all(c in facets or sum(c < m for m in facets) > 1 for c in cuts))

    return (all(any(is_opposite(v, w) for w in directions) for v in directions) and
            closed(frozenset(range(len(vectors))) - free,
                   len(kept) + 1 - rank(equations) - rank(directions)))
