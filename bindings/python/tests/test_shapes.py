# SPDX-License-Identifier: Apache-2.0
"""Shapes and queries of two of them, without arrays; errors."""

import array
import ctypes
import unittest

import abut


class Queries(unittest.TestCase):
    def test_two_boxes(self):
        with abut.Shape.box(1, 1, 1) as box:
            apart = abut.pair_distance(box, abut.pose(), box, abut.pose(3.5, 0, 0))
            self.assertAlmostEqual(apart.distance, 1.5, places=12)
            self.assertAlmostEqual(apart.normal.x, 1.0, places=12)
            touching = abut.pair_contacts(box, abut.pose(), box, abut.pose(0, 0, 1.75))
            self.assertEqual(len(touching), 4)
            for contact in touching:
                self.assertAlmostEqual(contact.distance, -0.25, places=12)
                self.assertAlmostEqual(contact.normal.z, 1.0, places=12)
            many = abut.pairs_distance(box, [abut.pose()] * 3, box, [abut.pose(3 + i, 0, 0) for i in range(3)])
            self.assertEqual([round(each.distance, 9) for each in many], [1.0, 2.0, 3.0])
            self.assertEqual(len(abut.pair_contacts(box, abut.pose(), box, abut.pose(0, 0, 1.75), max_contacts=1)), 1)

    def test_whether_two_overlap(self):
        box, ball, here = abut.Shape.box(1, 1, 1), abut.Shape.sphere(1), abut.pose()
        self.assertIs(abut.pair_overlaps(box, here, ball, abut.pose(1.5, 0, 0)), True)
        self.assertIs(abut.pair_overlaps(box, here, ball, abut.pose(2.5, 0, 0)), False)
        self.assertIs(abut.pair_overlaps(box, here, ball, abut.pose(2.5, 0, 0), margin=0.5), True)
        there = [abut.pose(1.5, 0, 0), abut.pose(2.5, 0, 0), abut.pose(1.9, 1.9, 0)]
        self.assertEqual(abut.pairs_overlap(box, here, ball, there).tolist(), [1, 0, 0])
        self.assertEqual(abut.pairs_overlap([box, ball, box], here, [ball, box, box], there).tolist(), [1, 0, 1])
        self.assertEqual(abut.pairs_overlap(box, here, ball, []).tolist(), [])
        with self.assertRaisesRegex(ValueError, "b has 2 and poses_b has 3"):
            abut.pairs_overlap(box, here, [ball, box], there)
        with self.assertRaisesRegex(TypeError, "a is of type str"):
            abut.pairs_overlap(["box"], here, ball, there)

    def test_memories_of_pairs_change_no_answer(self):
        corners = [x for i in range(8) for x in ((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5)]
        with abut.Shape.hull(corners) as cube:
            memory = abut.PairMemory()
            for step in range(3):
                there = abut.pose(2 + step, 0, 0)
                found = abut.pair_distance(cube, abut.pose(), cube, there, memory=memory)
                self.assertAlmostEqual(found.distance, 1 + step, places=12)
                self.assertEqual(len(abut.pair_contacts(cube, abut.pose(), cube, there, memory=memory)), 0)
            self.assertNotEqual(bytes(memory), bytes(64))
            self.assertEqual(len(abut.pair_contacts(cube, abut.pose(), cube, abut.pose(0.9, 0, 0), memory=memory)), 4)
            memories = (abut.PairMemory * 2)()
            many = abut.pairs_distance(cube, [abut.pose()] * 2, cube, [abut.pose(3, 0, 0), abut.pose(4, 0, 0)], memories)
            self.assertEqual([round(each.distance, 9) for each in many], [2.0, 3.0])

    def test_records_are_checked(self):
        with abut.Shape.sphere(1) as ball:
            contact, = abut.pair_contacts(ball, abut.pose(), ball, abut.pose(1, 0, 0))
        abut.validate_contact(contact)
        contact.toi = 2
        with self.assertRaisesRegex(abut.Error, "contact.toi is 2"):
            abut.validate_contact(contact)

    def test_arrays_of_a_wrong_count_are_refused(self):
        ball, here = abut.Shape.sphere(1), abut.pose()
        universe = abut.Universe()
        for name, call in {
            "xyz has 4 numbers": lambda: abut.Shape.hull([1, 2, 3, 4]),
            "xyz has 5 numbers": lambda: abut.Shape.particles([1, 2, 3, 4, 5], 1),
            "xyz has 7 numbers": lambda: abut.Shape.mesh(array.array("d", range(7)), [0, 1, 1]),
            "triangles has 2 numbers": lambda: abut.Shape.mesh(range(9), [0, 1]),
            "heights has 3 numbers": lambda: abut.Shape.height_field(2, 2, [0, 0, 0]),
            "normal has 2 numbers": lambda: abut.Shape.plane([0, 1], 0),
            "orientation has 3 numbers": lambda: abut.pose(orientation=(1, 0, 0)),
            "direction has 2 numbers": lambda: abut.ray((0, 0, 0), (1, 0)),
            "displacement_a has 1 numbers": lambda: abut.pair_cast(ball, here, [1], ball, here),
            "children has 2 and poses has 1": lambda: abut.Shape.composite([ball, ball], [here]),
            "poses_a has 1 and poses_b has 2": lambda: abut.pairs_distance(ball, [here], ball, [here] * 2),
            "shapes has 1 and poses has 0": lambda: universe.overlaps_of_each([ball], []),
            "point has 2 numbers": lambda: universe.at_point([0, 0]),
        }.items():
            with self.assertRaisesRegex(ValueError, name):
                call()

    def test_grids_of_cells(self):
        points, triangles = [(0, 0, 0), (4, 0, 0), (4, 4, 1), (0, 4, 1)], [(0, 1, 2), (0, 2, 3)]
        grid = abut.Shape.uv_grid(points, triangles, sides=abut.SIDES_FRONT, axis_v=abut.AXIS_Y, cells_u=3, cells_v=3)
        self.assertEqual(list(grid.parameters.values()), [1, 0, 1, 3, 3])
        self.assertEqual(grid.cast_ray(abut.pose(), abut.ray((1, 2, 5), (0, 0, -1))).distance, 4.5)
        with self.assertRaisesRegex(abut.Error, "axis_v is 0"):
            abut.Shape.uv_grid(points, triangles, axis_v=abut.AXIS_X)

    def test_holes_of_height_fields(self):
        heights = [0.0] * 9
        heights[4] = float("nan")
        field = abut.Shape.height_field(3, 3, heights, diagonal=abut.DIAGONAL_FALLING)
        self.assertIsNone(field.cast_ray(abut.pose(), abut.ray((0.75, 0.75, 5), (0, 0, -1))))
        self.assertEqual(field.cast_ray(abut.pose(), abut.ray((0.25, 0.25, 5), (0, 0, -1))).distance, 5)

    def test_distance_fields(self):
        values = [[[1, 1, 1], [1, -0.5, 1], [1, 1, 1]] if layer == 1 else [[1] * 3] * 3 for layer in range(3)]
        field = abut.Shape.distance_field(values, 0.5, (-0.5, -0.5, -0.5))
        self.assertEqual(field.kind, "distance_field")
        self.assertEqual(field.parameters["spacing_y"], 0.5)
        down = abut.ray((0, 0, 5), (0, 0, -1))
        self.assertAlmostEqual(field.cast_ray(abut.pose(), down).distance, 5 - 0.5 / 3)
        container = abut.Shape.distance_field(values, (0.5, 0.5, 0.5), (-0.5, -0.5, -0.5), is_inside_out=True)
        self.assertLess(container.cast_ray(abut.pose(), down).normal.z, 0)
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
        solid = abut.Shape.distance_field_from_mesh(corners, faces, spacing=0.05)
        self.assertAlmostEqual(solid.distance_field_report().error, 0.025 * 3 ** 0.5, places=6)
        self.assertAlmostEqual(solid.cast_ray(abut.pose(), abut.ray((0.2, 0.2, -5), (0, 0, 1))).distance, 5, places=3)
        with self.assertRaisesRegex(ValueError, "values has shape"):
            abut.Shape.distance_field(memoryview(bytes(8)))
        universe = abut.Universe()
        part = universe.add_part(motion=abut.MOTION_STATIC)
        geometry = universe.add_geometry(part, field)
        universe.set_field_values(geometry, 1, 1, 1, [[[0.25]]])
        with self.assertRaisesRegex(abut.Error, "layer is 4"):
            universe.set_field_values(geometry, 1, 1, 4, [[[0.25]]])

    def test_shapes(self):
        capsule = abut.Shape.capsule(0.5, 2)
        self.assertEqual(capsule.kind, "capsule")
        self.assertEqual(list(capsule.parameters.values()), [0.5, 2.0])
        self.assertAlmostEqual(capsule.aabb(abut.pose(0, 0, 1)).maximum.z, 3.5)
        points = array.array("d", [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0])
        mesh = abut.Shape.mesh(points, [0, 1, 2, 0, 2, 3], sides=abut.SIDES_FRONT)
        xyz, indices = mesh.triangles()
        self.assertEqual(list(xyz), list(points))
        self.assertEqual(list(indices), [0, 1, 2, 0, 2, 3])
        hit = mesh.cast_ray(abut.pose(), abut.ray((0.5, 0, 2), (0, 0, -1)))
        self.assertAlmostEqual(hit.distance, 2.0)
        self.assertIsNone(mesh.cast_ray(abut.pose(), abut.ray((5, 0, 2), (0, 0, -1))))
        self.assertEqual(abut.Shape.hull(points).kind, "hull")
        self.assertEqual(abut.Shape.hull(points).hull_report().vertex_count, 4)
        self.assertEqual(abut.Shape.plane((0, 0, 2), 1).kind, "plane")
        self.assertEqual(abut.Shape.height_field(2, 2, [0, 0, 0, 1]).kind, "height_field")
        self.assertEqual(abut.Shape.of_kind("sphere", [2.0]).parameters, {"radius": 2.0})
        triangle = abut.Shape.triangle((0, 0, 0), (1, 0, 0), (0, 1, 0))
        for shape in (abut.Shape.cone(1, 2), abut.Shape.ellipsoid(1, 2, 3), abut.Shape.point(), abut.Shape.segment(1), triangle):
            self.assertIn(shape.kind, abut.shape_kinds())
        plate = abut.Shape.box(2, 2, 1)
        for hole in (abut.Shape.cylinder_hole(1, 1, abut.OPEN_TOP | abut.OPEN_BOTTOM),
                     abut.Shape.box_hole(1, 1, 1, abut.OPEN_Z_HIGH | abut.OPEN_Z_LOW)):
            drilled = abut.Shape.composite([plate, hole], [abut.pose()] * 2)
            self.assertIsNone(drilled.cast_ray(abut.pose(), abut.ray((0, 0, 5), (0, 0, -1))))
            self.assertEqual(drilled.cast_ray(abut.pose(), abut.ray((1.5, 0, 5), (0, 0, -1))).distance, 4)
        self.assertEqual(abut.Shape.sphere_hole(2).kind, "sphere_hole")
        balls = abut.Shape.particles([(0, 0, 0), (5, 0, 0)], [1, 2])
        for x, distance in ((0, 8), (5, 7)):
            self.assertEqual(balls.cast_ray(abut.pose(), abut.ray((x, 0, 9), (0, 0, -1))).distance, distance)
        with self.assertRaisesRegex(ValueError, "xyz has 2 and radius has 1"):
            abut.Shape.particles([(0, 0, 0), (5, 0, 0)], [1])
        self.assertEqual(list(triangle.parameters.values()), [0, 0, 0, 1, 0, 0, 0, 1, 0])
        self.assertEqual(repr(capsule), "<Shape capsule radius=0.5 half_height=2>")
        self.assertEqual(repr(mesh), "<Shape mesh sides=1 vertices=4 triangles=2>")
        self.assertEqual(repr(abut.Shape.hull(points)), "<Shape hull vertices=4 faces=2>")
        self.assertFalse(abut.pair_support("plane", "plane"))
        self.assertTrue(abut.pair_support("plane", "box", abut.QUERY_DISTANCE))

    def test_a_time_budget_takes_a_route(self):
        abut.load_routes("# abut routes 1\ndistance cone cylinder auto 0 1e-06 1e-09\n"
                         "distance cone cylinder auto 0.01 2e-07 0.01\n")
        try:
            routes = abut.pair_routes("cylinder", "cone", time_budget=5e-7)
            self.assertEqual([bool(route.flags & abut.ROUTE_CHOSEN) for route in routes], [False, True])
            self.assertEqual([route.error_bound for route in routes], [0, 0.01])
            cone, cylinder = abut.Shape.cone(1, 1), abut.Shape.cylinder(1, 1)
            asked = (cone, abut.pose(), cylinder, abut.pose(0.5, 1, 4))
            self.assertEqual(abut.pair_distance(*asked, time_budget=5e-7).upper,
                             abut.pair_distance(*asked, error_bound=0.01).upper)
            with self.assertRaisesRegex(abut.Error, "text: line 1 is 'none'"):
                abut.load_routes("none")
        finally:
            abut.load_routes()
        self.assertGreater(len(abut.pair_routes("box", "box", abut.QUERY_CONTACTS)), 0)

    def test_composites_tell_their_children(self):
        drilled = abut.Shape.composite([abut.Shape.box(1, 1, 1), abut.Shape.sphere_hole(0.5)],
                                       [abut.pose(0, 0, 2), abut.pose()])
        whole = abut.Shape.composite([abut.Shape.sphere(1), drilled], [abut.pose(3, 0, 0), abut.pose()], [4, 6])
        children = whole.children()
        self.assertEqual([shape.kind for shape, _ in children], ["sphere", "box", "sphere_hole"])
        self.assertEqual([child.material for _, child in children], [4, 6, 6])
        self.assertEqual([child.is_hole for _, child in children], [0, 0, 1])
        self.assertEqual((children[2][1].cut_begin, children[2][1].cut_end), (1, 3))
        self.assertEqual(children[1][1].pose.position.z, 2)
        with self.assertRaisesRegex(abut.Error, "shape is a sphere"):
            abut.Shape.sphere(1).children()

    def test_failures_are_logged(self):
        told = []
        abut.set_log(lambda level, message: told.append((level, message)))
        with self.assertRaises(abut.Error):
            abut.Shape.sphere(-1)
        abut.set_log(None)
        with self.assertRaises(abut.Error):
            abut.Shape.sphere(-2)
        (level, message), = told
        self.assertEqual(level, abut.LOG_WARNING)
        self.assertIn("radius is -1", message)

    def test_parameters_of_kinds(self):
        self.assertEqual(abut.shape_parameters("capsule"), ["radius", "half_height"])
        self.assertEqual(abut.shape_parameters("point"), [])

    def test_arguments_of_other_libraries_are_named(self):
        for expected, call in {
            "cylinder has no argument height; give half_height, which is half of it":
                lambda: abut.Shape.cylinder(radius=1, height=2),
            "capsule has no argument length; give half_height": lambda: abut.Shape.capsule(1, length=2),
            "cone has no argument lz; give half_height": lambda: abut.Shape.cone(1, lz=2),
            "box has no argument extents; give half_x, half_y and half_z, which are half of it":
                lambda: abut.Shape.box(extents=(1, 2, 3)),
            "box has no argument half_extents; give half_x, half_y and half_z one by one":
                lambda: abut.Shape.box(half_extents=(1, 2, 3)),
            "sphere has no argument diameter; give radius, which is half of it": lambda: abut.Shape.sphere(diameter=1),
            "segment has no argument length; give half_length, which is half of it":
                lambda: abut.Shape.segment(length=1),
            "unexpected keyword argument 'colour'": lambda: abut.Shape.sphere(1, colour=2),
        }.items():
            with self.subTest(expected), self.assertRaisesRegex(TypeError, expected):
                call()
        self.assertEqual(abut.Shape.box.__name__, "box")

    def test_errors(self):
        closed = abut.Shape.sphere(1)
        with self.assertRaises(abut.Error) as caught:
            abut.Shape.sphere(-2.5)
        self.assertEqual(caught.exception.status, abut.OUT_OF_RANGE)
        self.assertEqual(caught.exception.name, "ABUT_OUT_OF_RANGE")
        self.assertIn("radius", caught.exception.message)
        self.assertIn("-2.5", str(caught.exception))
        for expected, call in {
            "UniverseOptions has no field broad_phase; it has broadphase": lambda: abut.Universe(broad_phase=1),
            "radius is 'big'; it must be a number": lambda: abut.Shape.sphere("big"),
            "b is of type Pose; it must be a Shape": lambda: abut.pair_distance(closed, abut.pose(), abut.pose(), abut.pose()),
            "name is of type int; it must be a str": lambda: abut.has_feature(1),
            "along is of type int; it must be a Ray": lambda: closed.cast_ray(abut.pose(), 1),
        }.items():
            with self.subTest(expected), self.assertRaisesRegex(TypeError, expected):
                call()
        for expected, call in {
            r"threads is -1; it must be in \[0, 4294967295\]": lambda: abut.Universe(threads=-1),
            "name is 'ball'; the kinds of shape are sphere": lambda: abut.Shape.of_kind("ball"),
            "indices has the number -1": lambda: abut.Shape.of_kind("mesh", [0], [0] * 9, [0, 1, -1]),
        }.items():
            with self.subTest(expected), self.assertRaisesRegex(ValueError, expected):
                call()
        with self.assertRaisesRegex(ctypes.ArgumentError, "-1 is not in"):
            abut.Universe().set_policy(-1, 0)
        closed.close()
        with self.assertRaises(ValueError):
            closed.aabb(abut.pose())


if __name__ == "__main__":
    unittest.main()
