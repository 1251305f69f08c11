"""Twenty everyday tasks: what is given, and when an answer is right. Answers that may differ, as a point
or a conflict, are judged; all others are one and the same."""

import random
from fractions import Fraction
from math import gcd


def box(n, low, high):
    """low <= x_j <= high."""
    unit = [[int(i == j) for j in range(n)] for i in range(n)]
    return unit + [[-c for c in row] for row in unit], [high] * n + [-low] * n


def drawn(seed, n, m, high=9):
    """m rows that hold at 0, and a box."""
    draw = random.Random(seed)
    A, b = box(n, -20, 20)
    return (A + [[draw.randint(-high, high) for _ in range(n)] for _ in range(m)],
            b + [draw.randint(5, 60) for _ in range(m)])


def infeasible(seed, n, m):
    """Rows of which some say x1 + ... + xn <= -1 <= 1 <= x1 + ... + xn."""
    A, b = drawn(seed, n, m)
    half = [int(j % 2 == 0) for j in range(n)]
    other = [1 - h for h in half]
    return A + [half, other, [-1] * n], b + [-1, -2, 1]


# ---- right or wrong ------------------------------------------------------------------------------


def holds(A, b, x):
    return all(sum(c * t for c, t in zip(row, x)) <= right for row, right in zip(A, b))


def is_point(A, b, *more):
    if more:
        A, b = A + more[0], b + more[1]
    return lambda x: holds(A, b, x)


def is_conflict(A, b):
    """No solution; and one without each of the rows, as Farkas' lemma tells by the judge's own lists."""
    import fmb
    def meets(rows):
        return bool(fmb.solve(fmb.System.from_arrays([A[i] for i in rows], [b[i] for i in rows])))
    return lambda rows: not meets(rows) and all(meets([k for k in rows if k != i]) for i in rows
                                                if len(rows) > 1)


def is_proof(A, b):
    def judge(found):
        sums = [sum(found[i] * A[i][j] for i in found) for j in range(len(A[0]))]
        return not any(sums) and sum(found[i] * b[i] for i in found) < 0 and min(found.values()) >= 0
    return judge


def is_best(A, b, c):
    return lambda found: (holds(A, b, found[1]) and
                          sum(x * y for x, y in zip(c, found[1])) == found[0] and found[0])


def is_ray(A, b):
    return lambda r: any(r) and holds(A, [0] * len(b), r)


def normal(rows):
    """Rows (coefficients, right side, relation) as a set of integers without a common divisor."""
    out = set()
    for a, right, relation in rows:
        numbers = [Fraction(x) for x in (*a, right)]
        size = 1
        for x in numbers:
            size = size * x.denominator // gcd(size, x.denominator)
        whole = [int(x * size) for x in numbers]
        common = gcd(*whole) or 1
        if relation == "=" and next((x for x in whole if x), 1) < 0:
            common = -common
        out.add((*(x // common for x in whole), relation))
    return out


def in_rows(result):
    """Of fmb, of PPL, or as a list, as such a set."""
    if isinstance(result, list):
        return normal(result)
    if hasattr(result, "system"):
        s = result.system
        return normal([([row.coefficients.get(name, 0) for name in s.names], row.right, row.relation)
                       for row in s])
    return normal([([-int(c) for c in row.coefficients()] + [0] * (dim_of(result) - len(
        row.coefficients())), int(row.inhomogeneous_term()), "=" if row.is_equality() else "<=")
        for row in result])


def dim_of(constraints):
    return max(len(row.coefficients()) for row in constraints)


# ---- the tasks -----------------------------------------------------------------------------------

ROWS = drawn(1, 6, 30)
SMALL, OTHER = drawn(2, 3, 8), drawn(3, 3, 8)
MOVED = (OTHER[0], [right + 3 * sum(row) for row, right in zip(*OTHER)])
CONE = ([[c if sum(x * y for x, y in zip(row, (1, 2, 1, 3))) <= 0 else -c for c in row]
         for row in drawn(4, 4, 12)[0][8:]], [0] * 12)
POINTS = [[random.Random(k).randint(-50, 50), random.Random(-k - 1).randint(-50, 50)] for k in range(60)]
FLAT = (ROWS[0] + [[1, 1, 1, 1, 1, 1], [-2, -2, -2, -2, -2, -2], [1, -1, 0, 0, 0, 0], [-1, 1, 0, 0, 0, 0]],
        ROWS[1] + [1, -2, 0, 0])
OPEN = ([[1, -1, 0], [0, 1, -1], [-1, 0, 1], [1, 1, 1]], [0, 0, 0, 9])
TEXT = "2x + y <= 13; x - 3y <= 4; 2z - x <= 6; x + y + z >= 5; y <= 2z; z >= 0"


def solves_text(found):
    x, y, z = (found[name] for name in "xyz")
    return 2 * x + y <= 13 and x - 3 * y <= 4 and 2 * z - x <= 6 and x + y + z >= 5 and y <= 2 * z and z >= 0


# name, question, what is given, and what makes answers comparable
TASKS = [
    ("feasible", "Is there a solution?", ROWS, bool),
    ("solution", "A solution", ROWS, is_point(*ROWS)),
    ("conflict", "Which rows are in conflict?", infeasible(5, 6, 20), is_conflict(*infeasible(5, 6, 20))),
    ("multipliers", "A proof that there is none (Farkas)", infeasible(6, 6, 20), is_proof(*infeasible(6, 6, 20))),
    ("intervals", "The interval of each variable", ROWS, list),
    ("optimum", "The best value, and where", (*ROWS, [3, -2, 5, 1, 0, 4]), is_best(*ROWS, [3, -2, 5, 1, 0, 4])),
    ("redundant", "Which rows are redundant?", ROWS, sorted),
    ("projection", "The projection on two of six variables", ROWS, in_rows),
    ("vertices", "All vertices", SMALL, lambda found: sorted(map(tuple, found))),
    ("hull", "The convex hull of 60 points of the plane", (POINTS,), in_rows),
    ("inclusion", "Does one polyhedron lie in another?", (*SMALL, *box(3, -20, 20)), bool),
    ("equality", "Are two polyhedra the same?", (*SMALL, SMALL[0][::-1], SMALL[1][::-1]), bool),
    ("common_point", "A common point of two", (*SMALL, *MOVED), is_point(*SMALL, *MOVED)),
    ("minkowski_sum", "The Minkowski sum of two", (*SMALL, *OTHER), in_rows),
    ("image", "The image under a linear map", SMALL, in_rows),
    ("union_hull", "The hull of two together", (*SMALL, *MOVED), in_rows),
    ("strict", "Strict rows: is there a solution?", OPEN, bool),
    ("dimension", "The dimension, with hidden equations", FLAT, int),
    ("from_text", "A solution of rows as text", (TEXT,), solves_text),
    ("ray", "A direction without an end", CONE, is_ray(*CONE)),
]
