"""Systems of linear inequalities."""

from __future__ import annotations

import operator
import os
import re
import warnings
from fractions import Fraction
from typing import Any, Iterable, Iterator, Mapping, Protocol, Sequence, Union, overload

from fmb._lib import (NULL, ArgumentError, Number, encoded, exact, ffi, lib, listed, made, need,
                      number, owned, parsed, printed, spelled, text, written)
from fmb._linear import Form, FormLike, Row, Variable, form, text_of_form


class ParseWarning(UserWarning):
    """Something in a text that is left out: a second objective, a name that may be misspelled."""


RELATIONS = {"<=": lib.FMB_LE, "<": lib.FMB_LT, "=": lib.FMB_EQ, "==": lib.FMB_EQ,
             ">=": lib.FMB_GE, ">": lib.FMB_GT}
WORDS = {lib.FMB_LE: "<=", lib.FMB_LT: "<", lib.FMB_EQ: "="}
FORMATS = ("auto", "fmb", "ine", "ieq", "smt2", "mps", "lp")


class SystemRow:
    """A row of a system, as it is kept: `coefficients` by variable, `relation` (<=, < or =),
    `right`, all exact, and its `label` or None."""

    __slots__ = ("coefficients", "relation", "right", "label")

    def __init__(self, coefficients: dict[str, Fraction], relation: str, right: Fraction,
                 label: str | None):
        self.coefficients = coefficients
        self.relation = relation
        self.right = right
        self.label = label

    def left(self) -> Form:
        """The form on the left."""
        return Form(self.coefficients)

    def as_row(self) -> Row:
        """The same for another system."""
        return Row([(self.left(), self.relation, form(self.right))], self.label)

    def holds(self, point: Mapping[str, Number]) -> bool:
        """Does it hold at a point, exactly?"""
        return self.as_row().holds(point)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, SystemRow) and (
            self.coefficients, self.relation, self.right) == (
            other.coefficients, other.relation, other.right)

    def __hash__(self) -> int:
        return hash((frozenset(self.coefficients.items()), self.relation, self.right))

    def __repr__(self) -> str:
        """With a positive first coefficient, as people write it."""
        terms, relation, right = list(self.coefficients.items()), self.relation, self.right
        if terms and terms[0][1] < 0:
            terms, right = [(name, -c) for name, c in terms], -right
            relation = {"<=": ">=", "<": ">", "=": "="}[relation]
        label = f"{self.label}: " if self.label else ""
        return f"{label}{text_of_form(terms)} {relation} {spelled(right)}"


class HasSystem(Protocol):
    """What stands for a system: a polyhedron."""

    system: System


RowLike = Union[Row, SystemRow, str]
SystemLike = Union["System", str, Row, Iterable[RowLike], HasSystem]


