"""Variables, linear forms and rows that are written as in mathematics."""

from __future__ import annotations

import opcode
import re
import sys
import threading
from fractions import Fraction
from numbers import Number as Number_
from types import FrameType
from typing import Any, Iterable, Iterator, Mapping, Union

from fmb._lib import ArgumentError, Number, exact, spelled

_chains = threading.local()


def _name_of(variable: Any) -> str:
    """The name of a variable given by itself or by its name."""
    name = getattr(variable, "name", variable)
    if not isinstance(name, str) or not name:
        raise ArgumentError(f"a variable needs a name, not {name!r}")
    return name


class Form:
    """A linear form: `coefficients` by the names of variables, and a `constant`, all exact.

    >>> x, y = vars("x y")
    >>> 2 * x + y / 3 - 1
    2x + 1/3 y - 1
    """

    __slots__ = ("coefficients", "constant")
    __hash__ = None  # type: ignore[assignment]
    __array_ufunc__ = None  # so that a number of NumPy's leaves arithmetic to the form

    def __init__(self, coefficients: Mapping[str, Number] | None = None, constant: Number = 0):
        self.coefficients = {}
        for name, c in (coefficients or {}).items():
            value = exact(c)
            if value:
                self.coefficients[_name_of(name)] = value
        self.constant = exact(constant)

    def __add__(self, other: FormLike) -> Form:
        more = form(other)
        out = Form()
        out.coefficients = dict(self.coefficients)
        for name, c in more.coefficients.items():
            total = out.coefficients.get(name, 0) + c
            if total:
                out.coefficients[name] = total
            else:
                out.coefficients.pop(name, None)
        out.constant = self.constant + more.constant
        return out

    __radd__ = __add__

    def __mul__(self, factor: Number) -> Form:
        if isinstance(factor, Form):
            raise TypeError("a product of two forms is not linear")
        k = exact(factor)
        return Form({name: k * c for name, c in self.coefficients.items()}, k * self.constant)

    __rmul__ = __mul__

    def __truediv__(self, divisor: Number) -> Form:
        if isinstance(divisor, Form):
            raise TypeError("a quotient of two forms is not linear")
        return self * (1 / exact(divisor))

    def __neg__(self) -> Form:
        return self * -1

    def __pos__(self) -> Form:
        return self

    def __sub__(self, other: FormLike) -> Form:
        return self + -form(other)

    def __rsub__(self, other: FormLike) -> Form:
        return form(other) + -self

    def __le__(self, other: FormLike) -> Row:
        return _compare(self, "<=", other)

    def __lt__(self, other: FormLike) -> Row:
        return _compare(self, "<", other)

    def __ge__(self, other: FormLike) -> Row:
        return _compare(self, ">=", other)

    def __gt__(self, other: FormLike) -> Row:
        return _compare(self, ">", other)

    def __eq__(self, other: object) -> Row:  # type: ignore[override]
        if not isinstance(other, (Form, str, Number_)) and not hasattr(other, "item"):
            return NotImplemented  # so that it is not equal
        return _compare(self, "=", other)  # type: ignore[arg-type]

    def __reduce__(self) -> Any:
        return Form, (self.coefficients, self.constant)

    def __call__(self, point: Mapping[str, Number]) -> Fraction:
        """Its value at a point.

        >>> x, y = vars("x y")
        >>> (2 * x - y)({"x": 1, "y": "1/2"})
        Fraction(3, 2)
        """
        return self.constant + sum((c * exact(point[name])
                                    for name, c in self.coefficients.items()), Fraction(0))

    def __repr__(self) -> str:
        return text_of_form(self.coefficients.items(), self.constant)


class Variable(Form):
    """A variable: the form that is itself."""

    __slots__ = ("name",)

    def __init__(self, name: str):
        super().__init__({name: 1})
        self.name = name

    def __reduce__(self) -> Any:
        return Variable, (self.name,)

    def __hash__(self) -> int:  # type: ignore[override]
        return hash(self.name)


FormLike = Union[Form, int, float, Fraction, str]


class Row:
    """A relation between two forms, or a chain of such: `0 <= x`, `0 <= x <= y + 1`, `x == y`.

    `links` are its relations, each (left, relation, right). A label names the row in conflicts.

    >>> x, y = vars("x y")
    >>> 0 <= x <= y + 1
    0 <= x <= y + 1
    """

    __slots__ = ("links", "label", "ends")

    def __init__(self, links: Iterable[tuple[Form, str, Form]], label: str | None = None):
        self.links = tuple(links)
        self.label = label
        self.ends: tuple[object, object] = (None, None)  # operands as Python has them, in chains

    def named(self, label: str) -> Row:
        """The same row with a label."""
        return Row(self.links, label)

    def __bool__(self) -> bool:
        """Python asks this between the links of a chain; elsewhere a row has no truth."""
        left, relation, right = self.links[-1]
        frame = sys._getframe(1)
        in_chain = _is_in_chain(frame)
        if relation == "=" and not in_chain:  # as `in` and lists compare
            return left.coefficients == right.coefficients and left.constant == right.constant
        if not in_chain:
            raise TypeError(f"the row {self!r} is neither true nor false: ask fmb.solve, or "
                            "row.holds(point)")
        begun = [chain for chain in _begun() if _is_within(frame, chain[1])]
        _chains.begun = begun + [(self, frame, frame.f_lasti)]
        return True

    def holds(self, point: Mapping[str, Number]) -> bool:
        """Does it hold at a point, exactly?

        >>> x, y = vars("x y")
        >>> (x + y <= 3).holds({"x": 1, "y": 2})
        True
        """
        tests = {"<=": Fraction.__le__, "<": Fraction.__lt__, ">=": Fraction.__ge__,
                 ">": Fraction.__gt__, "=": Fraction.__eq__}
        return all(tests[relation](left(point), right(point))
                   for left, relation, right in self.links)

    def __reduce__(self) -> Any:
        return Row, (self.links, self.label)

    def __repr__(self) -> str:
        ends = "".join(f" {relation} {right!r}" for _, relation, right in self.links)
        return (f"{self.label}: " if self.label else "") + repr(self.links[0][0]) + ends


