"""Frames and meshes from arrays."""

import os
import tempfile
import unittest

import fmb

try:
    import numpy as np
except ImportError as error:
    raise unittest.SkipTest("NumPy is not there") from error


def boxes(rng, n, dim):
    return fmb.Frames(rng.uniform(0, 10, (n, dim)), rng.uniform(-1, 1, (n, dim, dim)))


class Frames(unittest.TestCase):
    def setUp(self):
        self.rng = np.random.default_rng()

    def test_one_by_one_and_all_against_all_are_the_same(self):
        for dim in (2, 3, 4):
            some, others = boxes(self.rng, 40, dim), boxes(self.rng, 30, dim)
            pairs = np.stack(np.meshgrid(np.arange(40), np.arange(30), indexing="ij"), -1)
            tested = some.test(others, pairs.reshape(-1, 2))
            self.assertEqual(some.meet(others).tolist(), tested.pairs[tested.meets].tolist())

    def test_common_points_lie_in_their_box(self):
        some = boxes(self.rng, 60, 3)
        met = some.meet()
        answer = some.test(some, met, boxes=True, inside=True, times=True, witness=True)
        self.assertTrue(answer.meets.all())
        low, high = answer.world[..., 0], answer.world[..., 1]
        self.assertTrue((low <= answer.witness + 1e-9).all() and (answer.witness <= high + 1e-9).all())

    def test_floats_are_doubles(self):
        origin = self.rng.uniform(0, 5, (50, 2)).astype(np.float32)
        axes = self.rng.uniform(-1, 1, (50, 2, 2)).astype(np.float32)
        single = fmb.Frames(origin, axes, shape="simplex").meet()
        double = fmb.Frames(origin.astype(float), axes.astype(float), shape="simplex").meet()
        self.assertEqual(single.tolist(), double.tolist())

    def test_motion_and_contact(self):
        still = [[[1, 0], [0, 1]]] * 2
        apart = fmb.Frames([[0, 0], [3, 0]], still)
        self.assertEqual(len(apart.meet()), 0)
        moving = fmb.Frames([[0, 0], [3, 0]], still, [[0, 0], [-3, 0]])
        self.assertEqual(moving.meet().tolist(), [[0, 1]])
        times = moving.test(moving, [[0, 1]], times=True).time
        np.testing.assert_allclose(times, [[2 / 3, 1]])
        touching = fmb.Frames([[0, 0], [1, 0]], still)
        self.assertEqual(len(touching.meet()), 1)
        self.assertEqual(len(touching.meet(contact="open")), 0)

    def test_one_pair_exactly(self):
        a, b = fmb.cuboid([0, 0], [[1, 0], [0, 1]]), fmb.cuboid([4, 5], [[1, 0], [0, 1]])
        self.assertEqual(fmb.distance(a, b).square, 25)
        self.assertEqual(len(fmb.separate(a, b)), 1)
        self.assertEqual(fmb.common(a, b), [])
        self.assertIsNone(fmb.depth(a, b))
        c = fmb.simplex([0.5, 0.5], [[1, 0], [0, 1]])
        self.assertEqual(fmb.depth(a, c, norm="max").square, fmb.depth(a, c).square)
        self.assertIsNone(fmb.separate(a, c))

    def test_shapes_that_do_not_fit(self):
        for origin, axes in (([0, 0], [[1, 0]]), ([[0, 0]], [[[1, 0, 0]]]), ([[0, 0]], [])):
            with self.assertRaises(fmb.ArgumentError):
                fmb.Frames(origin, axes)
        with self.assertRaises(fmb.ArgumentError):
            fmb.Frames([[float("nan")]], [[[1.0]]])
        some = boxes(self.rng, 3, 2)
        with self.assertRaises(fmb.ArgumentError):
            some.test(some, [[0, 3]])
        with self.assertRaises(fmb.ArgumentError):
            some.test(some, shape="round")


class Meshes(unittest.TestCase):
    TENT = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [.2, .2, -1], [.2, .2, 1], [.9, .9, 1]]

    def test_hits(self):
        mesh = fmb.Mesh(self.TENT, [[0, 1, 2], [3, 4, 5]])
        self.assertEqual(mesh.meet().hits, [(0, 1, "cross")])
        self.assertEqual(len(mesh.meet(mesh.placed(move=(9, 0, 0)))), 0)
        self.assertEqual(len(mesh.meet(mesh.placed(move=(9, 0, 0)), motion=(-9, 0, 0))), 4)

    def test_arrays_are_not_copied_and_outlive_the_mesh(self):
        mesh = fmb.Mesh(self.TENT, [[0, 1, 2], [3, 4, 5]])
        points, cells = mesh.points, mesh.cells
        del mesh
        np.testing.assert_array_equal(points, self.TENT)
        np.testing.assert_array_equal(cells, [[0, 1, 2], [3, 4, 5]])
        with self.assertRaises(ValueError):
            points[0, 0] = 1

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "one.off")
            with open(path, "w", encoding="ascii") as out:
                out.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
            self.assertEqual(len(fmb.Mesh.read(path)), 1)
            with open(path, "w", encoding="ascii") as out:
                out.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 q\n")
            with self.assertRaisesRegex(fmb.ParseError, "one.off:"):
                fmb.Mesh.read(path)

    def test_groups(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "two.obj")
            with open(path, "w", encoding="utf-8") as out:
                out.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\ng Flügel\nf 1 3 2\n")
            self.assertEqual([fmb.Mesh.read(path).group(c) for c in range(3)], [None, "Flügel", None])

    def test_cells_that_are_none(self):
        for cells in ([[0, 1, 9]], [[0, 1]], [[-1, 0, 1]]):
            with self.assertRaises(fmb.ArgumentError):
                fmb.Mesh(self.TENT, cells)


if __name__ == "__main__":
    unittest.main()
