"""The questions, their answers, limits, Ctrl-C, threads."""

import os
import random
import signal
import threading
import time
import unittest
from fractions import Fraction as Q

import fmb
from fmb import Polyhedron, System


def cube(n):
    return System("\n".join(f"0 <= x{i} <= 1" for i in range(n)))


def hard(n, rows, seed):
    """A dense system whose projection takes long."""
    draw = random.Random(seed)
    lines = [" + ".join(f"{draw.randint(1, 99)} x{j}" for j in range(n)) + f" <= {draw.randint(99, 999)}"
             for _ in range(rows)]
    lines += [f"x{j} >= -{draw.randint(1, 9)}" for j in range(n)]
    return System("\n".join(line.replace("+ -", "- ") for line in lines))


class Questions(unittest.TestCase):
    def test_a_point_and_a_conflict(self):
        answer = fmb.solve("x + y <= 3; 2y < x - 4")
        self.assertTrue(answer)
        self.assertTrue(System("x + y <= 3; 2y < x - 4").holds(answer.point))
        self.assertIsNone(answer.conflict)
        s = System("a: x <= 1; b: x >= 2; c: y <= 9")
        answer = fmb.solve(s)
        self.assertFalse(answer)
        self.assertIsNone(answer.point)
        self.assertEqual([row.label for row in answer.conflict.rows], ["a", "b"])
        self.assertEqual(answer.conflict.numbers, [0, 1])

    def test_every_answer_is_proved(self):
        s = System("x + y <= 3; x >= 0; y >= 0; x <= 9")
        for answer in (fmb.solve(s), fmb.bounds(s), fmb.optimize(s, max="x + 2y"), fmb.reduce(s),
                       fmb.project(s, "x")):
            self.assertTrue(answer.proof.check(), repr(answer))
            self.assertTrue(fmb.check(answer._about, answer.proof.to_text()))
        proof = fmb.solve(s).proof.to_text()
        self.assertFalse(fmb.check("x + y <= -1; x >= 0; y >= 0; x <= 9", proof))
        with self.assertRaises(fmb.ParseError):
            fmb.check(s, "no proof")

    def test_boxes(self):
        box = fmb.bounds("0 <= x; x + y <= 4; y > 1")
        self.assertEqual((box["x"].lower, box["x"].upper, box["y"].upper), (0, 3, 4))
        self.assertFalse(box["x"].upper.attained)
        self.assertIn(Q(1, 2), box["x"])
        self.assertNotIn(3, box["x"])
        self.assertEqual(list(fmb.bounds("x >= 1; y >= 2", of="y")), ["y"])
        self.assertFalse(fmb.bounds("x >= 1; x <= 0"))

    def test_optima(self):
        x, y = fmb.vars("x y")
        s = System([x + 2 * y <= 4, x >= 0, y >= 0])
        best = fmb.optimize(s, max=x + 3 * y + 1)
        self.assertEqual((best.value, dict(best.point)), (7, {"x": 0, "y": 2}))
        self.assertEqual(fmb.optimize(s, min="x + y").value, 0)
        away = fmb.optimize("x >= 0", max="x")
        self.assertTrue(away.unbounded)
        self.assertEqual(away.ray["x"], 1)
        near = fmb.optimize("x < 1", max="x")
        self.assertEqual((near.value, near.attained), (1, False))
        with self.assertRaises(fmb.ArgumentError):
            fmb.optimize(s)
        s.maximize(x)
        self.assertEqual(fmb.optimize(s).value, 4)

    def test_vertices_and_hulls_are_each_others_inverse(self):
        draw = random.Random(time.time_ns())
        for _ in range(10):
            points = [[draw.randint(-9, 9) for _ in range(3)] for _ in range(8)]
            rows = fmb.hull(points)
            back = fmb.vertices(rows.system).vertices
            self.assertTrue({tuple(map(Q, p)) for p in points} >= set(back))
            self.assertTrue(all(rows.system.holds(dict(zip(("x1", "x2", "x3"), p)))
                                for p in points))
        cone = fmb.vertices(fmb.hull([(0, 0)], rays=[(1, 0)], lines=[(0, 1)]).system)
        self.assertEqual((cone.rays, cone.lines), ([(1, 0)], [(0, 1)]))

    def test_projections(self):
        shadow = fmb.project("x <= z; z <= y", "x y")
        self.assertEqual(str(shadow), "x - y <= 0")
        self.assertEqual(str(fmb.eliminate("x <= z; z <= y", "z")), "x - y <= 0")
        for method in ("auto", "fm", "hull", "dd"):
            self.assertEqual(str(fmb.project("x <= z; z <= y", "x y", method=method)),
                             "x - y <= 0")
        with self.assertRaisesRegex(fmb.ArgumentError, "no variable is called 'q'"):
            fmb.project("x >= 1", "q")

    def test_sessions(self):
        s = fmb.Session("x >= 0; x <= 4")
        with s.pushed():
            s.add("bad: x >= 5")
            self.assertEqual(s.solve().conflict.rows[-1].label, "bad")
        self.assertTrue(s.solve())
        row = s.add("x + y >= 7/3")
        self.assertEqual(s.bounds()["y"].lower, Q(7, 3) - 4)
        s.remove(row)
        self.assertEqual(len(s), 2)
        with self.assertRaises(fmb.StateError):
            s.pop()

    def test_integers_are_noted(self):
        s = System("2x = 1")
        s.set_integer("x")
        self.assertEqual(s.integers, ("x",))
        self.assertTrue(fmb.solve(s).proof.check().relaxed)

    def test_options_that_are_none(self):
        with self.assertRaisesRegex(fmb.ArgumentError, "no option is called 'speed'"):
            fmb.solve("x >= 1", speed=3)
        with self.assertRaises(fmb.ArgumentError):
            fmb.solve("x >= 1", max_seconds=-1)
        with self.assertRaises(fmb.RuleError):
            fmb.solve("x >= 1", rules="none-such")


