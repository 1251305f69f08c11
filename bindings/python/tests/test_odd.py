"""What newcomers try: empty and huge things, numbers that are none, names of all kinds, callbacks that
raise, objects that are closed, copied, pickled."""

import copy
import gc
import os
import pickle
import signal
import threading
import time
import unittest
import warnings
from decimal import Decimal
from fractions import Fraction as Q

import fmb
from fmb import Polyhedron, Session, System

HUGE = 10 ** 5000 + 1


class Numbers(unittest.TestCase):
    def test_long_ones_go_in_and_come_out(self):
        (x,) = fmb.vars("x")
        s = System([x * HUGE <= Q(1, HUGE)])
        self.assertEqual(s[0].coefficients["x"] * HUGE, HUGE * s[0].right * HUGE * HUGE)
        self.assertEqual(fmb.solve([x == -HUGE]).point["x"], -HUGE)
        self.assertEqual(fmb.bounds([x <= Q(HUGE, 7)])["x"].upper, Q(HUGE, 7))
        self.assertEqual(fmb.optimize([x <= HUGE], max=x).value, HUGE)
        self.assertEqual(fmb.hull([[0], [HUGE]]).system[0].right, HUGE)
        self.assertIn(str(10 ** 600), repr(fmb.solve([x == 10 ** 600]).point))
        self.assertTrue(repr(fmb.solve([x == HUGE])) and repr(s[0]) and repr(x * HUGE))
        self.assertEqual(fmb.Form({}, "1" * 5000).constant, (10 ** 5000 - 1) // 9)

    def test_those_that_are_none_are_told(self):
        (x,) = fmb.vars("x")
        for value in ("1/0", "nan", "", "1 2", Decimal("NaN"), Decimal("inf"), float("nan"), None, [], {}, 1j):
            with self.assertRaises(fmb.ArgumentError):
                fmb.Form({"x": value})
        with self.assertRaises(ZeroDivisionError):
            x / 0
        self.assertEqual(fmb.Form({"x": "0", "y": 0.0}).coefficients, {})

    def test_names(self):
        for name in ("", "a\0b", 3, None):
            with self.assertRaises(fmb.ArgumentError):
                fmb.Form({name: 1}) if name != "a\0b" else System([fmb.Form({name: 1}) <= 1])
        strange = fmb.Form({"a b": 1, 'q"\\': 2, "größe": 3})
        s = System([strange <= 3, strange >= 1])
        self.assertEqual(fmb.optimize(s, max=strange).value, 3)
        self.assertEqual(str(fmb.image(s, {"out put": strange})), "out put <= 3\nout put >= 1")
        self.assertEqual(pickle.loads(pickle.dumps(s)), s)
        with self.assertRaises(fmb.ArgumentError):
            fmb.vars("x3:1")

    def test_numbers_beside_names(self):
        e, e3, milk = fmb.vars("e e3 milk")
        self.assertEqual(repr(2 * e3 + 3 * e + 4 * milk), "2 e3 + 3 e + 4 milk")
        box = [e3 <= 7, e <= 1]
        self.assertEqual(fmb.optimize(box, max=2 * e3 + 3 * e).value, 17)
        self.assertEqual(str(fmb.image(box, {"y": 2 * e3})), "y <= 14")
        self.assertEqual(System(str(System([2 * e3 <= 1]))), System([2 * e3 <= 1]))

    def test_comparisons_with_what_is_no_form(self):
        (x,) = fmb.vars("x")
        self.assertFalse(x in [None, "a", []])
        self.assertTrue(x != [] and not x == None)  # noqa: E711  pylint: disable=C0121
        with self.assertRaisesRegex(TypeError, "row"):
            (x <= 1) + x

    def test_chains_with_equations(self):
        x, y, z = fmb.vars("x y z")
        self.assertEqual(repr(x == y <= 3), "x = y <= 3")
        self.assertEqual(repr(0 <= x == y == z), "0 <= x = y = z")
        self.assertEqual(len(System([x == y == z])), 2)


class Texts(unittest.TestCase):
    def test_semicolons_in_several_lines(self):
        s = System('x >= 0; y >= 0 # this; that\nlow: x + y <= 3; "a;b" = 1')
        self.assertEqual((len(s), s.names), (4, ("x", "y", "a;b")))
        with self.assertRaises(fmb.ParseError) as caught:
            System("x >= 1; y <= <= 3\nz = 1")
        self.assertEqual((caught.exception.line, caught.exception.column), (1, 14))
        labelled = System("x <= 1")
        labelled.set_label(0, "a;b")
        self.assertEqual(pickle.loads(pickle.dumps(labelled))[0].label, "a;b")

    def test_what_is_left_out_is_told(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            System("milk >= 1\nmilk + egg <= 3\nmilk <= mlik\nmilk <= 2")
        self.assertTrue(any(issubclass(w.category, fmb.ParseWarning) for w in caught))

    def test_bytes_that_are_no_text(self):
        s = System((), ["x"])
        with self.assertRaises((fmb.ParseError, TypeError)):
            System.parse(None)
        with self.assertRaises(TypeError):
            System(fmb.Form({"x": 1}))
        with self.assertRaises(TypeError):
            fmb.solve(3)
        with self.assertRaises(TypeError):
            fmb.solve({"x": 1})
        self.assertEqual(len(s), 0)


class Rows(unittest.TestCase):
    def test_slices_and_points(self):
        s = System("x >= 0; y >= 0; x + y <= 1")
        self.assertEqual(s[-2:], [s[1], s[2]])
        self.assertTrue(s.holds([0, 1]) and not s.holds((1, 1)) and s.holds({"x": 0, "y": "1/2"}))
        with self.assertRaisesRegex(fmb.ArgumentError, "has no 'y'"):
            s.holds({"x": 1})
        with self.assertRaises(TypeError):
            s["x"]

    def test_which_variables(self):
        x, _ = fmb.vars("x y")
        s = System("0 <= x <= 1; y = x")
        self.assertEqual(str(fmb.project(s, x)), str(fmb.project(s, "x")))
        self.assertEqual(str(fmb.project(s, [1])), "y <= 1\ny >= 0")
        self.assertEqual(list(fmb.bounds(s, of=[])), [])
        self.assertEqual(list(fmb.bounds(s, of=["y", "x"])), ["y", "x"])
        for keep in ([2], [-1], ["q"], "q"):
            with self.assertRaises(fmb.ArgumentError):
                fmb.project(s, keep)

    def test_names_that_are_there(self):
        s = System(System("y <= 1"), "x y")
        self.assertEqual(s.names, ("x", "y"))
        self.assertEqual(fmb.hull([[0, 1]], names=["x2", "x1"]).system.names, ("x2", "x1"))
        with self.assertRaises(fmb.ArgumentError):
            fmb.hull([[0, 1]], names=["a"])
        for points in ([], [1, 2], [[1], [1, 2]]):
            with self.assertRaises(fmb.ArgumentError):
                fmb.hull(points)

    def test_ends_are_numbers(self):
        box = fmb.bounds("0 <= x < 3")
        self.assertTrue(box["x"].lower < 1 < box["x"].upper <= 3 and box["x"].upper > box["x"].lower)
        self.assertTrue(fmb.bounds("x <= 3")["x"].lower < -10 ** 9)
        self.assertEqual(box["x"], fmb.bounds("0 <= y < 3")["y"])
        self.assertNotEqual(box["x"], fmb.bounds("0 <= y <= 3")["y"])
        with self.assertRaises(TypeError):
            box["x"].lower < "a"  # pylint: disable=expression-not-assigned

    def test_sets_are_compared_with_texts(self):
        square = Polyhedron("0 <= x <= 1")
        self.assertTrue(square == "x >= 0; x <= 1" and square != "x >= 0" and square < "x >= 0")
        self.assertFalse(square < square or square == 3)
        self.assertTrue(square and not square & "x = 2")
        with self.assertRaises(fmb.ArgumentError):
            square.translated({"X": 1})

    def test_long_answers_are_shortened_for_people(self):
        s = System("\n".join(f"x{j} = {j}" for j in range(500)))
        self.assertIn("... (400 more)", repr(fmb.solve(s).point))
        self.assertEqual(str(fmb.solve(s).point).count("="), 500)
        self.assertLess(len(repr(fmb.bounds(s))), 5000)
        self.assertLess(len(repr(fmb.project(s, s.names))), 5000)


class Copies(unittest.TestCase):
    def test_everything_is_pickled(self):
        s = System("a: x + y <= 3; x >= 0; y >= 0; x + y <= 4")
        away = pickle.loads(pickle.dumps(fmb.optimize("x >= 0", max="x")))
        self.assertTrue(away.unbounded and away.ray["x"] == 1)
        for answer in (fmb.solve(s), fmb.bounds(s), fmb.optimize(s, max="x + 2y"), fmb.reduce(s),
                       fmb.project(s, "x"), fmb.vertices(s), fmb.solve("x < 0; x > 0")):
            for twin in (pickle.loads(pickle.dumps(answer)), copy.deepcopy(answer), copy.copy(answer)):
                self.assertEqual(repr(twin), repr(answer))
                self.assertEqual((twin.feasible, twin.stats), (answer.feasible, answer.stats))
                self.assertTrue(twin.proof.check())
        x, y = fmb.vars("x y")
        for thing in (x, x + y / 3, 0 <= x <= y, (x <= 1).named("cap"), s[0], Polyhedron(s),
                      System(), System("x < 0; x > 0"), fmb.solve(s).point, Polyhedron()):
            self.assertEqual(repr(pickle.loads(pickle.dumps(thing))), repr(thing))
        for error in (fmb.Unfinished("time"), fmb.ParseError("bad", 3, 4)):
            twin = pickle.loads(pickle.dumps(error))
            self.assertEqual((str(twin), vars(twin)), (str(error), vars(error)))
        with self.assertRaises(TypeError):
            pickle.dumps(fmb.Solver())

    def test_a_session_that_is_closed(self):
        with Session("x >= 0") as s:
            self.assertIn("1 row", repr(s))
        for use in (s.solve, s.push, lambda: s.add("x <= 1"), lambda: s.system, lambda: len(s)):
            with self.assertRaises(fmb.StateError):
                use()
        self.assertEqual(repr(s), "Session (closed)")

    def test_rows_of_sessions_are_exact(self):
        s = Session("x <= 9")
        low, top = s.add("x >= 1/3"), s.add(fmb.Form({"x": HUGE}) <= 1)
        s.remove(top)
        s.set_right(low, Q(2, 3))
        self.assertEqual(s.bounds()["x"].lower, Q(2, 3))
        s.set_right(low, "5/7")
        self.assertEqual(s.optimize(min=fmb.Form({"x": 3})).value, Q(15, 7))
        self.assertEqual(s.optimize(min="x/3").value, Q(5, 21))
        for wrong in (lambda: s.remove(top), lambda: s.remove(99), lambda: s.set_right(low, float("nan")),
                      lambda: s.add("x <= 1; x >= 0")):
            with self.assertRaises(fmb.ArgumentError):
                wrong()


class Threads(unittest.TestCase):
    def test_a_solver_that_is_asked_twice_at_once(self):
        solver, told = fmb.Solver(progress=lambda e: told.append(ask())), []

        def ask():
            try:
                return solver.solve("x >= 1")
            except fmb.StateError as e:
                return e
        solver.project("x <= y; y <= z", "x z")
        self.assertTrue(told and all(isinstance(e, fmb.StateError) for e in told))

    def test_ctrl_c_behind_a_query_within_a_query(self):
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        try:
            fmb.project("x <= y; y <= z", "x z", method="fm", progress=lambda e: fmb.solve("x >= 1"))
            with self.assertRaises(KeyboardInterrupt):
                os.kill(os.getpid(), signal.SIGINT)
                time.sleep(1)
        finally:
            signal.signal(signal.SIGINT, before)

    def test_ctrl_c_that_is_ignored(self):
        before = signal.signal(signal.SIGINT, signal.SIG_IGN)
        try:
            timer = threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT))
            timer.start()
            rows = [" + ".join(f"{(i * j) % 7 - 3} x{j}" for j in range(6)) for i in range(14)]
            text = "\n".join(f"{row} <= {i % 5 + 1}" for i, row in enumerate(rows))
            for _ in range(20):
                self.assertEqual(fmb.vertices(text.replace("+ -", "- ")).stop, "done")
            timer.join()
        finally:
            signal.signal(signal.SIGINT, before)

    def test_nothing_is_kept(self):
        """Queries of all kinds leave nothing behind."""
        def ask(n):
            for _ in range(n):
                fmb.solve("x + y <= 3; 2y < x - 4", max_seconds=9).proof.check()
                fmb.vertices("0 <= x <= 1; 0 <= y <= 1").vertices  # pylint: disable=W0106
                fmb.project("x <= y; y <= z", "x z", rules=[lambda view: []], progress=lambda e: None)
                try:
                    System("x <")
                except fmb.ParseError:
                    pass
            gc.collect()
        ask(20)
        before, resident = len(gc.get_objects()), pages()
        ask(200)
        self.assertLess(len(gc.get_objects()), before + 50)
        self.assertLess(pages(), resident + 500)


