"""Systems from arrays, and back; NumPy and SciPy are asked for only here."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, Sequence

from fmb._lib import NULL, ArgumentError, exact, ffi, lib, made, need


def system(cls: Any, A: Any, b: Any, relations: str | Sequence[str],
           names: Sequence[str] | None) -> Any:
    """The rows A x REL b."""
    rows, dim = _shape(A)
    if len(b) != rows:
        raise ArgumentError(f"A has {rows} rows, but b has {len(b)} numbers")
    self = cls._of(made("fmb_system", lib.fmb_system_new, dim, NULL))
    rel = _relations(relations, rows)
    if hasattr(A, "tocsr"):
        _add_sparse(self, A.tocsr(), b, rel)
    elif getattr(getattr(A, "dtype", None), "kind", "O") in "fiub":
        _add_dense(self, A, b, rel)
    else:
        _add_exact(self, A, b, rel)
    for j, name in enumerate(names or ()):
        need(lib.fmb_system_set_name(self._s, j, name.encode()), self._trouble)
    return self


def _shape(A: Any) -> tuple[int, int]:
    if hasattr(A, "shape"):
        if len(A.shape) != 2:
            raise ArgumentError(f"A has {len(A.shape)} dimensions, not 2")
        return int(A.shape[0]), int(A.shape[1])
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


def _integer(*arrays: Any) -> bool:
    """Are all of them integers that 64 bits hold?"""
    return all(a.dtype.kind in "ib" or (a.dtype.kind == "u" and a.dtype.itemsize < 8)
               for a in arrays)


def _vector(b: Any) -> Any:
    import numpy as np
    b = np.asarray(b)
    if b.dtype.kind not in "fiub":
        raise ArgumentError("b holds more than numbers of NumPy's: give A as lists, too")
    return b


def _add_sparse(self: Any, A: Any, b: Any, rel: Any) -> None:
    import numpy as np
    b = _vector(b)
    whole = _integer(A.data, b)
    number, kind = ("int64_t", np.int64) if whole else ("double", np.float64)
    add = lib.fmb_system_add_rows_int if whole else lib.fmb_system_add_rows
    start = np.ascontiguousarray(A.indptr, np.uintp)
    var = np.ascontiguousarray(A.indices, np.intc)
    coef, right = np.ascontiguousarray(A.data, kind), np.ascontiguousarray(b, kind)
    need(add(self._s, len(b), _view("size_t", start), _view("int", var), _view(number, coef), rel,
             _view(number, right)), self._trouble)


def _add_dense(self: Any, A: Any, b: Any, rel: Any) -> None:
    import numpy as np
    A, b = np.asarray(A), _vector(b)
    whole = _integer(A, b)
    number, kind = ("int64_t", np.int64) if whole else ("double", np.float64)
    add = lib.fmb_system_add_rows_int if whole else lib.fmb_system_add_rows
    coef, right = np.ascontiguousarray(A, kind), np.ascontiguousarray(b, kind)
    need(add(self._s, len(b), NULL, NULL, _view(number, coef), rel, _view(number, right)),
         self._trouble)


def _add_exact(self: Any, A: Any, b: Any, rel: Any) -> None:
    for i, (row, right) in enumerate(zip(A, b)):
        terms = [(j, exact(c)) for j, c in enumerate(row) if c != 0]
        texts = [ffi.new("char[]", str(c).encode()) for _, c in terms]
        need(lib.fmb_system_add_terms_text(self._s, len(terms), [j for j, _ in terms],
                                           ffi.new("char *[]", texts), rel[i],
                                           str(exact(right)).encode()), self._trouble)


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
