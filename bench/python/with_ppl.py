"""The tasks of tasks.py with pplpy (Debian's python3-ppl)."""

import re
from fractions import Fraction
from math import lcm

from ppl import (C_Polyhedron, Constraint_System, Generator_System, Linear_Expression, MIP_Problem,
                 NNC_Polyhedron, Poly_Con_Relation, Variable, point)


def constraints(A, b):
    cs = Constraint_System()
    for row, right in zip(A, b):
        cs.insert(Linear_Expression(row, 0) <= right)
    return cs


def coordinates(generator):
    return [Fraction(int(c), int(generator.divisor())) for c in generator.coefficients()]


def corners(A, b):
    generators = C_Polyhedron(constraints(A, b)).minimized_generators()
    return [coordinates(g) for g in generators if g.is_point()]


def hull_of_points(points):
    gs = Generator_System()
    for x in points:
        gs.insert(point(Linear_Expression(x, 0)))
    return C_Polyhedron(gs).minimized_constraints()


def hull_of_fractions(points):
    gs = Generator_System()
    for x in points:
        size = lcm(*(c.denominator for c in x))
        gs.insert(point(Linear_Expression([int(c * size) for c in x], 0), size))
    return C_Polyhedron(gs).minimized_constraints()


def feasible(A, b):
    return not C_Polyhedron(constraints(A, b)).is_empty()


def solution(A, b):
    return coordinates(MIP_Problem(len(A[0]), constraints(A, b), 0).optimizing_point())


def conflict(A, b):
    kept = list(range(len(A)))
    for i in range(len(A)):
        rest = [k for k in kept if k != i]
        if C_Polyhedron(constraints([A[k] for k in rest], [b[k] for k in rest])).is_empty():
            kept = rest
    return kept


def multipliers(A, b):
    m = range(len(A))
    cs = Constraint_System()
    for i in m:
        cs.insert(Variable(i) >= 0)
    for column in zip(*A):
        cs.insert(Linear_Expression(list(column), 0) == 0)
    cs.insert(Linear_Expression(b, 0) == -1)
    found = coordinates(MIP_Problem(len(A), cs, 0).optimizing_point())
    return {i: c for i, c in enumerate(found) if c}


def intervals(A, b):
    p, out = C_Polyhedron(constraints(A, b)), []
    for j in range(len(A[0])):
        low, high = p.minimize(Variable(j) + 0), p.maximize(Variable(j) + 0)
        out.append((Fraction(int(low["inf_n"]), int(low["inf_d"])) if low["bounded"] else None,
                    Fraction(int(high["sup_n"]), int(high["sup_d"])) if high["bounded"] else None))
    return out


def optimum(A, b, c):
    problem = MIP_Problem(len(c), constraints(A, b), Linear_Expression(c, 0))
    best = coordinates(problem.optimizing_point())
    return sum(x * y for x, y in zip(c, best)), best


def redundant(A, b):
    out = []
    for i in range(len(A)):
        rest = [k for k in range(len(A)) if k != i and k not in out]
        p = C_Polyhedron(constraints([A[k] for k in rest], [b[k] for k in rest]))
        if p.relation_with(Linear_Expression(A[i], 0) <= b[i]).implies(
                Poly_Con_Relation.is_included()):
            out.append(i)
    return out


def projection(A, b):
    p = C_Polyhedron(constraints(A, b))
    p.remove_higher_space_dimensions(2)
    return p.minimized_constraints()


def vertices(A, b):
    return corners(A, b)


def hull(points):
    return hull_of_points(points)


def inclusion(A, b, C, d):
    return C_Polyhedron(constraints(C, d)).contains(C_Polyhedron(constraints(A, b)))


def equality(A, b, C, d):
    return C_Polyhedron(constraints(A, b)) == C_Polyhedron(constraints(C, d))


def common_point(A, b, C, d):
    return coordinates(MIP_Problem(len(A[0]), constraints(A + C, b + d), 0).optimizing_point())


def minkowski_sum(A, b, C, d):
    return hull_of_fractions([[s + t for s, t in zip(x, y)]
                              for x in corners(A, b) for y in corners(C, d)])


def image(A, b):
    return hull_of_fractions([(x + y - z, x - 2 * y) for x, y, z in corners(A, b)])


def union_hull(A, b, C, d):
    p = C_Polyhedron(constraints(A, b))
    p.poly_hull_assign(C_Polyhedron(constraints(C, d)))
    return p.minimized_constraints()


def strict(A, b):
    cs = Constraint_System()
    for row, right in zip(A, b):
        cs.insert(Linear_Expression(row, 0) < right)
    return not NNC_Polyhedron(cs).is_empty()


def dimension(A, b):
    return C_Polyhedron(constraints(A, b)).affine_dimension()


def from_text(text):
    names = sorted(set(re.findall(r"[a-z]\w*", text)))
    known = {name: Variable(j) for j, name in enumerate(names)}
    cs = Constraint_System()
    for row in text.split(";"):
        cs.insert(eval(re.sub(r"(\d)\s*([a-z])", r"\1*\2", row), known))
    return dict(zip(names, coordinates(MIP_Problem(len(names), cs, 0).optimizing_point())))


def ray(A, b):
    generators = C_Polyhedron(constraints(A, b)).minimized_generators()
    return next([int(c) for c in g.coefficients()] for g in generators if g.is_ray())
