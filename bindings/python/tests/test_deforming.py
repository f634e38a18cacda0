# SPDX-License-Identifier: Apache-2.0
"""Vertices on straight lines, from lists and from arrays."""

import unittest

import abut

try:
    import numpy
except ImportError:
    numpy = None

OVER = [0.25, 0.25, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0]
BELOW = [0.25, 0.25, -1, 0, 0, 0, 1, 0, 0, 0, 1, 0]


class Deforming(unittest.TestCase):
    def test_tells_the_first_touch(self):
        touch = abut.vertices_touch_faces(OVER, BELOW)[0]
        self.assertEqual(touch.touches, 1)
        self.assertAlmostEqual(touch.upper, 0.5)
        self.assertEqual(abut.vertices_touch_faces(OVER, OVER)[0].touches, 0)
        self.assertEqual(abut.edges_touch_edges(OVER + BELOW, OVER + BELOW)[1].touches,
                         abut.edges_touch_edges(BELOW, BELOW)[0].touches)

    def test_takes_a_separation(self):
        self.assertAlmostEqual(abut.vertices_touch_faces(OVER, BELOW, 0.5)[0].upper, 0.25, 6)

    @unittest.skipIf(numpy is None, "NumPy is not there")
    def test_takes_arrays(self):
        over, below = (numpy.array([values] * 3, dtype="f4").reshape(3, 4, 3) for values in (OVER, BELOW))
        self.assertEqual(abut.vertices_touch_faces(over, below).touches.tolist(), [1, 1, 1])

    def test_refuses_what_does_not_belong_together(self):
        with self.assertRaisesRegex(ValueError, "start has 1 and end has 2"):
            abut.vertices_touch_faces(OVER, BELOW + BELOW)
        with self.assertRaisesRegex(ValueError, "start has 11 numbers"):
            abut.vertices_touch_faces(OVER[:11], BELOW)

    def test_corners_given_twice_make_edges_and_points(self):
        edge, point = [(-1, 0, 0), (1, 0, 0), (1, 0, 0)], [(0, 0, 0)] * 3
        for face, x, touches in ((edge, 0.5, 1), (edge, 1.5, 0), (point, 0, 1), (point, 0.1, 0)):
            first, = abut.vertices_touch_faces([[(x, 0, 1), *face]], [[(x, 0, -1), *face]])
            self.assertEqual(first.touches, touches, (face, x))
            if touches:
                self.assertAlmostEqual(first.lower, 0.5)


if __name__ == "__main__":
    unittest.main()
