# SPDX-License-Identifier: Apache-2.0
"""abut.fcl against what python-fcl documents: its README, its conventions, and what trimesh calls. Needs NumPy."""

import math
import unittest

try:
    import numpy
    from numpy.testing import assert_allclose
except ImportError:
    raise unittest.SkipTest("NumPy is not installed") from None

import abut
import abut.fcl as fcl

TETRAHEDRON = numpy.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
FACES = numpy.array([[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]])
CUBE = numpy.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
TURN_X = numpy.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])


def mesh(vertices=TETRAHEDRON, faces=FACES):
    model = fcl.BVHModel()
    model.beginModel(len(vertices), len(faces))
    model.addSubModel(vertices, faces)
    model.endModel()
    return model


def convex(vertices=CUBE):
    return fcl.Convex(vertices, 0, [])


def at(geometry, x=0.0, y=0.0, z=0.0):
    return fcl.CollisionObject(geometry, fcl.Transform(numpy.array([x, y, z], "f8")))


def distance(o1, o2):
    result = fcl.DistanceResult()
    request = fcl.DistanceRequest(enable_nearest_points=True, enable_signed_distance=True)
    found = fcl.distance(o1, o2, request, result)
    assert found == result.min_distance
    return result


def contacts(o1, o2, most=100):
    result = fcl.CollisionResult()
    count = fcl.collide(o1, o2, fcl.CollisionRequest(num_max_contacts=most, enable_contact=True), result)
    assert count == len(result.contacts) and result.is_collision == (count > 0)
    return result.contacts


