"""The laboratory: pruning rules and orders of variables of one's own, and what they are worth.

A rule is a function that is given a View of the elimination when a round is over, and returns the
rows that may go. An order is one that is given a View and the columns on offer, and returns one of
them. Both go where their words go: `rules=[mine, "kohler"]`, `order=mine`.

>>> @rule
... def same_rows(view):
...     "Of rows with the same coefficients the tightest stays."
...     best = {}
...     for row in view.rows:
...         tightness = (row.right, row.relation != "<", row.name)
...         if row.relation != "=":
...             best[row.coefficients] = min(best.get(row.coefficients, tightness), tightness)
...     return [row for row in view.rows
...             if row.relation != "=" and best[row.coefficients][2] != row.name]
>>> @order
... def smaller_side(view, columns):
...     "The column whose larger side is smallest."
...     return min(columns, key=lambda column: max(view.signs(column)))
>>> solve("x + y <= 3; 2x + 2y <= 5; x - y <= 0; x >= 1", rules=[same_rows], order=smaller_side)
feasible: x = 1, y = 1
>>> trial(rules=[same_rows], order=smaller_side, systems=40).wrong
[]

What a rule says is believed, and one that drops too much makes answers too large. `trial` asks about
many small systems, and finds those answers; the smallest system that shows one is told:

>>> @rule
... def liar(view):
...     "All rows of a round go, but the first."
...     return view.rows[1:]
>>> print(trial(rules=[liar], order="given", seed=1).wrong[0])
a solution is found, but there is none:
y >= 0
u >= 0
u + y <= -1
"""

from __future__ import annotations

import os
import random
from typing import Any, Callable, Iterable, Iterator, Sequence, overload

from fmb import _experiment
from fmb._callbacks import Drops, Rule, View, ViewRow, built_in
from fmb._experiment import Problem, problems
from fmb._lib import ArgumentError
from fmb._solver import Solver
from fmb._system import System, SystemLike, SystemRow, system

__all__ = ["Problem", "Rule", "Trial", "View", "ViewRow", "Wrong", "built_in", "experiment", "order", "problems", "rule",
           "small_systems", "trial"]


@overload
def rule(end_round: Callable[[View], Drops]) -> Rule: ...


@overload
def rule(*, name: str | None = None, source: str = "", needs_history: bool = False,
         breaks_history: bool | None = None, verdict_only: bool = False,
         one_base: bool = False) -> Callable[[Callable[[View], Drops]], Rule]: ...


def rule(end_round: Callable[[View], Drops] | None = None, **told: Any) -> Any:
    """A decorator: a Rule of the function, which says what it is told (as Rule does).

    >>> @rule(needs_history=True)
    ... def kohler_again(view):
    ...     return [row for row in view.rows if len(row.history or ()) > view.eliminated + 1]
    >>> kohler_again
    Rule kohler-again
    """
    if end_round is not None:
        return Rule(end_round)
    return lambda function: Rule(function, **told)


Order = Callable[[View, Sequence[int]], int]


def order(choose: Order) -> Order:
    """A decorator that says what a function is for; every function of a view and a list of columns
    is an order."""
    return choose


# ---- systems to try something on ---------------------------------------------------------------


# Incompatible rules gave wrong answers on these, eliminated in the given order.
_KNOWN = """
u - y <= 0; -u <= -1; -u - y <= -1; u + 2y <= -1
x - y <= -1; -x + 2y + 2z <= -1; x + y - 2z <= 1; x - 2y <= -2; -2x + y <= 1
-x + y <= 0; x - y - z <= 0; -x - z <= 0; x + y <= 0
-x + y <= -1; -x - y <= -1; x <= 0; x <= 1
a + b <= c + d; 0 <= a + b + c + d; b <= 0; c <= a; a + b + d <= 0; a + d <= b; 0 <= a + d; d >= 1
a + b <= c + d; 0 <= a + b + c + d; b <= 0; c <= a; a + b + d <= 0; a + d <= b; 0 <= a + d
-a <= d - 1; a + c <= b + d + 1; b + d <= 1; a + d <= b + 1; a + b <= -1; d <= b + c - 1; b + c <= a - 1
"""


def small_systems(seed: int = 1, most_variables: int = 4, most_rows: int = 9) -> Iterator[System]:
    """Some small systems that are known to tell, and then random ones without an end, with many
    ties, some strict rows and some equations; of the same seed the same ones."""
    for known in _KNOWN.strip().splitlines():
        yield System(known)
    draw = random.Random(seed)
    while True:
        dim = draw.randint(2, most_variables)
        largest = draw.choice((1, 1, 3))
        s = System((), [f"x{j + 1}" for j in range(dim)])
        relations = draw.choice((["<="], ["<="], ["<=", "<="] * 3 + ["<", "="]))
        for _ in range(draw.randint(dim + 1, most_rows)):
            numbers = [draw.randint(-largest, largest) for _ in range(dim)]
            _add_row(s, numbers, draw.choice(relations), draw.randint(-1, largest))
        yield s


