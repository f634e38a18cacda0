# SPDX-License-Identifier: Apache-2.0
"""The Python binding without arrays: layouts, completeness, queries, a universe, errors.

With the folder of the C headers in ABUT_HEADERS it also checks that no function is missing.
"""

import array
import ctypes
import os
import pathlib
import re
import unittest

import abut
from abut import c

HEADERS = pathlib.Path(os.environ["ABUT_HEADERS"]) if "ABUT_HEADERS" in os.environ else None


class Layout(unittest.TestCase):
    def test_structs_are_those_of_the_library(self):
        structs = {"abut_" + re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower(): value for name, value in vars(c).items()
                   if isinstance(value, type) and issubclass(value, ctypes.Structure) and name[0] != "_"}
        reported = {}
        for index in range(c.library.abut_layout_count()):
            entry = c.LayoutEntry()
            c.library.abut_layout_at(index, ctypes.byref(entry))
            reported.setdefault(entry.type.decode(), {})[entry.field.decode()] = (entry.offset, entry.size)
        self.assertGreater(len(reported), 20)
        for name, fields in reported.items():
            ours = {field: (getattr(structs[name], field).offset, getattr(structs[name], field).size)
                    for field, _ in structs[name]._fields_}
            ours[""] = (0, ctypes.sizeof(structs[name]))
            self.assertEqual(ours, fields, name)

    def test_no_function_is_missing(self):
        if HEADERS is None:
            self.skipTest("the folder of the headers was not given")
        for header, functions in (("abut.h", c.FUNCTIONS), ("picking.h", c.PICKING_FUNCTIONS)):
            text = (HEADERS / "abut" / header).read_text()
            declared = set(re.findall(r"^ABUT_API [^;(]*?(abut_\w+)\(", text, re.MULTILINE))
            self.assertGreater(len(declared), 8)
            self.assertEqual(declared, set(functions))

    def test_constants_are_those_of_the_header(self):
        if HEADERS is None:
            self.skipTest("the folder of the headers was not given")
        for header in ("abut.h", "picking.h"):
            text = (HEADERS / "abut" / header).read_text()
            for name, value in re.findall(r"^  ABUT_(\w+) = (\d+)", text, re.MULTILINE):
                self.assertEqual(getattr(c, name), int(value), name)


class Version(unittest.TestCase):
    def test_the_package_has_the_version_of_the_library(self):
        self.assertEqual(abut.__version__, abut.version())


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
        self.assertFalse(abut.pair_support("plane", "plane"))
        self.assertTrue(abut.pair_support("plane", "box", abut.QUERY_DISTANCE))

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


