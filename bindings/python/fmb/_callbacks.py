"""Rules and orders in Python, called by queries (their authors use fmb.lab)."""

from __future__ import annotations

from typing import Any, Callable, Iterable, Sequence, Union

from fmb._lib import NULL, ArgumentError, RuleError, StateError, encoded, ffi, lib, need
from fmb._lib import note_lost, number, text, written

_RELATIONS = {lib.FMB_LE: "<=", lib.FMB_LT: "<", lib.FMB_EQ: "="}


def _bits(words: Any, n: int) -> frozenset[int]:
    """The elements of a bit set."""
    whole = int.from_bytes(ffi.buffer(words, 8 * n)[:], "little")
    out = []
    while whole:
        least = whole & -whole
        out.append(least.bit_length() - 1)
        whole ^= least
    return frozenset(out)


class ViewRow:
    """A live row: `coefficients` (a tuple of int, by column), `relation` (<=, < or =) and `right`.

    `name` is a number that stays the same for the whole elimination. What else is said of a row is
    asked of the elimination, and so only until the callback returns."""

    __slots__ = ("_view", "name", "coefficients", "relation", "right")

    def __init__(self, view: View, name: int):
        w = view._c()
        dim = view.dim
        whole = lib.fmb_view_int64(w, name)
        if whole != NULL:
            entries = ffi.unpack(whole, dim + 1)
        else:
            entries = [int(number(written(lib.fmb_view_text, w, name, col)))
                       for col in range(dim + 1)]
        self._view = view
        self.name = name
        self.coefficients: tuple[int, ...] = tuple(entries[:dim])
        self.right: int = entries[dim]
        self.relation = _RELATIONS[lib.fmb_view_rel(w, name)]

    @property
    def history(self) -> frozenset[int] | None:
        """The base rows that it was combined from; None while no histories are kept."""
        n = ffi.new("size_t *")
        words = lib.fmb_view_history(self._view._c(), self.name, n)
        return _bits(words, n[0]) if words != NULL else None

    @property
    def effective(self) -> frozenset[int]:
        """The columns that some combination on the way to it cancelled."""
        n = ffi.new("size_t *")
        words = lib.fmb_view_effective(self._view._c(), self.name, n)
        return _bits(words, n[0]) if words != NULL else frozenset()

    @property
    def minimal(self) -> bool:
        """Is it certain that no other combination uses fewer of its base rows?"""
        return bool(lib.fmb_view_minimal(self._view._c(), self.name))

    @property
    def slack(self) -> int:
        """Over the box of the variables, the sign of how far it is from being reached: if 1, it
        says nothing there."""
        return int(lib.fmb_view_slack(self._view._c(), self.name))

    def __repr__(self) -> str:
        return f"{self.coefficients} {self.relation} {self.right}"


class View:
    """An elimination between two rounds, as a rule or an order sees it until it returns."""

    def __init__(self, w: Any):
        self._w: Any = w
        self._rows: list[ViewRow] | None = None
        self.dim = int(lib.fmb_view_dim(w))
        self.eliminated = int(lib.fmb_view_eliminated(w))
        column = lib.fmb_view_column(w)
        self.column: int | None = int(column) if column >= 0 else None

    def _c(self) -> Any:
        if self._w is None:
            raise StateError("a view is over when the rule or order that was given it returns")
        return self._w

    @property
    def rows(self) -> list[ViewRow]:
        """The live rows."""
        if self._rows is None:
            w = self._c()
            self._rows = [ViewRow(self, lib.fmb_view_row(w, i))
                          for i in range(lib.fmb_view_rows(w))]
        return self._rows

    def variable(self, column: int) -> int | None:
        """The number of the system's variable of a column; None: the form that is optimised."""
        if not 0 <= column < self.dim:
            raise IndexError(f"column {column} of {self.dim}")
        j = int(lib.fmb_view_variable(self._c(), column))
        return j if j >= 0 else None

    def signs(self, column: int) -> tuple[int, int]:
        """How many rows have a negative coefficient there, and how many a positive one: with `p`
        and `q` of them, `p * q` rows take the place of `p + q`."""
        if not 0 <= column < self.dim:
            raise IndexError(f"column {column} of {self.dim}")
        w = self._c()
        signs = [lib.fmb_view_sign(w, lib.fmb_view_row(w, i), column)
                 for i in range(lib.fmb_view_rows(w))]
        return signs.count(-1), signs.count(1)

    def stopped(self) -> bool:
        """Has a limit come? To be asked in long loops: then return at once."""
        return bool(lib.fmb_view_stop(self._c()))

    def __repr__(self) -> str:
        state = "over" if self._w is None else f"{len(self.rows)} rows, {self.dim} columns"
        return f"View: {state}"


Drops = Union[Iterable[Union[ViewRow, int]], None]


class Rule:
    """A pruning rule: `end_round` is given a View when a variable is gone (and may be before the
    first), and returns the rows of it that may go.

    A rule that reads histories says `needs_history`; any other breaks those of other rules, which
    then start anew, unless it says that it does not. `verdict_only`: it keeps whether there is a
    solution, but not what all of them are. `one_base`: it argues with the rows of the beginning.
    What a rule says is believed: `fmb.lab.trial` finds those that are wrong."""

    def __init__(self, end_round: Callable[[View], Drops], name: str | None = None,
                 source: str = "", needs_history: bool = False, breaks_history: bool | None = None,
                 verdict_only: bool = False, one_base: bool = False):
        self.end_round = end_round
        self.name = name or str(getattr(end_round, "__name__", "rule")).replace("_", "-")
        if not self.name.strip() or any(c in self.name for c in ", \t\n\0"):
            raise ArgumentError(f"{self.name!r} is no name of a rule: no blanks, no commas")
        self.source = source or (getattr(end_round, "__doc__", "") or "").strip()
        breaks = not needs_history if breaks_history is None else breaks_history
        self.flags = (needs_history * lib.FMB_RULE_NEEDS_HISTORY
                      | breaks * lib.FMB_RULE_BREAKS_HISTORY
                      | verdict_only * lib.FMB_RULE_VERDICT_ONLY
                      | one_base * lib.FMB_RULE_ONE_BASE)

    def __call__(self, view: View) -> Drops:
        return self.end_round(view)

    def __repr__(self) -> str:
        return f"Rule {self.name}"


