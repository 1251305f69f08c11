"""Systems: rows in and out, files, texts, errors."""

import copy
import os
import pickle
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction as Q

import fmb
from fmb import System


class Rows(unittest.TestCase):
    def test_chains_keep_their_order(self):
        x, y = fmb.vars("x y")
        self.assertEqual(repr(0 <= x <= y + 1), "0 <= x <= y + 1")
        self.assertEqual(repr(3 > 2 * x > y > 0), "3 > 2x > y > 0")
        self.assertEqual(repr(x <= 3 <= y), "x <= 3 <= y")
        self.assertEqual(repr(x <= x <= x), "x <= x <= x")
        self.assertEqual([repr(0 <= x <= n) for n in (1, 2)], ["0 <= x <= 1", "0 <= x <= 2"])
        self.assertEqual(repr(0 <= x <= (lambda: 0 <= y <= 2)().links[1][2]), "0 <= x <= 2")
        self.assertEqual(len(System([0 <= x <= y <= 3])), 3)

    def test_a_row_has_no_truth(self):
        x, _ = fmb.vars("x y")
        for ask in (lambda: bool(x <= 3), lambda: 1 if x <= 3 else 2, lambda: not x <= 3,
                    lambda: x <= 3 and x >= 1, lambda: x <= 3 or x >= 1,
                    lambda: any([x <= 3]), lambda: 0 < x < 3 and 1):
            with self.assertRaisesRegex(TypeError, "neither true nor false"):
                ask()
        self.assertEqual(repr(x >= 1), "x >= 1")

    def test_equal_variables_are_found_in_lists(self):
        x, y = fmb.vars("x y")
        self.assertIn(x, [y, x])
        self.assertEqual([y, x].index(x), 1)

    def test_numbers_are_meant_exactly(self):
        (x,) = fmb.vars("x")
        for value, exact in ((0.1, Q(0.1)), ("0.1", Q(1, 10)), (Decimal("0.1"), Q(1, 10)),
                             (Q(1, 3), Q(1, 3)), (10 ** 50, Q(10 ** 50))):
            s = System([x <= fmb.Form(None, value)])
            self.assertEqual(s[0].right, exact)

    def test_numbers_that_are_none(self):
        (x,) = fmb.vars("x")
        for value in (float("nan"), float("inf"), "one", None):
            with self.assertRaises((fmb.ArgumentError, TypeError)):
                fmb.Form({"x": value})
        with self.assertRaises(TypeError):
            x * x

    def test_rows_come_back(self):
        s = System("a: 2x + y <= 3; b: x > 1/3; x = y")
        self.assertEqual(s[0].coefficients, {"x": 2, "y": 1})
        self.assertEqual([r.label for r in s], ["a", "b", None])
        self.assertEqual([r.relation for r in s], ["<=", "<", "="])
        self.assertEqual(s[1].right, Q(-1, 3))
        self.assertEqual(s[-1], s[2])
        with self.assertRaises(IndexError):
            s[3]

    def test_rows_hold_or_not(self):
        s = System("x + y <= 3; x > 0")
        self.assertTrue(s.holds({"x": 1, "y": 2}))
        self.assertFalse(s.holds({"x": 0, "y": 2}))

    def test_systems_are_joined_by_names(self):
        s = System("x <= 1")
        s += "y <= 2; x >= 0"
        self.assertEqual(s.names, ("x", "y"))
        self.assertEqual(len(s), 3)
        other = s.copy()
        other.rename("x", "z")
        self.assertEqual(s.names, ("x", "y"))
        self.assertEqual(other.names, ("z", "y"))

    def test_names_that_are_no_words(self):
        s = System((), ["a b", "größe"])
        s.add(fmb.Form({"a b": 1}) <= fmb.Form({"größe": 2}))
        self.assertEqual(s.names, ("a b", "größe"))

    def test_copies_and_pickles(self):
        s = System("x + y <= 1/3; y > 2")
        for twin in (copy.copy(s), copy.deepcopy(s), pickle.loads(pickle.dumps(s))):
            self.assertEqual(twin, s)
            twin += "x = 0"
            self.assertEqual(len(s), 2)


