"""The tasks of tasks.py with SymPy, as far as it knows systems of inequalities in several variables: 1.13
and later have lpmax; the Debian package, 1.11, does not, and tasks that need it were not run."""

import sympy
from sympy import convex_hull, symbols


def solved(A, b, c=None):
    from sympy.solvers.simplex import lpmax
    x = symbols(f"x1:{len(A[0]) + 1}")
    rows = [sum(k * t for k, t in zip(row, x)) <= right for row, right in zip(A, b)]
    best, at = lpmax(sum(k * t for k, t in zip(c or [0] * len(x), x)), rows)
    return best, [at[t] for t in x]


def feasible(A, b):
    from sympy.solvers.simplex import InfeasibleLPError
    try:
        return bool(solved(A, b))
    except InfeasibleLPError:
        return False


def solution(A, b):
    return solved(A, b)[1]


def intervals(A, b):
    out = []
    for j in range(len(A[0])):
        unit = [int(i == j) for i in range(len(A[0]))]
        out.append((-solved(A, b, [-c for c in unit])[0], solved(A, b, unit)[0]))
    return out


def optimum(A, b, c):
    return solved(A, b, c)


def common_point(A, b, C, d):
    return solved(A + C, b + d)[1]


def hull(points):
    corners = convex_hull(*points).vertices
    rows = []
    for p, q in zip(corners, corners[1:] + corners[:1]):
        normal = (q.y - p.y, p.x - q.x)
        rows.append((normal, normal[0] * p.x + normal[1] * p.y, "<="))
    return rows


def inclusion(A, b, C, d):
    return all(solved(A, b, row)[0] <= right for row, right in zip(C, d))


def equality(A, b, C, d):
    return inclusion(A, b, C, d) and inclusion(C, d, A, b)


def from_text(text):
    from sympy.parsing.sympy_parser import (implicit_multiplication, parse_expr,
                                            standard_transformations)
    from sympy.solvers.simplex import lpmax
    ways = standard_transformations + (implicit_multiplication,)
    return {str(x): value for x, value in lpmax(
        sympy.S.Zero, [parse_expr(row, transformations=ways) for row in text.split(";")])[1].items()}
