# SPDX-License-Identifier: Apache-2.0
"""Poses from matrices and from rotations of SciPy, without NumPy where there is one of them."""

import math
import random
import unittest

import abut

try:
    import numpy
    from numpy.testing import assert_allclose, assert_array_equal
except ImportError:
    numpy = None

QUARTER = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
SEED = random.SystemRandom().getrandbits(32)


def rotated(quaternion, point):
    """A point turned, by the product of quaternions."""
    def product(p, q):
        (a, b, c, d), (e, f, g, h) = p, q
        return (a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f,
                a * h + b * g - c * f + d * e)
    w, x, y, z = quaternion
    return product(product(quaternion, (0, *point)), (w, -x, -y, -z))[1:]


def random_quaternion(source):
    numbers = [source.gauss(0, 1) for _ in range(4)]
    if source.random() < 0.3:  # half turns, where the scalar vanishes
        numbers[source.randrange(4)] = 0.0
        numbers[0] = 0.0 if source.random() < 0.5 else numbers[0]
    length = math.sqrt(sum(number * number for number in numbers))
    return [number / length for number in numbers]


def matrix_of(quaternion):
    columns = [rotated(quaternion, axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    return [list(row) for row in zip(*columns)]


class Rotation:
    """As those of SciPy: the scalar is last."""

    def __init__(self, numbers):
        self.numbers = numbers

    def as_quat(self):
        return self.numbers


class OnePose(unittest.TestCase):
    def test_matrices_of_any_turn(self):
        source = random.Random(SEED)
        for _ in range(200):
            quaternion = random_quaternion(source)
            rows = matrix_of(quaternion)
            found = [*abut.pose(1, 2, 3, rows).orientation]
            same = sum(a * b for a, b in zip(found, quaternion))
            self.assertAlmostEqual(abs(same), 1, places=14, msg=f"seed {SEED}: {quaternion}")
            for row, other in zip(matrix_of(found), rows):
                for a, b in zip(row, other):
                    self.assertAlmostEqual(a, b, places=14, msg=f"seed {SEED}: {quaternion}")

    def test_homogeneous_matrices_are_poses(self):
        matrix = [[*row, moved] for row, moved in zip(QUARTER, (5, 6, 7))] + [[0, 0, 0, 1]]
        box = abut.Shape.box(1, 2, 3).aabb(matrix)
        self.assertEqual([round(number, 9) for number in box.maximum], [7, 7, 10])
        with abut.Universe() as universe:
            part = universe.add_part(pose=matrix)
            self.assertEqual([*universe.pose(part).position], [5, 6, 7])
            universe.set_pose(part, abut.pose(1, 2, 3))
            self.assertEqual([*universe.pose(part).position], [1, 2, 3])
            universe.set_poses([part, universe.add_part()], [matrix, abut.pose()])
            self.assertEqual([*universe.pose(part).position], [5, 6, 7])

    def test_rotations_of_scipy(self):
        self.assertEqual([*abut.pose(orientation=Rotation([0.6, 0, 0, 0.8])).orientation], [0.8, 0.6, 0, 0])

    def test_one_matrix_serves_for_many(self):
        found = abut.poses([(1, 2, 3), (4, 5, 6)], QUARTER)
        self.assertEqual([bytes(each.orientation) for each in found], [bytes(abut.pose(0, 0, 0, QUARTER).orientation)] * 2)

    def test_what_is_no_rotation_is_refused(self):
        shifted = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [5, 6, 7, 1]]
        scaled = [[2, 0, 0, 0], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]]
        ball = abut.Shape.sphere(1)
        for expected, call in {
            "orientation is no rotation: its rows are not of length 1": lambda: abut.pose(orientation=[[1, 0, 0]] * 3),
            "orientation is no rotation: it mirrors":
                lambda: abut.pose(orientation=[[1, 0, 0], [0, 1, 0], [0, 0, -1]]),
            "at is no rotation: .* Scale shapes, not poses": lambda: ball.aabb(scaled),
            r"pose_b has the last row \(5.0, 6.0, 7.0, 1.0\); .* The translation is the last column":
                lambda: abut.pair_distance(ball, abut.pose(), ball, shifted),
            "orientation is no rotation": lambda: abut.pose(orientation=[[float("nan")] * 3] * 3),
        }.items():
            with self.subTest(expected), self.assertRaisesRegex(ValueError, expected):
                call()


