"""Solvers, sessions, and the questions."""

from __future__ import annotations

import operator
import threading
from typing import Any, Callable, Iterable, Mapping, Sequence, Union

from fmb import _callbacks
from fmb._answers import Answer, Judgement, Proof
from fmb._lib import (NULL, ArgumentError, StateError, encoded, exact, ffi, forget_lost,
                      in_main_thread, lib, need, note_lost, parsed, printed, raise_lost, spelled,
                      text, written)
from fmb._linear import Form, FormLike, Row, text_of_form
from fmb._results import Box, Generators, Optimum, Reduction, SystemAnswer
from fmb._system import System, SystemLike, SystemRow, quoted, system, words

Names = Union[str, Iterable[Any]]
_FATES = {lib.FMB_FATE_UNKNOWN: "unknown", lib.FMB_FATE_KEPT: "kept",
          lib.FMB_FATE_EQUALITY: "equality", lib.FMB_FATE_REDUNDANT: "redundant"}


@ffi.def_extern(onerror=note_lost)  # type: ignore[misc]
def pyfmb_tell(self: Any, e: Any) -> None:
    """An event of a query that is watched."""
    watcher: Solver = ffi.from_handle(self)
    watcher._tell(e)


_RESULT, _RESULT_SIZE = ffi.typeof("fmb_result *"), ffi.sizeof("fmb_result")
_KINDS = ("begin", "round", "rule", "lp", "end", "row", "rebase", "engine")


class Event:
    """What a watched query tells: its `kind` ("begin", "round", "rule", "lp", "row", "rebase",
    "engine", "end"), `name` (of the query, the rule, ...), round, rows, rows dropped by the rule,
    seconds since it began, and `text`, the JSON that `fmb --trace` writes."""

    __slots__ = ("kind", "name", "round", "rows", "dropped", "seconds", "text")

    def __init__(self, e: Any):
        self.kind = _KINDS[e.kind]
        self.name = text(e.name)
        self.dropped = int(e.dropped)
        self.round = int(e.round)
        self.rows = int(e.rows_out)
        self.seconds = float(e.seconds)
        self.text = printed(lib.fmb_event_print, e).rstrip("\n")

    def __repr__(self) -> str:
        return self.text