def _begun() -> list[tuple[Row, FrameType, int]]:
    """Chains of this thread whose next link is to come, with the frame and the place in it."""
    return getattr(_chains, "begun", [])


def _is_within(inner: FrameType | None, outer: FrameType) -> bool:
    while inner is not None and inner is not outer:
        inner = inner.f_back
    return inner is outer


# Instructions that may stand between a comparison and the jump on its truth value.
_BEHIND = ("CACHE", "EXTENDED_ARG", "COPY", "DUP_TOP", "TO_BOOL")


def _is_in_chain(frame: FrameType) -> bool:
    """Does what runs there ask for the truth of a link, to go on with the next? Between links,
    and nowhere else, the compiler keeps a copy of the second operand under the comparison."""
    code, at = frame.f_code.co_code, frame.f_lasti
    if "JUMP" in opcode.opname[code[at]]:
        at -= 2
    while at > 0 and opcode.opname[code[at]] in _BEHIND:
        at -= 2
    if at < 2 or opcode.opname[code[at]] != "COMPARE_OP":
        return False
    at -= 2
    while at > 0 and opcode.opname[code[at]] in ("CACHE", "EXTENDED_ARG"):
        at -= 2
    return opcode.opname[code[at]] in ("COPY", "ROT_THREE")


_MIRROR = {"<=": ">=", "<": ">", ">=": "<=", ">": "<", "=": "="}


def _compare(left: Form, relation: str, other: FormLike) -> Row:
    """Behind the first link of a chain, which shares an operand with this, the whole chain.

    Of `0 <= x`, and of `2 * x > y` where y is a variable, Python asks the second operand about the
    first: the links of a chain are put in its order.
    """
    row = Row([(left, relation, form(other))])
    row.ends = (left, other)
    begun, now = _begun(), sys._getframe(2)
    if not begun or begun[-1][1] is not now:
        return row
    before, _, at = begun.pop()
    if now.f_lasti <= at:  # an exception ended that chain
        return row
    middle = next((end for end in before.ends for own in row.ends if end is own), None)
    if middle is None:
        return row
    links = before.links
    if before.ends[1] is not middle:
        (first, sign, second), = links
        links = ((second, _MIRROR[sign], first),)
    last, sign, end = row.links[0]
    if row.ends[0] is not middle:
        last, sign, end = end, _MIRROR[sign], last
    out = Row(links + ((last, sign, end),))
    out.ends = (None, row.ends[1] if row.ends[0] is middle else row.ends[0])
    return out


def form(value: FormLike) -> Form:
    """A form of what may stand in one: a form, the name of a variable, or a number."""
    if isinstance(value, Form):
        return value
    if isinstance(value, Row):
        raise TypeError(f"the row {value!r} stands where a form or a number should: rows cannot be "
                        "added, multiplied or compared")
    if isinstance(value, str):
        return Variable(value)
    return Form(None, value)


# Names that may follow a number closely: 2x, 3y1; but 2e3 would be a number.
_SHORT = re.compile(r"[A-DF-Za-df-z]\d*", re.ASCII)


def text_of_form(terms: Iterable[tuple[str, Fraction]], constant: Fraction = Fraction(0)) -> str:
    """A form as people, and fmb's own files, write it."""
    out = ""
    for name, c in terms:
        size = abs(c)
        close = size.denominator == 1 and _SHORT.fullmatch(name)
        factor = "" if size == 1 else spelled(size) + ("" if close else " ")
        sign = ("-" if c < 0 else "") if not out else (" - " if c < 0 else " + ")
        out += f"{sign}{factor}{name}"
    if constant or not out:
        sign = ("-" if constant < 0 else "") if not out else (" - " if constant < 0 else " + ")
        out += f"{sign}{spelled(abs(constant))}"
    return out


def vars(names: str | Iterable[str]) -> tuple[Variable, ...]:  # pylint: disable=redefined-builtin
    """Variables: of names between blanks or commas, `x1:4` for x1 to x4, or of a list of names.

    >>> vars("x y z1:3")
    (x, y, z1, z2, z3)
    """
    if isinstance(names, str):
        names = [name for word in re.split(r"[\s,]+", names.strip()) for name in _spread(word)]
    return tuple(Variable(name) for name in names)


def _spread(word: str) -> Iterator[str]:
    numbered = re.fullmatch(r"(.*?)(\d+):(\d+)", word)
    if not numbered:
        if not word or ":" in word:
            raise ArgumentError(f"a variable needs a name, or several as x1:3, not {word!r}")
        yield word
        return
    stem, first, last = numbered.groups()
    if int(first) > int(last):
        raise ArgumentError(f"{word!r}: there is no variable from {first} to {last}")
    for number in range(int(first), int(last) + 1):
        yield f"{stem}{number}"


def total(forms: Iterable[FormLike]) -> Form:
    """The sum of forms, in time proportional to their terms.

    >>> total(vars("x1:3"))
    x1 + x2 + x3
    """
    out = Form()
    for more in map(form, forms):
        for name, c in more.coefficients.items():
            out.coefficients[name] = out.coefficients.get(name, Fraction(0)) + c
        out.constant += more.constant
    out.coefficients = {name: c for name, c in out.coefficients.items() if c}
    return out
