"""Cuboids and simplices in any dimension, still or moving: which of them meet, where, and how near
they come. NumPy is needed here."""

from __future__ import annotations

import operator
from fractions import Fraction
from typing import Any, Callable, NamedTuple

import numpy as np

from fmb._answers import Answer
from fmb._lib import NULL, ArgumentError, Unfinished, exact, ffi, in_main_thread, lib, made
from fmb._lib import need, note_lost, number, owned, raise_lost, spelled, text, written
from fmb._solver import _solver
from fmb._system import System

_SHAPES = {"cuboid": lib.FMB_CUBOID, "simplex": lib.FMB_SIMPLEX,
           "cuboid by corners": lib.FMB_CUBOID_BY_CORNERS,
           "simplex by corners": lib.FMB_SIMPLEX_BY_CORNERS}
_CONTACTS = {"closed": lib.FMB_CONTACT_CLOSED, "open": lib.FMB_CONTACT_OPEN}
_SIMD = {"auto": lib.FMB_SIMD_AUTO, "plain": lib.FMB_SIMD_PLAIN, "avx2": lib.FMB_SIMD_AVX2,
         "avx512": lib.FMB_SIMD_AVX512}
MOST_TOLD = 1 << 62


def _word(table: dict[str, int], word: str, what: str) -> int:
    if word not in table:
        raise ArgumentError(f"{word!r} is no {what}: {', '.join(table)}")
    return table[word]


def _array(numbers: Any, what: str) -> Any:
    try:
        return numbers.to_numpy() if hasattr(numbers, "to_numpy") else np.asarray(numbers)
    except ValueError as e:
        raise ArgumentError(f"{what} is no array of numbers: {e}") from e


def doubles(numbers: Any, what: str, kind: Any = np.float64) -> Any:
    """Numbers in an array, as doubles or floats, one behind the other."""
    array = _array(numbers, what)
    if array.dtype.kind not in "fiubO":
        raise ArgumentError(f"{what} holds {array.dtype}, not numbers")
    try:
        return np.ascontiguousarray(array, kind)
    except (TypeError, ValueError) as e:
        raise ArgumentError(f"{what} is no array of numbers: {e}") from e


def whole_numbers(numbers: Any, what: str) -> Any:
    """Numbers of frames or vertices, from 0, in an array."""
    array = _array(numbers, what)
    if array.size == 0:
        return np.ascontiguousarray(array, np.uint32)
    if array.dtype.kind not in "iu":
        raise ArgumentError(f"{what} holds {array.dtype}, not integers")
    if array.min() < 0 or array.max() > 0xffffffff:
        raise ArgumentError(f"{what} counts from 0, to {0xffffffff} at most")
    return np.ascontiguousarray(array, np.uint32)