class System:
    """A system of linear inequalities, whose numbers are exact.

    Of a text (a line or what stands between `;` is a row), of rows, or of nothing:

    >>> System("0 <= x <= 4; 2x + y < 10")
    System of 3 rows in x, y
    >>> x, y = vars("x y")
    >>> s = System([x + y <= 3, x >= 0])
    >>> s += y >= x / 2
    >>> print(s)
    x + y <= 3
    x >= 0
    1/2 x - y <= 0
    """

    __slots__ = ("_s", "_names", "__weakref__")

    def __init__(self, rows: SystemLike = (), variables: str | Iterable[str] | None = None):
        self._s: Any
        self._names: tuple[str, ...] | None = None
        if variables is not None:
            self._s = made("fmb_system", lib.fmb_system_new, 0, NULL)
            for name in words(variables):
                self.add_variable(name)
            self.join(system(rows))
        elif isinstance(rows, System):
            self._s = made("fmb_system", lib.fmb_system_copy, rows._s)
        elif isinstance(rows, str):
            self._s = _parse(rows, "fmb")
        else:
            self._s = made("fmb_system", lib.fmb_system_new, 0, NULL)
            for row in _listed_rows(rows):
                self.add(row)

    # ---- from elsewhere ----------------------------------------------------------------------

    @classmethod
    def _of(cls, c_system: Any) -> System:
        self = cls.__new__(cls)
        self._s = c_system
        self._names = None
        return self

    @classmethod
    def parse(cls, source: str | bytes, format: str = "auto") -> System:
        """A system from text in one of the formats fmb, ine, ieq, smt2, mps, lp."""
        return cls._of(_parse(source, format))

    @classmethod
    def read(cls, path: str | os.PathLike[str], format: str = "auto") -> System:
        """A system from a file, whose name tells the format, unless its content does."""
        path = os.fspath(path)
        if format == "auto":
            told = lib.fmb_format_of_name(os.fsencode(path))
            format = text(lib.fmb_format_text(told))
        with open(path, "rb") as file:
            return cls._of(_parse(file.read(), format, path))

    @classmethod
    def from_arrays(cls, A: Any, b: Any, relations: str | Sequence[str] = "<=",
                    names: str | Sequence[str] | None = None) -> System:
        """The rows A x REL b: A a list of lists, an array of NumPy's, or a sparse one of SciPy's.

        A float is meant exactly; fractions are taken in lists, and in arrays of objects.

        >>> System.from_arrays([[1, 1], [1, -1]], [2, 0], ["<=", "="])
        System of 2 rows in x1, x2
        """
        from fmb import _arrays
        made_of: System = _arrays.system(cls, A, b, relations, names)
        return made_of

    # ---- changes -----------------------------------------------------------------------------

    def _trouble(self) -> str:
        return text(lib.fmb_system_trouble(self._s))

    def add_variable(self, name: str | None = None) -> int:
        """Append a variable, which no row names yet; its number is returned."""
        index = ffi.new("int *")
        need(lib.fmb_system_add_variable(self._s, encoded(name) if name is not None else NULL,
                                         index), self._trouble)
        self._names = None
        return int(index[0])

    def _index(self, name: str) -> int:
        j = lib.fmb_system_find(self._s, encoded(name))
        return int(j) if j >= 0 else self.add_variable(name)

    def add(self, row: RowLike) -> None:
        """Append a row, or a chain of them; variables that are new come with it."""
        if isinstance(row, str):
            self.join(System(row))
            return
        if isinstance(row, SystemRow):
            row = row.as_row()
        if not isinstance(row, Row):
            raise TypeError(f"{row!r} is no row: write one like x + y <= 3")
        for left, relation, right in row.links:
            self._add(left - right, relation, row.label)

    def _add(self, difference: Form, relation: str, label: str | None) -> None:
        terms = difference.coefficients
        var = [self._index(name) for name in terms]
        texts = [ffi.new("char[]", spelled(c).encode()) for c in terms.values()]
        need(lib.fmb_system_add_terms_text(
            self._s, len(var), var, ffi.new("char *[]", texts), RELATIONS[relation],
            spelled(-difference.constant).encode()), self._trouble)
        if label is not None:
            need(lib.fmb_system_set_label(self._s, len(self) - 1, encoded(label)), self._trouble)

    def __iadd__(self, rows: RowLike | SystemLike) -> System:
        if isinstance(rows, (Row, SystemRow)):
            self.add(rows)
        else:
            self.join(system(rows))
        return self

    def join(self, other: System) -> None:
        """Append all rows of another system, its variables by their names."""
        var = [self._index(name) for name in other.names]
        need(lib.fmb_system_join(self._s, other._s, var if var else NULL), self._trouble)

    def copy(self) -> System:
        """A system of its own."""
        return System(self)

    def rename(self, old: str, new: str) -> None:
        """Give a variable another name."""
        need(lib.fmb_system_set_name(self._s, self.index(old), encoded(new)), self._trouble)
        self._names = None

    def set_label(self, row: int, label: str | None) -> None:
        """Name a row, or not."""
        need(lib.fmb_system_set_label(self._s, self._row(row),
                                      encoded(label) if label is not None else NULL),
             self._trouble)

    def set_integer(self, *names: str) -> None:
        """Note that variables are integer: answers are about the reals all the same."""
        for name in names:
            need(lib.fmb_system_set_integer(self._s, self.index(name), True), self._trouble)

    # ---- the objective -----------------------------------------------------------------------

    def maximize(self, objective: FormLike) -> None:
        """The form that `optimize` makes large."""
        self._set_objective(lib.FMB_SENSE_MAX, objective)

    def minimize(self, objective: FormLike) -> None:
        """The form that `optimize` makes small."""
        self._set_objective(lib.FMB_SENSE_MIN, objective)

    def _set_objective(self, sense: int, objective: FormLike) -> None:
        if isinstance(objective, str):
            data = encoded(objective)
        else:
            wanted = form(objective)
            for name in wanted.coefficients:
                self._index(name)
            data = encoded(text_of_form([(quoted(name), c) for name, c in
                                         wanted.coefficients.items()], wanted.constant))
        where = ffi.new("fmb_where *")
        parsed(lib.fmb_system_parse_objective(self._s, sense, data, len(data), where), where)

    @property
    def objective(self) -> Form | None:
        """The form that it carries; None if there is none."""
        if lib.fmb_system_sense(self._s) == lib.FMB_SENSE_NONE:
            return None
        n = int(lib.fmb_system_objective_terms(self._s))
        var = ffi.new("int[]", n + 1)
        lib.fmb_system_get_objective(self._s, var, NULL, NULL)
        constant = number(written(lib.fmb_system_objective_constant_text, self._s))
        return Form({self.names[var[k]]: number(written(lib.fmb_system_objective_term_text,
                                                        self._s, k)) for k in range(n)}, constant)

    @property
    def sense(self) -> str | None:
        """Which way its objective is to go: "max" or "min"; None if there is none."""
        return {lib.FMB_SENSE_MAX: "max", lib.FMB_SENSE_MIN: "min"}.get(
            lib.fmb_system_sense(self._s))

    # ---- what there is -----------------------------------------------------------------------

    @property
    def names(self) -> tuple[str, ...]:
        """The names of its variables, in their order."""
        if self._names is None:
            self._names = tuple(text(lib.fmb_system_name(self._s, j)) for j in range(self.dim))
        return self._names

    @property
    def dim(self) -> int:
        """Number of variables."""
        return int(lib.fmb_system_dim(self._s))

    def index(self, name: str | Variable) -> int:
        """The number of a variable."""
        j = lib.fmb_system_find(self._s, encoded(getattr(name, "name", name)))
        if j < 0:
            raise ArgumentError(f"no variable is called {name!r}"
                                + (f": there are {listed(self.names, most=20)}" if self.dim else ""))
        return int(j)

    @property
    def integers(self) -> tuple[str, ...]:
        """Variables that are noted to be integer."""
        return tuple(name for j, name in enumerate(self.names)
                     if lib.fmb_system_is_integer(self._s, j))

    def __len__(self) -> int:
        return int(lib.fmb_system_rows(self._s))

    def _row(self, i: int) -> int:
        n = len(self)
        if not -n <= i < n:
            raise IndexError(f"row {i} of {n}")
        return i % n

    @overload
    def __getitem__(self, i: int) -> SystemRow: ...

    @overload
    def __getitem__(self, i: slice) -> list[SystemRow]: ...

    def __getitem__(self, i: int | slice) -> SystemRow | list[SystemRow]:
        if isinstance(i, slice):
            return [self[k] for k in range(*i.indices(len(self)))]
        i = self._row(operator.index(i))
        n = lib.fmb_system_terms(self._s, i)
        var, rel = ffi.new("int[]", max(1, n)), ffi.new("fmb_rel *")
        need(lib.fmb_system_get_rows(self._s, i, 1, NULL, var, NULL, rel, NULL))
        terms = {self.names[var[k]]: number(written(lib.fmb_system_term_text, self._s, i, k))
                 for k in range(n)}
        label = lib.fmb_system_label(self._s, i)
        return SystemRow(terms, WORDS[rel[0]], number(written(lib.fmb_system_rhs_text, self._s, i)),
                         text(label) if label != NULL else None)

    def __iter__(self) -> Iterator[SystemRow]:
        return (self[i] for i in range(len(self)))

    @property
    def rows(self) -> list[SystemRow]:
        """All rows."""
        return list(self)

    def holds(self, point: Mapping[str, Number] | Sequence[Number]) -> bool:
        """Does every row hold at a point, exactly? Its numbers by name, or in the order of the
        variables.

        >>> System("x + y <= 3; x > 0").holds({"x": "1/3", "y": 0})
        True
        """
        if not isinstance(point, Mapping):
            values = list(point)
            if len(values) != self.dim:
                raise ArgumentError(f"a point of {len(values)} coordinates, but there are "
                                    f"{self.dim} variables")
            point = dict(zip(self.names, values))
        at = {getattr(name, "name", name): exact(x) for name, x in point.items()}
        for name in self.names:
            if name not in at:
                raise ArgumentError(f"the point has no {name!r}")
        return all(row.holds(at) for row in self)

    def to_arrays(self) -> Any:
        """The rows as arrays of NumPy's: (A, relations, b), the nearest doubles."""
        from fmb import _arrays
        return _arrays.dense(self)

    def to_sparse(self) -> Any:
        """The rows as (A, relations, b), A a sparse array of SciPy's."""
        from fmb import _arrays
        return _arrays.sparse(self)

    def to_text(self, format: str = "fmb") -> str:
        """The system in one of the formats fmb, ine, smt2, mps, lp."""
        return printed(lib.fmb_system_print, self._s, _format(format))

    def write(self, path: str | os.PathLike[str], format: str = "auto") -> None:
        """A file, whose name tells the format."""
        path = os.fspath(path)
        if format == "auto":
            format = text(lib.fmb_format_text(lib.fmb_format_of_name(os.fsencode(path))))
        content = self.to_text("fmb" if format == "auto" else format)
        with open(path, "w", encoding="utf-8", errors="surrogateescape", newline="\n") as file:
            file.write(content)

    def __str__(self) -> str:
        return "\n".join(map(repr, self)) if len(self) else "(no rows)"

    def __repr__(self) -> str:
        names = ", ".join(self.names[:6]) + (", ..." if self.dim > 6 else "")
        rows = "row" if len(self) == 1 else "rows"
        return f"System of {len(self)} {rows}" + (f" in {names}" if names else "")

    def _repr_html_(self) -> str:
        from fmb import _html
        return _html.table([str(row) for row in self], repr(self))

    def __copy__(self) -> System:
        return self.copy()

    def __deepcopy__(self, memo: Any) -> System:
        return self.copy()

    def __reduce__(self) -> Any:
        if self.dim == 0 and len(self) == 0:
            return System, ()
        return System.parse, (self.to_text("fmb").encode(errors="surrogateescape"), "fmb")

    def __eq__(self, other: object) -> bool:
        """The same variables and rows in the same order; of sets: Polyhedron."""
        return (isinstance(other, System) and self.names == other.names
                and list(self) == list(other))

    __hash__ = None  # type: ignore[assignment]