class Universes(unittest.TestCase):
    def test_step(self):
        with abut.Universe(broadphase=abut.BROADPHASE_TREE) as universe, abut.Shape.sphere(1) as ball:
            parts = [universe.add_part(pose=abut.pose(x=1.5 * i), user_data=10 + i) for i in range(3)]
            geometries = [universe.add_geometry(part, ball, tolerance=0.01) for part in parts]
            universe.step(0.01)
            found = universe.contacts()
            self.assertEqual([(each.geometry_a.slot, each.geometry_b.slot) for each in found],
                             [(geometries[0].slot, geometries[1].slot), (geometries[1].slot, geometries[2].slot)])
            self.assertAlmostEqual(found[0].distance, -0.5)
            with self.assertRaisesRegex(abut.Error, "UNIVERSE_LOCAL_POINTS"):
                universe.local_points()
            self.assertEqual(universe.stats().contacts, 2)
            self.assertIn("sphere", universe.explain())
            self.assertEqual(universe.user_data(parts[2]), 12)
            self.assertEqual(universe.describe(geometries[1]).tolerance, 0.01)
            self.assertEqual(len(universe.geometries(parts[0])), 1)
            universe.set_poses(parts[:1], [abut.pose(-5, 0, 0)])
            universe.step()
            self.assertEqual(len(universe.contacts()), 1)
            self.assertEqual(universe.poses(parts)[0].position.x, -5)
            universe.destroy_parts(parts[1:])
            self.assertEqual(len(universe.parts()), 1)
            with self.assertRaises(abut.Error) as caught:
                universe.poses(parts)
            self.assertEqual(caught.exception.status, abut.STALE_ID)

    def setUp(self):
        self.universe, self.ball = abut.Universe(events=abut.EVENTS_PAIRS | abut.EVENTS_PERSIST), abut.Shape.sphere(1)
        self.parts = [self.universe.add_part(pose=abut.pose(x=1.5 * i)) for i in range(3)]
        self.geometries = [self.universe.add_geometry(part, self.ball, label=i, tag=i) for i, part in enumerate(self.parts)]
        self.addCleanup(self.ball.close)
        self.addCleanup(self.universe.close)

    def events_of_a_step(self):
        self.universe.step()
        slots = [each.slot for each in self.geometries]
        return [(each.kind, slots.index(each.geometry_a.slot), slots.index(each.geometry_b.slot))
                for each in self.universe.events()]

    def test_local_points(self):
        with abut.Universe(flags=abut.UNIVERSE_LOCAL_POINTS) as universe, abut.Shape.sphere(1) as ball:
            for x in (3, 4.5):
                universe.add_geometry(universe.add_part(pose=abut.pose(x)), ball)
            universe.step()
            points, = universe.local_points()
            self.assertEqual((points.a.x, points.b.x), (1, -1))

    def test_events(self):
        self.assertEqual(self.events_of_a_step(), [(abut.EVENT_BEGIN, 0, 1), (abut.EVENT_BEGIN, 1, 2)])
        first = self.universe.hash()
        self.universe.park(self.geometries[2:])
        self.assertEqual(self.events_of_a_step(), [(abut.EVENT_PERSIST, 0, 1), (abut.EVENT_END, 1, 2)])
        self.assertNotEqual(self.universe.hash(), first)
        self.assertEqual(self.universe.describe(self.geometries[2]).parking, abut.PARKING_SHORT_TERM)
        self.universe.park(self.geometries[2:], abut.PARKING_NONE)
        self.assertEqual(self.events_of_a_step(), [(abut.EVENT_PERSIST, 0, 1), (abut.EVENT_BEGIN, 1, 2)])

    def test_rules(self):
        for a, b in ((self.geometries[0], self.geometries[1]), (self.parts[0], self.parts[1]), (0, 1), (0, None)):
            self.universe.set_rule(a, b, abut.RULE_DISABLE)
            self.universe.step()
            self.assertEqual(len(self.universe.contacts()), 1)
            self.universe.set_rule(b, a, abut.RULE_NONE)
            self.universe.step()
            self.assertEqual(len(self.universe.contacts()), 2)
        self.universe.set_rule(None, None, abut.RULE_DISABLE)
        self.universe.clear_rules()
        self.universe.step()
        self.assertEqual(len(self.universe.contacts()), 2)
        with self.assertRaises(TypeError):
            self.universe.set_rule("ball", None, abut.RULE_DISABLE)

    def test_filter(self):
        asked = []

        def keeps(a, b):
            asked.append((a.slot, b.slot))
            if len(asked) == 1:
                self.universe.park(self.geometries[2:])
            with self.assertRaises(abut.Error) as caught:
                self.universe.refilter()
            self.assertEqual(caught.exception.status, abut.BUSY)
            return len(asked) != 1

        self.universe.set_filter(keeps)
        self.assertEqual(self.events_of_a_step(), [(abut.EVENT_BEGIN, 1, 2)])
        slots = [each.slot for each in self.geometries]
        self.assertEqual(asked, [(slots[0], slots[1]), (slots[1], slots[2])])
        self.assertEqual(self.events_of_a_step(), [(abut.EVENT_END, 1, 2)])
        self.universe.set_filter(None)
        self.assertEqual(self.events_of_a_step(), [(abut.EVENT_BEGIN, 0, 1)])

    def test_what_a_filter_raises_comes_out_of_the_step(self):
        def fails(a, b):
            raise KeyError("no such pair")

        self.universe.set_filter(fails)
        with self.assertRaises(KeyError):
            self.universe.step()
        self.assertEqual(len(self.universe.contacts()), 2)
        self.universe.set_filter(None)
        self.universe.step()

    def test_policies(self):
        self.universe.set_policy(0, 1, detail=abut.DETAIL_BOX, period=3)
        self.assertEqual(self.universe.policy(1, 0).period, 3)
        self.assertEqual(self.events_of_a_step(), [(abut.EVENT_BEGIN, 0, 1), (abut.EVENT_BEGIN, 1, 2)])
        self.assertEqual(len(self.universe.contacts()), 1)
        self.universe.set_policy(0, 1)
        self.universe.step()
        self.assertEqual(len(self.universe.contacts()), 2)

    def test_focus(self):
        tags = lambda: [self.universe.describe(geometry).tag for geometry in self.geometries]
        for geometry in self.geometries:
            self.universe.change(geometry, tag=0)
        # The boxes are 9, 10.5 and 12 from the centre.
        self.universe.set_focus([(-10, 0, 0)], near_tag=0, far_tag=4, near_distance=1, far_distance=9.5)
        self.universe.step()
        self.assertEqual(tags(), [0, 4, 4])
        self.universe.set_focus([], near_tag=0, far_tag=4)
        self.universe.step()
        self.assertEqual(tags(), [4, 4, 4])
        self.universe.set_focus(None)
        self.universe.change(self.geometries[0], tag=0)
        self.universe.step()
        self.assertEqual(tags(), [0, 4, 4])
        with self.assertRaises(abut.Error):
            self.universe.set_focus([(0, 0, 0)], near_tag=64)

    def test_sleep(self):
        self.universe.set_sleep(self.parts, steps=2)
        for _ in range(3):
            self.universe.step(0.01)
        self.assertEqual(len(self.universe.sleep_changes()), 0)
        self.universe.step(0.01)
        self.assertEqual([(each.part.slot, each.is_asleep) for each in self.universe.sleep_changes()],
                         [(part.slot, 1) for part in self.parts])
        self.assertEqual({each.flags for each in self.universe.events()}, {abut.EVENT_ASLEEP})
        self.assertEqual(self.universe.stats().asleep, 3)
        self.universe.wake(self.parts[:1])
        self.universe.step(0.01)
        self.assertFalse(self.universe.is_asleep(self.parts[2]))
        self.universe.keep_awake(self.parts)
        for _ in range(5):
            self.universe.step(0.01)
        self.assertEqual(self.universe.stats().asleep, 0)
        with self.assertRaises(TypeError):
            self.universe.set_sleep(self.parts, depth=1)

    def test_changes(self):
        self.universe.change(self.geometries[0], flags=abut.GEOMETRY_SENSOR, material=7, user_data=3)
        self.assertEqual(self.universe.options_of(self.geometries[0]).material, 7)
        self.universe.step()
        contact = self.universe.contacts()[0]
        self.assertEqual((contact.flags, contact.material_a, contact.material_b), (abut.CONTACT_SENSOR, 7, 0))
        with abut.Shape.box(0.1, 0.1, 0.1) as crumb:
            self.universe.set_shapes(self.geometries[1:2], [crumb])
        self.assertEqual(self.events_of_a_step(), [(abut.EVENT_END, 0, 1), (abut.EVENT_END, 1, 2)])
        self.assertEqual(self.universe.motion(self.parts[0]), abut.MOTION_DYNAMIC)
        self.universe.set_motions(self.parts, [abut.MOTION_STATIC] * 3)
        self.assertEqual(self.universe.motion(self.parts[2]), abut.MOTION_STATIC)
        with self.assertRaises(TypeError):
            self.universe.change(self.geometries[0], colour=1)

    def test_detections(self):
        self.universe.detect_pairs([(self.geometries[1], self.geometries[0])])
        self.assertEqual(len(self.universe.contacts()), 1)
        self.universe.detect_region((2, -1, -1), (float("inf"), 1, 1))
        self.assertEqual(len(self.universe.contacts()), 2)
        self.universe.set_poses(self.parts[:1], [abut.pose(x=-9)])
        self.universe.refresh()
        self.universe.detect_changed()
        self.assertEqual(len(self.universe.contacts()), 1)
        self.universe.detect_all()
        self.assertEqual(self.universe.stats().examined_pairs, 1)
        self.assertIsInstance(self.universe.explain_json(), dict)