def _add_row(s: System, numbers: Sequence[int], relation: str, right: int) -> None:
    s.join(System.from_arrays([list(numbers)], [right], relation, s.names))


# ---- trials --------------------------------------------------------------------------------------


class Wrong:
    """A wrong answer: the `system` that it is about, made as small as it still goes wrong, and the
    one that was `met`; `kept`, the kept variables, None where a verdict was asked for; what was
    `told`, and the `truth`, which has a proof that was checked."""

    def __init__(self, system: System, met: System, kept: tuple[str, ...] | None, told: str,
                 truth: str):
        self.system = system
        self.met = met
        self.kept = kept
        self.told = told
        self.truth = truth

    def __str__(self) -> str:
        if self.kept is None:
            found, is_one = ("a solution is found", "there is none") if self.told == "feasible" else (
                "no solution is found", "there is one")
            return f"{found}, but {is_one}:\n{self.system}"
        return (f"projected on {', '.join(self.kept)}, this is not\n{self.told}\nbut\n{self.truth}\n"
                f"of:\n{self.system}")

    __repr__ = __str__


class Trial:
    """What rules and an order did in an elimination of many systems: `asked` questions, `wrong`
    answers (a list of Wrong), `undecided` ones, and what they counted beside an elimination without
    rules: rows `made` and `made_without`, rows `dropped`. It is true if nothing is wrong."""

    def __init__(self) -> None:
        self.asked = self.undecided = self.made = self.made_without = self.dropped = 0
        self.wrong: list[Wrong] = []

    def __bool__(self) -> bool:
        return not self.wrong

    def __repr__(self) -> str:
        ratio = f" ({self.made / self.made_without:.3f} of it)" if self.made_without else ""
        undecided = f", {self.undecided} undecided" if self.undecided else ""
        text = (f"{self.asked} questions: {len(self.wrong)} wrong{undecided}; {self.made} rows made, "
                f"{self.made_without} without rules{ratio}; {self.dropped} dropped")
        return text + "".join(f"\n{wrong}" for wrong in self.wrong[:1])


def trial(rules: Any = None, order: Any = None, systems: int | Iterable[SystemLike] = 200, seed: int = 1,
          most_wrong: int = 1, **options: Any) -> Trial:
    """Ask about systems, random ones of a seed or those that are given, with these rules and this
    order, and hold every verdict and every projection on the last variable against one that another
    method found and proved. It ends behind `most_wrong` wrong answers. Histories start anew
    wherever a rule breaks them (rebase="always") and nothing is settled before rules come in
    (presolve="none"), unless options say otherwise.

    >>> trial(rules="kohler", systems=50).wrong
    []
    """
    options = {"rebase": "always", "presolve": "none", "max_rows": 5000, **options, "method": "fm"}
    bench = _Bench(Solver(rules=rules, order=order, **options),
                   Solver(rules="none", order=order, **options))
    if isinstance(systems, int):
        drawn = small_systems(seed)
        systems = [next(drawn) for _ in range(systems)]
    for s in map(system, systems):
        for kept in (None, s.names[-1:]):
            bench.ask(s, kept)
        if len(bench.trial.wrong) >= most_wrong:
            break
    return bench.trial


def experiment(ways: Iterable[Any], of: Iterable[Problem], out: str | os.PathLike[str] | None = None,
               **options: Any) -> list[dict[str, Any]]:
    """Eliminate in each of the ways, `{"rules": [mine, "kohler"], "order": mine}` or rules alone, and
    count. A dict for each run, with the columns of `fmb-qualify run` (docs/laboratory.md; no time is
    taken); with `out`, a file of CSV, too, for `fmb-qualify plots`. Problems are those of a folder that
    `fmb-qualify benchmark` wrote, `problems(folder, sizes=[1])`, or one's own; where nothing satisfies
    one, the verdict is what is asked for, as a projection would begin with that. Every answer is held
    against one that another method found and proved; where that finds none within its limit of 20
    seconds, the answer is believed. Of a wrong one, `system` is the smallest system that shows it.

    >>> diamond = Problem("diamond", 0, 1, system("a + b + c <= 1; a + b - c <= 1; a - b + c <= 1; "
    ...     "a - b - c <= 1; c - a + b <= 1; b - a - c <= 1; c - a - b <= 1; -a - b - c <= 1"), 1)
    >>> for run in experiment(["none", "kohler", {"rules": "chernikov", "order": "given"}], [diamond]):
    ...     print(run["rules"], run["order"], run["outcome"], run["rounds"])
    none pairs decided 12 14
    kohler pairs decided 12 4
    chernikov given decided 12 4
    """
    options = {"presolve": "bounds", "max_rows": 10000, "max_seconds": 10, **options, "method": "fm"}
    truths, lines = Solver(max_seconds=20), []
    for block, problem in enumerate(of, 1):
        kept = problem.system.names[:problem.kept] or None
        said, answer = _asked(truths, problem.system, kept)
        truth = said if said is not None and answer.proof.check() else None
        if truth is not None and answer.feasible is False:
            kept, truth = None, "infeasible"
        for way in _experiment.ways_of(ways):
            line: dict[str, Any] = {**_experiment.run(problem, way, kept, truth, _asked, **options), "block": block}
            if line["outcome"] == "wrong":
                solver = way.solver(**options)
                small = _smaller(problem.system, lambda s: _Bench(solver, solver).is_wrong(s, kept))
                line["system"] = "; ".join(str(small).splitlines())
            lines.append(line)
    if out is not None:
        _experiment.write(lines, out)
    return lines


