# SPDX-License-Identifier: Apache-2.0
"""The contacts in the picture of docs/deformables.md are those that abut finds."""

import collections
import unittest

import abut
import elements

OF_KIND = {abut.c.STENCIL_VERTEX_FACE: 0, abut.c.STENCIL_EDGE_EDGE: 1, abut.c.STENCIL_VERTEX_EDGE: 2,
           abut.c.STENCIL_VERTEX_VERTEX: 3}


def elements_of(places, faces):
    with abut.Shape.mesh([x for place in places for x in place], [k for face in faces for k in face]) as mesh:
        return abut.Elements(mesh)


def key(stencil):
    """The vertices of both features."""
    used = [(k, i < stencil.of_a) for i, (k, weight) in enumerate(zip(stencil.vertices, stencil.weights)) if weight != 0]
    return tuple(tuple(sorted(k for k, is_of_a in used if is_of_a == side)) for side in (True, False))


class ElementsTest(unittest.TestCase):
    def test_the_contacts_that_are_drawn_are_those_of_abut(self):
        a, b = elements_of(*elements.sheet()), elements_of(*elements.ball())
        found = list(a.closest(b, reach=elements.REACH))
        drawn = elements.contacts()
        self.assertEqual(sorted(key(its) for its in found), sorted(its[1:3] for its in drawn))
        self.assertEqual(collections.Counter(OF_KIND[its.kind] for its in found),
                         collections.Counter(elements.kind_of(its) for its in drawn))
        of_drawn = {its[1:3]: its[0] for its in drawn}
        for its in found:
            self.assertAlmostEqual(its.distance, of_drawn[key(its)], delta=1e-12)


if __name__ == "__main__":
    unittest.main()