class Frames:
    """A set of frames: origin + sum c_i axes_i + t speed, 0 <= t <= 1, where a cuboid has
    0 <= c_i <= 1, and a simplex 0 <= c_i, sum c_i <= 1. Everything is copied once.

    origin: [n, dim]; axes: [n, naxes, dim], row i is an edge, or, of a shape "by corners", the
    corner at its end; speed: [n, dim] or None. Arrays of floats or doubles are read where they lie.

    >>> boxes = Frames([[0, 0], [2, 2], [0.5, 0.5]], [[[1, 0], [0, 1]]] * 3)
    >>> boxes.meet()
    array([[0, 2]], dtype=uint32)
    """

    def __init__(self, origin: Any, axes: Any, speed: Any = None, shape: str = "cuboid"):
        single = getattr(origin, "dtype", None) == np.float32
        kind = np.float32 if single else np.float64
        origin, axes = doubles(origin, "origin", kind), doubles(axes, "axes", kind)
        if origin.ndim != 2 or axes.ndim != 3 or axes.shape[::2] != origin.shape:
            raise ArgumentError("origin is of shape [n, dim] and axes of [n, naxes, dim], not "
                                f"{list(origin.shape)} and {list(axes.shape)}")
        arrays = ffi.new("fmb_frame_arrays *", {
            "size": ffi.sizeof("fmb_frame_arrays"), "shape": _word(_SHAPES, shape, "shape"),
            "naxes": axes.shape[1], "single": single, "origin": _data(origin),
            "axes": _data(axes)})
        if speed is not None:
            speed = doubles(speed, "speed", kind)
            if speed.shape != origin.shape:
                raise ArgumentError(f"speed is of shape {list(speed.shape)}, origin of "
                                    f"{list(origin.shape)}")
            arrays.speed = _data(speed)
        self._f = made("fmb_frames", lib.fmb_frames_from_arrays, origin.shape[1], origin.shape[0],
                       arrays, NULL, trouble=lambda: _wrong(origin, axes, speed))

    def __len__(self) -> int:
        return int(lib.fmb_frames_count(self._f))

    @property
    def dim(self) -> int:
        """The dimension of the space."""
        return int(lib.fmb_frames_dim(self._f))

    def __reduce__(self) -> Any:
        raise TypeError("frames are not pickled: pickle the arrays that they are made of")

    def __getitem__(self, i: int) -> Frame:
        i = operator.index(i)
        if not -len(self) <= i < len(self):
            raise IndexError(f"frame {i} of {len(self)}")
        return Frame(self, i % len(self))

    def test(self, other: Frames | None = None, pairs: Any = None, boxes: bool = False,
             inside: bool = False, times: bool = False, witness: bool = False,
             **options: Any) -> Pairs:
        """Do frame a of this set and frame b of the other meet, for all pairs (a, b)? Without
        pairs: frame i of one and frame i of the other. What else is wanted comes as arrays, too.
        Options: contact="closed", threads=1, tightest=False, max_seconds, simd="auto"."""
        other = self if other is None else other
        kernel = _Kernel(self.dim, options)
        if pairs is None:
            n = min(len(self), len(other))
            pairs = np.repeat(np.arange(n, dtype=np.uint32), 2).reshape(-1, 2)
        pairs = whole_numbers(pairs, "pairs")
        if pairs.size == 0:
            pairs = pairs.reshape(0, 2)
        if pairs.ndim != 2 or pairs.shape[1] != 2:
            raise ArgumentError(f"pairs are of shape [n, 2], not {list(pairs.shape)}")
        n, dim = len(pairs), self.dim
        out = Pairs(pairs, np.zeros(n, np.uintc),
                    np.full((n, dim, 2), np.nan) if boxes else None,
                    np.full((n, dim, 2), np.nan) if inside else None,
                    np.full((n, 2), np.nan) if times else None,
                    np.full((n, dim), np.nan) if witness else None)
        answers = ffi.new("fmb_pair_answers *", {
            "size": ffi.sizeof("fmb_pair_answers"),
            "verdict": ffi.cast("fmb_verdict *", _data(out.verdict)), "world": _out(out.world),
            "inside": _out(out.inside), "time": _out(out.time), "witness": _out(out.witness)})
        pointer = ffi.cast("fmb_frames_pair *", _data(pairs))
        kernel.ask(lib.fmb_frames_test, self._f, other._f, n, pointer, answers)
        return out

    def meet(self, other: Frames | None = None, most: int = MOST_TOLD, **options: Any) -> Any:
        """All pairs that meet, [n, 2]: of this set and another, or of this one with itself (a < b);
        no more than `most` of them. Pairs that a limit left open raise Unfinished."""
        kernel, told = _Kernel(self.dim, options), _Told(most)
        handle = ffi.new_handle(told)
        kernel.ask(lib.fmb_frames_meet, self._f, other._f if other is not None else NULL,
                   lib.pyfmb_told, handle)
        if told.raised is not None:
            raise told.raised
        if told.unknown:
            raise Unfinished(f"{told.unknown} pairs are undecided")
        return np.concatenate(told.parts)[:most] if told.parts else np.zeros((0, 2), np.uint32)

    def __repr__(self) -> str:
        return f"Frames: {len(self)} in {self.dim} dimensions"


class Pairs(NamedTuple):
    """Answers to pairs. Of a pair that does not meet only the verdict is known; the rest is nan."""

    pairs: Any
    verdict: Any  # [n]: 1 if they meet, 2 if not, 0 if a limit came first
    world: Any  # [n, dim, 2]: the tightest box of the common points, or None
    inside: Any  # [n, dim, 2]: the same in coordinates of the second frame, or None
    time: Any  # [n, 2]: when they meet, or None
    witness: Any  # [n, dim]: a common point, or None

    @property
    def meets(self) -> Any:
        """[n] of bool; raises Unfinished if a limit left a pair open."""
        if (self.verdict == lib.FMB_UNKNOWN).any():
            raise Unfinished("some pairs are undecided")
        return self.verdict == lib.FMB_FEASIBLE


