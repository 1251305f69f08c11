"""The compiled core, its errors, and numbers on their way through it."""

from __future__ import annotations

import os
import re
import threading
from decimal import Decimal
from fractions import Fraction
from numbers import Rational
from typing import Any, Callable, Sequence, Union

from fmb._core import ffi as ffi
from fmb._core import lib as lib

NULL = ffi.NULL
Number = Union[int, float, Fraction, Decimal, Rational]


class Error(Exception):
    """Something that libfmb refused; what each kind of it is, its subclasses tell."""


class ArgumentError(Error, ValueError):
    """An argument out of range, of the wrong shape, or not finite."""


class ParseError(Error, ValueError):
    """A text that is none of its format: `line` and `column` count from 1, 0 if not known."""

    def __init__(self, message: str, line: int = 0, column: int = 0):
        super().__init__(message)
        self.line, self.column = line, column


class RuleError(Error, ValueError):
    """Pruning rules that are unknown, or unsound together."""


class StateError(Error, RuntimeError):
    """Not now: nothing was asked, or nothing is loaded."""


class Unfinished(Error, RuntimeError):
    """A limit was reached first; `reason` says which: "time", "rows", "bytes" or "cancelled"; of
    pairs of frames, how many are undecided."""

    def __init__(self, reason: str):
        super().__init__(reason)
        self.reason = reason

    def __str__(self) -> str:
        return f"the query ended at a limit: {self.reason}"


_KINDS: dict[int, type[Exception]] = {
    lib.FMB_ERR_ARG: ArgumentError, lib.FMB_ERR_MEMORY: MemoryError,
    lib.FMB_ERR_PARSE: ParseError, lib.FMB_ERR_IO: OSError, lib.FMB_ERR_RULE: RuleError,
    lib.FMB_ERR_STATE: StateError, lib.FMB_ERR_RANGE: OverflowError}


def text(of: Any) -> str:
    """A text of the library's; bytes that are no UTF-8, as of a file, come back by encoded."""
    return str(ffi.string(of).decode(errors="surrogateescape")) if of != NULL else ""


def encoded(name: Any) -> bytes:
    """A name for the library, to which a NUL is its end."""
    if not isinstance(name, str):
        raise ArgumentError(f"a name is a str, not {name!r}")
    if "\0" in name:
        raise ArgumentError(f"{name!r}: a name holds no NUL")
    return name.encode(errors="surrogateescape")


def need(status: int, trouble: Callable[[], str] = str) -> None:
    """Raise what a status says, and why."""
    if status != lib.FMB_OK:
        why = trouble() or text(lib.fmb_status_text(status))
        raise _KINDS.get(status, Error)(why)


def parsed(status: int, where: Any, name: str | None = None) -> None:
    """The same behind a reader, which says where its text went wrong."""
    if status in (lib.FMB_ERR_PARSE, lib.FMB_ERR_ARG) and ffi.string(where.text):
        source = encoded(name) if name else NULL
        message = written(lib.fmb_where_text, where, source)
        if status == lib.FMB_ERR_ARG:
            raise ArgumentError(message)
        raise ParseError(message, where.line, where.column)
    need(status)


def written(write: Callable[..., int], *what: Any) -> str:
    """What a function *_text writes, however long it is."""
    size = 64
    while True:
        block = ffi.new("char[]", size)
        length = write(*what, block, size)
        if length < size:
            return str(ffi.unpack(block, length).decode(errors="surrogateescape"))
        size = length + 1


def printed(write: Callable[..., int], *what: Any) -> str:
    """What a function *_print writes."""
    length = ffi.new("size_t *")
    need(write(*what, NULL, 0, length))
    block = ffi.new("char[]", length[0] + 1)
    need(write(*what, block, length[0] + 1, length))
    return str(ffi.unpack(block, length[0]).decode(errors="surrogateescape"))


# Python refuses to convert texts of more than 4300 digits (or its configured limit) into numbers.
_SURE_DIGITS = 600


def digits(n: int) -> str:
    """A whole number of any length as text."""
    if n.bit_length() < 3 * _SURE_DIGITS:
        return str(n)
    if n < 0:
        return "-" + digits(-n)
    half = n.bit_length() * 3 // 20
    above, below = divmod(n, int(10 ** half))
    return digits(above) + digits(below).zfill(half)


def spelled(value: Fraction) -> str:
    """An exact number as text, however long it is."""
    if value.denominator == 1:
        return digits(value.numerator)
    return f"{digits(value.numerator)}/{digits(value.denominator)}"


def _whole(word: str) -> int:
    if len(word) <= _SURE_DIGITS:
        return int(word)
    if word[0] == "-":
        return -_whole(word[1:])
    half = len(word) // 2
    return _whole(word[:-half]) * int(10 ** half) + _whole(word[-half:])


def number(exact: str) -> Fraction:
    """An exact number of the library's."""
    above, bar, below = exact.partition("/")
    return Fraction(_whole(above), _whole(below)) if bar else Fraction(_whole(above))


def exact(value: Number | str) -> Fraction:
    """A number of the caller's, meant exactly: a float is its binary value, "0.1" is 1/10."""
    if type(value) is Fraction:  # pylint: disable=unidiomatic-typecheck
        return value
    given: Any = value
    try:
        if hasattr(given, "item"):  # a number of NumPy's
            given = given.item()
        if isinstance(given, str) and len(given) > _SURE_DIGITS and (
                re.fullmatch(r"\s*-?\d+(/\d+)?\s*", given)):
            return number(given.strip())
        if not isinstance(given, (int, float, str, Decimal, Rational)) and (
                hasattr(given, "as_integer_ratio")):  # NumPy's long double
            return Fraction(*map(int, given.as_integer_ratio()))
        return Fraction(given)
    except (TypeError, OverflowError) as e:
        raise ArgumentError(f"{_shortened(value)} is no finite number") from e
    except (ValueError, ZeroDivisionError) as e:
        raise ArgumentError(f"{_shortened(value)} is no number") from e


def _shortened(value: object) -> str:
    shown = repr(value)
    return shown if len(shown) <= 80 else shown[:77] + "..."


def listed(parts: Sequence[str], between: str = ", ", most: int = 100) -> str:
    """What a repr shows of many: the first of them, and how many more there are."""
    rest = len(parts) - most
    return between.join(parts[:most]) + (f"{between}... ({rest} more)" if rest > 0 else "")


def made(kind: str, make: Callable[..., int], *arguments: Any,
         trouble: Callable[[], str] = str) -> Any:
    """What a function hands out in its last argument; it is freed with its last use."""
    out = ffi.new(f"{kind} **")
    need(make(*arguments, out), trouble)
    return owned(kind, out[0])


def owned(kind: str, thing: Any) -> Any:
    """An object that is freed with its last use; None for NULL."""
    return ffi.gc(thing, getattr(lib, kind + "_free")) if thing != NULL else None


# Raised at the entry of a callback, like a KeyboardInterrupt, where no handler catches it.
_lost: list[BaseException] = []


def note_lost(_kind: Any, raised: BaseException, _traceback: Any) -> None:
    """Keep it for the caller of the query, who is told when that has ended."""
    _lost.append(raised)


def forget_lost() -> None:
    """Something else is raised."""
    _lost.clear()


def raise_lost() -> None:
    """Raise what was lost in a callback."""
    if _lost:
        raise _lost.pop()


_main = threading.main_thread().ident


def _forked() -> None:
    global _main  # pylint: disable=global-statement
    _main = threading.main_thread().ident


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forked)


def in_main_thread() -> bool:
    """Only there Python hears of Ctrl-C."""
    return threading.get_ident() == _main
