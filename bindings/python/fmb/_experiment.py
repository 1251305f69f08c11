"""Experiments with rules and orders in Python: every run a line with the columns of `fmb-qualify run`."""

from __future__ import annotations

import csv
import json
import os
import pathlib
from typing import Any, Callable, Iterable, Iterator, Mapping, NamedTuple

from fmb._lib import RuleError, lib, text
from fmb._solver import Event, Solver
from fmb._system import System

# docs/laboratory.md says what each column is.
COLUMNS = (
    "plan block family size seed digits density rows variables kept question method order rules evidence outcome stop "
    "verdict pairs made rows_kept lived peak held rounds max_rows max_seconds timed passes seconds version commit "
    "machine system").split()
_MOST_ROUNDS = 32


class Problem(NamedTuple):
    """A system, and how many of its first variables stay; 0: has it a solution?"""

    family: str
    size: int
    seed: int
    system: System
    kept: int


class Way(NamedTuple):
    """Rules and an order, as Solver takes them; `"default"`: the rules that it takes without a word."""

    rules: Any = "none"
    order: Any = "pairs"

    def solver(self, **options: Any) -> Solver:
        """Which works in this way."""
        return Solver(rules=None if self.rules == "default" else self.rules, order=self.order, **options)


def problems(folder: str | os.PathLike[str], families: Any = None, sizes: Any = None, seeds: Any = None) -> Iterator[Problem]:
    """Those of a folder that `fmb-qualify benchmark` has written; of all families, sizes and seeds, or
    of the given ones.

    >>> import pathlib, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     place = pathlib.Path(folder)
    ...     _ = (place / "manifest.csv").write_text("name,family,size,instance,kept\\nline-1,line,1,1,0\\n")
    ...     _ = (place / "line-1.ine").write_text("begin\\n1 2 integer\\n1 -1\\nend\\n")
    ...     [(one.family, len(one.system)) for one in problems(folder, sizes=[1])]
    [('line', 1)]
    """
    place = pathlib.Path(folder)
    with open(place / "manifest.csv", encoding="utf-8", newline="") as file:
        for line in csv.DictReader(file):
            size, seed = int(line["size"]), int(line["instance"])
            if ((families is None or line["family"] in families) and (sizes is None or size in sizes)
                    and (seeds is None or seed in seeds)):
                yield Problem(line["family"], size, seed, System.read(place / f"{line['name']}.ine"), int(line["kept"]))


class _Rounds:
    """The events of rounds while a query runs."""

    def __init__(self) -> None:
        self.alive: list[int] = []
        self.pairs = self.peak = 0

    def put(self, event: Event) -> None:
        if event.kind == "round":
            told = json.loads(event.text)
            self.pairs += told["pairs"]
            self.alive.append(told["rows_out"])
            self.peak = max(self.peak, told["rows_in"], told["rows_out"])

    def text(self) -> str:
        return " ".join(map(str, self.alive[:_MOST_ROUNDS])) + (" ..." if len(self.alive) > _MOST_ROUNDS else "")


def name_of(word: Any) -> str:
    """What a set of rules, or an order, is called in a line."""
    if isinstance(word, (list, tuple)):
        return ",".join(map(name_of, word)) or "none"
    return str(getattr(word, "name", None) or getattr(word, "__name__", word)).replace("_", "-")


def run(problem: Problem, way: Way, kept: tuple[str, ...] | None, truth: str | None,
        asked: Callable[..., tuple[str | None, Any]], **options: Any) -> dict[str, Any]:
    """One line. `kept` are the variables of the projection that is asked for, None for the verdict; `truth`
    is what is right, None if it is not known; `asked` asks."""
    rounds = _Rounds()
    line: dict[str, Any] = dict.fromkeys(COLUMNS, "")
    line.update(plan="python", family=problem.family, size=problem.size, seed=problem.seed, digits=0, density=100,
                rows=len(problem.system), variables=len(problem.system.names), kept=problem.kept,
                question="project" if problem.kept else "solve", method="fm", order=name_of(way.order),
                rules=name_of(way.rules), evidence="all", max_rows=options.get("max_rows", 0),
                max_seconds=options.get("max_seconds", 0), timed="no", passes=0, seconds=0,
                version=text(lib.fmb_version()))
    try:
        said, answer = asked(way.solver(progress=rounds.put, **options), problem.system, kept)
    except RuleError:
        line.update(outcome="refused")
        return line
    stats = answer.stats
    is_wrong = said is not None and truth is not None and said != truth
    line.update(outcome="stopped" if said is None else "wrong" if is_wrong else "decided", stop=answer.stop,
                verdict={True: "feasible", False: "infeasible"}.get(answer.feasible, "unknown"), pairs=rounds.pairs,
                made=stats["rows_made"], rows_kept=stats["rows_kept"], lived=sum(rounds.alive), peak=rounds.peak,
                held=stats["rows_peak"], rounds=rounds.text())
    return line


def write(lines: list[dict[str, Any]], path: str | os.PathLike[str]) -> None:
    """As CSV, for `fmb-qualify plots`."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(lines)


def ways_of(ways: Iterable[Any]) -> list[Way]:
    """Each is Way's words, or rules alone."""
    return [Way(**way) if isinstance(way, Mapping) else Way(way) for way in ways]
