"""Systems from arrays, and back; NumPy and SciPy are asked for only here."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Sequence

from fmb._lib import NULL, ArgumentError, encoded, exact, ffi, lib, made, need, spelled


def system(cls: Any, A: Any, b: Any, relations: str | Sequence[str],
           names: str | Sequence[str] | None) -> Any:
    """The rows A x REL b."""
    from fmb._system import words
    A, b = _plain(A), _plain(b)
    rows, dim = _shape(A)
    if getattr(b, "ndim", 1) != 1 or not hasattr(b, "__len__"):
        raise ArgumentError(f"b has {getattr(b, 'ndim', 0)} dimensions, not 1")
    if len(b) != rows:
        raise ArgumentError(f"A has {rows} rows, but b has {len(b)} numbers")
    called = words(names) if names is not None else []
    if names is not None and len(called) != dim:
        raise ArgumentError(f"A has {dim} columns, but there are {len(called)} names")
    self = cls._of(made("fmb_system", lib.fmb_system_new, dim, NULL))
    rel = _relations(relations, rows)
    if hasattr(A, "tocsr"):
        _add_sparse(self, A.tocsr(), b, rel)
    elif _is_numbers(A):
        _add_dense(self, A, b, rel)
    elif not _add_integers(self, A, b, rel):
        _add_exact(self, A, b, rel)
    if not set(called).isdisjoint(self.names):  # one may be the usual one of another variable
        for j in range(dim):
            need(lib.fmb_system_set_name(self._s, j, b"\1%d" % j), self._trouble)
    self._names = None
    for j, name in enumerate(called):
        need(lib.fmb_system_set_name(self._s, j, encoded(name)), self._trouble)
    return self


def _plain(array: Any) -> Any:
    """The values of a table such as one of pandas."""
    return array.to_numpy() if hasattr(array, "to_numpy") else array


def _shape(A: Any) -> tuple[int, int]:
    if hasattr(A, "shape"):
        if len(A.shape) != 2:
            raise ArgumentError(f"A has {len(A.shape)} dimensions, not 2")
        return int(A.shape[0]), int(A.shape[1])
    if not all(hasattr(row, "__len__") for row in A):
        raise ArgumentError("A is no matrix: give a list of rows, or an array")
    dims = {len(row) for row in A}
    if len(dims) > 1:
        raise ArgumentError("the rows of A are not of one length")
    return len(A), dims.pop() if dims else 0


def _relations(relations: str | Sequence[str], rows: int) -> Any:
    from fmb._system import RELATIONS
    words = [relations] * rows if isinstance(relations, str) else list(relations)
    if len(words) != rows:
        raise ArgumentError(f"A has {rows} rows, but there are {len(words)} relations")
    try:
        return ffi.new("fmb_rel[]", [RELATIONS[word] for word in words])
    except KeyError as e:
        raise ArgumentError(f"{e.args[0]!r} is no relation: {', '.join(RELATIONS)}") from e


def _vector(b: Any) -> Any:
    import numpy as np
    try:
        out = np.asarray(b)
    except ValueError as e:
        raise ArgumentError(f"b is no list of numbers: {e}") from e
    if out.ndim != 1:
        raise ArgumentError(f"b has {out.ndim} dimensions, not 1")
    return out


def _is_numbers(array: Any) -> bool:
    """An array of NumPy's whose numbers are integers, or doubles at most?"""
    kind = getattr(array, "dtype", None)
    return kind is not None and (kind.kind in "iub" or (kind.kind == "f" and kind.itemsize <= 8))


def _kind(*arrays: Any) -> tuple[str, Any, Any] | None:
    """What all these numbers are exactly: integers of 64 bits, or doubles; or None."""
    import numpy as np
    if all(a.dtype.kind in "ib" or (a.dtype.kind == "u" and (
            a.dtype.itemsize < 8 or a.size == 0 or a.max() < 1 << 63)) for a in arrays):
        return "int64_t", np.int64, lib.fmb_system_add_rows_int
    if all(a.dtype.kind == "f" or a.size == 0 or (
            -(1 << 53) <= int(a.min()) and int(a.max()) <= 1 << 53) for a in arrays):
        return "double", np.float64, lib.fmb_system_add_rows
    return None


