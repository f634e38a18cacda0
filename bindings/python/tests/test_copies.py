# SPDX-License-Identifier: Apache-2.0
"""What copy, pickle and multiprocessing make of shapes, universes and pickers, and who goes first when all go."""

import copy
import gc
import multiprocessing
import os
import pickle
import subprocess
import sys
import unittest

import abut
from abut import c

CUBE = ([x for i in range(8) for x in ((i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2 & 1) * 2 - 1)],
        [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5])


def made_shapes():
    """A shape of every kind."""
    ball = abut.Shape.sphere(0.7)
    drilled = abut.Shape.composite([abut.Shape.box(1, 1, 1), abut.Shape.cylinder_hole(0.3, 2)],
                                   [abut.pose(), abut.pose(0.1)], materials=[3, 4])
    return [
        ball, abut.Shape.box(1, 2, 3), abut.Shape.capsule(0.5, 1), abut.Shape.cylinder(0.5, 1), abut.Shape.cone(0.5, 1),
        abut.Shape.ellipsoid(1, 2, 3), abut.Shape.point(), abut.Shape.segment(2),
        abut.Shape.triangle((0, 0, 0), (1, 0, 0), (0, 1, 0)), abut.Shape.plane((0, 0, 1), 0.25),
        abut.Shape.hull(CUBE[0]), abut.Shape.mesh(*CUBE, sides="solid"), abut.Shape.uv_grid(*CUBE),
        abut.Shape.height_field(3, 2, [0, 1, 2, 3, float("nan"), 5], solid_below=True),
        abut.Shape.distance_field([[[-1, 1], [1, 1]], [[1, 1], [1, 2]]], 0.5),
        abut.Shape.particles([0, 0, 0, 1, 0, 0], 0.1), drilled, abut.Shape.composite([ball, drilled], [abut.pose()] * 2),
        abut.Shape.sphere_hole(1), abut.Shape.box_hole(1, 2, 3), abut.Shape.cylinder_hole(0.5, 1, c.OPEN_TOP),
    ]


def described(shape):
    """All that can be asked of a shape."""
    box = shape.aabb(abut.pose(0.1, 0.2, 0.3, (0.8, 0, 0.6, 0)))
    said = [shape.kind, shape.parameters, bytes(box)]
    try:
        xyz, triangles = shape.triangles()
    except abut.Error:
        return said
    return [*said, bytes(xyz), bytes(triangles)]


def width_of(shape):
    """For a worker."""
    box = shape.aabb()
    return box.maximum.x - box.minimum.x


