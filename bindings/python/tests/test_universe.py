# SPDX-License-Identifier: Apache-2.0
"""Universes and picking, without arrays."""

import unittest

import abut
from abut import c


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

    def test_welds(self):
        for flags, normals in ((0, {(0, 0, 1), (-1, 0, 0)}), (abut.UNIVERSE_WELDS, {(0, 0, 1)})):
            with abut.Universe(flags=flags) as universe, abut.Shape.box(1, 1, 1) as tile, \
                    abut.Shape.box(0.5, 0.5, 0.5) as box:
                for x in (0, 2):
                    universe.add_geometry(universe.add_part(pose=abut.pose(x, 0, -1), motion=abut.MOTION_STATIC), tile)
                universe.add_geometry(universe.add_part(pose=abut.pose(0.505, 0, 0.49)), box)
                universe.step()
                found = universe.contacts()
                self.assertEqual({(round(each.normal.x), round(each.normal.y), round(each.normal.z))
                                  for each in found}, normals)

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
        self.universe.set_rule(self.parts[1], 0, abut.RULE_ENABLE)
        self.universe.set_rule(None, None, abut.RULE_DISABLE)
        self.universe.step()
        a, b, last = self.geometries
        self.assertEqual(self.universe.why_apart(a, b), set())
        self.assertEqual(self.universe.why_apart(b, last), {"rule"})
        self.assertEqual(self.universe.why_apart(a, last), {"rule", "boxes"})
        self.assertEqual(self.universe.rule_between(a, b), (abut.RULE_ENABLE, 0, self.parts[1]))
        self.assertEqual(self.universe.rule_between(b, last), (abut.RULE_DISABLE, None, None))
        self.universe.clear_rules()
        self.assertEqual(self.universe.rule_between(a, b), (abut.RULE_NONE, None, None))
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

    def test_user_data(self):
        self.universe.set_user_data(self.parts, [4, 5, 6])
        self.universe.set_geometry_user_data(self.geometries, 2**64 - 1)
        self.assertEqual([self.universe.user_data(part) for part in self.parts], [4, 5, 6])
        self.assertEqual(self.universe.describe(self.geometries[1]).user_data, 2**64 - 1)

    def test_save_and_load(self):
        self.universe.step()
        data = self.universe.save()
        with abut.Universe.load(data) as other:
            other.step()
            self.universe.step()
            self.assertEqual(other.hash(), self.universe.hash())
            self.assertEqual(list(other.parts()), list(self.universe.parts()))
        with self.assertRaises(abut.Error):
            abut.Universe.load(data[:-1])

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

    def test_what_has_changed(self):
        with abut.Universe() as universe, abut.Shape.sphere(1) as ball:
            parts = [universe.add_part() for _ in range(3)]
            geometries = [universe.add_geometry(part, ball) for part in parts]
            since = universe.revision()
            self.assertEqual(list(universe.changes(since)), [])
            universe.set_pose(parts[1], abut.pose(5, 0, 0))
            self.assertEqual(list(universe.changes(since)), [geometries[1]])
            universe.destroy_geometries([geometries[0]])
            gone, moved = universe.changes(since)
            self.assertEqual((gone.slot, gone.generation, moved), (geometries[0].slot, 0, geometries[1]))
            for x in range(600):
                universe.change(geometries[2], label=x)
            self.assertIsNone(universe.changes(since))


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
                along = abut.camera_ray(view, 8, 4)
                self.assertEqual(picker.cast_ray(along).geometry.slot, geometry.slot)
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