class Solver:
    """Options and workspace of queries; one thread's at a time.

    Options have the names of the command's (`Solver.options()`): method="fm", rules="kohler",
    max_seconds=10, max_rows, max_bytes, threads=2, ... The functions of this module take them, too:

    >>> solve("x >= 1", max_seconds=1).feasible
    True
    """

    def __init__(self, progress: Callable[[Event], None] | None = None, rules: Any = None,
                 order: Any = None, **options: Any):
        o = ffi.new("fmb_options *", {"size": ffi.sizeof("fmb_options")})
        self._texts: list[Any] = []  # the library borrows rules and presolve
        self._raised: BaseException | None = None
        self._busy = threading.Lock()
        own = _callbacks.Callbacks(self._fail, rules, order)
        if own.names is not None:
            options["rules"] = own.names
        if own.order_name is not None:
            options["order"] = own.order_name
        if own and "method" not in options:
            options["method"] = "fm"  # others may answer without an elimination
        for name, value in options.items():
            self._set(o, name, value)
        out = ffi.new("fmb_solver **")
        status = lib.fmb_solver_new(o, NULL, out)
        if status == lib.FMB_ERR_RULE:
            raise _callbacks.unknown_rules(options.get("rules"))
        need(status, lambda: written(lib.fmb_options_trouble, o))
        self._v = ffi.gc(out[0], lib.fmb_solver_free)
        self._callbacks = own
        own.add_to(self._v, self._trouble)
        self._progress = progress
        if progress is not None:
            self._handle = ffi.new_handle(self)
            lib.fmb_solver_set_sink(self._v, {"put": lib.pyfmb_tell, "self": self._handle})

    def _set(self, o: Any, name: str, value: Any) -> None:
        word = ffi.new("char[]", encoded(_option(value)))
        self._texts.append(word)
        if lib.fmb_options_set(o, encoded(name), word) != lib.FMB_OK:
            known = [info[0] for info in Solver.options()]
            if name not in known:
                raise ArgumentError(f"no option is called {name!r}: {', '.join(known)}")
            (values,) = (info[1] for info in Solver.options() if info[0] == name)
            raise ArgumentError(f"{name}={value!r}: expected {values}")

    @staticmethod
    def options() -> list[tuple[str, str, str, str]]:
        """Every option: its name, its values, what it is by default, and its meaning."""
        out: list[tuple[str, str, str, str]] = []
        i = 0
        while True:
            info = lib.fmb_options_describe(i)
            if info == NULL:
                return out
            out.append((text(info.name), text(info.values), text(info.initial), text(info.meaning)))
            i += 1

    def cancel(self) -> None:
        """Ask a running query to stop soon; from any thread."""
        lib.fmb_solver_cancel(self._v)

    def _fail(self, raised: BaseException) -> None:
        """A callback raised this: the query ends, and raises it."""
        if self._raised is None:
            self._raised = raised
        lib.fmb_solver_cancel(self._v)

    def _tell(self, e: Any) -> None:
        try:
            if self._progress is not None and self._raised is None:
                self._progress(Event(e))
        except BaseException as raised:  # pylint: disable=broad-except
            self._fail(raised)

    def __reduce__(self) -> Any:
        raise TypeError("a solver belongs to one process: make another one of the same options")

    def _trouble(self) -> str:
        return text(lib.fmb_solver_trouble(self._v))

    def _ask(self, query: Callable[..., int], *arguments: Any) -> Any:
        """One query; Ctrl-C ends it, and then raises KeyboardInterrupt as usual."""
        result = ffi.new(_RESULT)
        result.size = _RESULT_SIZE
        if not self._busy.acquire(False):
            raise StateError("this solver is answering a question: another thread, and a callback, "
                             "need one of their own")
        watched = in_main_thread()
        if watched:
            lib.pyfmb_begin(lib.PYFMB_SOLVER, self._v)
        try:
            status = query(self._v, *arguments, result)
        finally:
            if watched:
                lib.pyfmb_end()
            self._busy.release()
        if self._raised is not None:
            raised, self._raised = self._raised, None
            forget_lost()
            raise raised
        raise_lost()
        if status != lib.FMB_OK:
            need(status, self._trouble)
        return result

    # ---- the questions -----------------------------------------------------------------------

    def solve(self, rows: SystemLike) -> Answer:
        """Is there a solution? A point, or rows in conflict."""
        s = system(rows)
        return Answer(self._v, s, self._ask(lib.fmb_solve, s._s))

    def project(self, rows: SystemLike, keep: Names) -> SystemAnswer:
        """The projection on the variables to keep, in the order in which the system has them: an
        irredundant system in canonical form."""
        s, out = system(rows), ffi.new("fmb_system **")
        var = sorted(set(_indices(s, keep)))
        result = self._ask(lib.fmb_project, s._s, var if var else NULL, len(var), out)
        return SystemAnswer(self._v, s, result, _system(out))

    def eliminate(self, rows: SystemLike, drop: Names) -> SystemAnswer:
        """The projection on all variables but those."""
        s = system(rows)
        gone = set(_indices(s, drop))
        return self.project(s, [name for j, name in enumerate(s.names) if j not in gone])

    def bounds(self, rows: SystemLike, of: Names | None = None) -> Box:
        """The tightest interval of each variable."""
        s, out = system(rows), ffi.new("fmb_box **")
        var = _indices(s, of) if of is not None else None
        asked = NULL if var is None else ffi.new("int[]", var + [0])  # NULL is all of them
        result = self._ask(lib.fmb_bound, s._s, asked, len(var or ()), out)
        return Box(self._v, s, result, out[0])

    def optimize(self, rows: SystemLike, max: Any = None,  # pylint: disable=W0622
                 min: Any = None) -> Optimum:
        """The best value of a form, which may be a list of coefficients in the order of variables;
        without one, of the objective that the system carries."""
        s, out = system(rows), ffi.new("fmb_optimum **")
        if max is None and min is None and s.sense is None:
            raise ArgumentError("give max or min, as the system has no objective")
        if max is not None or min is not None:
            if max is not None and min is not None:
                raise ArgumentError("give max or min, not both")
            s = s.copy()
            if max is not None:
                s.maximize(_form_over(s, max))
            elif min is not None:
                s.minimize(_form_over(s, min))
        result = self._ask(lib.fmb_optimize, s._s, NULL, out)
        return Optimum(self._v, s, result, out[0])

    def reduce(self, rows: SystemLike) -> Reduction:
        """The same set by rows none of which the others imply."""
        s, out = system(rows), ffi.new("fmb_system **")
        fate = ffi.new("fmb_fate[]", len(s) + 1)
        result = self._ask(lib.fmb_reduce, s._s, fate, out)
        return Reduction(self._v, s, result, _system(out),
                         [_FATES[fate[i]] for i in range(len(s))])

    def vertices(self, rows: SystemLike) -> Generators:
        """Vertices, rays and lines of the closure."""
        s, out = system(rows), ffi.new("fmb_generators **")
        return Generators(self._v, s, self._ask(lib.fmb_generate, s._s, out), out[0])

    def hull(self, points: Any, rays: Any = (), lines: Any = (),
             names: Sequence[str] | None = None) -> SystemAnswer:
        """The convex hull of points, rays and lines: an irredundant system."""
        g, out = _generators(points, rays, lines), ffi.new("fmb_system **")
        result = self._ask(lib.fmb_hull, g, out)
        answer = _system(out)
        called = words(names) if names is not None else []
        dim = lib.fmb_generators_dim(g)
        if names is not None and len(called) != dim:
            raise ArgumentError(f"points of {dim} coordinates, but {len(called)} names")
        if answer is not None:  # one may be the usual name of another
            for j in range(len(called)):
                answer.rename(answer.names[j], f"\1{j}")
            for j, name in enumerate(called):
                answer.rename(f"\1{j}", name)
        return SystemAnswer(self._v, System() if answer is None else answer, result, answer)

    # ---- images, sums, hulls of polyhedra ----------------------------------------------------

    def image(self, rows: SystemLike, graph: Mapping[str, FormLike] | str | System) -> SystemAnswer:
        """The image under a map, a form for the name of each coordinate; or under a relation."""
        s = system(rows)
        if not isinstance(graph, System):
            graph = _graph(s, graph)
        lift, out = ffi.new("fmb_system **"), ffi.new("fmb_system **")
        result = self._ask(lib.fmb_image, s._s, graph._s, lift, out)
        return SystemAnswer(self._v, _system(lift) or s, result, _system(out))

    def sum(self, *polyhedra: SystemLike) -> SystemAnswer:
        """The Minkowski sum: all sums of a point of each."""
        return self._join(lib.fmb_sum, polyhedra)

    def hull_of(self, *polyhedra: SystemLike) -> SystemAnswer:
        """The closed convex hull of all of them together."""
        return self._join(lib.fmb_hull_union, polyhedra)

    def _join(self, query: Callable[..., int], polyhedra: Sequence[SystemLike]) -> SystemAnswer:
        if len(polyhedra) == 1 and isinstance(polyhedra[0], (list, tuple)) and not all(
                isinstance(p, (Row, SystemRow)) for p in polyhedra[0]):
            polyhedra = polyhedra[0]  # a list of them
        all_of = [system(p) for p in polyhedra]
        lift, out = ffi.new("fmb_system **"), ffi.new("fmb_system **")
        result = self._ask(query, [s._s for s in all_of], len(all_of), lift, out)
        return SystemAnswer(self._v, _system(lift) or System(), result, _system(out))


