#!/usr/bin/env python3
"""The judge judged: unit tests of the comparison code of cases.py and programs.py, with no fmb in
sight."""

import unittest
from fractions import Fraction as F

import programs
import questions as q
import rows as exact
from families import row_of, wrapped


def row(text, names=("x", "y", "z")):
    return exact.read_line(text, list(names))


def system(*texts):
    return [row(t) for t in texts]


class Reading(unittest.TestCase):
    def test_sums(self):
        self.assertEqual(row("-0.25x + 3 y - 7 <= 1/2 z"), ([F(-1, 4), 3, F(-1, 2)], "<=", 7))
        self.assertEqual(row("y > x"), ([1, -1, 0], "<", 0))
        self.assertEqual(row("z + 2 > 3 + z"), ([0, 0, 0], "<", -1))
        self.assertEqual(row("x + x >= y"), ([-2, 1, 0], "<=", 0))
        with self.assertRaises(ValueError):
            row("x * y <= 1")

    def test_ine(self):
        text = "* c\nH-representation\nlinearity 1 2\nbegin\n3 3 rational\n1 1/2 0\n0 1 -1\n2 0 -1\n"
        text += "9 9 9\nend\nstrict_inequality 1 3\n"
        self.assertEqual(exact.read_ine(text), [([F(-1, 2), 0], "<=", 1), ([-1, 1], "=", 0),
                                                ([0, 1], "<", 2)])

    def test_recorded_rows(self):
        self.assertEqual(row_of("I 1 2 -3".split(), -1), ([-2, 3], "<=", 1))
        self.assertEqual(row_of("E -6 1 1".split(), -1), ([-1, -1], "=", -6))
        self.assertEqual(row_of("<= 1 2 -3".split(), 1), ([2, -3], "<=", 1))

    def test_wrapper(self):
        self.assertEqual(wrapped("# a\nvars: x\nsystem:\n  x <= 1\n  x >= 0\nexact: y\n"),
                         ["x <= 1", "x >= 0"])


class Optima(unittest.TestCase):
    def test_values(self):
        def judge(value, recorded):
            return q.judge_optimum({"optimum": {"value": value}}, recorded)
        self.assertIsNone(judge("-932/2", -466.0))
        self.assertIsNone(judge("1/3", 0.333333))
        self.assertIsNone(judge("5", 5.000001))
        self.assertIn("truth", judge("1/3", 0.33333))
        self.assertIn("truth", judge("5", -5.0))
        self.assertIn("truth", judge("-inf", -5.0))
        self.assertIn("truth", judge(None, 0.0))


class Canonical(unittest.TestCase):
    def same(self, a, b):
        self.assertEqual(exact.canonical(system(*a)), exact.canonical(system(*b)))

    def differ(self, a, b):
        self.assertNotEqual(exact.canonical(system(*a)), exact.canonical(system(*b)))

    def test_scale_and_order(self):
        self.same(["2x + 4y <= 6", "z < 1"], ["1/3z < 1/3", "x + 2y <= 3"])
        self.differ(["x <= 1"], ["x < 1"])
        self.differ(["x <= 1"], ["-x <= 1"])
        self.differ(["x <= 1"], ["x <= 2"])

    def test_modulo_equalities(self):
        self.same(["x = y", "x <= 1"], ["y - x = 0", "y <= 1"])
        self.same(["x + y = 1", "y + z = 1", "x <= 3"], ["x = z", "x + y = 1", "-y <= 2"])
        self.differ(["x = y", "x <= 1"], ["x = y", "z <= 1"])
        self.same(["x = y", "x = z"], ["y = z", "x = z"])

    def test_constants(self):
        self.same(["0 <= 1", "x <= 1"], ["x <= 1"])
        self.same(["0 <= -1", "x <= 1"], ["0 < 0"])
        self.same(["x = 1", "x = 2"], ["0 <= -1"])
        self.same(["x = 1", "-x <= -2"], ["0 <= -1"])
        self.differ(["0 < 1"], ["0 < 0"])
        self.assertEqual(exact.canonical([]), ((), frozenset()))


