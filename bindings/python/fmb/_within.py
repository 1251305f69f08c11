"""Does one set lie within another? Yes or no, without a proof, and so quickly."""

from __future__ import annotations

import threading
from typing import Any, Callable, Iterator

from fmb._lib import Unfinished, ffi, lib, need, spelled, text
from fmb._solver import Solver
from fmb._system import RELATIONS, System

_default = threading.local()


def yes_or_no(options: dict[str, Any]) -> Solver:
    """A solver for questions of which only the answer is wanted, and no proof."""
    if options:
        without: dict[str, Any] = {**options, "evidence": "none"}
        return Solver(**without)
    own: Solver | None = getattr(_default, "solver", None)
    if own is None:
        own = _default.solver = Solver(evidence="none")
    return own


_AGAINST = {lib.FMB_LE: (lib.FMB_GT,), lib.FMB_LT: (lib.FMB_GE,),
            lib.FMB_EQ: (lib.FMB_LT, lib.FMB_GT)}


def is_within(inner: System, outer: System, options: dict[str, Any]) -> bool:
    """Do all solutions of one system satisfy the other? Each row of that is turned against it."""
    new = [name for name in outer.names if name not in inner.names]
    if new:
        inner = inner.copy()
        for name in new:
            inner.add_variable(name)
    solver = yes_or_no(options)
    need(lib.fmb_solver_load(solver._v, inner._s), solver._trouble)
    try:
        return not any(_meets(solver, add, relation) for add, relations in
                       _rows_against(solver, inner, outer) for relation in relations)
    finally:
        lib.fmb_solver_unload(solver._v)


def _meets(solver: Solver, add: Callable[[int], int], relation: int) -> bool:
    """Is the loaded system feasible with one more row?"""
    v = solver._v
    need(lib.fmb_solver_push(v), solver._trouble)
    need(add(relation), solver._trouble)
    result = solver._ask(lib.fmb_solve, lib.fmb_solver_system(v))
    need(lib.fmb_solver_pop(v), solver._trouble)
    if result.verdict == lib.FMB_UNKNOWN:
        raise Unfinished(text(lib.fmb_stop_text(result.stop)))
    return bool(result.verdict == lib.FMB_FEASIBLE)


def _rows_against(solver: Solver, inner: System, outer: System) -> Iterator[Any]:
    """For each row of one, what adds it to the other with a relation, and against which ones."""
    m, terms, v = len(outer), int(lib.fmb_system_nonzeros(outer._s)), solver._v
    start, rel = ffi.new("size_t[]", m + 1), ffi.new("fmb_rel[]", m + 1)
    var, coef = ffi.new("int[]", terms + 1), ffi.new("int64_t[]", terms + 1)
    right, place = ffi.new("int64_t[]", m + 1), [inner.index(name) for name in outer.names]
    if lib.fmb_system_get_rows_int(outer._s, 0, m, start, var, coef, rel, right) != lib.FMB_OK:
        yield from _long_rows_against(solver, place, outer)
        return
    a = ffi.new("int64_t[]", inner.dim + 1)
    for i in range(m):
        for k in range(start[i], start[i + 1]):
            a[place[var[k]]] = coef[k]
        yield (lambda relation, b=right[i]: lib.fmb_solver_add_int(v, a, relation, b),
               _AGAINST[rel[i]])
        for k in range(start[i], start[i + 1]):
            a[place[var[k]]] = 0


def _long_rows_against(solver: Solver, place: list[int], outer: System) -> Iterator[Any]:
    """Likewise for fractions, and numbers beyond 64 bits."""
    for row in outer:
        var = [place[outer.index(name)] for name in row.coefficients]
        texts = [ffi.new("char[]", spelled(c).encode()) for c in row.coefficients.values()]
        coef, right = ffi.new("char *[]", texts), spelled(row.right).encode()
        yield (lambda relation, n=len(var), var=var, coef=coef, right=right:
               lib.fmb_solver_add_terms_text(solver._v, n, var, coef, relation, right),
               _AGAINST[RELATIONS[row.relation]])
