# SPDX-License-Identifier: Apache-2.0
"""Arrays at every door: what goes in, what comes out, and what is said about wrong ones. Needs NumPy."""

import copy
import pickle
import unittest
import unittest.mock

try:
    import numpy
    from numpy.testing import assert_allclose, assert_array_equal
except ImportError:
    raise unittest.SkipTest("NumPy is not installed") from None

import abut

HERE = (0, 0, 0, 1, 0, 0, 0)


def poses_along_x(*positions):
    out = numpy.zeros((len(positions), 7))
    out[:, 0], out[:, 3] = positions, 1
    return out


class Inputs(unittest.TestCase):
    def setUp(self):
        self.ball = abut.Shape.sphere(1)

    def distances(self, poses_a, poses_b):
        return abut.pairs_distance(self.ball, poses_a, self.ball, poses_b).distance.tolist()

    def test_poses_of_any_number_type_and_layout_are_read(self):
        there = poses_along_x(3, 4, 5)
        wide = numpy.zeros((6, 14), "f4")
        wide[::2, ::2] = there
        for poses in (there, there.astype("f4"), wide[::2, ::2], numpy.asfortranarray(there), there.tolist(),
                      there.astype(int), abut.poses(there[:, :3]), list(abut.poses(there[:, :3]))):
            self.assertEqual(self.distances(poses_along_x(0, 0, 0), poses), [1, 2, 3])

    def test_arrays_that_cannot_be_written_are_read(self):
        there = poses_along_x(3, 4)
        there.flags.writeable = False
        self.assertEqual(self.distances(there, there), [-2, -2])

    def test_one_pose_serves_for_many(self):
        there = poses_along_x(3, 4)
        for one in (abut.pose(), HERE, numpy.array(HERE), list(HERE)):
            self.assertEqual(self.distances(one, there), [1, 2])
            self.assertEqual(self.distances(there, one), [1, 2])

    def test_a_pose_of_numbers_serves_for_one_call(self):
        there = numpy.array([3, 0, 0, 1, 0, 0, 0], "f4")
        self.assertEqual(abut.pair_distance(self.ball, HERE, self.ball, there).distance, 1)
        self.assertEqual(self.ball.aabb(there).maximum.x, 4)

    def test_what_was_expected_is_said(self):
        ball, universe = self.ball, abut.Universe()
        three = numpy.zeros((3, 3))
        for expected, call in {
            r"xyz has shape \(4, 2\); it must be \(N, 3\)": lambda: abut.Shape.hull(numpy.zeros((4, 2))),
            r"xyz has shape \(4,\); it must be \(N, 3\)": lambda: abut.Shape.particles(numpy.zeros(4), 1),
            r"triangles has shape \(1, 5\)": lambda: abut.Shape.mesh(three, numpy.zeros((1, 5), int)),
            r"triangles has the number -1; it must be in \[0, 4294967295\]":
                lambda: abut.Shape.mesh(three, numpy.array([[0, 1, -1]])),
            r"poses_b has shape \(2, 3\); it must be \(N, 7\)":
                lambda: abut.pairs_distance(ball, HERE, ball, numpy.zeros((2, 3))),
            r"poses_b has shape \(3,\)": lambda: abut.pairs_distance(ball, HERE, ball, numpy.zeros(3)),
            "poses_a has 2 and poses_b has 3":
                lambda: abut.pairs_distance(ball, poses_along_x(0, 0), ball, poses_along_x(0, 0, 0)),
            r"pose_b has 3 numbers; it must have 7; abut.pose\(x, y, z\) makes one": lambda: abut.pair_distance(ball, HERE, ball, numpy.zeros(3)),
            r"points has shape \(2, 4\); it must be \(N, 3\)": lambda: universe.at_points(numpy.zeros((2, 4))),
            r"rays has shape \(2, 3\); it must be \(N, 6\)": lambda: universe.cast_rays(numpy.zeros((2, 3))),
            r"heights has shape \(2, 3\)": lambda: abut.Shape.height_field(2, 2, numpy.zeros((2, 3))),
            r"xyz has a row of 2 numbers; each must have 3": lambda: abut.Shape.hull([(0, 0)]),
            r"pairs has shape \(3,\); it must be \(N, 2\)": lambda: universe.detect_pairs(numpy.zeros(3)),
            "orientations has 2": lambda: abut.poses(three, numpy.zeros((2, 4))),
        }.items():
            with self.subTest(expected), self.assertRaisesRegex(ValueError, expected):
                call()
        for expected, call in {
            "xyz holds complex128; it must hold numbers": lambda: abut.Shape.hull(numpy.zeros((4, 3), complex)),
            "triangles holds float64; it must hold whole numbers": lambda: abut.Shape.mesh(three, numpy.zeros((1, 3))),
            "parts holds float64 of shape": lambda: universe.poses(numpy.zeros(3)),
            r"pose_b is of type NoneType; it must be a Pose; abut.pose\(x, y, z\)": lambda: abut.pair_distance(ball, HERE, ball, None),
            r"along is of type float; it must be a Ray; abut.ray\(origin, direction\)": lambda: universe.cast_ray(5.0),
            "a is of type str; it must be a Shape": lambda: abut.pairs_distance("ball", HERE, ball, HERE),
        }.items():
            with self.subTest(expected), self.assertRaisesRegex(TypeError, expected):
                call()

    def test_numbers_of_numpy_are_numbers(self):
        self.assertEqual(abut.Shape.sphere(numpy.float32(2)).parameters["radius"], 2)
        universe = abut.Universe(threads=numpy.int64(1), origin=numpy.zeros(3, "f4"))
        universe.set_policy(numpy.uint8(3), 1, period=numpy.int32(2))
        universe.step(numpy.float32(0.5))
        self.assertEqual(universe.policy(1, numpy.int16(3)).period, 2)

    def test_a_pose_that_is_not_finite_is_refused_and_named(self):
        there = poses_along_x(3, numpy.nan)
        with self.assertRaisesRegex(abut.Error, "ABUT_NOT_FINITE"):
            self.distances(HERE, there)

    def test_shapes_from_arrays(self):
        cube = numpy.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], "f4")
        self.assertEqual(abut.Shape.hull(cube).hull_report().vertex_count, 8)
        self.assertEqual(abut.Shape.particles(cube, 0.1).aabb().maximum.x, 1.1)
        mesh = abut.Shape.mesh(cube[:3], numpy.array([[0, 1, 2]], "i8"))
        assert_array_equal(numpy.reshape(mesh.triangles()[0], (-1, 3)), cube[:3])
        field = abut.Shape.height_field(heights=numpy.array([[0, 1, 2], [3, 4, 5]], "f4"))
        self.assertEqual((field.parameters["columns"], field.parameters["rows"]), (3, 2))
        self.assertEqual(field.aabb().maximum.z, 5)