def _form_over(s: System, wanted: Any) -> FormLike:
    """A form, or its coefficients in the order of variables."""
    if not isinstance(wanted, (str, Row)) and hasattr(wanted, "__len__"):
        if len(wanted) != s.dim:
            raise ArgumentError(f"{len(wanted)} coefficients, but there are {s.dim} variables")
        return Form(dict(zip(s.names, wanted)))
    given: FormLike = wanted
    return given


def _option(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (list, tuple)):
        return ",".join(map(str, value))
    return str(value)


def _system(out: Any) -> System | None:
    if out[0] == NULL:
        return None
    return System._of(ffi.gc(out[0], lib.fmb_system_free))


def _indices(s: System, names: Names) -> list[int]:
    """The numbers of variables, given by names, as variables, or by numbers."""
    if isinstance(names, Form):
        names = words(names)
    if isinstance(names, str):
        names = words(names)
    out = []
    for name in names:
        if hasattr(name, "__index__"):
            j = operator.index(name)
            if not 0 <= j < s.dim:
                raise ArgumentError(f"no variable has the number {j}: there are {s.dim}")
            out.append(j)
        else:
            out.append(s.index(name))
    return out


def _rows_of(points: Any) -> list[Any]:
    rows = list(points.tolist() if hasattr(points, "tolist") else points)
    if not all(hasattr(row, "__len__") for row in rows):
        raise ArgumentError("points, rays and lines are lists of lists, or arrays of two dimensions")
    return rows


def _generators(points: Any, rays: Any, lines: Any) -> Any:
    lists = [_rows_of(points), _rows_of(rays), _rows_of(lines)]
    dims = {len(x) for some in lists for x in some}
    if len(dims) != 1:
        raise ArgumentError("points, rays and lines are not of one dimension" if dims else
                            "a hull needs a point, at least")
    rows = [f"{head} " + " ".join(spelled(exact(c)) for c in x)
            for some, head in zip(lists, "100") for x in some]
    first_line = len(lists[0]) + len(lists[1])
    lines_at = " ".join(str(first_line + i + 1) for i in range(len(lists[2])))
    head = f"linearity {len(lists[2])} {lines_at}\n" if lists[2] else ""
    data = (f"V-representation\n{head}begin\n{len(rows)} {dims.pop() + 1} "
            "rational\n" + "\n".join(rows) + "\nend\n").encode()
    out, where = ffi.new("fmb_generators **"), ffi.new("fmb_where *")
    parsed(lib.fmb_generators_parse(data, len(data), NULL, out, where), where)
    return ffi.gc(out[0], lib.fmb_generators_free)