class Copies(unittest.TestCase):
    def assert_alike(self, shape, copied):
        self.assertIs(type(copied), abut.Shape)
        self.assertNotEqual(copied.pointer.value, None)
        self.assertEqual(described(copied), described(shape))

    def test_shapes_of_every_kind(self):
        shapes = made_shapes()
        self.assertEqual({shape.kind for shape in shapes}, set(abut.shape_kinds()))
        for shape in shapes:
            for made in (copy.copy, copy.deepcopy, lambda its: pickle.loads(pickle.dumps(its))):
                with self.subTest(shape.kind):
                    copied = made(shape)
                    self.assert_alike(shape, copied)
                    copied.close()
            with self.assertRaises(ValueError):
                copied.kind
            self.assertEqual(shape.kind, described(shape)[0])

    def test_a_copy_is_there_without_its_shape(self):
        shape = abut.Shape.mesh(*CUBE)
        expected = described(shape)
        copies = [copy.copy(shape), copy.deepcopy([shape, shape])]
        shape.close()
        self.assertEqual(described(copies[0]), expected)
        self.assertIs(copies[1][0], copies[1][1])
        self.assertEqual(described(copies[1][0]), expected)
        for made in (copy.copy, copy.deepcopy, pickle.dumps):
            with self.assertRaisesRegex(ValueError, "this shape is closed"):
                made(shape)

    def test_multiprocessing(self):
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            self.assertEqual(pool.map(width_of, [abut.Shape.box(1, 2, 3), abut.Shape.sphere(3)]), [2, 6])

    def test_other_bytes_are_refused(self):
        with abut.Universe() as empty:
            made, (kind, data) = abut.Shape.sphere(1).__reduce_ex__(2)
            with self.assertRaisesRegex(ValueError, "a universe of 0 geometries; they must be those of a Shape"):
                made(kind, empty.save())
        for wrong, why in ((b"", "bytes"), (b"another thing", "bytes"), (data[:-1], "bytes"),
                           (data[:60] + bytes([data[60] ^ 1]) + data[61:], "bytes")):
            for load in (lambda: made(kind, wrong), lambda: abut.Universe.load(wrong)):
                with self.subTest(len(wrong)), self.assertRaisesRegex(abut.Error, why):
                    load()

    def test_inputs_and_answers(self):
        ball, there = abut.Shape.sphere(1), abut.poses([(3, 0, 0), (1, 0, 0)])
        found = abut.pairs_distance(ball, abut.pose(), ball, there)
        asked = [abut.pose(1, 2, 3), abut.ray((0, 0, 0), (1, 0, 0)), abut.movement((1, 2, 3)), there, found, found[0],
                 abut.PairMemory(), c.QueryOptions(1, 2), c.QueryFilter(3), c.GeometryId(4, 5),
                 abut.pair_time_of_impact(ball, abut.pose(), abut.movement(), ball, there[0], abut.movement((-5, 0, 0)))]
        for before, after in zip(asked, pickle.loads(pickle.dumps(asked))):
            self.assertIs(type(after), type(before))
            memory = (before.memory, after.memory) if hasattr(before, "memory") else (before, after)
            self.assertEqual(bytes(memory[0]), bytes(memory[1]))
        overlap = abut.pairs_overlap(ball, abut.pose(), ball, there)
        self.assertEqual(pickle.loads(pickle.dumps(overlap)), overlap)
        contacts = pickle.loads(pickle.dumps(abut.pairs_contacts(ball, abut.pose(), ball, there)))
        self.assertEqual([len(group) for group in contacts], [0, 1])

    def test_universes(self):
        with abut.Universe() as universe, abut.Shape.sphere(1) as ball:
            parts = [universe.add_part(pose=abut.pose(x=1.5 * i), user_data=i) for i in range(3)]
            for part in parts:
                universe.add_geometry(part, ball)
            universe.step()
            for made in (copy.copy, copy.deepcopy, lambda its: pickle.loads(pickle.dumps(its))):
                with made(universe) as copied:
                    self.assertEqual(copied.hash(), universe.hash())
                    copied.set_poses(parts[:1], [abut.pose(-9)])
                    copied.step()
                    self.assertEqual((len(copied.contacts()), len(universe.contacts())), (1, 2))

    @unittest.skipUnless(abut.c.picking, "no library for picking")
    def test_pickers_refuse(self):
        with abut.Universe() as universe, abut.Picker(universe) as picker:
            for made in (copy.copy, copy.deepcopy, pickle.dumps):
                with self.assertRaisesRegex(TypeError, "a Picker cannot be copied or pickled"):
                    made(picker)


# In a process of its own, which a failure would end.
_CYCLES = """
import gc, random
import abut

class Viewer:
    pass

random.seed({seed})
for _ in range(50):
    viewer = Viewer()
    names = ["universe", "picker", "viewer", "other"]
    universe = abut.Universe()
    with abut.Shape.sphere(1) as ball:
        universe.add_geometry(universe.add_part(), ball)
    its = {{"universe": universe, "picker": abut.Picker(universe), "viewer": viewer, "other": abut.Picker(universe)}}
    assert its["picker"].cast_ray(abut.ray((-5, 0, 0), (1, 0, 0))).distance == 4
    random.shuffle(names)
    for name in names:
        setattr(viewer, name, its[name])
    del viewer, universe, its
    gc.collect()
"""


@unittest.skipUnless(abut.c.picking, "no library for picking")
class Collected(unittest.TestCase):
    def test_in_any_order(self):
        seed = int.from_bytes(os.urandom(4), "little")
        done = subprocess.run([sys.executable, "-B", "-c", _CYCLES.format(seed=seed)], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""), f"seed {seed}")

    def test_a_picker_outlives_the_pointer_of_its_universe(self):
        universe = abut.Universe()
        picker = abut.Picker(universe)
        pointer, universe._pointer = universe._pointer, None
        abut.c.library.abut_universe_destroy(pointer)
        picker.close()
        gc.collect()


if __name__ == "__main__":
    unittest.main()
