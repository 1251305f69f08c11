"""Bridges to what others use: matrices of cddlib, linear programs in the shape of SciPy's."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Iterable, NamedTuple, Sequence

from fmb import _arrays
from fmb._lib import ArgumentError, Number, exact
from fmb._linear import Form, Row, form
from fmb._results import Optimum
from fmb._solver import _solver
from fmb._system import System


def from_cdd(rows: Iterable[Sequence[Number]], linear: Iterable[int] = (),
             names: Sequence[str] | None = None) -> System:
    """A system from rows of cddlib's H-representation: [b, -A], which mean b - A x >= 0; those
    whose numbers are in `linear` are equations.

    >>> from_cdd([[3, -1, -1], [0, 1, 0]])
    System of 2 rows in x1, x2
    """
    matrix, equations = [list(row) for row in rows], set(linear)
    names = names or [f"x{j + 1}" for j in range(max(map(len, matrix), default=1) - 1)]
    out = System((), names)
    for i, row in enumerate(matrix):
        if len(row) != len(names) + 1:
            raise ArgumentError(f"row {i} has {len(row)} numbers, not {len(names) + 1}")
        left = Form({name: -exact(c) for name, c in zip(names, row[1:])})
        out.add(Row([(left, "=" if i in equations else "<=", form(exact(row[0])))]))
    return out


def to_cdd(s: System) -> tuple[list[list[Fraction]], list[int]]:
    """The rows [b, -A] of a system, and the numbers of equations; strict rows are refused.

    >>> to_cdd(System("x + y <= 3; x = 1"))[1]
    [1]
    """
    A, relations, b = _arrays.fractions(s)
    if "<" in relations:
        raise ArgumentError("cddlib knows no strict rows")
    return ([[right] + [-c for c in row] for row, right in zip(A, b)],
            [i for i, relation in enumerate(relations) if relation == "="])


class LinprogResult(NamedTuple):
    """What scipy.optimize.linprog tells, proved: status 0 optimal, 1 limit, 2 infeasible,
    3 unbounded; `exact` is the answer that `x` and `fun` are the nearest floats of."""

    x: Any
    fun: float | None
    success: bool
    status: int
    message: str
    exact: Optimum


def linprog(c: Any, A_ub: Any = None, b_ub: Any = None, A_eq: Any = None, b_eq: Any = None,
            bounds: Any = (0, None), **options: Any) -> LinprogResult:
    """Minimize c x subject to A_ub x <= b_ub, A_eq x = b_eq and bounds, as scipy.optimize.linprog
    is asked, with a result that is exact and proved.

    >>> linprog([-1, -2], A_ub=[[1, 1]], b_ub=[4]).fun
    -8.0
    """
    n = len(c)
    names = [f"x{j + 1}" for j in range(n)]
    s = System((), names)
    for A, b, relation in ((A_ub, b_ub, "<="), (A_eq, b_eq, "=")):
        if (A is None) != (b is None):
            raise ArgumentError("a matrix and its right side come together: A_ub and b_ub, A_eq "
                                "and b_eq")
        if A is not None:
            s.join(System.from_arrays(A, b, relation, names))
    for name, (low, high) in zip(names, _bounds(bounds, n)):
        if low is not None and low != float("-inf"):
            s.add(Row([(form(name), ">=", form(exact(low)))]))
        if high is not None and high != float("inf"):
            s.add(Row([(form(name), "<=", form(exact(high)))]))
    best = _solver(options).optimize(s, min=Form(dict(zip(names, c))))
    if best.feasible is None or not best.tight and best.feasible:
        return LinprogResult(None, None, False, 1, f"a limit was reached: {best.stop}", best)
    if not best.feasible:
        return LinprogResult(None, None, False, 2, f"infeasible: {best.conflict!r}", best)
    if best.unbounded:
        return LinprogResult(None, None, False, 3, f"unbounded along {best.ray!r}", best)
    assert best.point is not None and best.value is not None
    return LinprogResult(best.point.floats(), float(best.value), True, 0, "optimal, proved", best)


def _bounds(bounds: Any, n: int) -> list[tuple[Any, Any]]:
    bounds = (0, None) if bounds is None else bounds
    pairs = [bounds] if len(bounds) == 2 and not hasattr(bounds[0], "__len__") else list(bounds)
    if len(pairs) == 1:
        pairs *= n
    if len(pairs) != n:
        raise ArgumentError(f"bounds of {len(pairs)} variables, but there are {n}")
    return [(low, high) for low, high in pairs]
