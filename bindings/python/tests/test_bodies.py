# SPDX-License-Identifier: Apache-2.0
"""Bodies that contacts push: the wrapper of the library for response."""

import pickle
import unittest

import abut

UP = (0, 0, 1)
FALLEN = 9.81 * 0.1 ** 2 / 2  # after ten steps


@unittest.skipUnless(abut.c.response, "no library for response")
class Bodies(unittest.TestCase):
    def setUp(self):
        self.universe = abut.Universe(tolerance_mode=abut.TOLERANCE_MARGIN)
        ground = self.universe.add_part(motion=abut.MOTION_STATIC)
        self.ground = self.universe.add_geometry(ground, abut.Shape.plane(UP, 0), tolerance=1e-3)
        self.part = self.universe.add_part(pose=abut.pose(0, 0, 2))
        self.geometry = self.universe.add_geometry(self.part, abut.Shape.sphere(0.5), tolerance=1e-3)
        self.response = abut.Response(self.universe)
        self.response.add_bodies([self.part], density=1000)

    def fall(self, steps, response=None):
        for _ in range(steps):
            (response or self.response).step(0.01)

    def height(self):
        return self.universe.pose(self.part).position.z

    def test_a_ball_falls_and_rests(self):
        mass = self.response.body(self.part).mass
        self.assertAlmostEqual(mass, abut.mass_properties(abut.Shape.sphere(0.5), 1000).mass)
        self.fall(10)
        self.assertAlmostEqual(self.height(), 2 - FALLEN, places=9)
        self.fall(290)
        self.assertAlmostEqual(self.height(), 0.5, delta=2e-3)
        contact, = self.response.contacts()
        self.assertAlmostEqual(abs(contact.force.z), mass * 9.81, delta=1e-3 * mass)
        self.assertEqual(len(self.response.objects()), 1)
        island, = self.response.islands()
        self.assertEqual((island.body_count, island.residuals.is_converged), (1, 1))
        self.assertAlmostEqual(self.response.energy().kinetic, 0, places=6)
        self.assertIn("bodies 1", self.response.explain())
        self.assertEqual(self.response.explain_json()["step"][0]["bodies"], 1)
        self.assertEqual(repr(self.response), "<Response of 1 bodies>")
        self.assertIsInstance(self.response.validate(), list)

    def test_bytes_give_the_same_bits(self):
        self.fall(70)
        universe, response = pickle.loads(pickle.dumps((self.universe, self.response)))
        self.assertEqual(response.hash(), self.response.hash())
        with self.assertRaisesRegex(abut.Error, "bytes"):
            abut.Response.load(self.universe, b"another thing")
        self.fall(20)
        self.fall(20, response)
        self.assertEqual((response.hash(), universe.hash()), (self.response.hash(), self.universe.hash()))
        self.assertEqual(bytes(universe.pose(self.part)), bytes(self.universe.pose(self.part)))

    def test_forces_and_links(self):
        weight = self.response.body(self.part).mass * 9.81
        self.response.apply_force(self.part, (0, 0, weight))
        self.response.apply_torque(self.part, (0, 0, 1))
        self.fall(1)
        self.assertAlmostEqual(self.height(), 2, places=12)
        link = self.response.add_link(b=self.part, point_a=(0, 0, 2), point_b=(0, 0, 2))
        self.fall(100)
        self.assertAlmostEqual(self.height(), 2, places=6)
        self.assertAlmostEqual(self.response.link_force(link).z, weight, places=3)
        self.response.move_link(link, (0, 0, 3))
        self.fall(200)
        self.assertAlmostEqual(self.height(), 3, places=6)
        self.response.remove_link(link)
        with self.assertRaisesRegex(abut.Error, "ABUT_STALE_ID"):
            self.response.link_force(link)
        self.response.remove_body(self.part)
        with self.assertRaisesRegex(abut.Error, "ABUT_STALE_ID"):
            self.response.body(self.part)

    def test_rules(self):
        self.assertIn("penalty", self.response.kinds())
        self.response.set_variable("stiffness", "1e6")
        self.assertEqual(self.response.add_rule(self.geometry, None, "penalty", "k=$stiffness$&d=1e3"), 0)
        self.assertIn("penalty", self.response.rule_between(self.geometry, self.ground))
        self.response.set_rule_parameters(0, "k=1e5&d=1e3")
        self.response.set_geometry_kind(self.geometry, "none")
        self.assertIn("none", self.response.rule_between(self.geometry, self.ground))
        self.response.clear_rules()
        self.fall(80)
        self.assertLess(self.height(), 0)
        with self.assertRaisesRegex(TypeError, "a rule speaks of a GeometryId"):
            self.response.add_rule("ball", None, "none")

    def test_callbacks(self):
        told, asked = [], []
        self.response.set_force_callback(lambda part, pose, velocity, time: ((0, 0, 2 * 9.81 * self.mass), (0, 0, 0)))
        self.mass = self.response.body(self.part).mass
        self.fall(10)
        # The field is taken at the start of each step of h: after n steps it lifts by a h^2 n (n + 1) / 2.
        self.assertAlmostEqual(self.height(), 2 - FALLEN + 2 * 9.81 * 1e-4 * 55, places=9)
        self.response.set_force_callback(None)
        self.response.set_listener(lambda each: told.append(each.event))
        self.fall(150)
        self.assertEqual(told[:2], [abut.RESPONSE_EVENT_BEGIN, abut.RESPONSE_EVENT_PERSIST])
        self.response.set_contact_callback(lambda contact, material: asked.append(contact.distance) or False)
        self.fall(50)
        self.assertLess(self.height(), 0)
        self.assertTrue(asked)
        self.response.set_contact_callback(None)

        def fail(_):
            raise KeyError("listener")

        self.response.set_listener(fail)
        with self.assertRaisesRegex(KeyError, "listener"):
            self.fall(1)

    def test_a_kind_of_ones_own(self):
        def law(contact, velocity, dt, out):
            out.friction_primary = out.friction_secondary = 0
            return True

        self.response.add_kind("ice", law)
        self.response.add_rule(None, None, "ice")
        self.fall(200)
        self.assertAlmostEqual(self.height(), 0.5, delta=2e-3)

    def test_particles(self):
        grains = self.universe.add_geometry(self.universe.add_part(), abut.Shape.particles([(5, 0, 1), (6, 0, 1)], 0.1))
        self.response.add_particles(grains, [1, 0], [(5, 0, 1), (6, 0, 1)])
        self.fall(10)
        xyz, velocities = self.response.particles(grains)
        self.assertAlmostEqual(xyz[0].z, 1 - FALLEN, places=9)
        self.assertEqual([*xyz[1], *velocities[1]], [6, 0, 1, 0, 0, 0])
        with self.assertRaisesRegex(ValueError, "masses has 1, xyz 2 and velocities 2"):
            self.response.add_particles(grains, [1], [(5, 0, 1), (6, 0, 1)])
        self.response.remove_particles(grains)

    def test_springs_and_tetrahedra(self):
        corners = [(0, 0, 5), (1, 0, 5), (0, 1, 5), (0, 0, 6)]
        soft = self.universe.add_geometry(self.universe.add_part(), abut.Shape.particles(corners, 0.1))
        self.response.add_particles(soft, [0, 1, 1, 1], corners)
        before = self.response.energy().potential
        self.response.add_springs(soft, [(0, 1), (0, 2)], 1e3, [1, 2], [0.5, 0.5])
        self.assertAlmostEqual(self.response.energy().potential - before, 2 * 0.5 * 1e3 * 0.25)
        self.response.add_tetrahedra(soft, [(0, 1, 2, 3)], young=1e4, damping=0.1)
        self.fall(10)
        self.assertEqual([*self.response.particles(soft)[0][0]], [0, 0, 5])
        with self.assertRaisesRegex(ValueError, "pairs has 1 and damping has 2"):
            self.response.add_springs(soft, [(0, 1)], 1, [1, 2])
        with self.assertRaisesRegex(abut.Error, "options.poisson is 0.5"):
            self.response.add_tetrahedra(soft, [(0, 1, 2, 3)], poisson=0.5)

    def test_a_mesh_follows_particles(self):
        corners = [(0, 0, 5), (1, 0, 5), (0, 1, 5), (0, 0, 6)]
        part = self.universe.add_part()
        soft = self.universe.add_geometry(part, abut.Shape.particles(corners, 0.1))
        skin = self.universe.add_geometry(part, abut.Shape.mesh(corners[:3], [0, 1, 2]))
        self.response.add_particles(soft, [1, 1, 1, 1], corners)
        self.response.map_vertices(skin, soft, [(0, 1, 2, 3)] * 3, [(0.25,) * 4, (0.5, 0.5, 0, 0), (0, 0, 0, 1)])
        self.fall(10)
        places = self.universe.vertices(skin)
        self.assertAlmostEqual(places[0].x, 0.25)
        self.assertAlmostEqual(places[2].z, 6 - FALLEN, places=9)
        with self.assertRaisesRegex(ValueError, "numbers has 1 and weights has 2"):
            self.response.map_vertices(skin, soft, [(0, 1, 2, 3)], [(0.25,) * 4] * 2)
        self.response.remove_particles(skin)

    def test_it_goes_with_its_universe(self):
        self.universe.close()
        with self.assertRaisesRegex(ValueError, "this response is closed"):
            self.fall(1)


