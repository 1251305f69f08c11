"""Meshes of triangles or tetrahedra: which cells meet, and how. NumPy is needed here."""

from __future__ import annotations

import os
from typing import Any

import numpy as np

from fmb._frames import Proximity, doubles, set_option, whole_numbers
from fmb._lib import NULL, ArgumentError, Unfinished, encoded, exact, ffi, in_main_thread, lib
from fmb._lib import made, need, owned, parsed, text, written
from fmb._solver import _solver

HOW = ("apart", "share", "touch", "cross", "coplanar")


def _three(numbers: Any, what: str) -> list[float]:
    out = list(map(float, numbers))
    if len(out) != 3:
        raise ArgumentError(f"{what} has {len(out)} numbers, not 3")
    return out


class Mesh:
    """Cells over common vertices in space: points [n, 3], and cells [m, 3] (triangles) or [m, 4]
    (tetrahedra), which number them from 0. Everything is copied.

    >>> tent = Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [.2, .2, -1], [.2, .2, 1], [.9, .9, 1]],
    ...             [[0, 1, 2], [3, 4, 5]])
    >>> tent.meet().hits
    [(0, 1, 'cross')]
    """

    def __init__(self, points: Any, cells: Any):
        points, cells = doubles(points, "points"), whole_numbers(cells, "cells")
        if points.ndim != 2 or points.shape[1] != 3 or cells.ndim != 2 or (
                cells.shape[1] not in (3, 4)):
            raise ArgumentError("points are of shape [n, 3] and cells of [m, 3] or [m, 4], not "
                                f"{list(points.shape)} and {list(cells.shape)}")
        self._m = made("fmb_mesh", lib.fmb_mesh_new, cells.shape[1], len(points),
                       ffi.cast("double *", points.ctypes.data), len(cells),
                       ffi.cast("uint32_t *", cells.ctypes.data), NULL)

    @classmethod
    def read(cls, path: str | os.PathLike[str], format: str = "auto") -> Mesh:
        """A mesh from a file: OFF, OBJ, PLY, STL, medit."""
        path = os.fspath(path)
        kind = ffi.new("fmb_mesh_format *")
        if not lib.fmb_mesh_format_parse(encoded(format), kind):
            raise ArgumentError(f"no format of meshes is called {format!r}")
        told = kind[0] or lib.fmb_mesh_format_of_name(os.fsencode(path))
        with open(path, "rb") as file:
            data = file.read()
        out, where = ffi.new("fmb_mesh **"), ffi.new("fmb_where *")
        parsed(lib.fmb_mesh_parse(ffi.from_buffer(data), len(data), told, NULL, out, where), where,
               path)
        return cls._of(owned("fmb_mesh", out[0]))

    @classmethod
    def _of(cls, c_mesh: Any) -> Mesh:
        self = cls.__new__(cls)
        self._m = c_mesh
        return self

    @property
    def points(self) -> Any:
        """[n, 3]: its vertices, without a copy; read only."""
        return self._array(lib.fmb_mesh_points(self._m), lib.fmb_mesh_vertices(self._m), 3,
                           np.float64)

    @property
    def cells(self) -> Any:
        """[m, 3] or [m, 4]: the vertices of its cells, without a copy; read only."""
        return self._array(lib.fmb_mesh_indices(self._m), len(self),
                           lib.fmb_mesh_corners(self._m), np.uint32)

    def _array(self, pointer: Any, rows: int, columns: int, kind: Any) -> Any:
        if rows == 0:
            return np.zeros((0, columns), kind)
        block = ffi.gc(ffi.cast("char *", pointer), lambda _, mesh=self._m: None)
        view = ffi.buffer(block, rows * columns * np.dtype(kind).itemsize)
        array = np.frombuffer(view, kind).reshape(rows, columns)
        array.flags.writeable = False
        return array

    def __len__(self) -> int:
        return int(lib.fmb_mesh_cells(self._m))

    def __reduce__(self) -> Any:
        return Mesh, (np.array(self.points), np.array(self.cells))

    def group(self, cell: int) -> str | None:
        """The name of the group of faces that a cell is of, as OBJ has them, or None.

        >>> import os, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     path = os.path.join(folder, "wing.obj")
        ...     with open(path, "w", encoding="ascii") as out:
        ...         _ = out.write("v 0 0 0\\nv 1 0 0\\nv 0 1 0\\ng left wing\\nf 1 2 3\\n")
        ...     Mesh.read(path).group(0)
        'left wing'
        """
        name = lib.fmb_mesh_group(self._m, cell)
        return text(name) if name != NULL else None

    def placed(self, scale: Any = 1, move: Any = (0, 0, 0)) -> Mesh:
        """The mesh at another place: scale * x + move, scale a number or one for each axis."""
        if isinstance(scale, (int, float)):
            scale = (scale, scale, scale)
        place = ffi.new("fmb_mesh_place *", {"scale": _three(scale, "scale"),
                                             "move": _three(move, "move")})
        return Mesh._of(made("fmb_mesh", lib.fmb_mesh_placed, self._m, place, NULL))

    def meet(self, other: Mesh | None = None, motion: Any = None, within: Any = 0,
             **options: Any) -> Hits:
        """Which cells meet those of another mesh, or one another. motion: [3], by which the other
        moves while t goes from 0 to 1. within: cells that are no farther apart are hits, too,
        exactly; a number, a Fraction or "1/3". Options: neighbours=False, threads=1, max_seconds,
        max_bytes.

        >>> flat = Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> flat.meet(flat.placed(move=(0, 0, 0.5)), within="1/2").hits
        [(0, 0, 'apart')]
        """
        answer = ffi.gc(ffi.new("fmb_mesh_answer *", {"size": ffi.sizeof("fmb_mesh_answer")}),
                        lib.fmb_mesh_answer_clear)
        length = ffi.new("char[]", encoded(str(exact(within))))
        self._ask(lib.fmb_mesh_meet, other, motion, length, options, answer)
        return Hits(answer)

    def distance(self, other: Mesh, motion: Any = None,
                 **options: Any) -> tuple[int, int, Proximity] | None:
        """How far another mesh is apart, exactly: the nearest cells of both, and their distance, as
        `fmb.distance` tells it; None if a mesh has no cell. Motion and options: as above.

        >>> flat = Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> a, b, near = flat.distance(flat.placed(move=(3, 0, 1)))
        >>> a, b, near.square, near.points[0]
        (0, 0, Fraction(5, 1), [Fraction(1, 1), Fraction(0, 1), Fraction(0, 1)])
        """
        out = ffi.new("fmb_mesh_nearest *", {"size": ffi.sizeof("fmb_mesh_nearest")})
        self._ask(lib.fmb_mesh_distance, other, motion, NULL, options, out)
        if out.stop != lib.FMB_STOP_DONE:
            raise Unfinished(text(lib.fmb_stop_text(out.stop)))
        if out.distance == NULL:
            return None
        meet = lib.fmb_proximity_length(out.distance) == 0
        result = ffi.new("fmb_result *", {"size": ffi.sizeof("fmb_result"), "verdict": (
            lib.FMB_FEASIBLE if meet else lib.FMB_INFEASIBLE)})
        return int(out.a), int(out.b), Proximity(_solver({})._v, result, out.distance, "euclidean")

    def _ask(self, query: Any, other: Mesh | None, motion: Any, within: Any,
             options: dict[str, Any], out: Any) -> None:
        o = ffi.new("fmb_mesh_options *", {"size": ffi.sizeof("fmb_mesh_options")})
        for name, value in options.items():
            if name not in ("neighbours", "threads", "max_seconds", "max_bytes"):
                raise ArgumentError(f"no option of meshes is called {name!r}")
            set_option(o, name, value)
        moving = ffi.new("double[3]", _three(motion, "motion")) if motion is not None else NULL
        o.motion, o.within = moving, within
        going = ffi.new("bool *", True)
        o.progress, o.self = ffi.addressof(lib, "pyfmb_goes_on"), going
        watched = in_main_thread()
        if watched:
            lib.pyfmb_begin(lib.PYFMB_MESH, going)
        try:
            status = query(self._m, other._m if other is not None else NULL, o, out)
        finally:
            if watched:
                lib.pyfmb_end()
        need(status, lambda: written(lib.fmb_mesh_options_trouble, o))

    def __repr__(self) -> str:
        kind = "triangles" if lib.fmb_mesh_corners(self._m) == 3 else "tetrahedra"
        return f"Mesh of {len(self)} {kind}"


class Hits:
    """Cells that meet: arrays `a`, `b`, `shared` (vertices in common), `how` (numbers of the words
    in HOW); `hits`, the same as tuples; `stop`, "done" unless a limit was reached."""

    def __init__(self, answer: Any):
        n = int(answer.hits)
        kind = np.dtype([("a", np.uint32), ("b", np.uint32), ("shared", np.intc),
                         ("how", np.uintc)])
        block = ffi.buffer(answer.hit, n * kind.itemsize) if n else b""
        table = np.frombuffer(block, kind).copy()
        self.a, self.b, self.shared, self.how = (table[name] for name in table.dtype.names)
        self.tested = int(answer.tested)
        self.stop = text(lib.fmb_stop_text(answer.stop))

    @property
    def hits(self) -> list[tuple[int, int, str]]:
        """(a, b, how) of each."""
        return [(int(a), int(b), HOW[how]) for a, b, how in zip(self.a, self.b, self.how)]

    def __len__(self) -> int:
        return len(self.a)

    def __repr__(self) -> str:
        return f"{len(self)} hits" + ("" if self.stop == "done" else f" ({self.stop})")
