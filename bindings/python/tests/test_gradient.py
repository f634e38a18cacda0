# SPDX-License-Identifier: Apache-2.0
"""The gradient of distances against differences of distances. Needs NumPy."""

import math
import unittest

try:
    import numpy
    from numpy.testing import assert_allclose, assert_array_equal
except ImportError:
    raise unittest.SkipTest("NumPy is not installed") from None

import abut

STEP = 1e-5


def turned(pose, turn):
    """A pose after a small turn around axes of the world through its position."""
    angle = numpy.linalg.norm(turn)
    x, y, z = turn * (math.sin(angle / 2) / angle)
    w, a, b, c = math.cos(angle / 2), *pose[4:]
    s = pose[3]
    return numpy.concatenate([pose[:3], [w * s - x * a - y * b - z * c, w * a + x * s + y * c - z * b,
                                         w * b - x * c + y * s + z * a, w * c + x * b - y * a + z * s]])


def moved(pose, axis, by):
    if axis < 3:
        return pose + by * numpy.eye(7)[axis]
    return turned(pose, by * numpy.eye(3)[axis - 3])


def by_differences(a, pose_a, b, pose_b):
    """Central differences of the distance, by the six movements of either pose."""
    rows = []
    for side in range(2):
        for axis in range(6):
            ends = []
            for by in (STEP, -STEP):
                poses = [pose_a, pose_b]
                poses[side] = moved(poses[side], axis, by)
                ends.append(abut.pair_distance(a, poses[0], b, poses[1]).distance)
            rows.append((ends[0] - ends[1]) / (2 * STEP))
    return numpy.array(rows[:6]), numpy.array(rows[6:])


class Gradient(unittest.TestCase):
    def setUp(self):
        self.seed = int.from_bytes(numpy.random.bytes(4), "little")
        self.random = numpy.random.default_rng(self.seed)

    def poses(self, spread, count=20):
        turns = self.random.normal(size=(count, 4))
        turns /= numpy.linalg.norm(turns, axis=1, keepdims=True)
        return numpy.concatenate([self.random.normal(size=(count, 3)) * spread, turns], axis=1)

    def check(self, a, b, spread):
        poses_a, poses_b = self.poses(spread), self.poses(spread)
        found = abut.pairs_distance(a, poses_a, b, poses_b)
        rows_a, rows_b = abut.distance_gradient(found, poses_a, poses_b)
        self.assertEqual((rows_a.shape, rows_b.shape), ((20, 6), (20, 6)))
        misses = []
        for i, (pose_a, pose_b) in enumerate(zip(poses_a, poses_b)):
            expected = numpy.concatenate(by_differences(a, pose_a, b, pose_b))
            misses.append(numpy.abs(numpy.concatenate([rows_a[i], rows_b[i]]) - expected).max())
        # Where the closest features change within the step, differences are of two of them: rare, so most must agree.
        self.assertLess(numpy.sort(misses)[-3], 1e-4, f"seed {self.seed}: {a}, {b}")
        return found.distance

    def test_apart(self):
        for a, b in ((abut.Shape.box(0.3, 0.5, 0.7), abut.Shape.capsule(0.2, 0.6)),
                     (abut.Shape.ellipsoid(0.3, 0.5, 0.4), abut.Shape.box(0.3, 0.2, 0.4)),
                     (abut.Shape.hull(self.random.normal(size=(20, 3)) * 0.4), abut.Shape.sphere(0.3))):
            self.assertGreater((self.check(a, b, 3.0) > 0).sum(), 10)

    def test_overlapping(self):
        box, ball = abut.Shape.box(0.9, 1.0, 1.1), abut.Shape.ellipsoid(0.9, 0.8, 0.7)
        self.assertGreater((self.check(box, ball, 0.3) < 0).sum(), 10)

    def test_one_contacts_and_one_pose_for_all(self):
        box, ball = abut.Shape.box(1, 1, 1), abut.Shape.sphere(0.5)
        here, there = abut.pose(), abut.pose(2, 0.5, 0)
        rows = abut.distance_gradient(abut.pair_distance(box, here, ball, there), here, there)
        assert_allclose(rows, [[-1, 0, 0, 0, 0, 0.5], [1, 0, 0, 0, 0, 0]], atol=1e-12)
        places = abut.poses([(2, 0.5, 0), (0, 0, 4)])
        found = abut.pairs_distance(box, here, ball, places)
        assert_array_equal(abut.distance_gradient(found, here, places)[0][0], rows[0])
        contacts = abut.pair_contacts(box, here, box, abut.pose(1.9, 0, 0))
        at_contacts = abut.distance_gradient(contacts, here, abut.pose(1.9, 0, 0))[1]
        assert_allclose(at_contacts[:, :3], [[1, 0, 0]] * len(contacts), atol=1e-12)

    def test_what_is_wrong_is_said(self):
        box = abut.Shape.box(1, 1, 1)
        found = abut.pairs_distance(box, abut.pose(), box, abut.poses([(3, 0, 0), (4, 0, 0)]))
        with self.assertRaisesRegex(ValueError, "found has 2 and poses_b has 3"):
            abut.distance_gradient(found, abut.pose(), [abut.pose()] * 3)
        with self.assertRaisesRegex(TypeError, "found is of type float; it must be a Distance"):
            abut.distance_gradient(1.0, abut.pose(), abut.pose())


if __name__ == "__main__":
    unittest.main()