@unittest.skipUnless(abut.c.response, "no library for response")
class Problems(unittest.TestCase):
    GIVEN = {"masses": [2], "inertias": [1, 0, 0, 0, 1, 0, 0, 0, 1], "centres": [(0, 0, 1)],
             "free_velocities": [(3, 0, -0.0981, 0, 0, 0)], "bodies": [(abut.NO_BODY, 0)], "points": [(0, 0, 0)],
             "normals": [(0, 0, 1)], "frictions": [(0.5, 0.5)]}

    def test_a_body_on_the_ground(self):
        velocities, impulses, residuals = abut.solve_contact_problem(**self.GIVEN)
        self.assertAlmostEqual(impulses[0].z, 0.1962)
        self.assertAlmostEqual(velocities[0].linear.z, 0)
        self.assertEqual(residuals.is_converged, 1)
        same = abut.solve_contact_problem({"most_rounds": 500}, **self.GIVEN, compliances=None)[1]
        self.assertEqual(bytes(same.memory), bytes(impulses.memory))

    def test_what_is_wrong_is_said(self):
        with self.assertRaisesRegex(ValueError, "bodies has 1 and points has 2"):
            abut.solve_contact_problem(**{**self.GIVEN, "points": [(0, 0, 0)] * 2})
        with self.assertRaisesRegex(TypeError, "a contact problem has no array weights; it has masses"):
            abut.solve_contact_problem(**self.GIVEN, weights=[1])
        with self.assertRaisesRegex(abut.Error, "normals"):
            abut.solve_contact_problem(**{**self.GIVEN, "normals": None})


if __name__ == "__main__":
    unittest.main()