class Conventions(unittest.TestCase):
    def test_sizes_are_full_and_frames_those_of_fcl(self):
        for geometry, highest, lowest in [
                (fcl.Box(1, 2, 3), 1.5, -1.5), (fcl.Sphere(2), 2, -2), (fcl.Ellipsoid(1, 2, 3), 3, -3),
                (fcl.Capsule(0.5, 3), 2, -2), (fcl.Cylinder(0.5, 3), 1.5, -1.5), (fcl.Cone(0.5, 3), 1.5, -1.5),
                (convex(), 0.5, -0.5), (mesh(), 1, 0), (fcl.TriangleP([0, 0, 1], [1, 0, 2], [0, 1, 3]), 3, 1)]:
            box = geometry.shapes[0].aabb()
            self.assertAlmostEqual(box.maximum.z, highest, msg=type(geometry).__name__)
            self.assertAlmostEqual(box.minimum.z, lowest, msg=type(geometry).__name__)
            assert_allclose(geometry.aabb_center[2], (highest + lowest) / 2)

    def test_the_tip_of_a_cone_is_above_and_its_rim_below(self):
        ball = fcl.Sphere(0.25)
        self.assertAlmostEqual(distance(at(fcl.Cone(1, 2)), at(ball, z=2)).min_distance, 0.75)
        self.assertAlmostEqual(distance(at(fcl.Cone(1, 2)), at(ball, x=2, z=-1)).min_distance, 0.75)

    def test_contacts_point_from_the_first_and_depths_are_positive(self):
        a, b = fcl.Sphere(1), fcl.Box(2, 2, 2)
        contact, = contacts(at(a), at(b, x=1.5))
        self.assertIs(contact.o1, a)
        self.assertIs(contact.o2, b)
        assert_allclose(contact.normal, [1, 0, 0], atol=1e-12)
        assert_allclose(contact.pos, [0.75, 0, 0], atol=1e-12)
        self.assertAlmostEqual(contact.penetration_depth, 0.5)
        self.assertEqual((contact.b1, contact.b2), (-1, -1))
        contact, = contacts(at(b, x=1.5), at(a))
        assert_allclose(contact.normal, [-1, 0, 0], atol=1e-12)

    def test_contacts_are_as_many_as_asked_for(self):
        box = fcl.Box(1, 1, 1)
        self.assertEqual(len(contacts(at(box), at(box, z=0.9))), 4)
        self.assertEqual(len(contacts(at(box), at(box, z=0.9), most=2)), 2)
        self.assertEqual(len(contacts(at(box), at(box, z=0.9), most=math.inf)), 4)
        self.assertEqual(len(contacts(at(box), at(box, z=1.1))), 0)
        result = fcl.CollisionResult()
        self.assertEqual(fcl.collide(at(box), at(box, z=0.9), result=result), 1)
        self.assertEqual(fcl.collide(at(box), at(box, z=5), result=result), 0)
        self.assertTrue(result.is_collision)
        self.assertEqual(len(result.contacts), 1)

    def test_models_are_built_in_steps(self):
        model = fcl.BVHModel()
        states = [model.buildState()]
        model.beginModel()
        states.append(model.buildState())
        for triangle in FACES:
            model.addTriangle(*TETRAHEDRON[triangle])
        model.endModel()
        self.assertEqual([*states, model.buildState(), model.num_tries_()], [0, 1, 2, 4])
        self.assertAlmostEqual(distance(at(model), at(fcl.Sphere(1), z=3)).min_distance, 1)
        empty = fcl.BVHModel()
        empty.beginModel()
        with self.assertRaisesRegex(ValueError, "it has no triangles"):
            empty.endModel()

    def test_triangles_are_told(self):
        ball = fcl.Sphere(0.25)
        contact, *_ = contacts(at(mesh()), at(ball, 0.2, 0.2, -0.2))
        self.assertEqual((contact.b1, contact.b2), (0, -1))
        assert_allclose(contact.normal, [0, 0, -1], atol=1e-9)
        found = distance(at(ball, 0.2, 0.2, -2), at(mesh()))
        self.assertEqual((found.b1, found.b2), (-1, 0))
        self.assertAlmostEqual(found.min_distance, 1.75)
        assert_allclose(found.nearest_points, [[0.2, 0.2, -1.75], [0.2, 0.2, 0]], atol=1e-9)
        found = distance(at(mesh()), at(ball, 2, 2, 2))
        self.assertEqual(found.b1, 3)

    def test_half_spaces_and_planes(self):
        ball, floor = fcl.Sphere(1), fcl.Halfspace(numpy.array([0.0, 0, 2]), 4.0)
        self.assertAlmostEqual(distance(at(ball, z=5), at(floor)).min_distance, 2)
        self.assertAlmostEqual(distance(at(ball, z=-5), at(floor)).min_distance, -8)
        plane = fcl.Plane(numpy.array([0.0, 0, 1]), 2.0)
        for z, apart in ((5, 2), (-5, 6), (2.25, -0.75), (1.75, -0.75)):
            self.assertAlmostEqual(distance(at(ball, z=z), at(plane)).min_distance, apart, msg=str(z))
            self.assertEqual(len(contacts(at(ball, z=z), at(plane))), int(apart < 0))
        for z, up in ((2.25, -1), (1.75, 1)):
            contact, = contacts(at(ball, z=z), at(plane))
            assert_allclose(contact.normal, [0, 0, up], atol=1e-12)
        self.assertAlmostEqual(distance(at(mesh(), z=1.5), at(plane)).min_distance, -0.5)

    def test_sizes_can_be_set(self):
        box = fcl.Box(1, 1, 1)
        moved = at(box, x=2)
        self.assertAlmostEqual(distance(at(fcl.Sphere(1)), moved).min_distance, 0.5)
        box.side = [2, 2, 2]
        self.assertAlmostEqual(distance(at(fcl.Sphere(1)), moved).min_distance, 0)
        self.assertEqual(moved.box, ((1, -1, -1), (3, 1, 1)))


