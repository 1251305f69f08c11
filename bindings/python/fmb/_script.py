"""SMT-LIB scripts that ask more than once."""

from __future__ import annotations

import os
from fractions import Fraction
from typing import Iterator

from fmb._answers import Answer
from fmb._lib import NULL, StateError, ffi, lib, owned, parsed
from fmb._solver import Solver
from fmb._system import System


class Script:
    """An SMT-LIB script with several checks, push, pop, and what they may be asked behind each.

    Its questions are systems; `answers` asks them one after the other:

    >>> script = Script('''
    ... (declare-const x Real) (declare-const y Real)
    ... (assert (<= (+ x y) 3)) (check-sat) (get-value ((+ x 1)))
    ... (push) (assert (! (>= x 2) :named low)) (assert (>= y 2)) (check-sat) (pop) (check-sat)
    ... ''')
    >>> [answer.feasible for answer in script.answers()]
    [True, False, True]
    """

    def __init__(self, source: str | bytes, name: str | None = None):
        data = source.encode(errors="surrogateescape") if isinstance(source, str) else source
        self._name = name
        self._data = data
        self._s = self._parse()

    def _parse(self) -> object:
        out, where = ffi.new("fmb_script **"), ffi.new("fmb_where *")
        parsed(lib.fmb_script_parse(self._data, len(self._data), NULL, out, where), where,
               self._name)
        return owned("fmb_script", out[0])

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Script:
        """A script from a file."""
        with open(path, "rb") as file:
            return cls(file.read(), os.fspath(path))

    @property
    def asks_often(self) -> bool:
        """Does it ask more than one conjunction can be asked, as System.parse reads it?"""
        return bool(lib.fmb_script_asks_often(self._s))

    def systems(self) -> Iterator[System]:
        """What each check asks about, from the first one on."""
        for kind, system in self._commands():
            if kind == "check":
                yield system

    def answers(self, **options: object) -> Iterator[Answer]:
        """The answer to each check."""
        solver = Solver(**options)  # type: ignore[arg-type]
        for system in self.systems():
            yield solver.solve(system)

    def values(self, **options: object) -> Iterator[dict[str, Fraction]]:
        """For each get-value, its terms at a solution of the check before it. A term that is no
        more than a constant has its value whatever the solution is."""
        solver = Solver(**options)  # type: ignore[arg-type]
        last: System | None = None
        for kind, system in self._commands():
            if kind == "check":
                last = system
            elif kind == "value":
                yield self._values(solver, last)

    def _values(self, solver: Solver, last: System | None) -> dict[str, Fraction]:
        if last is None:
            raise StateError("get-value before the first check-sat")
        answer = solver.solve(last)
        if not answer:
            raise StateError("get-value where there is no solution")
        point = answer.point
        assert point is not None
        out: dict[str, Fraction] = {}
        while True:
            found = self._term(len(out))
            if found is None:
                return out
            word, system = found
            out[word] = _at(system, {name: point.get(name, Fraction(0)) for name in system.names})

    def _term(self, i: int) -> tuple[str, System] | None:
        out, where = ffi.new("fmb_system **"), ffi.new("fmb_where *")
        word, size = ffi.new("char **"), ffi.new("size_t *")
        parsed(lib.fmb_script_term(self._s, i, ffi.cast("const char **", word), size, out, where),
               where, self._name)
        if word[0] == NULL:
            return None
        return (bytes(ffi.buffer(word[0], size[0])).decode(errors="surrogateescape"),
                System._of(owned("fmb_system", out[0])))

    def _commands(self) -> Iterator[tuple[str, System]]:
        """Each command with an answer, and the system of the last check."""
        self._s = self._parse()
        kinds = {lib.FMB_SCRIPT_CHECK: "check", lib.FMB_SCRIPT_MODEL: "model",
                 lib.FMB_SCRIPT_VALUE: "value", lib.FMB_SCRIPT_CORE: "core"}
        kind, where = ffi.new("fmb_script_kind *"), ffi.new("fmb_where *")
        system = System()
        while True:
            parsed(lib.fmb_script_next(self._s, kind, where), where, self._name)
            if kind[0] == lib.FMB_SCRIPT_END:
                return
            if kind[0] == lib.FMB_SCRIPT_CHECK:
                out = ffi.new("fmb_system **")
                parsed(lib.fmb_script_question(self._s, out, where), where, self._name)
                system = System._of(owned("fmb_system", out[0]))
            yield kinds[kind[0]], system

    def __reduce__(self) -> tuple[object, ...]:
        return Script, (self._data, self._name)


def _at(system: System, point: dict[str, Fraction]) -> Fraction:
    """The value of a system's objective at a point."""
    form = system.objective
    return form(point) if form is not None else Fraction(0)
