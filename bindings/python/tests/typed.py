"""What users write: mypy --strict finds nothing wrong with it (the test "package types"), and it runs."""

from __future__ import annotations

from fractions import Fraction
from typing import Optional, Sequence, Tuple

import fmb
from fmb import lab


def questions() -> Optional[Fraction]:
    x, y = fmb.vars("x y")
    s = fmb.System([x + y <= 3, 0 <= x <= 4, (y == 2 * x - 1).named("line")])
    s += y >= Fraction(1, 3)
    answer = fmb.solve(s, max_seconds=1)
    if answer and answer.point is not None:
        values: list[float] = answer.point.floats()
        print(values, answer.point[x], answer.proof.check().accepted)
    elif answer.conflict is not None:
        print([row.label for row in answer.conflict.rows])
    shadow: fmb.SystemAnswer = fmb.project(s, "x")
    print([row.relation for row in shadow], s[0].coefficients["x"], s[1:3])
    low: fmb.End = fmb.bounds(s)["x"].lower
    print(low < 3, fmb.vertices(s).vertices[0], fmb.reduce(s).redundant)
    return fmb.optimize(s, max=x + 2 * y).value


def sets() -> bool:
    p = fmb.Polyhedron("0 <= x <= 1; 0 <= y <= 1")
    q = p & "x + y <= 1"
    corners: list[Tuple[Fraction, ...]] = (p + 2 * q).vertices()
    return q <= p and p.project("x") == "0 <= x <= 1" and len(corners) > 3


@lab.rule(needs_history=True)
def short_histories(view: lab.View) -> list[lab.ViewRow]:
    return [row for row in view.rows if len(row.history or ()) > view.eliminated + 1]


@lab.order
def first(view: lab.View, columns: Sequence[int]) -> int:
    return columns[0] if view.dim else 0


def laboratory() -> list[lab.Wrong]:
    return lab.trial(rules=[short_histories, "box"], order=first, systems=10).wrong


def sessions() -> list[Optional[bool]]:
    with fmb.Session("x >= 0", threads=1) as s:
        row = s.add("x <= 4")
        with s.pushed():
            s.add("x >= 5")
            s.set_right(row, "9/2")
            found = [s.solve().feasible]
    return found + [answer.feasible for answer in fmb.Script("(check-sat)").answers()]
