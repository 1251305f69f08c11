"""The tasks of tasks.py with islpy, written from its documentation: it is no Debian package, and this was
not run. It answers over the integers; where that is another question, the task is left out."""

import islpy as isl


def a_set(A, b):
    names = [f"x{j + 1}" for j in range(len(A[0]))]
    rows = [" + ".join(f"{c} {x}" for c, x in zip(row, names)) + f" <= {right}" for row, right in zip(A, b)]
    return isl.BasicSet(f"{{ [{', '.join(names)}] : {' and '.join(rows)} }}")


def feasible(A, b):
    return not a_set(A, b).is_empty()


def solution(A, b):
    point = a_set(A, b).sample_point()
    return [int(str(point.get_coordinate_val(isl.dim_type.set, j))) for j in range(len(A[0]))]


def projection(A, b):
    return a_set(A, b).project_out(isl.dim_type.set, 2, len(A[0]) - 2)


def inclusion(A, b, C, d):
    return a_set(A, b).is_subset(a_set(C, d))


def equality(A, b, C, d):
    return a_set(A, b).is_equal(a_set(C, d))


def common_point(A, b, C, d):
    point = a_set(A, b).intersect(a_set(C, d)).sample_point()
    return [int(str(point.get_coordinate_val(isl.dim_type.set, j))) for j in range(len(A[0]))]


def minkowski_sum(A, b, C, d):
    return a_set(A, b).sum(a_set(C, d))


def image(A, b):
    graph = isl.BasicMap("{ [x1, x2, x3] -> [x1 + x2 - x3, x1 - 2 x2] }")
    return a_set(A, b).apply(graph)


def union_hull(A, b, C, d):
    return isl.Set.union(a_set(A, b), a_set(C, d)).convex_hull()


def intervals(A, b):
    out = []
    for j in range(len(A[0])):
        own = isl.Set(str(a_set(A, b)))
        out.append((own.dim_min_val(j), own.dim_max_val(j)))
    return out


def from_text(text):
    names = sorted({word for word in text if word.isalpha()})
    rows = " and ".join(text.split(";"))
    point = isl.BasicSet(f"{{ [{', '.join(names)}] : {rows} }}").sample_point()
    return {x: int(str(point.get_coordinate_val(isl.dim_type.set, j))) for j, x in enumerate(names)}
