# SPDX-License-Identifier: Apache-2.0
"""Tools on a picker, without arrays: matrices, rectangles, snapping, clip planes, sensors, weights of corners."""

import math
import unittest

import abut
from abut import c


@unittest.skipIf(c.picking is None, "libabut_picking is not installed")
class PickingTools(unittest.TestCase):
    def setUp(self):
        self.universe = abut.Universe()
        self.addCleanup(self.universe.close)
        self.box = self.universe.add_geometry(self.universe.add_part(), abut.Shape.box(1, 1, 1))
        self.picker = abut.Picker(self.universe)
        self.ahead = abut.ray((-5, 0.5, 0), (1, 0, 0))

    def test_cameras_of_matrices(self):
        # Half a metre to each side of the axis, from 0.5 to 10.5 in front.
        parallel = [[2, 0, 0, 0.5], [0, 2, 0, 0], [0, 0, -0.2, -1.1], [0, 0, 0, 1]]
        view = abut.camera(matrix=parallel, width=100, height=100)
        self.assertEqual(view.projection, abut.PROJECTION_ORTHOGRAPHIC)
        self.assertAlmostEqual(view.vertical_extent, 1)
        along = abut.camera_ray(view, 75, 50)
        self.assertAlmostEqual(along.origin.x, 0)
        self.assertAlmostEqual(along.origin.z, -0.5)
        self.assertAlmostEqual(along.max_distance, 10)
        near, far = 0.1, 50
        perspective = [1, 0, 0, 0, 0, 2, 0, 0, 0, 0, far / (near - far), far * near / (near - far), 0, 0, -1, 0]
        view = abut.camera(matrix=perspective, depth=abut.CLIP_DEPTH_UNSIGNED, width=200, height=100)
        self.assertAlmostEqual(view.vertical_fov, 2 * math.atan(0.5))
        self.assertAlmostEqual(view.far_distance, far)
        with self.assertRaisesRegex(abut.Error, r"matrix\[3\] is 7; it must be 0"):
            abut.camera(matrix=[*perspective[:12], 7, *perspective[13:]])
        with self.assertRaisesRegex(ValueError, "matrix has 3 rows; it must have 4"):
            abut.camera(matrix=perspective[:12])

    def test_rectangles(self):
        view = abut.camera(eye=(0, -5, 0), target=(0, 0, 0))
        inside = self.picker.select_rectangle(view, 0, 0, 640, 480, abut.SELECTION_INSIDE)
        self.assertEqual([each.slot for each in inside], [self.box.slot])
        self.assertEqual(len(self.picker.select_rectangle(view, 320, 0, 640, 480, abut.SELECTION_INSIDE)), 0)
        self.assertEqual(len(self.picker.select_rectangle(view, 320, 0, 640, 480)), 1)
        self.assertEqual(len(self.picker.select_rectangle(view, 320, 0, 640, 480, ignore_geometry=self.box)), 0)
        with self.assertRaisesRegex(abut.Error, "x1 is nan"):
            self.picker.select_rectangle(view, 0, 0, math.nan, 1)

    def test_snapping(self):
        view = abut.camera(eye=(0, -5, 0), target=(0, 0, 0), projection=abut.PROJECTION_ORTHOGRAPHIC,
                           vertical_extent=48)
        found = self.picker.snap(view, 333, 230, 5)
        self.assertEqual(found.kind, abut.SNAP_VERTEX)
        self.assertAlmostEqual(found.pixels, 3)
        self.assertEqual((found.point.x, found.point.y, found.point.z), (1, -1, 1))
        self.assertEqual(self.picker.snap(view, 333, 236, 5, abut.SNAP_EDGE).kind, abut.SNAP_EDGE)
        self.assertEqual(self.picker.snap(view, 333, 236, 2).kind, 0)

    def test_clip_planes_and_back_faces(self):
        self.assertTrue(self.picker.ray_hits(self.ahead))
        self.assertEqual(list(self.picker.rays_hit([self.ahead, abut.ray((-5, 2, 0), (1, 0, 0))])), [1, 0])
        self.picker.set_clip_planes([abut.clip_plane((1, 0, 0)), abut.clip_plane((0, 0, 1), -9)])
        self.assertAlmostEqual(self.picker.cast_ray(self.ahead).distance, 6)
        with self.assertRaisesRegex(abut.Error, r"planes\[0\].normal"):
            self.picker.set_clip_planes([abut.clip_plane((0, 0, 0))])
        self.assertAlmostEqual(self.picker.cast_ray(self.ahead).distance, 6)
        self.picker.set_flags(abut.PICKER_SKIP_BACK_FACES)
        self.assertFalse(self.picker.ray_hits(self.ahead))
        self.picker.set_clip_planes()
        self.assertAlmostEqual(self.picker.cast_ray(self.ahead).distance, 4)

    def test_sensors(self):
        self.universe.change(self.box, flags=abut.GEOMETRY_SENSOR)
        self.assertFalse(self.picker.ray_hits(self.ahead))
        self.picker.set_flags(abut.PICKER_SENSORS)
        self.assertTrue(self.picker.ray_hits(self.ahead))

    def test_weights_of_corners(self):
        at = self.picker.barycentric(self.picker.cast_ray(self.ahead))
        self.assertAlmostEqual(sum(at.weights), 1)
        self.assertEqual(len(set(at.vertices)), 3)
        with self.assertRaisesRegex(abut.Error, "face is 99"):
            self.picker.barycentric(c.Pick(geometry=self.box, feature=c.Feature(c.FEATURE_FACE, 99)))


if __name__ == "__main__":
    unittest.main()
