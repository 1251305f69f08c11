"""The tasks of tasks.py with pycddlib 3, written from its documentation: it is no Debian package, and this
was not run. It knows no strict rows."""

import re
from fractions import Fraction

import cdd.gmp as cdd


def matrix(A, b):
    rows = [[right] + [-c for c in row] for row, right in zip(A, b)]
    return cdd.matrix_from_array(rows, rep_type=cdd.RepType.INEQUALITY)


def solved(A, b, c=None):
    m = matrix(A, b)
    m.obj_type = cdd.LPObjType.MAX
    m.obj_func = [0] + (c or [0] * len(A[0]))
    lp = cdd.linprog_from_matrix(m)
    cdd.linprog_solve(lp)
    return lp


def generators(A, b):
    return cdd.copy_generators(cdd.polyhedron_from_matrix(matrix(A, b))).array


def hull_of(points):
    rows = [[1, *x] for x in points]
    m = cdd.matrix_from_array(rows, rep_type=cdd.RepType.GENERATOR)
    return cdd.copy_inequalities(cdd.polyhedron_from_matrix(m))


def corners(A, b):
    return [row[1:] for row in generators(A, b) if row[0] == 1]


def feasible(A, b):
    return solved(A, b).status == cdd.LPStatusType.OPTIMAL


def solution(A, b):
    return solved(A, b).primal_solution


def conflict(A, b):
    kept = list(range(len(A)))
    for i in range(len(A)):
        rest = [k for k in kept if k != i]
        if not feasible([A[k] for k in rest], [b[k] for k in rest]):
            kept = rest
    return kept


def multipliers(A, b):
    lp = solved(A, b)
    return {i - 1: abs(value) for i, value in lp.dual_solution if value}


def intervals(A, b):
    out = []
    for j in range(len(A[0])):
        unit = [int(i == j) for i in range(len(A[0]))]
        low, high = solved(A, b, [-c for c in unit]), solved(A, b, unit)
        out.append((-low.obj_value if low.status == cdd.LPStatusType.OPTIMAL else None,
                    high.obj_value if high.status == cdd.LPStatusType.OPTIMAL else None))
    return out


def optimum(A, b, c):
    lp = solved(A, b, c)
    return lp.obj_value, lp.primal_solution


def redundant(A, b):
    return sorted(cdd.redundant_rows(matrix(A, b)))


def projection(A, b):
    m = cdd.block_elimination(matrix(A, b), {3, 4, 5, 6})
    cdd.matrix_canonicalize(m)
    return m


def vertices(A, b):
    return corners(A, b)


def hull(points):
    return hull_of(points)


def inclusion(A, b, C, d):
    for row, right in zip(C, d):
        lp = solved(A, b, row)
        if lp.status != cdd.LPStatusType.OPTIMAL or lp.obj_value > right:
            return False
    return True


def equality(A, b, C, d):
    return inclusion(A, b, C, d) and inclusion(C, d, A, b)


def common_point(A, b, C, d):
    return solved(A + C, b + d).primal_solution


def minkowski_sum(A, b, C, d):
    return hull_of([[s + t for s, t in zip(x, y)] for x in corners(A, b) for y in corners(C, d)])


def image(A, b):
    return hull_of([(x + y - z, x - 2 * y) for x, y, z in corners(A, b)])


def union_hull(A, b, C, d):
    return hull_of(corners(A, b) + corners(C, d))


def dimension(A, b):
    m = matrix(A, b)
    cdd.matrix_canonicalize(m)
    return len(A[0]) - len(m.lin_set)


def from_text(text):
    names = sorted(set(re.findall(r"[a-z]\w*", text)))
    A, b = [], []
    for row in text.split(";"):
        left, sign, right = re.split("(<=|>=)", re.sub(r"(\d)\s*([a-z])", r"\1*\2", row))
        turn = 1 if sign == "<=" else -1

        def at(point):
            known = dict(zip(names, point))
            return turn * (eval(left, known) - eval(right, known))
        zero = at([0] * len(names))
        A.append([at([int(i == j) for i in range(len(names))]) - zero for j in range(len(names))])
        b.append(-zero)
    return dict(zip(names, map(Fraction, solved(A, b).primal_solution)))


def ray(A, b):
    return next(row[1:] for row in generators(A, b) if row[0] == 0)