class Answers(unittest.TestCase):
    def test_fields_are_columns_of_the_same_memory(self):
        ball = abut.Shape.sphere(1)
        found = abut.pairs_distance(ball, HERE, ball, poses_along_x(3, 5))
        assert_allclose(found.normal, [[1, 0, 0], [1, 0, 0]])
        self.assertEqual(found.distance[1], found[1].distance)
        found.distance[1] = 7
        self.assertEqual(found[1].distance, 7)
        self.assertEqual(found.array["distance"].tolist(), [1, 7])
        self.assertEqual(numpy.asarray(found)["point_a"].shape, (2, 3))
        self.assertEqual([len(found[1:]), found[1:].distance[0], len(found[found.distance > 2])], [1, 7, 1])
        with self.assertRaisesRegex(AttributeError, "Distance have no field 'depth'; they have distance, lower"):
            found.depth

    def test_no_records_have_empty_columns(self):
        ball = abut.Shape.sphere(1)
        none = abut.pair_contacts(ball, HERE, ball, abut.pose(9))
        self.assertEqual((none.distance.shape, none.normal.shape, none.array.shape, none.id.dtype.name),
                         ((0,), (0, 3), (0,), "uint64"))
        self.assertEqual(abut.pairs_distance(ball, HERE, ball, numpy.zeros((0, 7))).distance.shape, (0,))
        self.assertEqual(abut.Universe().borrow_contacts().normal.shape, (0, 3))

    def test_records_are_pickled(self):
        ball = abut.Shape.sphere(1)
        found = abut.pairs_distance(ball, HERE, ball, poses_along_x(3, 5))
        self.assertEqual(pickle.loads(pickle.dumps(found)).array.tobytes(), found.array.tobytes())
        self.assertEqual(copy.copy(found)[1].distance, 3)

    def test_an_earlier_answer_is_filled_again(self):
        ball = abut.Shape.sphere(1)
        found = abut.pairs_distance(ball, HERE, ball, poses_along_x(3, 5))
        self.assertIs(abut.pairs_distance(ball, HERE, ball, poses_along_x(4, 5), out=found), found)
        self.assertEqual(found.distance.tolist(), [2, 3])
        with self.assertRaisesRegex(ValueError, "it must be the answer for 1 distances"):
            abut.pairs_distance(ball, HERE, ball, HERE, out=found)

    def test_points_against_a_shape(self):
        points = numpy.array([[2, 0, 0], [0, 0, 0.5], [0, 3, 0]], "f4")
        found = abut.points_distance(abut.Shape.sphere(1), abut.pose(), points)
        assert_allclose(found.distance, [1, -0.5, 2])
        assert_allclose(found.normal[2], [0, 1, 0])

    def test_contacts_of_many_pairs_are_those_of_each(self):
        box = abut.Shape.box(1, 1, 1)
        found = abut.pairs_contacts(box, HERE, box, poses_along_x(*[1.9] * 20, 5, 2.5), margin=1)
        self.assertEqual(found.counts.tolist(), [4] * 20 + [0, 4])
        alone = abut.pair_contacts(box, HERE, box, abut.pose(2.5), margin=1)
        self.assertEqual([bytes(contact) for contact in found[21]], [bytes(contact) for contact in alone])
        turned = [0, 0, 1.9, numpy.cos(numpy.pi / 8), 0, 0, numpy.sin(numpy.pi / 8)]
        self.assertEqual(abut.pairs_contacts(box, HERE, box, [turned] * 20, max_contacts=0).counts.tolist(), [8] * 20)

    def test_contacts_of_many_pairs_take_any_arrays(self):
        box = abut.Shape.box(1, 1, 1)
        wide = numpy.zeros((6, 14))
        wide[:, ::2] = [1.5, 0, 0, 1, 0, 0, 0]
        memories = abut.pair_memories(6)
        for poses in (wide[:, ::2], wide[:, ::2].astype("f4"), wide[:, ::2].tolist()):
            found = abut.pairs_contacts(box, HERE, box, poses, memories)
            self.assertEqual(found.counts.tolist(), [4] * 6)
        with self.assertRaisesRegex(ValueError, r"poses_b has shape \(6, 6\); it must be \(N, 7\)"):
            abut.pairs_contacts(box, HERE, box, wide[:, :6])
        with self.assertRaisesRegex(ValueError, "poses_b has 6 and memories has 5"):
            abut.pairs_contacts(box, HERE, box, wide[:, ::2], abut.pair_memories(5))

    def test_contacts_of_several_chunks_are_those_of_one(self):
        box, poses, told = abut.Shape.box(1, 1, 1), poses_along_x(*numpy.linspace(0, 4, 50)), []
        whole = abut.pairs_contacts(box, HERE, box, poses)
        with unittest.mock.patch("abut.progress.CHUNK", 7):
            parts = abut.pairs_contacts(box, HERE, box, poses, progress=lambda *done: told.append(done))
        self.assertEqual(told[-1], (50, 50))
        self.assertEqual(parts.counts.tolist(), whole.counts.tolist())
        self.assertEqual(bytes(parts.records.memory), bytes(whole.records.memory))

    def test_no_pairs_have_no_contacts(self):
        box = abut.Shape.box(1, 1, 1)
        found = abut.pairs_contacts(box, HERE, box, numpy.empty((0, 7)))
        self.assertEqual((len(found), len(found.records)), (0, 0))

    def test_pairs_that_have_no_contacts_are_told(self):
        ground = abut.Shape.plane((0, 0, 1), 0)
        with self.assertRaisesRegex(abut.Error, "pair 0: there is no algorithm for plane and plane"):
            abut.pairs_contacts(ground, HERE, ground, [HERE] * 3)

    def test_casts_of_many_pairs(self):
        ball = abut.Shape.sphere(1)
        found = abut.pairs_cast(ball, HERE, [[4, 0, 0], [0, 4, 0]], ball, abut.pose(4))
        assert_allclose(found.fraction, [0.5, numpy.inf])
        self.assertEqual(bytes(found[0]), bytes(abut.pair_cast(ball, HERE, (4, 0, 0), ball, abut.pose(4))))
        ways = numpy.array([[4, 9, 0, 9, 0, 9], [0, 9, 4, 9, 0, 9]], "f4")[:, ::2]
        assert_array_equal(abut.pairs_cast(ball, HERE, ways, ball, abut.pose(4)).fraction, found.fraction)

    def test_rays_on_a_shape(self):
        box = abut.Shape.box(1, 1, 1)
        lines = abut.rays([[-5, 0, 0], [-5, 3, 0], [0, 0, 9]], [[1, 0, 0], [1, 0, 0], [0, 0, -1]])
        found = abut.shape_cast_rays(box, abut.pose(0, 0, 1), lines)
        self.assertEqual((found.geometry["slot"] != 0).tolist(), [True, False, True])
        assert_allclose(found.distance[[0, 2]], [4, 7])
        rows = numpy.hstack([lines.origin, lines.direction]).astype("f4")
        assert_array_equal(abut.shape_cast_rays(box, abut.pose(0, 0, 1), rows).distance, found.distance)