class Scripts(unittest.TestCase):
    TEXT = """(declare-const x Real) (declare-const y Real)
        (assert (= (+ x y) 3)) (check-sat) (get-value (x (+ y (* 2 x) (- 1)) 7))
        (push 1) (assert (> x 5)) (assert (> y 5)) (check-sat) (pop 1)
        (assert (= x 1)) (check-sat) (get-value (y))"""

    def test_checks_and_values(self):
        script = fmb.Script(self.TEXT)
        self.assertTrue(script.asks_often)
        for _ in range(2):  # again from the beginning
            self.assertEqual([a.feasible for a in script.answers()], [True, False, True])
            first, second = script.values()
            self.assertEqual(second, {"y": 2})
            self.assertEqual(list(first.values())[2], 7)
            self.assertEqual(list(first.values())[1], first["x"] + 2)
        self.assertEqual([len(s) for s in script.systems()], [1, 3, 2])

    def test_mistakes(self):
        with self.assertRaises(fmb.ParseError):
            fmb.Script("(check-sat")
        with self.assertRaises(fmb.ParseError):
            list(fmb.Script("(pop 1) (check-sat)").systems())
        with self.assertRaises(fmb.StateError):
            list(fmb.Script("(declare-const x Real) (get-value (x))").values())

    def test_objectives(self):
        s = System("2x <= 1")
        self.assertEqual((s.objective, s.sense), (None, None))
        s.minimize("3x/2 + 1")
        self.assertEqual((repr(s.objective), s.sense), ("3/2 x + 1", "min"))
        self.assertEqual(fmb.optimize(s, max=[2]).value, 1)
        with self.assertRaises(fmb.ArgumentError):
            fmb.optimize(s, max=[1, 2])
        self.assertIn("V-representation", fmb.vertices("0 <= x <= 1").to_text())


class Limits(unittest.TestCase):
    def test_a_limit_is_told(self):
        answer = fmb.project(cube(30), [], max_rows=1, method="fm")
        shadow = fmb.vertices(cube(24), max_rows=100)
        self.assertEqual(shadow.stop, "rows")
        self.assertFalse(shadow.done)
        self.assertIsNotNone(answer)

    def test_an_unknown_answer_has_no_truth(self):
        answer = fmb.project(hard(14, 40, 1), "x0 x1 x2 x3 x4 x5", max_seconds=1e-6)
        self.assertEqual(answer.stop, "time")
        if answer.feasible is None:
            with self.assertRaises(fmb.Unfinished):
                bool(answer)

    def test_progress_is_told_and_may_refuse(self):
        told = []
        fmb.project(hard(6, 12, 1), "x0 x1", method="fm", progress=told.append)
        self.assertTrue(told and told[0].text.startswith("{"))

        def refuse(event):
            raise RuntimeError("enough")
        with self.assertRaisesRegex(RuntimeError, "enough"):
            fmb.project(hard(6, 12, 1), "x0 x1", method="fm", progress=refuse)

    def test_ctrl_c_ends_a_query(self):
        before = signal.getsignal(signal.SIGINT)
        signal.signal(signal.SIGINT, signal.default_int_handler)
        try:
            threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
            with self.assertRaises(KeyboardInterrupt):
                fmb.vertices(hard(30, 90, 2))
            self.assertTrue(fmb.solve("x >= 1"))
        finally:
            signal.signal(signal.SIGINT, before)

    def test_queries_run_side_by_side(self):
        """The interpreter goes on while a query runs."""
        solver, ended = fmb.Solver(), []

        def ask():
            ended.append(solver.vertices(hard(30, 90, 3)).stop)
        thread = threading.Thread(target=ask)
        thread.start()
        while not ended:
            solver.cancel()
            time.sleep(0.01)
        thread.join()
        self.assertEqual(ended, ["cancelled"])