class Transforms(unittest.TestCase):
    def test_all_that_the_readme_makes(self):
        R, T = numpy.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]), numpy.array([1.0, 2, 3])
        q = numpy.array([0.707, 0.0, 0.0, 0.707])
        for made, rotation, translation in [
                (fcl.Transform(), numpy.eye(3), [0, 0, 0]), (fcl.Transform(q), R, [0, 0, 0]),
                (fcl.Transform(R), R, [0, 0, 0]), (fcl.Transform(T), numpy.eye(3), T), (fcl.Transform(q, T), R, T),
                (fcl.Transform(R, T), R, T), (fcl.Transform(fcl.Transform(R, T)), R, T)]:
            assert_allclose(made.getRotation(), rotation, atol=1e-12)
            assert_allclose(made.getTranslation(), translation)
        assert_allclose(fcl.Transform(R).getQuatRotation(), [math.sqrt(0.5), 0, 0, math.sqrt(0.5)])
        thing = fcl.CollisionObject(fcl.Box(1, 2, 3), fcl.Transform(R, T))
        assert_allclose(thing.box, [[0, 1.5, 1.5], [2, 2.5, 4.5]], atol=1e-12)
        thing.setTransform(fcl.Transform())
        thing.setRotation(R)
        thing.setTranslation(-T)
        assert_allclose(thing.getRotation(), R)
        assert_allclose(thing.getTransform().getTranslation(), -T)
        thing.setQuatRotation(numpy.array([1.0, 0, 0, 0]))
        assert_allclose(thing.box, [[-1.5, -3, -4.5], [-0.5, -1, -1.5]], atol=1e-12)

    def test_an_object_keeps_a_copy(self):
        transform = fcl.Transform()
        thing = fcl.CollisionObject(fcl.Sphere(1), transform)
        transform.setTranslation(numpy.array([5.0, 0, 0]))
        thing.getTransform().setTranslation(numpy.array([5.0, 0, 0]))
        assert_allclose(thing.getTranslation(), [0, 0, 0])

    def test_what_is_wrong_is_refused(self):
        for expected, call in {
            r"rotation has shape \(2,\)": lambda: fcl.Transform([1, 2]),
            r"\(4,\) for a quaternion; a homogeneous matrix m is Transform\(m\[:3, :3\]": lambda: fcl.Transform(numpy.eye(4)),
            r"T has shape \(2,\)": lambda: fcl.Transform(numpy.eye(3), [1, 2]),
            "rotation is no rotation: its rows are not of length 1": lambda: fcl.Transform(2 * numpy.eye(3)),
            "R is no rotation: it mirrors": lambda: fcl.Transform().setRotation(-numpy.eye(3)),
            "geom is of type NoneType": fcl.CollisionObject,
            "at most 2 arguments, not 3": lambda: fcl.Transform(1, 2, 3),
            "endModel.. is missing": lambda: at(fcl.BVHModel()).box,
            "correct sequence": lambda: fcl.BVHModel().addSubModel(TETRAHEDRON, FACES),
            "has no shape": lambda: at(fcl.CollisionGeometry()).box,
        }.items():
            with self.subTest(expected), self.assertRaisesRegex(ValueError, expected):
                call()
        ball, box = fcl.Sphere(1), at(fcl.Box(1, 1, 1))
        for expected, call in {
            "o1 is of type Sphere; it must be a CollisionObject": lambda: fcl.collide(ball, box),
            "o2 is of type Sphere; it must be a CollisionObject": lambda: fcl.distance(box, ball),
        }.items():
            with self.subTest(expected), self.assertRaisesRegex(TypeError, expected):
                call()


