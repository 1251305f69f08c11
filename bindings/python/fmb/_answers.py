"""What queries answer."""

from __future__ import annotations

import os
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Iterator, Mapping

from fmb._lib import StateError, Unfinished, ffi, lib, listed, need, number, owned, parsed
from fmb._lib import printed, spelled, text, written

if TYPE_CHECKING:
    from fmb._system import System, SystemRow

NONE = ffi.cast("size_t", -1)
_ABSENT = int(NONE)


class Point(Mapping[str, Fraction]):
    """A point, or a direction: an exact number for the name of each variable.

    >>> p = solve("x + y = 3; x - y = 2").point
    >>> p, p["x"], float(p["y"])
    (x = 5/2, y = 1/2, Fraction(5, 2), 0.5)
    """

    __slots__ = ("_names", "_values")

    def __init__(self, names: tuple[str, ...], values: list[Fraction]):
        self._names = names
        self._values = dict(zip(names, values))

    def __getitem__(self, name: Any) -> Fraction:
        return self._values[getattr(name, "name", name)]

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def floats(self) -> list[float]:
        """The nearest floats, in the order of variables."""
        return [float(x) for x in self._values.values()]

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        import numpy as np
        return np.array(self.floats(), dtype)

    def _lines(self) -> list[str]:
        return [f"{name} = {spelled(x)}" for name, x in self._values.items()]

    def __reduce__(self) -> Any:
        return Point, (self._names, list(self._values.values()))

    def __str__(self) -> str:
        return ", ".join(self._lines()) or "(no variables)"

    def __repr__(self) -> str:
        return listed(self._lines()) or "(no variables)"

    def _repr_html_(self) -> str:
        from fmb import _html
        return _html.table(self._lines())


class Conflict:
    """Rows without a common solution, no fewer of which would do (an irreducible infeasible
    subsystem): `rows`, their `numbers` in the system, and the `multipliers` (Farkas) by which they
    add up to 0 <= negative or 0 < 0.

    >>> solve("a: x + y <= 1; b: x >= 1; c: y > 0").conflict
    1 (a: x + y <= 1) + 1 (b: x >= 1) + 1 (c: y > 0)
    """

    def __init__(self, numbers: list[int], multipliers: list[Fraction], rows: list[SystemRow]):
        self.numbers = numbers
        self.multipliers = multipliers
        self.rows = rows

    def __iter__(self) -> Iterator[tuple[SystemRow, Fraction]]:
        return iter(zip(self.rows, self.multipliers))

    def __len__(self) -> int:
        return len(self.rows)

    def __repr__(self) -> str:
        return listed([f"{spelled(m)} ({row!r})" for row, m in self], " + ")

    def _repr_html_(self) -> str:
        from fmb import _html
        return _html.table([f"{spelled(m)} × ({row!r})" for row, m in self],
                           "no common solution:")


class Proof:
    """Evidence of an answer, which a small independent program judges (docs/proof-format.md)."""

    def __init__(self, c_evidence: Any, about: System):
        self._e = c_evidence
        self._about = about

    @classmethod
    def parse(cls, source: str | bytes, about: System) -> Proof:
        """A proof from its text, about that system."""
        data = source.encode(errors="surrogateescape") if isinstance(source, str) else source
        out, where = ffi.new("fmb_evidence **"), ffi.new("fmb_where *")
        parsed(lib.fmb_evidence_parse(data, len(data), about._s, out, where), where)
        return cls(owned("fmb_evidence", out[0]), about)

    @classmethod
    def read(cls, path: str | os.PathLike[str], about: System) -> Proof:
        """A proof from a file."""
        with open(path, "rb") as file:
            return cls.parse(file.read(), about)

    def __len__(self) -> int:
        return int(lib.fmb_evidence_claims(self._e))

    @property
    def claims(self) -> list[str]:
        """Each claim in words."""
        return [printed(lib.fmb_evidence_print_claim, self._e, self._about._s, i).rstrip("\n")
                for i in range(len(self))]

    def to_text(self) -> str:
        """The proof as `fmb check` reads it."""
        return printed(lib.fmb_evidence_print, self._e, self._about._s)

    def write(self, path: str | os.PathLike[str]) -> None:
        """A file for `fmb check`."""
        with open(path, "w", encoding="utf-8", errors="surrogateescape", newline="\n") as file:
            file.write(self.to_text())

    def __reduce__(self) -> Any:
        return Proof.parse, (self.to_text(), self._about)

    def check(self) -> Judgement:
        """Judge every claim in exact arithmetic, by code that shares nothing with what found it."""
        out = ffi.new("fmb_judgement *", {"size": ffi.sizeof("fmb_judgement")})
        need(lib.fmb_check(self._about._s, self._e, out))
        return Judgement(out)

    def __repr__(self) -> str:
        return f"Proof of {len(self)} claim" + ("" if len(self) == 1 else "s")