class _Kernel:
    """Workspace of pairs."""

    def __init__(self, dim: int, options: dict[str, Any]):
        o = ffi.new("fmb_pair_options *", {"size": ffi.sizeof("fmb_pair_options")})
        for name, value in options.items():
            if name == "contact":
                value = _word(_CONTACTS, value, "contact")
            elif name == "simd":
                value = _word(_SIMD, value, "set of instructions")
            elif name not in ("threads", "tightest", "doubles_only", "max_seconds", "max_bytes"):
                raise ArgumentError(f"no option of pairs is called {name!r}")
            set_option(o, name, value)
        out = ffi.new("fmb_pair **")
        need(lib.fmb_pair_new(dim, o, NULL, out),
             lambda: written(lib.fmb_pair_options_trouble, o))
        self.k = owned("fmb_pair", out[0])

    def ask(self, query: Callable[..., int], *arguments: Any) -> None:
        """One query; Ctrl-C ends it."""
        watched = in_main_thread()
        if watched:
            lib.pyfmb_begin(lib.PYFMB_PAIR, self.k)
        try:
            status = query(self.k, *arguments)
        finally:
            if watched:
                lib.pyfmb_end()
        raise_lost()
        need(status, self.trouble)

    def trouble(self) -> str:
        """Why the last query was refused."""
        return text(lib.fmb_pair_trouble(self.k))


class _Told:
    """The pairs reported so far by a query."""

    def __init__(self, most: int):
        self.parts: list[Any] = []
        self.left = most
        self.unknown = 0
        self.raised: BaseException | None = None


@ffi.def_extern(onerror=note_lost)  # type: ignore[misc]
def pyfmb_told(self: Any, verdict: int, n: int, pair: Any) -> bool:
    """Some pairs that meet."""
    told: _Told = ffi.from_handle(self)
    try:
        if verdict == lib.FMB_UNKNOWN:
            told.unknown += n
            return True
        block = np.frombuffer(ffi.buffer(pair, n * ffi.sizeof("fmb_frames_pair")), np.uint32)
        told.parts.append(block.reshape(-1, 2).copy())
        told.left -= n
    except BaseException as e:  # pylint: disable=broad-except
        told.raised = e
    return told.left > 0 and told.raised is None


def set_option(o: Any, name: str, value: Any) -> None:
    """A field of an option structure."""
    try:
        setattr(o, name, value)
    except (TypeError, OverflowError) as e:
        raise ArgumentError(f"{name}={value!r}: {e}") from e


def _wrong(*arrays: Any) -> str:
    """The reason why numbers are no frame's."""
    for name, array in zip(("origin", "axes", "speed"), arrays):
        if array is not None and not np.isfinite(array).all():
            at = np.argwhere(~np.isfinite(array))[0].tolist()
            return f"{name}{at} is {array[tuple(at)]}"
    return ""


def _data(array: Any) -> Any:
    return ffi.cast("void *", array.ctypes.data)


def _out(array: Any) -> Any:
    return ffi.cast("double *", array.ctypes.data) if array is not None else NULL


# ---- one pair, exactly -----------------------------------------------------------------------


class Frame:
    """One frame of a set; or of its own: `cuboid`, `simplex`."""

    def __init__(self, frames: Frames, i: int):
        self.frames = frames
        self.i = i

    def _c(self) -> Any:
        return lib.fmb_frames_at(self.frames._f, self.i)

    def meets(self, other: Frame, **options: Any) -> bool:
        """Have they a common point at some time? Options as of Frames.test.

        >>> cuboid([0], [[1]]).meets(simplex([1], [[2]]))
        True
        """
        kernel, verdict = _Kernel(self.frames.dim, options), ffi.new("fmb_verdict *")
        answers = ffi.new("fmb_pair_answers *", {"size": ffi.sizeof("fmb_pair_answers"),
                                                 "verdict": verdict})
        both = _two(self, other)
        kernel.ask(lib.fmb_pair_test, 1, both, both + 1, answers)
        if verdict[0] == lib.FMB_UNKNOWN:
            raise Unfinished("1 pair is undecided")
        return bool(verdict[0] == lib.FMB_FEASIBLE)

    def __repr__(self) -> str:
        return f"Frame {self.i} of {self.frames!r}"


def cuboid(origin: Any, axes: Any, speed: Any = None) -> Frame:
    """The cuboid (parallelotope) with that corner and those edges."""
    return _one(origin, axes, speed, "cuboid")


def simplex(origin: Any, axes: Any, speed: Any = None) -> Frame:
    """The simplex (triangle, tetrahedron, ...) with that corner and those edges from it."""
    return _one(origin, axes, speed, "simplex")


def _one(origin: Any, axes: Any, speed: Any, shape: str) -> Frame:
    return Frames([_doubles_only(origin)], [[_doubles_only(axis) for axis in axes]],
                  [_doubles_only(speed)] if speed is not None else None, shape)[0]


def _doubles_only(numbers: Any) -> list[float]:
    """Frames are made of doubles, and answers about them are exact: so nothing is rounded here."""
    out = []
    for x in numbers:
        value = exact(x)
        out.append(float(value))
        if out[-1] != value:
            raise ArgumentError(f"{spelled(value)} is no double: a frame of float({value}) is "
                                "another one")
    return out