class Texts(unittest.TestCase):
    def test_a_mistake_is_told_with_its_place(self):
        with self.assertRaises(fmb.ParseError) as caught:
            System("x >= 1\ny <= <= 3")
        self.assertEqual((caught.exception.line, caught.exception.column), (2, 6))

    def test_every_format_comes_back(self):
        s = System("x + 2y <= 3; x >= -1; y >= -2")
        for name in ("fmb", "ine", "smt2", "mps", "lp"):
            back = System.parse(s.to_text(name), name)
            self.assertTrue(fmb.Polyhedron(s) == fmb.Polyhedron(back), name)

    def test_files_are_read_by_their_names(self):
        s = System("x + 2y <= 3; x > 1/7")
        with tempfile.TemporaryDirectory() as folder:
            for ending in ("fmb", "smt2", "txt"):
                path = os.path.join(folder, "s." + ending)
                s.write(path)
                self.assertEqual(System.read(path), s)
            with self.assertRaises(FileNotFoundError):
                System.read(os.path.join(folder, "none.ine"))
            with open(path, "w", encoding="ascii") as out:
                out.write("x >=\n")
            with self.assertRaisesRegex(fmb.ParseError, "s.txt:1:"):
                System.read(path)

    def test_words_that_are_no_formats(self):
        with self.assertRaisesRegex(fmb.ArgumentError, "no format"):
            System.parse("x >= 1", "word")


try:
    import numpy as np
    import scipy.sparse
except ImportError:
    np = None


@unittest.skipIf(np is None, "NumPy and SciPy are not there")
class Arrays(unittest.TestCase):
    def test_dense_sparse_and_lists_are_the_same(self):
        A = np.array([[1.0, 0.5], [0, -2]])
        b = np.array([3.0, 4.0])
        dense = System.from_arrays(A, b, ["<", ">="])
        self.assertEqual(dense, System.from_arrays(scipy.sparse.csr_array(A), b, ["<", ">="]))
        self.assertEqual(dense, System.from_arrays(scipy.sparse.coo_array(A), b, ["<", ">="]))
        self.assertEqual(dense, System.from_arrays(A.tolist(), b.tolist(), ["<", ">="]))
        self.assertEqual(dense, System.from_arrays(np.asfortranarray(A), b, ["<", ">="]))

    def test_integers_stay_whole(self):
        big = 2 ** 62 + 1
        s = System.from_arrays(np.array([[big]]), np.array([1]))
        self.assertEqual(s[0].coefficients["x1"], big)

    def test_fractions_in_lists(self):
        s = System.from_arrays([[Q(1, 3), 0]], [Q(1, 7)], names=["p", "q"])
        self.assertEqual(s[0].coefficients, {"p": Q(1, 3)})
        self.assertEqual(s.names, ("p", "q"))

    def test_arrays_come_back(self):
        A, relations, b = System("x - 2y <= 3; y = 1").to_arrays()
        self.assertEqual(A.tolist(), [[1, -2], [0, 1]])
        self.assertEqual((relations, b.tolist()), (["<=", "="], [3, 1]))
        A, relations, b = System("x - 2y <= 3; y = 1").to_sparse()
        self.assertEqual(A.toarray().tolist(), [[1, -2], [0, 1]])

    def test_empty_ones(self):
        s = System.from_arrays(np.zeros((0, 3)), np.zeros(0))
        self.assertEqual((len(s), s.dim), (0, 3))
        A, relations, b = s.to_arrays()
        self.assertEqual((A.shape, relations, len(b)), ((0, 3), [], 0))

    def test_shapes_that_do_not_fit(self):
        for A, b in (([[1, 2]], [1, 2]), ([[1, 2], [1]], [1, 2]), (np.zeros(3), [0] * 3)):
            with self.assertRaises(fmb.ArgumentError):
                System.from_arrays(A, b)
        with self.assertRaisesRegex(fmb.ArgumentError, "x1 is nan|nan"):
            System.from_arrays(np.array([[float("nan")]]), np.array([1.0]))


if __name__ == "__main__":
    unittest.main()