def words(names: str | Iterable[Any]) -> list[str]:
    """Names, of variables or as such, in a list or between blanks or commas."""
    if isinstance(names, Variable):
        return [names.name]
    if isinstance(names, str):
        return names.replace(",", " ").split()
    return [getattr(name, "name", name) for name in names]


def quoted(name: str) -> str:
    """A name as fmb's own text has it, whatever is in it."""
    if re.fullmatch(r"[A-Za-z_]\w*", name, re.ASCII):
        return name
    escaped = "".join(f"\\x{b:02x}" if b < 32 or b >= 127 else "\\" * (b in b'"\\') + chr(b)
                      for b in encoded(name))
    return f'"{escaped}"'


def _listed_rows(rows: Any) -> Any:
    """One row, rows, or what has a system."""
    if isinstance(rows, (Row, SystemRow)):
        return [rows]
    own = getattr(rows, "system", rows)
    if isinstance(own, (Form, Mapping)) or not hasattr(own, "__iter__"):
        raise TypeError(f"{rows!r} is neither a system nor a row: write one like x + y <= 3")
    return own


def _format(word: str) -> int:
    out = ffi.new("fmb_format *")
    if not lib.fmb_format_parse(encoded(word), out):
        raise ArgumentError(f"no format is called {word!r}: {', '.join(FORMATS)}")
    return int(out[0])


