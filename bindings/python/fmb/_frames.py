"""Cuboids and simplices in any dimension, still or moving: which of them meet, where, and how near
they come. NumPy is needed here."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Callable, NamedTuple

import numpy as np

from fmb._answers import Answer
from fmb._lib import NULL, ArgumentError, Unfinished, ffi, lib, made, need, number
from fmb._lib import owned, text, written
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
        origin = np.ascontiguousarray(origin, kind)
        axes = np.ascontiguousarray(axes, kind)
        if origin.ndim != 2 or axes.ndim != 3 or axes.shape[::2] != origin.shape:
            raise ArgumentError("origin is of shape [n, dim] and axes of [n, naxes, dim], not "
                                f"{list(origin.shape)} and {list(axes.shape)}")
        arrays = ffi.new("fmb_frame_arrays *", {
            "size": ffi.sizeof("fmb_frame_arrays"), "shape": _word(_SHAPES, shape, "shape"),
            "naxes": axes.shape[1], "single": single, "origin": _data(origin),
            "axes": _data(axes)})
        if speed is not None:
            speed = np.ascontiguousarray(speed, kind)
            if speed.shape != origin.shape:
                raise ArgumentError(f"speed is of shape {list(speed.shape)}, origin of "
                                    f"{list(origin.shape)}")
            arrays.speed = _data(speed)
        self._f = made("fmb_frames", lib.fmb_frames_from_arrays, origin.shape[1], origin.shape[0],
                       arrays, NULL)

    def __len__(self) -> int:
        return int(lib.fmb_frames_count(self._f))

    @property
    def dim(self) -> int:
        """The dimension of the space."""
        return int(lib.fmb_frames_dim(self._f))

    def __getitem__(self, i: int) -> Frame:
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
        pairs = np.ascontiguousarray(pairs, np.uint32)
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
        need(lib.fmb_frames_test(kernel.k, self._f, other._f, n, pointer, answers), kernel.trouble)
        return out

    def meet(self, other: Frames | None = None, most: int = MOST_TOLD, **options: Any) -> Any:
        """All pairs that meet, [n, 2]: of this set and another, or of this one with itself (a < b);
        no more than `most` of them. Pairs that a limit left open raise Unfinished."""
        kernel, told = _Kernel(self.dim, options), _Told(most)
        handle = ffi.new_handle(told)
        need(lib.fmb_frames_meet(kernel.k, self._f, other._f if other is not None else NULL,
                                 lib.pyfmb_told, handle), kernel.trouble)
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
            setattr(o, name, value)
        out = ffi.new("fmb_pair **")
        need(lib.fmb_pair_new(dim, o, NULL, out),
             lambda: written(lib.fmb_pair_options_trouble, o))
        self.k = owned("fmb_pair", out[0])

    def trouble(self) -> str:
        """Why the last query was refused."""
        return text(lib.fmb_pair_trouble(self.k))


class _Told:
    """Pairs as they are told of."""

    def __init__(self, most: int):
        self.parts: list[Any] = []
        self.left = most
        self.unknown = 0
        self.raised: BaseException | None = None


@ffi.def_extern()  # type: ignore[misc]
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


def cuboid(origin: Any, axes: Any, speed: Any = None) -> Frame:
    """The cuboid (parallelotope) with that corner and those edges."""
    return _one(origin, axes, speed, "cuboid")


def simplex(origin: Any, axes: Any, speed: Any = None) -> Frame:
    """The simplex (triangle, tetrahedron, ...) with that corner and those edges from it."""
    return _one(origin, axes, speed, "simplex")


def _one(origin: Any, axes: Any, speed: Any, shape: str) -> Frame:
    return Frames([origin], [axes], [speed] if speed is not None else None, shape)[0]


class Proximity(Answer):
    """How near two frames come, or how deep they are in each other: `length`, and the `shift` of
    the second after which they touch; `square` is exact, of the Euclidean length."""

    def __init__(self, solver: Any, result: Any, p: Any, norm: str):
        super().__init__(solver, System(), result)
        self._p = owned("fmb_proximity", p)
        self._norm = norm
        dim = range(lib.fmb_proximity_dim(p))
        self.length = float(lib.fmb_proximity_length(p))
        self.shift = [number(written(lib.fmb_proximity_shift_text, p, j)) for j in dim]
        self.points = [[number(written(lib.fmb_proximity_point_text, p, which, j)) for j in dim]
                       for which in (0, 1)]
        self.time = number(written(lib.fmb_proximity_time_text, p))

    @property
    def square(self) -> Fraction:
        """The square of the length, exactly."""
        measure = number(written(lib.fmb_proximity_measure_text, self._p))
        return measure if self._norm == "euclidean" else measure * measure

    def __repr__(self) -> str:
        return f"{self.length} by ({', '.join(map(str, self.shift))})"


_NORMS = {"euclidean": lib.FMB_NORM_EUCLIDEAN, "max": lib.FMB_NORM_MAX}


def _two(a: Frame, b: Frame) -> Any:
    both = ffi.new("fmb_frame[2]")
    both[0], both[1] = a._c(), b._c()
    return both


def _near(query: Callable[..., int], a: Frame, b: Frame, norm: str,
          options: dict[str, Any]) -> Proximity | None:
    v, out = _solver(options), ffi.new("fmb_proximity **")
    result = v._ask(query, _two(a, b), _word(_NORMS, norm, "norm"), out)
    if out[0] == NULL:
        if result.stop != lib.FMB_STOP_DONE:
            raise Unfinished(text(lib.fmb_stop_text(result.stop)))
        return None
    return Proximity(v._v, result, out[0], norm)


def distance(a: Frame, b: Frame, norm: str = "euclidean", **options: Any) -> Proximity | None:
    """How near they come; 0 if they meet.

    >>> distance(cuboid([0, 0], [[1, 0], [0, 1]]), cuboid([4, 5], [[1, 0], [0, 1]])).square
    Fraction(25, 1)
    """
    return _near(lib.fmb_distance, a, b, norm, options)


def depth(a: Frame, b: Frame, norm: str = "euclidean", **options: Any) -> Proximity | None:
    """How far the second has to go until they only touch; None if they are apart."""
    return _near(lib.fmb_depth, a, b, norm, options)


def separate(a: Frame, b: Frame, contact: str = "closed", **options: Any) -> System | None:
    """A row that the first satisfies, and the second the other way round; None if they meet."""
    v, out = _solver(options), ffi.new("fmb_system **")
    v._ask(lib.fmb_separate, _two(a, b), _word(_CONTACTS, contact, "contact"), out)
    return System._of(owned("fmb_system", out[0])) if out[0] != NULL else None


def common(a: Frame, b: Frame, **options: Any) -> list[tuple[Fraction, ...]]:
    """The vertices of what they have in common.

    >>> common(cuboid([0, 0], [[2, 0], [0, 2]]), cuboid([1, 1], [[2, 0], [0, 2]]))
    [(Fraction(1, 1), Fraction(1, 1)), (Fraction(2, 1), Fraction(1, 1)), \
(Fraction(2, 1), Fraction(2, 1)), (Fraction(1, 1), Fraction(2, 1))]
    """
    v, out = _solver(options), ffi.new("fmb_generators **")
    v._ask(lib.fmb_common, _two(a, b), out)
    if out[0] == NULL:
        return []
    g = owned("fmb_generators", out[0])
    dim = range(lib.fmb_generators_dim(g))
    return [tuple(number(written(lib.fmb_generators_coordinate_text, g, i, j)) for j in dim)
            for i in range(lib.fmb_generators_size(g))]
