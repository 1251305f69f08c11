"""The compiled core, its errors, and numbers on their way through it."""

from __future__ import annotations

import threading
from decimal import Decimal
from fractions import Fraction
from numbers import Rational
from typing import Any, Callable, Union

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
    """A limit was reached first; `reason` says which: "time", "rows", "bytes" or "cancelled"."""

    def __init__(self, reason: str):
        super().__init__(f"the query ended at a limit: {reason}")
        self.reason = reason


_KINDS: dict[int, type[Exception]] = {
    lib.FMB_ERR_ARG: ArgumentError, lib.FMB_ERR_MEMORY: MemoryError,
    lib.FMB_ERR_PARSE: ParseError, lib.FMB_ERR_IO: OSError, lib.FMB_ERR_RULE: RuleError,
    lib.FMB_ERR_STATE: StateError, lib.FMB_ERR_RANGE: OverflowError}


def text(of: Any) -> str:
    """A text of the library's."""
    return str(ffi.string(of).decode()) if of != NULL else ""


def need(status: int, trouble: Callable[[], str] = str) -> None:
    """Raise what a status says, and why."""
    if status != lib.FMB_OK:
        why = trouble() or text(lib.fmb_status_text(status))
        raise _KINDS.get(status, Error)(why)


def parsed(status: int, where: Any, name: str | None = None) -> None:
    """The same behind a reader, which says where its text went wrong."""
    if status in (lib.FMB_ERR_PARSE, lib.FMB_ERR_ARG) and ffi.string(where.text):
        source = name.encode() if name else NULL
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
            return str(ffi.unpack(block, length).decode())
        size = length + 1


def printed(write: Callable[..., int], *what: Any) -> str:
    """What a function *_print writes."""
    length = ffi.new("size_t *")
    need(write(*what, NULL, 0, length))
    block = ffi.new("char[]", length[0] + 1)
    need(write(*what, block, length[0] + 1, length))
    return str(ffi.unpack(block, length[0]).decode())


def number(exact: str) -> Fraction:
    """An exact number of the library's."""
    above, _, below = exact.partition("/")
    return Fraction(int(above), int(below) if below else 1)


def exact(value: Number | str) -> Fraction:
    """A number of the caller's, meant exactly: a float is its binary value, "0.1" is 1/10."""
    if isinstance(value, Fraction):
        return value
    if hasattr(value, "item"):  # a number of NumPy's
        value = value.item()
    try:
        return Fraction(value)
    except (TypeError, OverflowError) as e:
        raise ArgumentError(f"{value!r} is no finite number") from e
    except ValueError as e:
        raise ArgumentError(f"{value!r} is no number") from e


def made(kind: str, make: Callable[..., int], *arguments: Any,
         trouble: Callable[[], str] = str) -> Any:
    """What a function hands out in its last argument; it is freed with its last use."""
    out = ffi.new(f"{kind} **")
    need(make(*arguments, out), trouble)
    return owned(kind, out[0])


def owned(kind: str, thing: Any) -> Any:
    """An object that is freed with its last use; None for NULL."""
    return ffi.gc(thing, getattr(lib, kind + "_free")) if thing != NULL else None


def in_main_thread() -> bool:
    """Only there Python hears of Ctrl-C."""
    return threading.current_thread() is threading.main_thread()