class Readme(unittest.TestCase):
    """The examples of the README of python-fcl, and the values that its tests expect."""

    def test_pairs(self):
        box, cone = at(fcl.Box(1, 2, 3)), at(fcl.Cone(1, 3))
        result = fcl.CollisionResult()
        self.assertGreater(fcl.collide(box, cone, fcl.CollisionRequest(), result), 0)
        self.assertTrue(result.is_collision)
        result = fcl.DistanceResult()
        self.assertEqual(fcl.distance(box, cone, fcl.DistanceRequest(), result), -1)
        self.assertEqual(result.min_distance, -1)
        self.assertIs(result.o1, box.geometry)

    def test_continuous(self):
        request, result = fcl.ContinuousCollisionRequest(), fcl.ContinuousCollisionResult()
        ends = fcl.Transform(numpy.array([1.0, 0, 0])), fcl.Transform(numpy.array([-1.0, 0, 0]))
        self.assertEqual(fcl.continuousCollide(at(fcl.Box(1, 2, 3)), ends[0], at(fcl.Cone(1, 3)), ends[1], request, result),
                         0)
        self.assertTrue(result.is_collide)
        result = fcl.ContinuousCollisionResult()
        box, cone = at(fcl.Box(1, 1, 1)), at(fcl.Cone(1, 1), z=-2)
        time = fcl.continuousCollide(box, fcl.Transform(), cone, fcl.Transform(), request, result)
        self.assertTrue(result.is_collide)
        self.assertAlmostEqual(time, 0.5, places=4)
        self.assertEqual(result.time_of_contact, time)
        self.assertEqual(fcl.continuousCollide(box, fcl.Transform(), cone, cone.getTransform()), 1.0)

    def test_turning_is_asked_for(self):
        blade, ball = at(fcl.Box(4, 0.2, 0.2)), at(fcl.Sphere(0.5), y=1.5)
        end = fcl.Transform(numpy.array([math.sqrt(0.5), 0, 0, math.sqrt(0.5)]))
        for motion, touches in ((fcl.CCDMotionType.CCDM_TRANS, False), (fcl.CCDMotionType.CCDM_LINEAR, True)):
            result = fcl.ContinuousCollisionResult()
            request = fcl.ContinuousCollisionRequest(ccd_motion_type=motion)
            fcl.continuousCollide(blade, end, ball, ball.getTransform(), request, result)
            self.assertEqual(result.is_collide, touches)

    def test_pairwise_values(self):
        box, cone, solid, surface = at(fcl.Box(1, 1, 1)), at(fcl.Cone(1, 1)), at(convex()), at(mesh())
        for a, b in ((box, cone), (solid, cone), (box, surface), (solid, surface), (cone, surface)):
            self.assertLess(distance(a, b).min_distance, 0)
            self.assertTrue(contacts(a, b))
        cone.setTranslation(numpy.array([0.0, 0.0, -0.6]))
        self.assertFalse(contacts(cone, surface))
        self.assertAlmostEqual(distance(cone, surface).min_distance, 0.1, places=6)
        cone.setRotation(TURN_X)
        cone.setTranslation(numpy.array([0.0, -0.9, 0.0]))
        self.assertTrue(contacts(box, cone))
        self.assertAlmostEqual(distance(box, cone).min_distance, distance(solid, cone).min_distance, places=6)
        cone.setTranslation(numpy.array([0.0, -1.1, 0.0]))
        self.assertFalse(contacts(box, cone))
        for thing in (box, solid):
            self.assertAlmostEqual(distance(thing, cone).min_distance, 0.1, places=6)

    def test_names_of_what_collides(self):
        geometries = [fcl.Cylinder(1.0, 1.0) for _ in range(3)]
        names = {id(geometry): f"obj{number}" for number, geometry in enumerate(geometries, 1)}
        manager = fcl.DynamicAABBTreeCollisionManager()
        manager.registerObjects([at(geometry, z=z) for geometry, z in zip(geometries, (0, 0.3, 3.0))])
        manager.setup()
        data = fcl.CollisionData(fcl.CollisionRequest(num_max_contacts=100, enable_contact=True), fcl.CollisionResult())
        manager.collide(data, fcl.defaultCollisionCallback)
        self.assertEqual({(names[id(each.o1)], names[id(each.o2)]) for each in data.result.contacts}, {("obj1", "obj2")})


def managed(*objects):
    manager = fcl.DynamicAABBTreeCollisionManager()
    manager.registerObjects(objects)
    manager.setup()
    return manager


def collides(manager, *asked):
    data = fcl.CollisionData(fcl.CollisionRequest(num_max_contacts=100, enable_contact=True))
    manager.collide(*asked, data, fcl.defaultCollisionCallback)
    return data.result.is_collision


def nearest(manager, *asked):
    data = fcl.DistanceData(fcl.DistanceRequest(enable_nearest_points=True, enable_signed_distance=True))
    manager.distance(*asked, data, fcl.defaultDistanceCallback)
    return data.result


