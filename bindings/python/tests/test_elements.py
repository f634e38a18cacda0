# SPDX-License-Identifier: Apache-2.0
"""Elements of meshes that deform."""

import unittest

import abut
from abut import c

# A vertex over the middle of a triangle, and the same sheet as one mesh.
GROUND = [-1, -1, 0, 2, -1, 0, -1, 2, 0]
TIP = [0, 0, 1, 0.2, 0, 2, 0, 0.2, 2]
BELOW = [0, 0, -0.5, 0.2, 0, 0.5, 0, 0.2, 0.5]
FACE = [0, 1, 2]


def elements(xyz):
    with abut.Shape.mesh(xyz, FACE) as shape:
        return abut.Elements(shape)


class Elements(unittest.TestCase):
    def setUp(self):
        self.tip, self.ground = elements(TIP), elements(GROUND)

    def test_counts(self):
        self.assertEqual(self.tip.count().faces, 1)
        self.assertEqual(self.tip.edges(), [(0, 1), (0, 2), (1, 2)])
        self.assertEqual(repr(self.tip), "<Elements of 3 vertices, 3 edges and 1 faces>")

    def test_closest(self):
        self.assertEqual(len(self.tip.closest(self.ground, reach=0.5)), 0)
        found = self.tip.closest(self.ground, reach=1)
        self.assertEqual(len(found), 1)
        self.assertEqual(found[0].kind, c.STENCIL_VERTEX_FACE)
        self.assertEqual(found[0].distance, 1)
        self.assertEqual(tuple(found[0].normal), (0, 0, -1))
        self.assertAlmostEqual(sum(found[0].weights), 0)
        self.assertEqual(len(self.tip.closest(reach=10)), 0, "a triangle with itself")
        self.assertEqual(len(self.tip.candidates(self.ground, reach=1)), 8)

    def test_first_touches(self):
        self.tip.set_vertices(TIP, BELOW)
        found = self.tip.first_touches(self.ground)
        self.assertEqual(len(found), 1)
        self.assertAlmostEqual(found[0].toi, 2 / 3, 8)
        self.assertEqual(len(self.ground.crossings(self.tip)), 0)
        self.tip.set_vertices(BELOW)
        self.assertEqual([(each.edge, each.face, each.edge_is_of_b) for each in self.ground.crossings(self.tip)],
                         [(0, 0, 1), (1, 0, 1)])

    def test_universe(self):
        with abut.Universe(tolerance_mode=c.TOLERANCE_MARGIN) as universe:
            universe.set_policy(0, 0, detail=c.DETAIL_ELEMENTS, tolerance=1.5, contact_distance=0.25)
            ids = []
            for xyz in (GROUND, TIP):
                with abut.Shape.mesh(xyz, FACE) as shape:
                    ids.append(universe.add_geometry(universe.add_part(), shape))
            universe.step(0)
            found = universe.element_contacts()
            self.assertEqual(len(found), 1)
            self.assertEqual((found[0].geometry_a, found[0].geometry_b), tuple(ids))
            self.assertEqual((found[0].stencil.distance, found[0].gap), (1, 0.75))
            self.assertEqual(universe.borrow_element_contacts()[0].id, found[0].id)
            self.assertEqual(len(universe.contacts()), 0)

    def test_next_vertices(self):
        with abut.Universe(tolerance_mode=c.TOLERANCE_MARGIN) as universe:
            universe.set_policy(0, 0, detail=c.DETAIL_ELEMENTS)
            with abut.Shape.mesh(GROUND, FACE) as ground, abut.Shape.mesh(TIP, FACE) as tip:
                universe.add_geometry(universe.add_part(), ground)
                moving = universe.add_geometry(universe.add_part(), tip, flags=c.GEOMETRY_FAST)
            universe.step(0.01)

            def write(xyz):
                memory = universe.next_vertices(moving).memory
                for i in range(3):
                    memory[i] = c.Vec3(*xyz[3 * i:3 * i + 3])

            write(BELOW)
            universe.step(0.01)
            self.assertEqual(len(universe.element_contacts()), 1)
            self.assertAlmostEqual(universe.element_contacts()[0].stencil.toi, 2 / 3, 8)
            self.assertEqual(universe.element_contacts()[0].age, 0)
            self.assertEqual(tuple(universe.vertices(moving)[0]), tuple(TIP[:3]))
            universe.advance(moving)
            self.assertEqual(tuple(universe.vertices(moving)[0]), tuple(BELOW[:3]))
            self.assertEqual(tuple(universe.next_vertices(moving)[0]), tuple(TIP[:3]))
            universe.advance([moving])
            self.assertEqual(tuple(universe.vertices(moving)[0]), tuple(TIP[:3]))
            with self.assertRaises(abut.Error):
                universe.advance(moving)

    def test_refuses(self):
        with self.assertRaises(abut.Error):
            self.tip.set_vertices(TIP[:6])
        with self.assertRaises(ValueError):
            self.tip.set_vertices(TIP, TIP[:6])
        with self.assertRaises(TypeError):
            self.tip.closest(far=1)
        with self.assertRaises(abut.Error):
            abut.Elements(abut.Shape.sphere(1))
        self.tip.close()
        with self.assertRaises(ValueError):
            self.tip.count()

    def test_arrays(self):
        try:
            import numpy
        except ImportError:
            self.skipTest("without NumPy")
        with abut.Universe() as universe, abut.Shape.mesh(TIP, FACE) as tip:
            moving = universe.add_geometry(universe.add_part(), tip)
            universe.next_vertices(moving).array[:] = numpy.array(BELOW, float).reshape(3, 3)
            universe.advance(moving)
            numpy.testing.assert_array_equal(universe.vertices(moving).array.ravel(), BELOW)
        self.tip.set_vertices(numpy.array(TIP, float).reshape(3, 3))
        found = self.tip.closest(self.ground, reach=1)
        self.assertEqual(found.weights.shape, (1, 4))
        places = numpy.concatenate([numpy.array(TIP, float).reshape(3, 3)[found.vertices[0, :1]],
                                    numpy.array(GROUND, float).reshape(3, 3)[found.vertices[0, 1:]]])
        numpy.testing.assert_allclose(found.weights[0] @ places, found.distance[0] * numpy.array([0, 0, -1]), atol=1e-15)


if __name__ == "__main__":
    unittest.main()