class Sets(unittest.TestCase):
    def setUp(self):
        self.square = Polyhedron("0 <= x <= 1; 0 <= y <= 1")

    def test_operators(self):
        square = self.square
        self.assertTrue((square & "x + y <= 1") <= square)
        self.assertFalse(square <= (square & "x + y <= 1"))
        self.assertEqual(square + square, 2 * square)
        self.assertEqual(-square, Polyhedron("-1 <= x <= 0; -1 <= y <= 0"))
        far = square.translated({"x": 3})
        self.assertTrue(square.isdisjoint(far))
        self.assertEqual((square | far).bounds()["x"].upper, 4)
        self.assertNotEqual(square, far)
        self.assertEqual(square.project("x"), Polyhedron("0 <= x <= 1"))

    def test_strict_ones(self):
        open_square = Polyhedron("0 < x < 1; 0 < y < 1")
        self.assertTrue(open_square <= self.square)
        self.assertFalse(self.square <= open_square)
        self.assertNotEqual(open_square, self.square)

    def test_points(self):
        self.assertIn((Q(1, 2), "1/3"), self.square)
        self.assertNotIn({"x": 2, "y": 0}, self.square)
        with self.assertRaises(fmb.ArgumentError):
            (1, 2, 3) in self.square

    def test_dimensions(self):
        self.assertEqual(self.square.affine_dim(), 2)
        self.assertEqual((self.square & "x = 1").affine_dim(), 1)
        self.assertEqual((self.square & "x = 2").affine_dim(), -1)
        self.assertTrue((self.square & "x = 2").is_empty())

    def test_images(self):
        x, y = fmb.vars("x y")
        image = self.square.image({"u": x + y, "v": x - y})
        self.assertEqual(image.bounds()["v"].lower, -1)
        self.assertEqual(len(image.vertices()), 4)

    def test_pictures(self):
        try:
            import matplotlib
        except ImportError:
            self.skipTest("matplotlib is not there")
        matplotlib.use("Agg")
        self.assertEqual(len(self.square.plot().patches), 1)
        self.assertEqual(len(Polyhedron("x >= 0; y >= x").plot().patches), 1)
        solid = Polyhedron("0 <= x; 0 <= y; 0 <= z; x + y + z <= 1")
        self.assertEqual(len(solid.plot().collections), 1)
        with self.assertRaises(fmb.ArgumentError):
            Polyhedron("x >= 1").plot()


class Bridges(unittest.TestCase):
    def test_cddlib(self):
        from fmb.bridges import from_cdd, to_cdd
        s = from_cdd([[3, -1, -1], [0, 1, 0], [1, 0, -1]], linear=[2])
        self.assertEqual(Polyhedron(s), Polyhedron("x1 + x2 <= 3; x1 >= 0; x2 = 1"))
        rows, linear = to_cdd(s)
        self.assertEqual(Polyhedron(from_cdd(rows, linear)), Polyhedron(s))

    def test_linprog(self):
        from fmb.bridges import linprog
        best = linprog([-1, -2], A_ub=[[1, 1], [1, -1]], b_ub=[4, 2], bounds=[(0, 3), (None, 3)])
        self.assertEqual((best.status, best.fun, best.x), (0, -7.0, [1.0, 3.0]))
        self.assertTrue(best.exact.proof.check())
        self.assertEqual(linprog([1], bounds=(None, None)).status, 3)
        self.assertEqual(linprog([1], A_eq=[[1]], b_eq=[-1]).status, 2)


if __name__ == "__main__":
    unittest.main()