class Managers(unittest.TestCase):
    """Scenes and values of the tests of python-fcl."""

    def setUp(self):
        cylinder = fcl.Cylinder(1, 1)
        self.first = managed(at(fcl.Box(1, 1, 1)), at(cylinder))
        self.second = managed(at(fcl.Cone(1, 1), z=5), at(cylinder, z=-5))
        self.third = managed(at(mesh()), at(convex(), z=-5))
        self.box, self.cylinder = at(fcl.Box(1, 1, 1)), at(cylinder, z=-4.6)

    def test_collisions(self):
        first, second, third = self.first, self.second, self.third
        self.assertEqual([collides(first, self.box), collides(first, self.cylinder)], [True, False])
        self.assertEqual([collides(second, self.box), collides(second, self.cylinder)], [False, True])
        self.assertEqual([collides(first), collides(second)], [True, False])
        self.assertEqual([collides(first, second), collides(second, third), collides(first, third)], [False, True, True])

    def test_distances(self):
        first, second, third = self.first, self.second, self.third
        for manager, asked, expected in [(first, self.cylinder, 3.6), (second, self.box, 4.0), (first, second, 4.0)]:
            self.assertAlmostEqual(nearest(manager, asked).min_distance, expected, places=6)
        self.assertAlmostEqual(nearest(second).min_distance, 9.0, places=6)
        for manager, *asked in [(first, self.box), (second, self.cylinder), (first,), (second, third), (first, third)]:
            self.assertLess(nearest(manager, *asked).min_distance, 0)

    def test_nearest_points_do_not_depend_on_the_order(self):
        turned = fcl.Transform(numpy.array([0.8660254, 0.0, 0.0, 0.5]), [-2.0, 0, 0])
        one = managed(fcl.CollisionObject(fcl.Box(20, 5, 1000), turned))
        others = [at(fcl.Box(5, 5, 1000), -5, 10), at(fcl.Box(5, 5, 1000), -15, 15)]
        found = [nearest(one, managed(*order)) for order in (others, others[::-1])]
        self.assertEqual(found[0].min_distance, found[1].min_distance)
        for each in found:
            apart = numpy.linalg.norm(numpy.subtract(*each.nearest_points))
            self.assertAlmostEqual(each.min_distance, apart, places=6)

    def test_objects_come_move_and_go(self):
        ball = fcl.Sphere(1)
        things = [at(ball), at(ball, z=-5), at(ball, z=5)]
        manager = managed(*things[:2])
        manager.registerObject(things[2])
        self.assertEqual((manager.size(), manager.empty(), collides(manager)), (3, False, False))
        for z, expected in ((-0.3, True), (-5, False)):
            things[1].setTranslation(numpy.array([0, 0, z]))
            manager.update(things[1])
            self.assertEqual(collides(manager), expected)
        things[2].setTranslation(numpy.array([0, 0, 0.3]))
        manager.update([things[2]])
        self.assertTrue(collides(manager))
        manager.unregisterObject(things[2])
        manager.update(things[2])
        manager.unregisterObject({"obj": things[2]})
        self.assertEqual((manager.getObjects(), collides(manager)), (things[:2], False))
        manager.clear()
        self.assertEqual((manager.size(), manager.empty(), collides(manager)), (0, True, False))
        with self.assertRaisesRegex(ValueError, "the arguments must be"):
            manager.collide(ball)

    def test_a_callback_decides(self):
        ball, told = fcl.Sphere(1), []
        things = [at(ball, x=1.5 * number) for number in range(4)]
        manager = managed(*things)

        def note(o1, o2, data):
            data.append((things.index(o1), things.index(o2)))
            return len(data) == 2

        manager.collide(told, note)
        self.assertEqual(told, [(0, 1), (1, 2)])
        told.clear()
        manager.distance(at(ball, x=9), told, lambda o1, o2, data: (data.append(things.index(o1)) or False, 4.5))
        self.assertEqual(told, [3, 2])
        told.clear()
        manager.distance(at(ball, x=9), told, lambda o1, o2, data: (data.append(things.index(o1)) or True, 0))
        self.assertEqual(told, [3])

    def test_half_spaces_of_a_manager(self):
        walls = [at(fcl.Halfspace(numpy.array([0.0, 0, 1]), 0)), at(fcl.Plane(numpy.array([1.0, 0, 0]), 5))]
        manager = managed(*walls, at(fcl.Sphere(1), z=2))
        self.assertFalse(collides(manager))
        self.assertAlmostEqual(nearest(manager).min_distance, 1)
        self.assertTrue(collides(manager, at(fcl.Sphere(1), x=5.5, z=9)))

    def test_random_boxes_as_all_pairs_say(self):
        seed = int.from_bytes(numpy.random.bytes(4), "little")
        random = numpy.random.default_rng(seed)
        things = [at(fcl.Box(*random.uniform(0.2, 2, 3)), *random.uniform(-6, 6, 3)) for _ in range(40)]
        manager, pairs = managed(*things), []
        every = fcl.CollisionRequest(num_max_contacts=1)
        manager.collide(pairs, lambda o1, o2, data: fcl.collide(o1, o2, every) and data.append((o1, o2)))
        expected = {frozenset((id(a), id(b))) for i, a in enumerate(things) for b in things[:i] if contacts(a, b, 1)}
        self.assertEqual({frozenset(map(id, pair)) for pair in pairs}, expected, f"seed {seed}")
        asked = at(fcl.Sphere(0.5), *random.uniform(-9, 9, 3))
        self.assertEqual(nearest(manager, asked).min_distance, min(distance(a, asked).min_distance for a in things),
                         f"seed {seed}")


    def test_random_balls_as_all_pairs_say(self):
        seed = int.from_bytes(numpy.random.bytes(4), "little")
        random = numpy.random.default_rng(seed)
        sizes, places = random.uniform(1e-4, 1e-3, 60), random.uniform(-6, 6, (60, 3))
        things = [at(fcl.Sphere(size), *place) for size, place in zip(sizes, places)]
        gaps = numpy.linalg.norm(places[:, None] - places, axis=2) - sizes[:, None] - sizes
        gaps[numpy.diag_indices(60)] = numpy.inf
        message = f"seed {seed}"
        self.assertAlmostEqual(nearest(managed(*things)).min_distance, gaps.min(), places=12, msg=message)
        first, second = managed(*things[:40]), managed(*things[40:])
        self.assertAlmostEqual(nearest(first, second).min_distance, gaps[:40, 40:].min(), places=12, msg=message)
        self.assertAlmostEqual(nearest(first, things[50]).min_distance, gaps[:40, 50].min(), places=12, msg=message)


