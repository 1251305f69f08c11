"""Systems that change."""

from __future__ import annotations

import contextlib
import re
from fractions import Fraction
from typing import Any, Callable, Iterator

from fmb._answers import Answer
from fmb._lib import (NULL, ArgumentError, Number, StateError, encoded, exact, ffi, lib, made, need,
                      spelled)
from fmb._linear import Form, FormLike, Row
from fmb._results import Box, Optimum
from fmb._solver import Solver
from fmb._system import RELATIONS, System, SystemLike, system


class Session:
    """A system that changes, and a solver that goes on from its last answer.

    >>> s = Session("x >= 0; x <= 4")
    >>> with s.pushed():
    ...     row = s.add("x >= 5")
    ...     s.solve().feasible
    False
    >>> s.solve().feasible
    True
    """

    def __init__(self, rows: SystemLike = (), **options: Any):
        self._solver = Solver(**options)
        self._v = self._solver._v
        start = system(rows)
        need(lib.fmb_solver_load(self._v, start._s), self._solver._trouble)

    @property
    def system(self) -> System:
        """A copy of the system as it is now."""
        return System._of(made("fmb_system", lib.fmb_system_copy, self._now()))

    def _now(self) -> Any:
        now = lib.fmb_solver_system(self._v)
        if now == NULL:
            raise StateError("the session is closed")
        return now

    def __len__(self) -> int:
        return int(lib.fmb_system_rows(self._now()))

    def _index(self, name: str) -> int:
        j = lib.fmb_system_find(self._now(), encoded(name))
        return int(j) if j >= 0 else self.add_variable(name)

    def add_variable(self, name: str | None = None) -> int:
        """Append a variable."""
        index = ffi.new("int *")
        need(lib.fmb_solver_add_variable(self._v, encoded(name) if name is not None else NULL,
                                         index), self._solver._trouble)
        return int(index[0])

    def add(self, row: Row | str) -> int:
        """Append a row; its handle, which stays the same whatever rows come and go, is returned."""
        one = system(row)
        if len(one) != 1:
            raise ArgumentError(f"{row!r} is {len(one)} rows: add one at a time")
        terms = one[0]
        sign, relation = 1, terms.relation
        if relation != "=" and _is_lower_bound(row):  # as set_right will mean it
            sign, relation = -1, {"<=": ">=", "<": ">"}[relation]
        var = {self._index(name): sign * c for name, c in terms.coefficients.items()}
        texts = [ffi.new("char[]", spelled(c).encode()) for c in var.values()]
        need(lib.fmb_solver_add_terms_text(
            self._v, len(var), list(var), ffi.new("char *[]", texts), RELATIONS[relation],
            spelled(sign * terms.right).encode()), self._solver._trouble)
        if terms.label is not None:
            need(lib.fmb_solver_set_label(self._v, len(self) - 1, encoded(terms.label)))
        return int(lib.fmb_solver_last_row(self._v))

    def remove(self, row: int) -> None:
        """Remove the row of that handle."""
        need(lib.fmb_solver_remove(self._v, self._number(row)), self._solver._trouble)

    def set_right(self, row: int, right: Number | str) -> None:
        """Give the row of that handle another right side, in the direction in which it was given."""
        need(lib.fmb_solver_set_right_text(self._v, self._number(row),
                                           spelled(exact(right)).encode()), self._solver._trouble)

    def _number(self, row: int) -> int:
        self._now()
        number = int(lib.fmb_solver_row_number(self._v, row))
        if number >= len(self):
            raise ArgumentError(f"no row has the handle {row}")
        return number

    def push(self) -> None:
        """Begin a level."""
        need(lib.fmb_solver_push(self._v), self._solver._trouble)

    def pop(self) -> None:
        """End the last level: all is as it was when it began."""
        need(lib.fmb_solver_pop(self._v), self._solver._trouble)

    @contextlib.contextmanager
    def pushed(self) -> Iterator[Session]:
        """A level for as long as a `with` lasts."""
        self.push()
        try:
            yield self
        finally:
            self.pop()

    def solve(self) -> Answer:
        """Is there a solution now?"""
        return self._answer(Answer, lib.fmb_solve)

    def bounds(self) -> Box:
        """The tightest interval of each variable now."""
        out = ffi.new("fmb_box **")
        result = self._solver._ask(lib.fmb_bound, self._now(), NULL, 0, out)
        return Box(self._v, self.system, result, out[0])

    def optimize(self, max: FormLike | None = None,  # pylint: disable=redefined-builtin
                 min: FormLike | None = None) -> Optimum:
        """The best value of a form now; of forms of floats alone it goes on from the last answer."""
        if (max is None) == (min is None):
            return self._solver.optimize(self.system, max, min)
        wanted = max if max is not None else min
        now = self.system
        if not isinstance(wanted, Form) or any(name not in now.names for name in
                                               wanted.coefficients):
            return self._solver.optimize(now, max, min)
        coefficients = [wanted.coefficients.get(name, Fraction(0)) for name in now.names]
        numbers = [float(c) for c in coefficients]
        if numbers != coefficients or float(wanted.constant) != wanted.constant:
            return self._solver.optimize(now, max, min)
        array = ffi.new("double[]", numbers + [0.0])
        objective = ffi.new("fmb_objective *", {
            "sense": lib.FMB_SENSE_MAX if max is not None else lib.FMB_SENSE_MIN, "coef": array,
            "constant": float(wanted.constant)})
        out = ffi.new("fmb_optimum **")
        result = self._solver._ask(lib.fmb_optimize, self._now(), objective, out)
        return Optimum(self._v, now, result, out[0])

    def _answer(self, kind: type[Answer], query: Callable[..., int]) -> Answer:
        result = self._solver._ask(query, self._now())
        return kind(self._v, self.system, result)

    def close(self) -> None:
        """The system goes; the session can be asked no more."""
        lib.fmb_solver_unload(self._v)

    def __repr__(self) -> str:
        if lib.fmb_solver_system(self._v) == NULL:
            return "Session (closed)"
        return f"Session: {self.system!r}"

    def __enter__(self) -> Session:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()


def _is_lower_bound(row: Any) -> bool:
    """Is the row written as a lower bound on its form, like x >= 5?"""
    if isinstance(row, Row):
        return row.links[0][1] in (">=", ">")
    return isinstance(row, str) and ">" in re.sub(r'"(?:[^"\\]|\\.)*"', "", row)
