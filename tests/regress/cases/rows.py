"""Exact rows of a system, written a second time so that nothing is taken on trust from fmb.

A row is (coefficients, relation, right side): a list of Fraction, one of "<=", "<", "=", a Fraction.
Readers for .ine and for one-line inequalities; canonical form of an irredundant system; witness and
Farkas multipliers judged by evaluating them.
"""

import math
import re
from fractions import Fraction

MIRROR = {">=": "<=", ">": "<", "<=": "<=", "<": "<", "=": "="}


def read_ine(text):
    """Rows of cddlib/lrslib H-format: "b a1..an" means b + a.x >= 0, as many as the header says
    (unless it says no number: then all up to the end line), in the order of the file."""
    lines = [line.split() for line in text.splitlines() if line.strip() and line[0] != "*"]
    begin = next(i for i, words in enumerate(lines) if words[0].lower() == "begin")
    end = next(i for i, words in enumerate(lines) if words[0].lower().startswith("end"))
    count, width = lines[begin + 1][0], int(lines[begin + 1][1])
    words = [w for line in lines[begin + 2 : end] for w in line]
    if count.isdigit():
        words = words[: int(count) * width]
    numbers = [Fraction(w) for w in words]
    equal, strict = set(), set()
    for line in lines[:begin] + lines[end + 1 :]:
        name = line[0].lower()
        if name in ("linearity", "strict_inequality", "equality"):
            which = strict if name == "strict_inequality" else equal
            which.update(int(w) for w in line[2 : 2 + int(line[1])])
    rows = []
    for i in range(0, len(numbers), width):
        number = i // width + 1
        rel = "=" if number in equal else "<" if number in strict else "<="
        rows.append(([-a for a in numbers[i + 1 : i + width]], rel, numbers[i]))
    return rows


def read_sum(text, place):
    """Coefficients and constant of a sum such as "-0.25x2 + 3 y - 7"."""
    coef = [Fraction(0)] * len(place)
    constant = Fraction(0)
    term = re.compile(r"\s*([+-]?)\s*([0-9]+(?:\.[0-9]*)?(?:/[0-9]+)?)?\s*([A-Za-z_]\w*)?")
    at = 0
    while text[at:].strip():
        sign, number, name = (m := term.match(text, at)).groups()
        if number is None and name is None:
            raise ValueError("not a sum: " + text)
        value = Fraction(number or 1) * (-1 if sign == "-" else 1)
        if name is None:
            constant += value
        else:
            coef[place[name]] += value
        at = m.end()
    return coef, constant


def read_line(text, names):
    """One inequality "sum REL sum" over the variables names."""
    place = {name: j for j, name in enumerate(names)}
    left, rel, right = re.split(r"(<=|>=|<|>|=)", text)
    a, c = read_sum(left, place)
    b, d = read_sum(right, place)
    sign = -1 if rel in (">=", ">") else 1
    return [sign * (x - y) for x, y in zip(a, b)], MIRROR[rel], sign * (d - c)


def primitive(values):
    """The smallest integer vector that is a positive multiple of values."""
    scale = math.lcm(*(v.denominator for v in values)) if values else 1
    whole = [int(v * scale) for v in values]
    divisor = math.gcd(*whole) if any(whole) else 1
    return tuple(v // divisor for v in whole)


def echelon(equalities):
    """Reduced row echelon form of [a | b] rows, with the pivot column of each row."""
    rows, pivots = [list(r) for r in equalities], []
    width = len(rows[0]) if rows else 0
    done = 0
    for col in range(width):
        pick = next((i for i in range(done, len(rows)) if rows[i][col] != 0), None)
        if pick is None:
            continue
        rows[done], rows[pick] = rows[pick], rows[done]
        lead = rows[done][col]
        rows[done] = [v / lead for v in rows[done]]
        for i, row in enumerate(rows):
            if i != done and row[col] != 0:
                rows[i] = [v - row[col] * w for v, w in zip(row, rows[done])]
        pivots.append(col)
        done += 1
    return rows[:done], pivots


def canonical(rows):
    """(equalities, inequalities): equal for two irredundant descriptions of one closed set.

    The affine hull has one reduced echelon form, and modulo the hull each facet one inequality up
    to a positive factor. Rows 0 <= c with c >= 0 say nothing and are left out; an inconsistent
    constant row makes the whole set empty, written (empty, {}).
    """
    hull, pivots = echelon([a + [b] for a, rel, b in rows if rel == "="])
    if pivots and rows and pivots[-1] == len(rows[0][0]):
        return "empty", frozenset()
    rest = set()
    for a, rel, b in rows:
        if rel == "=":
            continue
        row = a + [b]
        for line, col in zip(hull, pivots):
            row = [v - row[col] * w for v, w in zip(row, line)]
        if any(row[:-1]):
            rest.add((primitive(row), rel))
        elif row[-1] < 0 or (row[-1] == 0 and rel == "<"):
            return "empty", frozenset()
    return tuple(primitive(row) for row in hull), frozenset(rest)


def holds(rows, point):
    """The number of the first row that the point breaks, or None."""
    for number, (a, rel, b) in enumerate(rows, 1):
        value = sum(x * y for x, y in zip(a, point) if x)
        if not (value == b if rel == "=" else value < b if rel == "<" else value <= b):
            return number
    return None


def refutes(rows, multipliers):
    """Why the multipliers {row number: value} prove nothing; None if they prove infeasibility."""
    width = len(rows[0][0]) if rows else 0
    total, right, strict = [Fraction(0)] * width, Fraction(0), False
    for number, value in multipliers.items():
        a, rel, b = rows[number - 1]
        if rel != "=" and value < 0:
            return f"row {number} has a negative multiplier"
        total = [t + value * x for t, x in zip(total, a)]
        right += value * b
        strict = strict or (rel == "<" and value > 0)
    if any(total):
        return "the combination still has a variable"
    if right < 0 or (right == 0 and strict):
        return None
    return f"the combination reads 0 {'<' if strict else '<='} {right}"