class Judgement:
    """What became of a proof: true if it is `accepted`; else `reason` says why not."""

    def __init__(self, out: Any):
        self.accepted = bool(out.accepted)
        self.held = int(out.held)
        self.feasible = _feasible(out.verdict)
        self.relaxed = bool(out.relaxed)
        self.reason = text(out.reason)

    def __bool__(self) -> bool:
        return self.accepted

    def __repr__(self) -> str:
        if not self:
            return f"rejected: {self.reason}"
        return f"accepted: {self.held} claim" + (" holds" if self.held == 1 else "s hold")


_FEASIBLE = {lib.FMB_FEASIBLE: True, lib.FMB_INFEASIBLE: False}
_EVIDENCE = ffi.typeof("fmb_evidence **")


def _feasible(verdict: int) -> bool | None:
    return _FEASIBLE.get(verdict)


_STATS = ("rounds", "pairs", "rows_made", "rows_kept", "rows_dropped", "rows_peak", "promotions",
          "pivots", "lps", "bytes_peak", "seconds")


class Answer:
    """What a query found out: `feasible` is True, False, or None where a limit came first; `stop`
    is "done" or the limit: "time", "rows", "bytes", "cancelled". The rest is read when asked for.
    An answer is true if the system is feasible."""

    def __init__(self, solver: Any, about: System, result: Any):
        self._about = about
        self.feasible = _feasible(result.verdict)
        self._stop = result.stop
        self._stats = result
        self._proof: Proof | None = None
        out = ffi.new(_EVIDENCE)
        if lib.fmb_solver_evidence(solver, out) == lib.FMB_OK:
            self._proof = Proof(ffi.gc(out[0], lib.fmb_evidence_free), about)

    _lazy: tuple[str, ...] = ()  # attributes read from the library at their first use

    def __getstate__(self) -> dict[str, Any]:
        """For pickle and deepcopy: all that can be asked, read."""
        state = {**self.__dict__, "_stats": self.stats, "_c": None}
        for name in self._lazy:
            state["_read_" + name] = getattr(self, name)
        return state

    def __bool__(self) -> bool:
        if self.feasible is None:
            raise Unfinished(self.stop)
        return self.feasible

    @property
    def stop(self) -> str:
        """Why the query ended."""
        return text(lib.fmb_stop_text(self._stop))

    @property
    def done(self) -> bool:
        """Did no limit end it?"""
        return bool(self._stop == lib.FMB_STOP_DONE)

    @property
    def stats(self) -> dict[str, float]:
        """What it took: rows made, pivots, bytes, seconds, ..."""
        if isinstance(self._stats, dict):
            return dict(self._stats)
        return {name: getattr(self._stats.stats, name) for name in _STATS}

    @property
    def proof(self) -> Proof:
        """Its evidence."""
        if self._proof is None:
            raise StateError("no evidence was kept: evidence=\"none\" keeps none, and a hull has none, "
                             "as evaluating its rows at the points is its proof")
        return self._proof

    def _claims(self, kind: int) -> Iterator[int]:
        if self._proof is not None:
            for i in range(len(self._proof)):
                if lib.fmb_evidence_kind(self._proof._e, i) == kind:
                    yield i

    @property
    def point(self) -> Point | None:
        """A solution, exactly; None if there is none."""
        for i in self._claims(lib.FMB_CLAIM_FEASIBLE):
            assert self._proof is not None
            return point_of(self._about, lib.fmb_evidence_coordinate_text, self._proof._e, i)
        return None

    @property
    def conflict(self) -> Conflict | None:
        """Rows without a common solution; None if there are none."""
        for i in self._claims(lib.FMB_CLAIM_INFEASIBLE):
            assert self._proof is not None
            return _conflict(self._about, self._proof._e, i)
        return None

    def __repr__(self) -> str:
        if self.feasible is None:
            return f"unknown: a limit was reached ({self.stop})"
        if self.feasible:
            return f"feasible: {self.point!r}"
        return f"infeasible: {self.conflict!r}"


def point_of(about: System, coordinate: Any, *of: Any) -> Point:
    """A point over the variables of a system, read by a function *_text."""
    return Point(about.names, [number(written(coordinate, *of, j)) for j in range(about.dim)])


def _conflict(about: System, e: Any, i: int) -> Conflict:
    numbers, multipliers = [], []
    row = lib.fmb_evidence_next_row(e, i, 0)
    while row != _ABSENT:
        numbers.append(int(row))
        multipliers.append(number(written(lib.fmb_evidence_multiplier_text, e, i, row)))
        row = lib.fmb_evidence_next_row(e, i, row + 1)
    return Conflict(numbers, multipliers, [about[r] for r in numbers])