class AsTrimeshDoes(unittest.TestCase):
    """The calls of CollisionManager in trimesh/collision.py, with the values of its tests of unit cubes."""

    def setUp(self):
        self.names, self.objects = {}, {}
        self.manager = fcl.DynamicAABBTreeCollisionManager()
        self.manager.setup()

    def add(self, name, x):
        matrix = numpy.eye(4, dtype="f4")
        matrix[0, 3] = x
        made = fcl.CollisionObject(convex(), fcl.Transform(matrix[:3, :3], matrix[:3, 3]))
        self.names[id(made.geometry)], self.objects[name] = name, made
        self.manager.registerObject(made)
        self.manager.update()

    def test_single_internal_and_moves(self):
        for name, x in (("cube0", 0), ("cube1", 5)):
            self.add(name, x)
        data = fcl.CollisionData(request=fcl.CollisionRequest(num_max_contacts=100000, enable_contact=True))
        asked = at(convex(), x=5)

        def collide(o1, o2, cdata):
            fcl.collide(o1=o1, o2=o2, request=cdata.request, result=cdata.result)
            return False

        self.manager.collide(asked, data, collide)
        self.assertEqual({self.names[id(each.o1)] for each in data.result.contacts}, {"cube1"})
        for each in data.result.contacts:
            self.assertEqual(each.o2, asked.geometry)
            self.assertAlmostEqual(each.penetration_depth, 1)
        self.assertFalse(collides(self.manager))
        self.objects["cube1"].setRotation(numpy.eye(4)[:3, :3])
        self.objects["cube1"].setTranslation(numpy.array([0.5, 0, 0]))
        self.manager.update(self.objects["cube1"])
        self.assertTrue(collides(self.manager))

    def test_distances(self):
        self.add("cube1", 5)
        for x, expected in ((0, 4.0), (5.75, -0.25)):
            self.assertAlmostEqual(nearest(self.manager, at(convex(), x=x)).min_distance, expected)
        self.add("cube2", -5)
        found = nearest(self.manager, at(convex(), x=-2))
        self.assertAlmostEqual(found.min_distance, 2)
        self.assertEqual(self.names[id(found.o1)], "cube2")
        self.assertAlmostEqual(nearest(self.manager).min_distance, 9)
        self.add("cube3", 2)
        found = nearest(self.manager)
        self.assertAlmostEqual(found.min_distance, 2)
        self.assertEqual({self.names[id(found.o1)], self.names[id(found.o2)]}, {"cube1", "cube3"})
        taken = self.objects["cube1"]
        self.manager.unregisterObject(taken)
        self.manager.update(taken)
        self.assertAlmostEqual(nearest(self.manager, taken).min_distance, 2)
        self.manager.registerObject(taken)
        self.manager.update()
        self.assertEqual(self.manager.size(), 3)


class Copies(unittest.TestCase):
    def test_objects_are_pickled(self):
        import pickle

        made = pickle.loads(pickle.dumps([at(mesh(), x=3), at(convex()), at(fcl.Plane(numpy.array([0.0, 0, 1]), 1))]))
        self.assertAlmostEqual(distance(made[0], made[1]).min_distance, 2.5)
        self.assertTrue(contacts(made[1], at(fcl.Sphere(0.1))))
        self.assertEqual(abut.fcl.__version__, abut.__version__)


if __name__ == "__main__":
    unittest.main()