def pages():
    try:
        with open("/proc/self/statm", encoding="ascii") as file:
            return int(file.read().split()[1])
    except OSError:
        return 0


try:
    import numpy as np
    import scipy.sparse
except ImportError:
    np = None


@unittest.skipIf(np is None, "NumPy and SciPy are not there")
class Arrays(unittest.TestCase):
    def test_numbers_of_numpy(self):
        (x,) = fmb.vars("x")
        for value in (np.int8(3), np.uint64(3), np.float32(3), np.float64(3), np.bool_(True) + 2,
                      np.longdouble(3), np.array(3)):
            self.assertEqual(repr(value * x), "3x")
            self.assertEqual(repr(x <= value), "x <= 3")
        with self.assertRaises(fmb.ArgumentError):
            x * np.array([1, 2])

    def test_nothing_is_rounded_on_the_way(self):
        big = 2 ** 62 + 1
        third = np.longdouble(1) / 3
        for A, b in ((np.array([[big]]), np.array([0.5])), (np.array([[big]], np.uint64), np.array([1])),
                     (np.array([[2 ** 63 + 1]], np.uint64), np.array([1])), (np.array([[big]]), [Q(1, 3)]),
                     (np.array([[Q(big)]], object), [1]), (scipy.sparse.csr_array([[big]]), np.array([0.5]))):
            s = System.from_arrays(A, b)
            self.assertEqual(s[0].coefficients["x1"], int(A.max() if A.dtype != object else A[0, 0]))
            self.assertEqual(s[0].right, Q(b[0]) if isinstance(b[0], Q) else Q(b[0].item() if hasattr(
                b[0], "item") else b[0]))
        s = System.from_arrays(np.array([[third]]), [1])
        self.assertEqual(s[0].coefficients["x1"], Q(*map(int, third.as_integer_ratio())))

    def test_memory_in_any_order(self):
        A = np.arange(24.0).reshape(4, 6)
        for view in (A[::2, ::3], A.T, np.asfortranarray(A), A.astype(">f8"), A.astype(np.float16), A[:, :0]):
            b = np.ones(len(view))
            self.assertEqual(System.from_arrays(view, b), System.from_arrays(view.tolist(), b.tolist())
                             if view.size else System.from_arrays(view.copy(), b))

    def test_tables_with_columns(self):
        class Table:  # as one of pandas
            shape = (2, 2)

            def __iter__(self):
                return iter(["first", "second"])

            def to_numpy(self):
                return np.array([[1, 2], [3, 4]])
        s = System.from_arrays(Table(), [1, 2], names="p q")
        self.assertEqual(str(s), "p + 2q <= 1\n3p + 4q <= 2")

    def test_what_is_no_matrix(self):
        one = np.ones((1, 2))
        for A, b in ((one, [[1, 2]]), (one, np.ones((1, 2))), (one, 3), (3, [1]), ([1, 2], [1, 2]),
                     (one, ["a"]), (one.astype(complex), [1]), (one, [None]), (one, [float("inf")])):
            with self.assertRaises((fmb.ArgumentError, TypeError)):
                System.from_arrays(A, b)
        with self.assertRaises(fmb.ArgumentError):
            System.from_arrays(one, [1], names=["a"])
        self.assertEqual(System.from_arrays(one, [1], names=["x2", "x1"]).names, ("x2", "x1"))

    def test_frames(self):
        unit = [[[1, 0], [0, 1]]]
        two = fmb.Frames([[0, 0], [0.5, 0]], unit * 2)
        for pairs in ([[0, -1]], [[0, 0.5]], np.array([[0, 2 ** 32 + 1]]), [[0]], [["a", "b"]]):
            with self.assertRaises(fmb.ArgumentError):
                two.test(two, pairs)
        self.assertEqual(len(two.test(two, []).verdict), 0)
        with self.assertRaisesRegex(fmb.ArgumentError, r"origin\[1, 0\] is nan"):
            fmb.Frames([[0, 0], [float("nan"), 0]], unit * 2)
        for origin in ([["a", 0]], np.zeros((1, 2), complex), [[None, 0]], [[1], [1, 2]], [], np.zeros((0, 0, 0))):
            with self.assertRaises(fmb.ArgumentError):
                fmb.Frames(origin, unit)
        for wrong in ({"threads": "2"}, {"contact": "near"}, {"speed": 3}, {"max_seconds": -1}):
            with self.assertRaises(fmb.ArgumentError):
                two.meet(**wrong)
        with self.assertRaises(fmb.ArgumentError):
            fmb.cuboid([Q(1, 3)], [[1]])
        none = fmb.Frames(np.zeros((0, 2)), np.zeros((0, 2, 2)))
        self.assertEqual((len(none), none.meet().shape, len(none.test().verdict)), (0, (0, 2), 0))
        self.assertEqual(two[np.int64(1)].i, 1)
        self.assertTrue(two[0].meets(two[1]) and not two[0].meets(fmb.cuboid([2, 2], [[1, 0], [0, 1]])))
        self.assertFalse(two[0].meets(fmb.cuboid([1, 0], [[1, 0], [0, 1]]), contact="open"))
        with self.assertRaises(fmb.ArgumentError):
            two[0].meets(fmb.cuboid([0], [[1]]))

    def test_meshes(self):
        tent = fmb.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        self.assertEqual(tent.placed(2).points[1, 0], 2)
        for wrong in (lambda: tent.placed((1, 2)), lambda: tent.meet(tent.placed(), motion=(1,)),
                      lambda: fmb.Mesh([[0, 0, 0]], [[0.5, 0, 0]]), lambda: fmb.Mesh([[0, 0]], [[0, 0, 0]]),
                      lambda: tent.meet(threads="a")):
            with self.assertRaises(fmb.ArgumentError):
                wrong()
        self.assertEqual(len(pickle.loads(pickle.dumps(tent))), 1)

    def test_ctrl_c_ends_pairs_and_meshes(self):
        draw = np.random.default_rng(1)
        many = fmb.Frames(draw.uniform(0, 9, (20000, 3)), draw.uniform(-1, 1, (20000, 3, 3)))
        points = draw.uniform(0, 1, (60000, 3))
        soup = fmb.Mesh(points, np.arange(60000).reshape(-1, 3))
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        try:
            for ask in (lambda: many.meet(many), lambda: soup.meet(soup)):
                begin = time.process_time()
                threading.Timer(0.1, os.kill, (os.getpid(), signal.SIGINT)).start()
                with self.assertRaises(KeyboardInterrupt):
                    ask()
                    time.sleep(30)
                self.assertLess(time.process_time() - begin, 20)
        finally:
            signal.signal(signal.SIGINT, before)


if __name__ == "__main__":
    unittest.main()
