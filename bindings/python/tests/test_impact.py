# SPDX-License-Identifier: Apache-2.0
"""Shapes that move and turn, one pair and many."""

import unittest

import abut


class Impact(unittest.TestCase):
    def setUp(self):
        self.box = abut.Shape.box(1, 1, 1)
        self.towards = abut.movement(velocity=(-6, 0, 0))

    def test_tells_when_two_shapes_touch(self):
        found = abut.pair_time_of_impact(self.box, abut.pose(), abut.movement(), self.box, abut.pose(5), self.towards)
        self.assertEqual(found.state, abut.c.IMPACT_TOUCHES)
        self.assertAlmostEqual(found.upper, 0.5)
        self.assertAlmostEqual(found.contact.normal.x, 1)
        near = abut.pair_time_of_impact(self.box, abut.pose(), [0] * 15, self.box, abut.pose(5), self.towards,
                                        margin=0.6)
        self.assertAlmostEqual(near.upper, 0.4)

    def test_tells_those_of_many(self):
        found = abut.pairs_time_of_impact(self.box, abut.pose(), abut.movement(), self.box,
                                          [abut.pose(5), abut.pose(0, 9), abut.pose(3)], self.towards, 2.0)
        self.assertEqual([each.state for each in found],
                         [abut.c.IMPACT_TOUCHES, abut.c.IMPACT_APART, abut.c.IMPACT_TOUCHES])
        self.assertAlmostEqual(found[2].upper, 1 / 6)

    def test_makes_a_movement_of_two_poses(self):
        made = abut.movement_between(abut.pose(), abut.pose(5), 0.5)
        self.assertEqual((made.velocity.x, made.angular_velocity.x), (10, 0))

    def test_tells_what_a_shape_meets_in_a_universe(self):
        universe = abut.Universe()
        posts = [universe.add_geometry(universe.add_part(pose=abut.pose(x)), self.box) for x in (5, 9)]
        universe.refresh()
        away = abut.movement(velocity=(10, 0, 0), angular_velocity=(3, 0, 0))
        ball = abut.Shape.sphere(1)
        hits = universe.cast_movement(ball, abut.pose(), away, mode=abut.c.HIT_ALL)
        self.assertEqual([each.geometry for each in hits], posts)
        self.assertAlmostEqual(hits[0].impact.upper, 0.3)
        near = universe.cast_movement(ball, abut.pose(), away, options={"margin": 1})
        self.assertAlmostEqual(near[0].impact.upper, 0.2)
        each = universe.cast_movements(ball, [abut.pose(), abut.pose(0, 9)], away)
        self.assertAlmostEqual(each[0].impact.upper, 0.3)
        self.assertEqual(each[1].geometry.slot, 0)

    def test_refuses_what_is_no_movement(self):
        with self.assertRaisesRegex(abut.Error, "movement_b.revolutions is"):
            abut.pair_time_of_impact(self.box, abut.pose(), abut.movement(), self.box, abut.pose(5),
                                     abut.movement(angular_velocity=(0, 0, 200)))
        with self.assertRaisesRegex(TypeError, "ImpactOptions has no field rounds"):
            abut.pair_time_of_impact(self.box, abut.pose(), abut.movement(), self.box, abut.pose(5), self.towards,
                                     rounds=1)


if __name__ == "__main__":
    unittest.main()