@unittest.skipUnless(numpy, "NumPy is not installed")
class ManyPoses(unittest.TestCase):
    def setUp(self):
        source = random.Random(SEED)
        self.quaternions = numpy.array([random_quaternion(source) for _ in range(300)])
        self.matrices = numpy.tile(numpy.eye(4), (300, 1, 1))
        self.matrices[:, :3, :3] = [matrix_of(each) for each in self.quaternions.tolist()]
        self.matrices[:, :3, 3] = numpy.random.default_rng(SEED).normal(size=(300, 3))

    def test_many_are_the_same_as_one_by_one(self):
        many = abut.poses(self.matrices[:, :3, 3], self.matrices[:, :3, :3])
        ball, box = abut.Shape.sphere(0.1), abut.Shape.box(1, 2, 3)
        by_matrix = abut.pairs_distance(box, self.matrices, ball, abut.pose(4, 0, 0))
        by_pose = abut.pairs_distance(box, many, ball, abut.pose(4, 0, 0))
        self.assertEqual(bytes(by_matrix.memory), bytes(by_pose.memory), f"seed {SEED}")
        listed = abut.poses(self.matrices[:, :3, 3].tolist(), self.matrices[:, :3, :3].tolist())
        self.assertEqual(bytes(listed.memory), bytes(many.memory), f"seed {SEED}")
        for i in range(0, 300, 7):
            single = abut.pose(*self.matrices[i, :3, 3], self.matrices[i, :3, :3])
            self.assertEqual(bytes(single), bytes(many[i]), f"seed {SEED}")

    def test_there_and_back(self):
        poses = abut.poses(self.matrices[:, :3, 3], self.quaternions)
        assert_allclose(abut.matrices(poses), self.matrices, atol=1e-14, err_msg=f"seed {SEED}")
        one = abut.matrices(poses[3])
        self.assertEqual(one.shape, (4, 4))
        assert_array_equal(one, abut.matrices(poses)[3])
        self.assertEqual(abut.matrices([]).shape, (0, 4, 4))

    def test_rotations_of_scipy(self):
        scalar_last = numpy.roll(self.quaternions, -1, axis=1)
        found = abut.poses(self.matrices[:, :3, 3], Rotation(scalar_last))
        assert_array_equal(found.array[:, 3:], self.quaternions)
        one = abut.poses(self.matrices[:, :3, 3], Rotation(scalar_last[0]))
        assert_array_equal(one.array[:, 3:], self.quaternions[:1].repeat(300, 0))
        with self.assertRaisesRegex(ValueError, "orientation has 300 numbers; it must have 4"):
            abut.pose(orientation=Rotation(scalar_last))

    def test_which_matrix_is_wrong(self):
        ball = abut.Shape.sphere(1)
        self.matrices[7, 3, 0] = 1
        with self.assertRaisesRegex(ValueError, r"poses_a has the last row \(1.0, .*\) in matrix 7"):
            abut.pairs_distance(ball, self.matrices, ball, abut.pose())
        with self.assertRaisesRegex(ValueError, "orientations is no rotation: it mirrors"):
            abut.poses([(0, 0, 0)], -self.matrices[:, :3, :3])
        with self.assertRaisesRegex(TypeError, "poses_a holds bool; it must hold numbers"):
            abut.pairs_distance(ball, self.matrices.astype(bool), ball, abut.pose())


if __name__ == "__main__":
    unittest.main()
