"""Polyhedra as sets."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Iterable, Mapping, Sequence

from fmb._answers import Point
from fmb._lib import ArgumentError, Number, exact, listed
from fmb._linear import FormLike
from fmb._results import Box, Generators, Optimum, SystemAnswer
from fmb._solver import Names, Solver, _solver
from fmb._system import System, SystemLike, system
from fmb._within import is_within, yes_or_no


class Polyhedron:
    """The set of solutions of a system, over the variables that the system names.

    `P & Q` is the intersection, `P | Q` the closed convex hull of both, `P + Q` the Minkowski sum,
    `3 * P` a multiple; `P <= Q` asks whether P lies within Q, `P == Q` whether they are the same
    set. All of it is exact. Options (max_seconds=..., threads=...) hold for all queries about it.

    >>> square = Polyhedron("0 <= x <= 1; 0 <= y <= 1")
    >>> square & "x + y <= 1" <= square
    True
    >>> (square + square).bounds()
    x in [0, 2], y in [0, 2]
    >>> square.project("x") == Polyhedron("0 <= x <= 1")
    True
    """

    def __init__(self, rows: SystemLike = (),
                 variables: str | Iterable[str] | None = None, **options: Any):
        self.system = System(system(rows), variables)
        self._options = options
        self._own: Solver | None = None

    @classmethod
    def from_arrays(cls, A: Any, b: Any, relations: str | Sequence[str] = "<=",
                    names: str | Sequence[str] | None = None, **options: Any) -> Polyhedron:
        """The set of all x with A x REL b, as System.from_arrays has it.

        >>> Polyhedron.from_arrays([[1], [-1]], [3, 0])
        Polyhedron(x1 <= 3; x1 >= 0)
        """
        return cls(System.from_arrays(A, b, relations, names), **options)

    @classmethod
    def from_generators(cls, points: Any, rays: Any = (), lines: Any = (),
                        names: Sequence[str] | None = None, **options: Any) -> Polyhedron:
        """The convex hull of points, and what rays and lines add.

        >>> Polyhedron.from_generators([(0, 0), (1, 0), (0, 1)], names=["x", "y"])
        Polyhedron(x + y <= 1; y >= 0; x >= 0)
        """
        return cls(_solver(options).hull(points, rays, lines, names).system, **options)

    def _ask(self) -> Solver:
        if not self._options:
            return _solver({})
        if self._own is None:
            self._own = Solver(**self._options)
        return self._own

    def _like(self, answer: SystemAnswer) -> Polyhedron:
        """The polyhedron of an answer; raises if a limit interrupted it."""
        bool(answer) if answer.feasible is None else None
        if not answer.done:
            from fmb._lib import Unfinished
            raise Unfinished(answer.stop)
        return Polyhedron(answer.system, **self._options)

    # ---- questions ---------------------------------------------------------------------------

    @property
    def names(self) -> tuple[str, ...]:
        """The names of its variables."""
        return self.system.names

    @property
    def dim(self) -> int:
        """The dimension of the space."""
        return self.system.dim

    def is_empty(self) -> bool:
        """Has it no point?"""
        return not yes_or_no(self._options).solve(self.system)

    def __bool__(self) -> bool:
        """Has it a point?

        >>> bool(Polyhedron("x >= 1") & "x < 1")
        False
        """
        return not self.is_empty()

    def point(self) -> Point | None:
        """Some point, or None."""
        return self._ask().solve(self.system).point

    def affine_dim(self) -> int:
        """The dimension of the set itself; -1 if it is empty.

        >>> Polyhedron("x + y = 1; x >= 0").affine_dim()
        1
        """
        reduced = self._ask().project(self.system, self.names)
        if not reduced:
            return -1
        return self.dim - [row.relation for row in reduced].count("=")

    def __contains__(self, point: Any) -> bool:
        return self.system.holds(point)

    def bounds(self, of: Names | None = None) -> Box:
        """The tightest box around it."""
        return self._ask().bounds(self.system, of)

    def maximize(self, form: FormLike) -> Optimum:
        """How far it goes in a direction."""
        return self._ask().optimize(self.system, max=form)

    def minimize(self, form: FormLike) -> Optimum:
        """The same the other way."""
        return self._ask().optimize(self.system, min=form)

    def generators(self) -> Generators:
        """Vertices, rays and lines of its closure."""
        return self._ask().vertices(self.system)

    def vertices(self) -> list[tuple[Fraction, ...]]:
        """Its vertices."""
        return self.generators().vertices

    # ---- new ones ----------------------------------------------------------------------------

    def project(self, keep: Names) -> Polyhedron:
        """Its shadow in some of the variables."""
        return self._like(self._ask().project(self.system, keep))

    def eliminate(self, drop: Names) -> Polyhedron:
        """Its shadow in all variables but some."""
        return self._like(self._ask().eliminate(self.system, drop))

    def reduced(self) -> Polyhedron:
        """The same set by its canonical rows, none of which can be left out."""
        return self.project(self.names)

    def image(self, graph: Mapping[str, FormLike] | str | System) -> Polyhedron:
        """Its image under a map: a form for the name of each coordinate."""
        return self._like(self._ask().image(self.system, graph))

    def translated(self, by: Mapping[str, Number]) -> Polyhedron:
        """Moved by a vector.

        >>> Polyhedron("0 <= x <= 1").translated({"x": 2})
        Polyhedron(x >= 2; x <= 3)
        """
        out = System((), self.names)
        by = {self.names[self.system.index(name)]: x for name, x in by.items()}
        for row in self.system:
            shift = sum((c * exact(by.get(name, 0)) for name, c in row.coefficients.items()),
                        Fraction(0))
            moved = row.as_row()
            left, relation, right = moved.links[0]
            out.add(type(moved)([(left, relation, right + shift)], row.label))
        return Polyhedron(out, **self._options)

    def __mul__(self, factor: Number) -> Polyhedron:
        if isinstance(factor, Polyhedron):
            return NotImplemented
        k = exact(factor)
        if k == 0:
            raise ArgumentError("0 times a polyhedron loses its directions: say what is meant")
        out = System((), self.names)
        for row in self.system:
            moved = row.as_row()
            left, relation, right = moved.links[0]
            out.add(type(moved)([(left * (1 / k), relation, right)], row.label))
        return Polyhedron(out, **self._options)

    __rmul__ = __mul__

    def __neg__(self) -> Polyhedron:
        return self * -1

    def __and__(self, other: SystemLike) -> Polyhedron:
        both = System(self.system)
        both.join(system(other))
        return Polyhedron(both, **self._options)

    def __or__(self, other: SystemLike) -> Polyhedron:
        return self._like(self._ask().hull_of(self.system, system(other)))

    def __add__(self, other: SystemLike) -> Polyhedron:
        return self._like(self._ask().sum(self.system, system(other)))

    # ---- comparisons -------------------------------------------------------------------------

    def __le__(self, other: SystemLike) -> bool:
        """Does it lie within the other?"""
        return is_within(self.system, system(other), self._options)

    def __ge__(self, other: SystemLike) -> bool:
        return Polyhedron(other, **self._options) <= self

    def __lt__(self, other: SystemLike) -> bool:
        """Does it lie within the other, which has more?"""
        return self <= other and not self >= other

    def __gt__(self, other: SystemLike) -> bool:
        return self >= other and not self <= other

    def __eq__(self, other: object) -> bool:
        """Are they the same set? The other may be a system, or the text of one, as well."""
        if not isinstance(other, (Polyhedron, System, str)):
            return NotImplemented
        return self <= other and self >= other

    __hash__ = None  # type: ignore[assignment]

    def isdisjoint(self, other: SystemLike) -> bool:
        """Have they no point in common?"""
        return (self & other).is_empty()

    # ---- to look at --------------------------------------------------------------------------

    def plot(self, ax: Any = None, **style: Any) -> Any:
        """Draw it in two or three dimensions with matplotlib; what is unbounded is cut off at a box
        around its vertices. Returns the axes."""
        from fmb import _plot
        return _plot.polyhedron(self, ax, **style)

    def __reduce__(self) -> Any:
        return _again, (self.system, self._options)

    def __repr__(self) -> str:
        rows = listed([repr(row) for row in self.system], "; ")
        return f"Polyhedron({rows or 'everything'})"

    def _repr_html_(self) -> str:
        return self.system._repr_html_()


def _again(rows: System, options: dict[str, Any]) -> Polyhedron:
    """From a pickle."""
    return Polyhedron(rows, **options)
