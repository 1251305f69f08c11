"""What queries answer, by question: boxes, optima, systems, generators."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Iterator, Mapping

from fmb._answers import Answer, Point, point_of
from fmb._lib import (NULL, StateError, Unfinished, exact, ffi, lib, listed, need, number, owned,
                      printed, spelled, written)

if TYPE_CHECKING:
    from fmb._system import System, SystemRow


class End:
    """An end of an interval: an exact `value`, or None where there is none; is it `attained`; is it
    `tight`, or only not beyond, as a limit was reached first?"""

    __slots__ = ("value", "attained", "tight", "_outward", "known")

    def __init__(self, end: Any, spelled: str):
        self.value = number(spelled) if spelled else None
        self.attained = bool(end.attained)
        self.tight = end.kind in (lib.FMB_END_FINITE, lib.FMB_END_INFINITE)
        self.known = end.kind != lib.FMB_END_UNKNOWN
        self._outward = float(end.value)

    def __float__(self) -> float:
        """Rounded outward."""
        return self._outward

    def _place(self) -> Fraction | float:
        """Where it is: a number, or an infinity."""
        return self.value if self.value is not None else self._outward

    def __eq__(self, other: object) -> bool:
        place = _place(other)
        return self.known and place is not None and self._place() == place

    def __lt__(self, other: object) -> bool:
        place = _place(other)
        if place is None:
            return NotImplemented
        return bool(self._place() < place)

    def __le__(self, other: object) -> bool:
        place = _place(other)
        if place is None:
            return NotImplemented
        return bool(self._place() <= place)

    def __gt__(self, other: object) -> bool:
        place = _place(other)
        if place is None:
            return NotImplemented
        return bool(self._place() > place)

    def __ge__(self, other: object) -> bool:
        place = _place(other)
        if place is None:
            return NotImplemented
        return bool(self._place() >= place)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return spelled(self.value) if self.value is not None else str(self._outward)


def _place(value: object) -> Fraction | float | None:
    """Of an end or a number; None of anything else."""
    if isinstance(value, End):
        return value._place()
    if isinstance(value, float):
        return value
    try:
        return exact(value)  # type: ignore[arg-type]
    except ValueError:
        return None


class Interval:
    """The values that a variable takes: from `lower` to `upper`."""

    __slots__ = ("lower", "upper")

    def __init__(self, lower: End, upper: End):
        self.lower, self.upper = lower, upper

    def __iter__(self) -> Iterator[End]:
        return iter((self.lower, self.upper))

    def __eq__(self, other: object) -> bool:
        """The same values?"""
        return isinstance(other, Interval) and all(
            own == end and own.attained == end.attained for own, end in zip(self, other))

    __hash__ = None  # type: ignore[assignment]

    def __contains__(self, value: Any) -> bool:
        value = exact(value)
        return ((self.lower.value is None or self.lower.value < value
                 or (self.lower.attained and self.lower.value == value))
                and (self.upper.value is None or value < self.upper.value
                     or (self.upper.attained and self.upper.value == value)))

    def __repr__(self) -> str:
        below = "[" if self.lower.attained else "("
        above = "]" if self.upper.attained else ")"
        return f"{below}{self.lower!r}, {self.upper!r}{above}"


class Box(Answer, Mapping[str, Interval]):
    """The tightest interval of each variable, by its name.

    >>> bounds("0 <= x; x + y <= 4; y > 1")
    x in [0, 3), y in (1, 4]
    """

    def __init__(self, solver: Any, about: System, result: Any, box: Any):
        Answer.__init__(self, solver, about, result)
        self._intervals: dict[str, Interval] = {}
        box = owned("fmb_box", box)
        for i in range(lib.fmb_box_size(box) if box is not None else 0):
            ends = [End(lib.fmb_box_end(box, i, side),
                        written(lib.fmb_box_end_text, box, i, side))
                    for side in (lib.FMB_LOWER, lib.FMB_UPPER)]
            self._intervals[about.names[lib.fmb_box_var(box, i)]] = Interval(*ends)

    def __getitem__(self, name: Any) -> Interval:
        return self._intervals[getattr(name, "name", name)]

    def __iter__(self) -> Iterator[str]:
        return iter(self._intervals)

    def __len__(self) -> int:
        return len(self._intervals)

    def floats(self) -> list[tuple[float, float]]:
        """Both ends of each, rounded outward."""
        return [(float(i.lower), float(i.upper)) for i in self._intervals.values()]

    def __repr__(self) -> str:
        if not self._intervals:
            return Answer.__repr__(self)
        return listed([f"{name} in {i!r}" for name, i in self._intervals.items()])


class Optimum(Answer):
    """The best value of a form: `value` is exact, None if the form is `unbounded` or there is no
    solution; `attained` says whether `point` reaches it; along `ray`, if unbounded, it never ends.

    >>> best = optimize("x + 2y <= 4; x >= 0; y >= 0", max="x + 3y")
    >>> best.value, best.point
    (Fraction(6, 1), x = 0, y = 2)
    """

    def __init__(self, solver: Any, about: System, result: Any, optimum: Any):
        super().__init__(solver, about, result)
        self._c = owned("fmb_optimum", optimum)
        self._any = self._c is not None
        end = lib.fmb_optimum_end(optimum)
        self.attained = bool(end.attained)
        self.unbounded = bool(end.kind == lib.FMB_END_INFINITE)
        self.tight = bool(end.kind in (lib.FMB_END_FINITE, lib.FMB_END_INFINITE))
        self._outward = float(end.value)

    _lazy = ("value", "point", "ray")

    @property
    def value(self) -> Fraction | None:
        """The optimum; after a limit what no solution is beyond."""
        if self._c is None:
            return self.__dict__.get("_read_value")
        spelled_value = written(lib.fmb_optimum_value_text, self._c)
        return number(spelled_value) if spelled_value else None

    def __float__(self) -> float:
        """Rounded outward; infinite if unbounded, nan if there is no solution."""
        return self._outward if self._any else math.nan

    @property
    def point(self) -> Point | None:
        if self._c is None:
            return self.__dict__.get("_read_point")
        return point_of(self._about, lib.fmb_optimum_coordinate_text, self._c)

    @property
    def ray(self) -> Point | None:
        """A direction in which the form has no bound."""
        if self._c is None or not self.unbounded:
            return self.__dict__.get("_read_ray")
        return point_of(self._about, lib.fmb_optimum_ray_text, self._c)

    def __repr__(self) -> str:
        if self.unbounded:
            return f"unbounded along {self.ray!r}"
        if self.value is None:
            return Answer.__repr__(self)
        sign = "" if self.attained else " (not attained)" if self.tight else " (at most so good)"
        return f"{spelled(self.value)}{sign} at {self.point!r}"


class SystemAnswer(Answer):
    """A system that is an answer: `system`, and whatever proves it.

    Of a projection, sum, image or hull `about` is the system that the proof is about."""

    def __init__(self, solver: Any, about: System, result: Any, system: System | None):
        super().__init__(solver, about, result)
        self._system = system

    @property
    def about(self) -> System:
        """The system that the proof is about."""
        return self._about

    @property
    def system(self) -> System:
        """The answer."""
        if self._system is None:
            raise Unfinished(self.stop)
        return self._system

    def __iter__(self) -> Iterator[SystemRow]:
        return iter(self.system)

    def __len__(self) -> int:
        return len(self.system)

    def __str__(self) -> str:
        return str(self.system)

    def __repr__(self) -> str:
        rows = listed([repr(row) for row in self.system], "; ") or "(no rows: everything)"
        return rows if self.done else f"{rows} (outer: {self.stop})"

    def _repr_html_(self) -> str:
        return self.system._repr_html_()


class Reduction(SystemAnswer):
    """A system without redundant rows; `fates[i]` says what became of row i: "kept", "redundant",
    "equality" (it always holds with equality), "unknown" (a limit came first)."""

    def __init__(self, solver: Any, about: System, result: Any, system: System | None,
                 fates: list[str]):
        super().__init__(solver, about, result, system)
        self.fates = fates

    @property
    def redundant(self) -> list[int]:
        """The numbers of rows that the others imply."""
        return [i for i, fate in enumerate(self.fates) if fate == "redundant"]


class Generators(Answer):
    """`vertices`, `rays` and `lines` that generate a polyhedron.

    >>> vertices("0 <= x <= 1; y >= 0")
    vertices: (0, 0), (1, 0); rays: (0, 1)
    """

    def __init__(self, solver: Any, about: System, result: Any, generators: Any):
        super().__init__(solver, about, result)
        self._g = owned("fmb_generators", generators)
        self._lists: dict[int, list[tuple[Fraction, ...]]] | None = None

    def __getstate__(self) -> dict[str, Any]:
        self._all()
        return {**super().__getstate__(), "_g": None}

    def _all(self) -> dict[int, list[tuple[Fraction, ...]]]:
        if self._lists is None:
            if self._g is None and not self.done:
                raise Unfinished(self.stop)
            self._lists = {lib.FMB_VERTEX: [], lib.FMB_RAY: [], lib.FMB_LINE: []}
            for i in range(lib.fmb_generators_size(self._g) if self._g is not None else 0):
                self._lists[lib.fmb_generators_kind(self._g, i)].append(tuple(
                    number(written(lib.fmb_generators_coordinate_text, self._g, i, j))
                    for j in range(self._about.dim)))
        return self._lists

    def _of_kind(self, kind: int) -> list[tuple[Fraction, ...]]:
        return list(self._all()[kind])

    @property
    def vertices(self) -> list[tuple[Fraction, ...]]:
        """Points, in the order of variables."""
        return self._of_kind(lib.FMB_VERTEX)

    @property
    def rays(self) -> list[tuple[Fraction, ...]]:
        """Extreme directions."""
        return self._of_kind(lib.FMB_RAY)

    @property
    def lines(self) -> list[tuple[Fraction, ...]]:
        """Directions both ways."""
        return self._of_kind(lib.FMB_LINE)

    def __len__(self) -> int:
        if self._g is not None:
            return int(lib.fmb_generators_size(self._g))
        return sum(map(len, (self._lists or {}).values()))

    def to_text(self) -> str:
        """The generators as cddlib and lrslib, and `fmb hull`, read them (.ext)."""
        if self._g is None:
            raise StateError("generators from a pickle have no text: write them before")
        return printed(lib.fmb_generators_print, self._g)

    def to_arrays(self) -> Any:
        """(kinds, X): 0 for a vertex, 1 for a ray, 2 for a line, and the nearest doubles."""
        import numpy as np
        n, dim = len(self), self._about.dim
        if self._g is None:  # it came from a pickle
            all_of = [(kind, x) for kind, some in self._all().items() for x in some]
            return (np.array([kind for kind, _ in all_of], np.uintc),
                    np.array([list(map(float, x)) for _, x in all_of], float).reshape(n, dim))
        kinds, X = np.zeros(n, np.uintc), np.zeros((n, dim))
        if n:
            need(lib.fmb_generators_get(
                self._g, 0, n, ffi.cast("fmb_generator_kind *", ffi.from_buffer(kinds)),
                ffi.from_buffer("double[]", X, True) if dim else NULL))
        return kinds, X

    def __repr__(self) -> str:
        if self._g is None and self._lists is None and not self.done:
            return Answer.__repr__(self)
        parts = [f"{word}: " + listed(["(" + ", ".join(map(spelled, x)) + ")" for x in some])
                 for word, some in (("vertices", self.vertices), ("rays", self.rays),
                                    ("lines", self.lines)) if some]
        return "; ".join(parts) or "(empty)"