class Universes(unittest.TestCase):
    def setUp(self):
        self.universe = abut.Universe()
        self.parts = self.universe.add_parts(poses_along_x(0, 3, 6), user_data=[7, 8, 9],
                                             motion=numpy.array([0, 0, 2], "u4"))
        self.geometries = self.universe.add_geometries(self.parts, abut.Shape.sphere(1), tolerance=[0, 0, 0.5], label=4)
        self.universe.step()

    def test_scenes_are_built_from_columns(self):
        self.assertEqual([self.universe.user_data(part) for part in self.parts], [7, 8, 9])
        self.assertEqual([self.universe.motion(part) for part in self.parts], [0, 0, abut.MOTION_STATIC])
        infos = [self.universe.describe(geometry) for geometry in self.geometries]
        self.assertEqual([(info.label, info.tolerance) for info in infos], [(4, 0), (4, 0), (4, 0.5)])
        with self.assertRaisesRegex(ValueError, "user_data has 2 elements; it must have 3"):
            self.universe.add_parts(poses_along_x(0, 3, 6), user_data=[7, 8])
        self.assertEqual(len(self.universe.parts()), 3)

    def test_pairs_of_geometries_are_an_array(self):
        pairs = self.geometries.array[numpy.array([[0, 1], [2, 1]])]
        self.universe.set_poses(self.parts, abut.pose())
        self.universe.detect_pairs(pairs)
        self.assertEqual(self.universe.contacts().geometry_a["slot"].tolist(), [each.slot for each in self.geometries[:2]])

    def test_poses_go_in_and_out_as_rows(self):
        rows = self.universe.poses(self.parts).array
        self.assertEqual(rows.shape, (3, 7))
        rows[:, 2] = 5
        self.universe.set_poses(self.parts, rows)
        assert_array_equal(self.universe.poses(self.parts).position[:, 2], [5, 5, 5])
        self.universe.set_poses(self.parts.array[1:], HERE)
        assert_array_equal(self.universe.poses(self.parts).position[:, 2], [5, 0, 0])
        self.assertEqual(self.universe.geometry_poses(self.geometries).array.shape, (3, 7))

    def test_velocities_go_in_and_out_as_rows(self):
        self.universe.set_velocities(self.parts, numpy.arange(18, dtype="f4").reshape(3, 6))
        assert_array_equal(self.universe.velocities(self.parts).array[1], range(6, 12))
        assert_array_equal(self.universe.velocities(self.parts).angular[2], [15, 16, 17])
        self.assertEqual(self.universe.velocity_source(self.parts[0]), abut.VELOCITY_GIVEN)
        self.universe.set_velocities(self.parts, None)
        self.assertEqual(self.universe.velocity_source(self.parts[0]), abut.VELOCITY_NONE)

    def test_batches_of_queries(self):
        small = abut.Shape.sphere(0.5)
        rays = abut.rays([[0, 0, 5], [3, 0, 5], [30, 0, 5]], (0, 0, -1))
        found = self.universe.cast_rays(rays)
        self.assertEqual(found.geometry["slot"].tolist(), [self.geometries[0].slot, self.geometries[1].slot, 0])
        assert_allclose(found.distance[:2], [4, 4])
        self.assertEqual(self.universe.at_points(numpy.array([[0, 0, 0], [9, 9, 9], [3, 0, 0]], "f4")).counts.tolist(),
                         [1, 0, 1])
        assert_allclose(self.universe.cast_shapes(small, poses_along_x(-5, -5), (10, 0, 0)).fraction, [0.35, 0.35])
        touched = self.universe.overlaps_of_each(small, poses_along_x(1.2, 30))
        self.assertEqual([list(group) for group in touched], [[self.geometries[0]], []])
        # More answers than there is room for at first: all 30 geometries in each of 3 queries.
        self.universe.add_geometries(self.universe.add_parts([HERE] * 27), small)
        self.universe.refresh()
        everywhere = self.universe.overlaps_of_each(abut.Shape.sphere(99), [HERE] * 3)
        self.assertEqual(everywhere.counts.tolist(), [30] * 3)
        self.assertEqual([list(group) for group in everywhere], [list(self.universe.geometries())] * 3)
        assert_allclose(self.universe.closest_to_each(small, poses_along_x(-5, 10)).distance["distance"], [3.5, 2.5])

    def test_shapes_change_by_rows(self):
        self.universe.set_parameters(self.geometries, numpy.array([[1], [2], [3]], "f4"))
        self.assertEqual([self.universe.shape_of(each).parameters["radius"] for each in self.geometries], [1, 2, 3])
        part = self.universe.add_part()
        field = self.universe.add_geometry(part, abut.Shape.height_field(heights=numpy.zeros((4, 5))))
        self.universe.set_heights(field, 1, 2, numpy.array([[3, 4, 6]]))
        self.assertEqual(self.universe.shape_of(field).aabb().maximum.z, 6)
        balls = self.universe.add_geometry(part, abut.Shape.particles(numpy.zeros((4, 3)), 1))
        self.universe.set_particles(balls, 2, numpy.array([[0, 0, 7]]))
        self.assertEqual(self.universe.shape_of(balls).aabb().maximum.z, 8)
        square = abut.Shape.mesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
        mesh = self.universe.add_geometry(part, square)
        self.universe.set_vertices(mesh, 3, numpy.array([[0, 1, 7]]))
        self.assertEqual(self.universe.shape_of(mesh).aabb().maximum.z, 7)
        self.universe.set_vertices(mesh, numpy.array([3, 0]), numpy.array([[0, 1, 0], [0, 0, 5]]))
        self.assertEqual(self.universe.shape_of(mesh).aabb().maximum.z, 5)
        with self.assertRaises(ValueError):
            self.universe.set_vertices(mesh, [3, 0], [[0, 1, 0]])
        self.universe.remove_triangles(mesh, [1])
        self.assertEqual(self.universe.shape_of(mesh).aabb().maximum.z, 5)
        self.universe.set_mesh(mesh, numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 4]]), [[0, 1, 2]])
        self.assertEqual(self.universe.shape_of(mesh).aabb().maximum.z, 4)


if __name__ == "__main__":
    unittest.main()