@unittest.skipIf(c.picking is None, "libabut_picking is not installed")
class Picking(unittest.TestCase):
    def test_rays(self):
        with abut.Universe() as universe, abut.Shape.sphere(1) as ball:
            geometry = universe.add_geometry(universe.add_part(), ball)
            with abut.Picker(universe) as picker:
                hit = picker.cast_ray(abut.ray((-5, 0, 0), (1, 0, 0)))
                self.assertEqual(hit.geometry.slot, geometry.slot)
                self.assertAlmostEqual(hit.distance, 4.0)
                self.assertEqual(len(picker.cast_ray_all(abut.ray((-5, 0, 0), (1, 0, 0)))), 2)
                self.assertEqual(hit.child, 0)
                self.assertEqual(picker.cast_ray(abut.ray((-5, 0, 0), (1, 0, 0)), mask=2).geometry.slot, 0)
                view = abut.camera(eye=(-5, 0, 0), target=(0, 0, 0), width=16, height=8)
                self.assertEqual(picker.pick_pixel(view, 8, 4).geometry.slot, geometry.slot)
                picture = picker.render(view)
                self.assertEqual(len(picture), 128)
                # Seen from five radii the ball is 3 pixels wide: it covers the centres of the middle four.
                self.assertEqual(sum(each.geometry.slot != 0 for each in picture), 4)

    def test_a_universe_closes_its_pickers_first(self):
        universe = abut.Universe()
        picker = abut.Picker(universe)
        universe.close()
        self.assertIsNone(picker._pointer)
        with self.assertRaisesRegex(ValueError, "this picker is closed"):
            picker.update()


if __name__ == "__main__":
    unittest.main()