class Evidence(unittest.TestCase):
    def test_points(self):
        s = system("x + y <= 1", "x < 2", "y = 1")
        self.assertIsNone(exact.holds(s, [F(0), F(1), F(0)]))
        self.assertEqual(exact.holds(s, [F(1, 10), F(1), F(0)]), 1)
        self.assertEqual(exact.holds(s, [F(-1), F(2), F(0)]), 3)
        self.assertEqual(exact.holds(system("x < 2"), [F(2), F(0), F(0)]), 1)

    def test_farkas(self):
        s = system("x <= 0", "-x <= 0", "x < 0", "x = 5")
        self.assertIsNone(exact.refutes(s, {2: F(1), 3: F(1)}))
        self.assertIsNone(exact.refutes(s, {1: F(1), 4: F(-1)}))
        self.assertIn("0 <= 0", exact.refutes(s, {1: F(1), 2: F(1)}))
        self.assertIn("variable", exact.refutes(s, {1: F(1), 2: F(2)}))
        self.assertIn("negative", exact.refutes(s, {1: F(-1), 4: F(1)}))
        self.assertIsNotNone(exact.refutes(s, {}))


class Judging(unittest.TestCase):
    class Reply:
        def __init__(self, code, **out):
            self.code, self.out = code, out

    def test_verdicts(self):
        s = system("x <= 0", "-x <= -1")
        good = self.Reply(1, verdict="infeasible", conflict=[{"row": 1, "multiplier": "1"},
                                                             {"row": 2, "multiplier": "1"}])
        self.assertEqual(q.judge_verdict(good, "unsat", s)[0], q.ANSWERED)
        self.assertEqual(q.judge_verdict(good, "sat", s)[0], q.WRONG)
        weak = self.Reply(1, verdict="infeasible", conflict=[{"row": 1, "multiplier": "1"}])
        self.assertEqual(q.judge_verdict(weak, "unsat", s)[0], q.WRONG)
        point = self.Reply(0, verdict="feasible", witness={"x": "0", "y": "0", "z": "0"})
        self.assertEqual(q.judge_verdict(point, "sat", system("x <= 0"))[0], q.ANSWERED)
        self.assertEqual(q.judge_verdict(point, "sat", s)[0], q.WRONG)
        self.assertEqual(q.judge_verdict(self.Reply(0, verdict="infeasible"), "unsat", None)[0],
                         q.WRONG)

    def test_sizes(self):
        said = {"cdd": {"rows": 5, "lin": 1}, "lrs": {"rows": 6, "lin": 0},
                "ppl": {"eq": 1, "ineq": 4}}
        self.assertEqual(q.recorded_sizes(said), {(1, 4): ["cdd", "ppl"], (0, 6): ["lrs"]})
        self.assertEqual(q.sizes(system("x = 1", "y <= 2", "z < 1")), (1, 2))

    def test_ends(self):
        self.assertEqual(q.end_of("-inf"), float("-inf"))
        self.assertEqual(q.end_of("2/4"), q.end_of("1/2"))
        self.assertNotEqual(q.end_of("1/3"), q.end_of("0.3333333333333333"))


class Programs(unittest.TestCase):
    class Options:
        seconds = 60.0

    def case(self, seconds, fault="", best_fault=""):
        return {"seconds": seconds, "fault": fault, "best_fault": best_fault, "best_seconds": 1.0,
                "float": {"read": 0.5, "decide": 0.5, "solve": 1.5}}

    def broken(self, done):
        """What of each bar is too much."""
        return [what.split(":")[0] for what, value, limit in
                programs.bars(done, self.Options, True) if value > limit]

    def test_bars(self):
        self.assertEqual(self.broken([self.case(20)]), [])
        self.assertEqual(self.broken([self.case(20.1)]), ["verdicts"])
        self.assertEqual(self.broken([self.case(1, fault="WRONG")]),
                         ["verdicts undecided, killed or wrong"])
        self.assertEqual(self.broken([self.case(1, best_fault="WRONG")]),
                         ["best values undecided or wrong"])
        few = [self.case(0.1)] * 90
        self.assertEqual(self.broken([self.case(11)] * 6 + few), [])
        self.assertEqual(self.broken([self.case(11)] * 7 + few), ["verdicts later than 10 s"])

    def test_values(self):
        reply = {"objective": {"sense": "min"}, "optimum": {"value": "-3/4"}}
        self.assertEqual(programs.value_of(reply), -0.75)
        reply["objective"]["sense"] = "max"
        self.assertEqual(programs.value_of(reply), 0.75)
        reply["optimum"]["value"] = "inf"
        self.assertEqual(programs.value_of(reply), float("-inf"))
        self.assertIsNone(programs.value_of({"verdict": "infeasible"}))
        self.assertTrue(programs.near(1e9 + 1, 1e9))
        self.assertFalse(programs.near(0.1, 0))
        self.assertEqual(programs.recorded({"published": 1.0, "two_float_solvers": 2.0}), 1.0)
        self.assertIsNone(programs.recorded(None))


if __name__ == "__main__":
    unittest.main()