def _spelled_form(f: Any) -> str:
    if isinstance(f, str):
        return f
    if not isinstance(f, Form):
        return spelled(exact(f))
    return text_of_form([(quoted(name), c) for name, c in f.coefficients.items()], f.constant)


def _graph(s: System, graph: Mapping[str, FormLike] | str) -> System:
    if not isinstance(graph, str):
        graph = "\n".join(f"{quoted(getattr(name, 'name', name))} = {_spelled_form(f)}"
                          for name, f in graph.items())
    else:
        graph = graph.replace(";", "\n")
    data = encoded(graph)
    out, where = ffi.new("fmb_system **"), ffi.new("fmb_where *")
    parsed(lib.fmb_system_parse_graph(data, len(data), NULL, s._s, out, where), where)
    return System._of(ffi.gc(out[0], lib.fmb_system_free))


# ---- functions of the module -----------------------------------------------------------------

_default = threading.local()


def _solver(options: dict[str, Any]) -> Solver:
    """A solver with the options; without options, the solver of this thread."""
    if options:
        return Solver(**options)
    own: Solver | None = getattr(_default, "solver", None)
    if own is None:
        own = _default.solver = Solver()
    return own


def solve(rows: SystemLike, **options: Any) -> Answer:
    """Is there a solution?

    >>> solve("x + y <= 3; 2y < x - 4")
    feasible: x = 0, y = -3
    """
    return _solver(options).solve(rows)


def project(rows: SystemLike, keep: Names, **options: Any) -> SystemAnswer:
    """The projection on some variables.

    >>> project("x <= z; z <= y", "x y")
    x - y <= 0
    """
    return _solver(options).project(rows, keep)


def eliminate(rows: SystemLike, drop: Names, **options: Any) -> SystemAnswer:
    """The projection on all variables but some."""
    return _solver(options).eliminate(rows, drop)


def bounds(rows: SystemLike, of: Names | None = None, **options: Any) -> Box:
    """The tightest box."""
    return _solver(options).bounds(rows, of)


def optimize(rows: SystemLike, max: Any = None,  # pylint: disable=redefined-builtin
             min: Any = None, **options: Any) -> Optimum:
    """The best value of a form, or of a list of coefficients.

    >>> optimize("x + 2y <= 4; x >= 0; y >= 0", max=[1, 3]).value
    Fraction(6, 1)
    """
    return _solver(options).optimize(rows, max, min)


def reduce(rows: SystemLike, **options: Any) -> Reduction:
    """Without the rows that others imply.

    >>> reduce("x >= 0; x >= -1; x <= 3").fates
    ['kept', 'redundant', 'kept']
    """
    return _solver(options).reduce(rows)


def vertices(rows: SystemLike, **options: Any) -> Generators:
    """Vertices, rays and lines."""
    return _solver(options).vertices(rows)


def hull(points: Any, rays: Any = (), lines: Any = (), names: Sequence[str] | None = None,
         **options: Any) -> SystemAnswer:
    """The convex hull of points, rays and lines.

    >>> hull([(0, 0), (2, 0), (0, 1)])
    x1 + 2x2 <= 2; x2 >= 0; x1 >= 0
    """
    return _solver(options).hull(points, rays, lines, names)


def image(rows: SystemLike, graph: Mapping[str, FormLike] | str | System,
          **options: Any) -> SystemAnswer:
    """The image under a map.

    >>> image("0 <= x <= 1; 0 <= y <= 1", {"z": "x + 2y"})
    z <= 3; z >= 0
    """
    return _solver(options).image(rows, graph)


def sum(*polyhedra: SystemLike, **options: Any) -> SystemAnswer:  # pylint: disable=redefined-builtin
    """The Minkowski sum.

    >>> sum("0 <= x <= 1", "2 <= x <= 3")
    x <= 4; x >= 2
    """
    return _solver(options).sum(*polyhedra)


def hull_of(*polyhedra: SystemLike, **options: Any) -> SystemAnswer:
    """The closed convex hull of polyhedra together."""
    return _solver(options).hull_of(*polyhedra)


def check(rows: SystemLike, proof: Proof | str) -> Judgement:
    """Judge a proof about a system."""
    s = system(rows)
    return (Proof.parse(proof.to_text() if isinstance(proof, Proof) else proof, s)).check()