@ffi.def_extern()  # type: ignore[misc]
def pyfmb_warn(self: Any, where: Any) -> None:
    """A reader leaves something out."""
    ffi.from_handle(self).append(written(lib.fmb_where_text, where, NULL))


_SEMICOLON = re.compile(r'"(?:[^"\\\n]|\\.)*"|#[^\n]*|;')


def _lines(source: str) -> str:
    """In Python's texts `;` ends a line, too, but not in quotes and comments."""
    return _SEMICOLON.sub(lambda m: "\n" if m[0] == ";" else m[0], source)


def _place(source: str, split: str, where: Any) -> None:
    """The place of an error in the text as the user gave it."""
    if split == source or where.line < 1:
        return
    data = encoded(split)
    start = 0
    for _ in range(where.line - 1):
        start = data.index(b"\n", start) + 1
    at = start + max(0, where.column - 1)
    before = encoded(source)[:at]
    where.line = before.count(b"\n") + 1
    where.column = at - before.rfind(b"\n") if where.column else 0


def _parse(source: str | bytes, format: str, name: str | None = None) -> Any:
    how = ffi.new("fmb_reader *", {"size": ffi.sizeof("fmb_reader"), "format": _format(format)})
    warned: list[str] = []
    handle = ffi.new_handle(warned)
    how.warn, how.self = lib.pyfmb_warn, handle
    if not isinstance(source, (str, bytes)):
        raise TypeError(f"a text is a str or bytes, not {source!r}")
    out, where = ffi.new("fmb_system **"), ffi.new("fmb_where *")
    if isinstance(source, str):
        split = source
        if format == "fmb" or format == "auto" and "\n" not in source.strip() and (
                not source.lstrip().startswith(("(", ";"))):
            split = _lines(source)
        data = split.encode(errors="surrogateescape")
    else:
        data = source
    status = lib.fmb_system_parse(data, len(data), how, out, where)
    if status != lib.FMB_OK and isinstance(source, str):
        _place(source, split, where)
    parsed(status, where, name)
    for told in warned:
        warnings.warn(f"{name}:{told}" if name else told, ParseWarning, stacklevel=3)
    return owned("fmb_system", out[0])


def system(like: SystemLike) -> System:
    """A system of what stands for one: itself, a text, a row or rows, or a polyhedron."""
    if isinstance(like, System):
        return like
    own = getattr(like, "system", None)
    return own if isinstance(own, System) else System(like)