def _add_sparse(self: Any, A: Any, b: Any, rel: Any) -> None:
    import numpy as np
    b = _vector(b)
    kind = _kind(A.data, b) if _is_numbers(A.data) and _is_numbers(b) else None
    if kind is None:
        start, var, coef = A.indptr.tolist(), A.indices.tolist(), A.data.tolist()
        for i, right in enumerate(b.tolist()):
            part = slice(start[i], start[i + 1])
            _add_terms(self, list(zip(var[part], coef[part])), right, rel[i])
        return
    number, dtype, add = kind
    start = np.ascontiguousarray(A.indptr, np.uintp)
    var = np.ascontiguousarray(A.indices, np.intc)
    coef, right = np.ascontiguousarray(A.data, dtype), np.ascontiguousarray(b, dtype)
    need(add(self._s, len(b), _view("size_t", start), _view("int", var), _view(number, coef), rel,
             _view(number, right)), self._trouble)


def _add_dense(self: Any, A: Any, b: Any, rel: Any) -> None:
    import numpy as np
    A, right = np.asarray(A), _vector(b)
    kind = _kind(A, right) if _is_numbers(right) else None
    if kind is None:
        _add_exact(self, A.tolist(), b, rel)
        return
    number, dtype, add = kind
    coef, right = np.ascontiguousarray(A, dtype), np.ascontiguousarray(right, dtype)
    need(add(self._s, len(right), NULL, NULL, _view(number, coef), rel, _view(number, right)),
         self._trouble)


def _add_integers(self: Any, A: Any, b: Any, rel: Any) -> bool:
    """Lists of 64-bit integers only; False for all others."""
    flat = [c for row in A for c in row]
    if set(map(type, flat)) | set(map(type, b)) != {int}:
        return False
    try:
        coef, right = ffi.new("int64_t[]", flat), ffi.new("int64_t[]", list(b))
    except OverflowError:
        return False
    need(lib.fmb_system_add_rows_int(self._s, len(right), NULL, NULL, coef, rel, right),
         self._trouble)
    return True


def _add_exact(self: Any, A: Any, b: Any, rel: Any) -> None:
    for i, (row, right) in enumerate(zip(A, b)):
        _add_terms(self, list(enumerate(row)), right, rel[i])


def _add_terms(self: Any, row: list[tuple[int, Any]], right: Any, relation: int) -> None:
    terms = [(j, value) for j, value in ((j, exact(c)) for j, c in row) if value]
    texts = [ffi.new("char[]", spelled(c).encode()) for _, c in terms]
    need(lib.fmb_system_add_terms_text(self._s, len(terms), [j for j, _ in terms],
                                       ffi.new("char *[]", texts), relation,
                                       spelled(exact(right)).encode()), self._trouble)


def _view(kind: str, array: Any) -> Any:
    """An array's memory; the library copies what it keeps."""
    return ffi.from_buffer(f"{kind}[]", array) if array.size else NULL


def _matrix(self: Any) -> Any:
    import numpy as np
    from fmb._system import WORDS
    m, n, terms = len(self), self.dim, int(lib.fmb_system_nonzeros(self._s))
    start, var = np.zeros(m + 1, np.uintp), np.zeros(terms, np.intc)
    coef, b, rel = np.zeros(terms), np.zeros(m), np.zeros(m, np.uintc)
    need(lib.fmb_system_get_rows(
        self._s, 0, m, ffi.from_buffer("size_t[]", start, True), _out("int", var),
        _out("double", coef), ffi.cast("fmb_rel *", _out("unsigned int", rel)), _out("double", b)))
    return start, var, coef, [WORDS[r] for r in rel], b, (m, n)


def _out(kind: str, array: Any) -> Any:
    return ffi.from_buffer(f"{kind}[]", array, True) if array.size else NULL


def sparse(self: Any) -> Any:
    """(A, relations, b) with a sparse A."""
    from scipy.sparse import csr_array
    start, var, coef, rel, b, shape = _matrix(self)
    return csr_array((coef, var, start.astype(int)), shape=shape), rel, b


def dense(self: Any) -> Any:
    """(A, relations, b)."""
    import numpy as np
    start, var, coef, rel, b, shape = _matrix(self)
    A = np.zeros(shape)
    A[np.repeat(np.arange(shape[0]), np.diff(start.astype(int))), var] = coef
    return A, rel, b


def fractions(self: Any) -> tuple[list[list[Fraction]], list[str], list[Fraction]]:
    """The rows as lists of fractions: (A, relations, b)."""
    A, rel, b = [], [], []
    for row in self:
        A.append([row.coefficients.get(name, Fraction(0)) for name in self.names])
        rel.append(row.relation)
        b.append(row.right)
    return A, rel, b