class Proximity(Answer):
    """How near two frames come, or how deep they are in each other: `length`, and the `shift` of
    the second after which they touch; `square` is exact, of the Euclidean length."""

    def __init__(self, solver: Any, result: Any, p: Any, norm: str):
        super().__init__(solver, System(), result)
        p = owned("fmb_proximity", p)
        dim = range(lib.fmb_proximity_dim(p))
        self.length = float(lib.fmb_proximity_length(p))
        self.shift = [number(written(lib.fmb_proximity_shift_text, p, j)) for j in dim]
        self.points = [[number(written(lib.fmb_proximity_point_text, p, which, j)) for j in dim]
                       for which in (0, 1)]
        self.time = number(written(lib.fmb_proximity_time_text, p))
        measure = number(written(lib.fmb_proximity_measure_text, p))
        self.square: Fraction = measure if norm == "euclidean" else measure * measure

    def __repr__(self) -> str:
        return f"{self.length} by ({', '.join(map(spelled, self.shift))})"


_NORMS = {"euclidean": lib.FMB_NORM_EUCLIDEAN, "max": lib.FMB_NORM_MAX}


def _two(a: Frame, b: Frame) -> Any:
    both = ffi.new("fmb_frame[2]")
    both[0], both[1] = a._c(), b._c()
    return both


def _near(query: Callable[..., int], a: Frame, b: Frame, norm: str,
          options: dict[str, Any]) -> Proximity | None:
    v, out = _solver(options), ffi.new("fmb_proximity **")
    result = v._ask(query, _two(a, b), _word(_NORMS, norm, "norm"), out)
    _finished(result, out)
    if out[0] == NULL:
        return None
    return Proximity(v._v, result, out[0], norm)


def _finished(result: Any, out: Any) -> None:
    """Raises if the result is missing because of a limit."""
    if out[0] == NULL and result.stop != lib.FMB_STOP_DONE:
        raise Unfinished(text(lib.fmb_stop_text(result.stop)))


def distance(a: Frame, b: Frame, norm: str = "euclidean", **options: Any) -> Proximity | None:
    """How near they come; 0 if they meet.

    >>> distance(cuboid([0, 0], [[1, 0], [0, 1]]), cuboid([4, 5], [[1, 0], [0, 1]])).square
    Fraction(25, 1)
    """
    return _near(lib.fmb_distance, a, b, norm, options)


def depth(a: Frame, b: Frame, norm: str = "euclidean", **options: Any) -> Proximity | None:
    """How far the second has to go until they only touch; None if they are apart."""
    return _near(lib.fmb_depth, a, b, norm, options)


def meeting(*frames: Frame, contact: str = "closed") -> System:
    """A system that has a solution if and only if the frames share a point at one time: over the
    point, the coordinates within each frame and, if something moves, the time.

    >>> solve(meeting(cuboid([0], [[2]]), cuboid([1], [[5]]), cuboid([2], [[1]]))).point["x1"]
    Fraction(2, 1)
    """
    if not frames:
        raise ArgumentError("no frame is given")
    all_of = ffi.new("fmb_frame[]", len(frames))
    for k, one in enumerate(frames):
        all_of[k] = one._c()
    return System._of(made("fmb_system", lib.fmb_system_from_frames, all_of, len(frames),
                           lib.FMB_COORDINATES_ALL, _word(_CONTACTS, contact, "contact"), NULL))


def separate(a: Frame, b: Frame, contact: str = "closed", **options: Any) -> System | None:
    """A row that the first satisfies, and the second the other way round; None if they meet."""
    v, out = _solver(options), ffi.new("fmb_system **")
    result = v._ask(lib.fmb_separate, _two(a, b), _word(_CONTACTS, contact, "contact"), out)
    _finished(result, out)
    return System._of(owned("fmb_system", out[0])) if out[0] != NULL else None


def common(a: Frame, b: Frame, **options: Any) -> list[tuple[Fraction, ...]]:
    """The vertices of what they have in common.

    >>> common(cuboid([0, 0], [[2, 0], [0, 2]]), cuboid([1, 1], [[2, 0], [0, 2]]))
    [(Fraction(1, 1), Fraction(1, 1)), (Fraction(2, 1), Fraction(1, 1)), \
(Fraction(2, 1), Fraction(2, 1)), (Fraction(1, 1), Fraction(2, 1))]
    """
    v, out = _solver(options), ffi.new("fmb_generators **")
    result = v._ask(lib.fmb_common, _two(a, b), out)
    _finished(result, out)
    if out[0] == NULL:
        return []
    g = owned("fmb_generators", out[0])
    dim = range(lib.fmb_generators_dim(g))
    return [tuple(number(written(lib.fmb_generators_coordinate_text, g, i, j)) for j in dim)
            for i in range(lib.fmb_generators_size(g))]
