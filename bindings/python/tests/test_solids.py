# SPDX-License-Identifier: Apache-2.0
"""Solid meshes and height fields: what is inside is pushed out."""

import unittest

import abut

BOX = [(x, y, z) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
FACES = [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
         (1, 3, 7), (1, 7, 5)]


class Solids(unittest.TestCase):
    def test_ball_inside_a_solid_mesh_is_inside(self):
        corners, faces = [n for p in BOX for n in p], [n for f in FACES for n in f]
        ball = abut.Shape.sphere(0.25)
        for sides, expected in (("both", 0.15), ("solid", -0.65)):
            found = abut.pair_distance(abut.Shape.mesh(corners, faces, sides=sides), abut.pose(), ball, abut.pose(0.6, 0, 0))
            self.assertAlmostEqual(found.distance, expected, 12)

    def test_unknown_sides_are_named(self):
        with self.assertRaisesRegex(ValueError, "sides is 'inside'; it must be one of both, front, solid"):
            abut.Shape.mesh([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2], sides="inside")

    def test_ball_below_a_solid_field_is_pushed_up(self):
        ball = abut.Shape.sphere(0.25)
        for solid_below, expected in ((False, 0.75), (True, -1.25)):
            field = abut.Shape.height_field(5, 5, [0] * 25, solid_below=solid_below)
            found = abut.pair_distance(field, abut.pose(), ball, abut.pose(2, 2, -1))
            self.assertAlmostEqual(found.distance, expected, 12)


if __name__ == "__main__":
    unittest.main()
