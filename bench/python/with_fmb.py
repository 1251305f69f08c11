"""The tasks of tasks.py with fmb."""

import fmb
from fmb import Polyhedron, System


def feasible(A, b):
    return bool(fmb.solve(System.from_arrays(A, b)))


def solution(A, b):
    return list(fmb.solve(System.from_arrays(A, b)).point.values())


def conflict(A, b):
    return fmb.solve(System.from_arrays(A, b)).conflict.numbers


def multipliers(A, b):
    found = fmb.solve(System.from_arrays(A, b)).conflict
    return dict(zip(found.numbers, found.multipliers))


def intervals(A, b):
    return [(x.lower.value, x.upper.value) for x in fmb.bounds(System.from_arrays(A, b)).values()]


def optimum(A, b, c):
    best = fmb.optimize(System.from_arrays(A, b), max=c)
    return best.value, list(best.point.values())


def redundant(A, b):
    return fmb.reduce(System.from_arrays(A, b)).redundant


def projection(A, b):
    return fmb.project(System.from_arrays(A, b), "x1 x2")


def vertices(A, b):
    return fmb.vertices(System.from_arrays(A, b)).vertices


def hull(points):
    return fmb.hull(points)


def inclusion(A, b, C, d):
    return Polyhedron.from_arrays(A, b) <= Polyhedron.from_arrays(C, d)


def equality(A, b, C, d):
    return Polyhedron.from_arrays(A, b) == Polyhedron.from_arrays(C, d)


def common_point(A, b, C, d):
    return list((Polyhedron.from_arrays(A, b) & Polyhedron.from_arrays(C, d)).point().values())


def minkowski_sum(A, b, C, d):
    return fmb.sum(System.from_arrays(A, b), System.from_arrays(C, d))


def image(A, b):
    return fmb.image(System.from_arrays(A, b), "y1 = x1 + x2 - x3; y2 = x1 - 2x2")


def union_hull(A, b, C, d):
    return fmb.hull_of(System.from_arrays(A, b), System.from_arrays(C, d))


def strict(A, b):
    return bool(fmb.solve(System.from_arrays(A, b, "<")))


def dimension(A, b):
    return Polyhedron.from_arrays(A, b).affine_dim()


def from_text(text):
    return dict(fmb.solve(text).point)


def ray(A, b):
    return fmb.vertices(System.from_arrays(A, b)).rays[0]