class _Bench:
    """The solver on trial, one that counts without rules, and one for the truth."""

    def __init__(self, tried: Solver, without: Solver):
        self.tried = tried
        self.without = without
        self.truths = Solver(method="lp")
        self.trial = Trial()

    def ask(self, s: System, kept: tuple[str, ...] | None) -> None:
        """One question about a system."""
        said, answer = _asked(self.tried, s, kept)
        _, without = _asked(self.without, s, kept)
        self.trial.asked += 1
        if said is None or not without.done:
            self.trial.undecided += 1
            return
        self.trial.made += int(answer.stats["rows_made"])
        self.trial.dropped += int(answer.stats["rows_dropped"])
        self.trial.made_without += int(without.stats["rows_made"])
        if said != self.truth(s, kept):
            small = _smaller(s, lambda one: self.is_wrong(one, kept))
            told, truth = _asked(self.tried, small, kept)[0], self.truth(small, kept)
            self.trial.wrong.append(Wrong(small, s, kept, str(told), truth))

    def truth(self, s: System, kept: tuple[str, ...] | None) -> str:
        """What another method says, with a proof that holds."""
        said, answer = _asked(self.truths, s, kept)
        if said is None or not answer.proof.check():
            raise ArgumentError(f"the truth about this system is not known:\n{s}")
        return said

    def is_wrong(self, s: System, kept: tuple[str, ...] | None) -> bool:
        """Does it still go wrong?"""
        if kept is not None and any(name not in s.names for name in kept):
            return False
        said = _asked(self.tried, s, kept)[0]
        return said is not None and said != self.truth(s, kept)


def _asked(solver: Solver, s: System, kept: tuple[str, ...] | None) -> tuple[str | None, Any]:
    """The content of an answer, for comparisons; None if a limit ended it."""
    if kept is None:
        answer: Any = solver.solve(s)
        said = "feasible" if answer.feasible else "infeasible"
    else:
        answer = solver.project(s, kept)
        said = "; ".join(map(repr, answer.system)) if answer.done else ""
    return (said if answer.done else None), answer


def _made_of(names: Sequence[str], rows: Sequence[SystemRow]) -> System:
    s = System((), names)
    for row in rows:
        s.add(row)
    return s


def _smaller(s: System, fails: Callable[[System], bool]) -> System:
    """The system with fewer rows and smaller numbers that still fails."""
    changed = True
    while changed:
        changed = False
        for candidate in _candidates(s):
            if fails(candidate):
                s, changed = candidate, True
                break
    return s


def _candidates(s: System) -> Iterator[System]:
    """Systems a step smaller than s."""
    rows, names = s.rows, s.names
    for i in range(len(rows)):
        yield _made_of(names, rows[:i] + rows[i + 1:])
    for name in names[:-1]:
        if not any(name in row.coefficients for row in rows):
            yield _made_of([other for other in names if other != name], rows)
    for i, row in enumerate(rows):
        for smaller in _simpler_rows(row):
            yield _made_of(names, rows[:i] + [smaller] + rows[i + 1:])


def _simpler_rows(row: SystemRow) -> Iterator[SystemRow]:
    if row.relation != "<=":
        yield SystemRow(row.coefficients, "<=", row.right, row.label)
    for name, c in row.coefficients.items():
        rest = {other: d for other, d in row.coefficients.items() if other != name}
        yield SystemRow(rest, row.relation, row.right, row.label)
        if abs(c) > 1:
            yield SystemRow({**row.coefficients, name: c / abs(c)}, row.relation, row.right, row.label)
    if row.right:
        yield SystemRow(row.coefficients, row.relation, row.right * 0, row.label)
        if abs(row.right) > 1:
            yield SystemRow(row.coefficients, row.relation, row.right / abs(row.right), row.label)