class _Asked:
    """A rule, or an order, of one solver."""

    def __init__(self, what: Callable[..., Any], fail: Callable[[BaseException], None]):
        self.what = what
        self.fail = fail
        self.handle = ffi.new_handle(self)

    def end_round(self, w: Any, drop: Any) -> None:
        """Mark the rows that the rule names."""
        view = View(w)
        try:
            rows = int(lib.fmb_view_rows(w))
            place: dict[int, int] = {}
            for row in self.what(view) or ():
                if isinstance(row, ViewRow):
                    place = place or {lib.fmb_view_row(w, i): i for i in range(rows)}
                    if row._view is not view:
                        raise ArgumentError(f"the row {row!r} is one of another round")
                    drop[place[row.name]] = True
                elif isinstance(row, int) and not isinstance(row, bool) and 0 <= row < rows:
                    drop[row] = True
                else:
                    raise ArgumentError(f"a rule returns rows of its view, or their places: not "
                                        f"{row!r}")
        finally:
            view._w = None

    def choose(self, w: Any, columns: Sequence[int]) -> int:
        """The column that the order names."""
        view = View(w)
        try:
            chosen = self.what(view, list(columns))
        finally:
            view._w = None
        if not isinstance(chosen, int) or chosen not in columns:
            raise ArgumentError(f"the order chose {chosen!r}, which is none of {list(columns)}")
        return chosen


@ffi.def_extern(error=lib.FMB_ERR_STATE, onerror=note_lost)  # type: ignore[misc]
def pyfmb_end_round(_state: Any, w: Any, drop: Any) -> int:
    """A round is over, and a rule of Python's is asked."""
    rule = ffi.cast("pyfmb_rule *", lib.fmb_view_rule(w))
    asked: _Asked = ffi.from_handle(rule.self)
    try:
        asked.end_round(w, drop)
        return int(lib.FMB_OK)
    except BaseException as raised:  # pylint: disable=broad-except
        asked.fail(raised)
        return int(lib.FMB_ERR_STATE)


@ffi.def_extern(error=-1, onerror=note_lost)  # type: ignore[misc]
def pyfmb_choose(self: Any, w: Any, col: Any, n: int) -> int:
    """An order of Python's is asked."""
    asked: _Asked = ffi.from_handle(self)
    try:
        return asked.choose(w, ffi.unpack(col, n))
    except BaseException as raised:  # pylint: disable=broad-except
        asked.fail(raised)
        return -1


class Callbacks:
    """The rules and the order of one solver: those of Python, and the words for all others."""

    def __init__(self, fail: Callable[[BaseException], None], rules: Any, order: Any):
        self.names: str | None = None
        self.order_name: str | None = None
        self._keep: list[Any] = []
        self._rules: list[Any] = []
        self._order: _Asked | None = None
        if order is not None and not isinstance(order, str):
            if not callable(order):
                raise ArgumentError(f"{order!r} is no order: a word, or a function of a view")
            self._order = _Asked(order, fail)
        elif order is not None:
            self.order_name = order
        if rules is not None:
            self._take_rules(fail, rules)

    def _take_rules(self, fail: Callable[[BaseException], None], rules: Any) -> None:
        listed = [rules] if isinstance(rules, str) or callable(rules) else list(rules)
        known: list[str] = []
        for rule in listed:
            if isinstance(rule, str):
                known.append(rule)
            elif callable(rule):
                self._rules.append(self._table(rule if isinstance(rule, Rule) else Rule(rule), fail))
            else:
                raise ArgumentError(f"{rule!r} is no rule: a word, or a function of a view")
        self.names = ",".join(known) if known else "none"

    def _table(self, rule: Rule, fail: Callable[[BaseException], None]) -> Any:
        asked = _Asked(rule, fail)
        name = ffi.new("char[]", encoded(rule.name))
        source = ffi.new("char[]", encoded(rule.source))
        table = ffi.new("pyfmb_rule *")
        table.table.name, table.table.source = name, source
        table.table.flags = rule.flags
        table.table.end_round = lib.pyfmb_end_round
        table.self = asked.handle
        self._keep += [asked, name, source]
        return table

    def __bool__(self) -> bool:
        return bool(self._rules) or self._order is not None

    def add_to(self, v: Any, trouble: Callable[[], str]) -> None:
        """The solver uses them from now on."""
        for table in self._rules:
            need(lib.fmb_solver_add_rule(v, ffi.addressof(table, "table")), trouble)
        if self._order is not None:
            lib.fmb_solver_set_chooser(v, {"choose": lib.pyfmb_choose, "self": self._order.handle})


def built_in() -> list[str]:
    """The names of the rules that the library has."""
    out: list[str] = []
    while (rule := lib.fmb_rule_at(len(out))) != NULL:
        out.append(text(rule.name))
    return out


def unknown_rules(rules: Any) -> RuleError:
    """What is said of words that are no rules."""
    return RuleError(f"rules={rules!r}: expected none, or some of {', '.join(built_in())}")
