# SPDX-License-Identifier: Apache-2.0
"""The scenes of examples/scenes, each with counts that follow from what it says.

usage: check_scenes.py ABUT DIRECT SCENES
"""

import collections
import json
import math

import program

MASK = (1 << 64) - 1


def splitmix(seed):
    """Numbers in [0, 1) by SplitMix64 (Steele, Lea and Flood 2014)."""
    while True:
        seed = (seed + 0x9E3779B97F4A7C15) & MASK
        z = seed
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        yield ((z ^ (z >> 31)) >> 11) * 2.0**-53


def pairs(contacts):
    return collections.Counter((c["part_a"], c["part_b"]) for c in contacts)


class Scenes(program.Case):
    def test_there_is_a_test_for_each_scene(self):
        names = {path.stem for path in program.SCENES.glob("*.json")}
        tested = {name.removeprefix("test_scene_") for name in dir(self) if name.startswith("test_scene_")}
        self.assertEqual(names, tested)

    def test_scene_stack(self):
        # A box stands on four corners, three times.
        contacts = self.contacts(program.SCENES / "stack.json")
        self.assertEqual(pairs(contacts), {("ground", "crate[0][0][0]"): 4,
                                           ("crate[0][0][0]", "crate[0][0][1]"): 4,
                                           ("crate[0][0][1]", "crate[0][0][2]"): 4})
        for contact in contacts:
            self.assertAlmostEqual(contact["distance"], -1e-4, delta=1e-12)
            self.assertEqual(contact["normal"], [0, 0, 1])

    def test_scene_tower(self):
        # At the end each box stands on four corners, and the ball rolls on the floor.
        contacts = [c for c in self.contacts(program.SCENES / "tower.json") if c["step"] == 400]
        self.assertEqual(pairs(contacts), {("floor", "box[0][0][0]"): 4, ("box[0][0][0]", "box[0][0][1]"): 4,
                                           ("box[0][0][1]", "box[0][0][2]"): 4, ("box[0][0][2]", "box[0][0][3]"): 4,
                                           ("floor", "ball"): 1})
        for contact in contacts:
            slop = 0 if contact["part_b"] == "ball" else 1e-5  # which boxes sank in by; the ball lay there from the start
            self.assertAlmostEqual(contact["distance"], -slop, delta=2e-6)

    def test_scene_grid(self):
        # Each ball touches the ground; 20 rows and 20 columns have 19 neighbours each. Diagonals are 1.4 apart.
        contacts = self.contacts(program.SCENES / "grid.json")
        on_ground = [c for c in contacts if c["part_a"] == "ground"]
        self.assertEqual(len(on_ground), 400)
        self.assertEqual(len(contacts) - len(on_ground), 2 * 20 * 19)
        self.assertTrue(all(math.isclose(c["distance"], -0.01, rel_tol=1e-9) for c in contacts))
        places = sorted((c["point_a"][0], c["point_a"][1]) for c in on_ground)
        self.assertAlmostEqual(places[0][0], -0.99 * 9.5)
        self.assertAlmostEqual(places[-1][1], 0.99 * 9.5)

    def test_scene_filters(self):
        contacts = self.contacts(program.SCENES / "filters.json")
        self.assertEqual(pairs(contacts), {("ground", "marble"): 1, ("ground", "wheel[0][0][0]"): 1,
                                           ("ground", "wheel[1][0][0]"): 1, ("ground", "coarse"): 1,
                                           ("door", "visitor"): 1})
        self.assertEqual([c["part_b"] for c in contacts if c["sensor"]], ["visitor"])
        marble = next(c for c in contacts if c["part_b"] == "marble")
        self.assertEqual((marble["material_a"], marble["material_b"]), ("stone", "glass"))

    def test_filters_without_what_keeps_pairs_apart(self):
        document = json.loads((program.SCENES / "filters.json").read_text())
        del document["rules"], document["policies"]
        for part in document["parts"]:
            for geometry in part["geometries"]:
                for field in ("mask", "exclusion", "parking"):
                    geometry.pop(field, None)
        self.assertEqual(pairs(self.contacts(self.scene(document))),
                         {("ground", "marble"): 1, ("ground", "ghost"): 1, ("twins[0][0][0]", "twins[1][0][0]"): 1,
                          ("cart", "trailer"): 4, ("ground", "wheel[0][0][0]"): 1, ("ground", "wheel[1][0][0]"): 1,
                          ("wheel[0][0][0]", "wheel[1][0][0]"): 1, ("door", "visitor"): 1, ("ground", "parked"): 1,
                          ("ground", "coarse"): 4})

    def test_a_focus_switches_what_slides_past_it(self):
        # The cube is at x = (step - 1) / 4 - 5, its nearer face |x| - 1 from the centre. It gets near below 1.1 and far
        # above 2.1: at x = -2 and x = 3.25.
        cube = {"kind": "box", "half": [1, 1, 1]}
        document = {
            "version": 1, "steps": 41, "dt": 0.25, "tags": {"near": 1, "far": 2},
            "focus": {"centres": [[90, 0, 0], [0, 0, 0]], "near_tag": "near", "far_tag": "far", "near_distance": 1.1,
                      "far_distance": 2.1},
            "policies": [{"tags": [0, "far"], "detail": "point", "period": 9}],
            "parts": [{"name": "slab", "motion": "static", "pose": {"position": [0, 0, -1]},
                       "geometries": [{"shape": {"kind": "box", "half": [20, 20, 1]}}]},
                      {"name": "cube", "pose": {"position": [-5, 0, 0.99]}, "script": {"velocity": [1, 0, 0]},
                       "geometries": [{"shape": cube, "tag": "far"}]}]}
        scene = self.scene(document)
        steps = collections.Counter(contact["step"] for contact in self.contacts(scene))
        self.assertEqual(steps, {step: 4 if -2 <= (step - 1) / 4 - 5 < 3.25 else 1 for step in range(1, 42)})
        plan = json.loads(self.succeed("explain", scene, "--json").stdout)
        self.assertEqual((plan["focus"]["near"], plan["focus"]["far"], plan["focus"]["centres"]), (0, 1, 2))

    def test_scene_motion(self):
        # The ball is at x = (step - 1) / 10 and touches the gate while 1.25 < x < 2.75. The paddle stands within
        # asin(0.3 / 1.5) = 11.5 degrees of the post at 0.9 s, 1.0 s and 1.1 s, and two seconds later again.
        events = self.events(program.SCENES / "motion.json")
        self.assertEqual([(e["step"], e["event"], e["part_a"], e["sensor"]) for e in events],
                         [(10, "begin", "paddle", False), (13, "end", "paddle", False),
                          (14, "begin", "gate", True), (29, "end", "gate", True),
                          (30, "begin", "paddle", False), (33, "end", "paddle", False)])
        contacts = self.contacts(program.SCENES / "motion.json")
        self.assertEqual(pairs(contacts), {("gate", "ball"): 15, ("paddle", "post"): 6})
        for contact in contacts:
            if contact["part_a"] == "paddle":
                time = (contact["step"] - 1) / 10 % 2
                weight = time if time <= 1 else 2 - time
                half = math.pi / 4  # of the quarter turn, which is blended along its chord
                turned = 2 * math.atan2(weight * math.sin(half), 1 - weight + weight * math.cos(half))
                self.assertAlmostEqual(contact["distance"], 1.5 * math.cos(turned) - 0.3, delta=1e-9)

    def test_scene_terrain(self):
        # The slopes are at 45 degrees: the middle of the ball is 0.7 / sqrt(2) from each.
        contacts = self.contacts(program.SCENES / "terrain.json")
        self.assertEqual(pairs(contacts), {("valley", "ball"): 2, ("mesh", "probe"): 1})
        for contact in contacts:
            expected = 0.7 / math.sqrt(2) - 0.5 if contact["part_a"] == "valley" else 0.4 - 0.5
            self.assertAlmostEqual(contact["distance"], expected, delta=1e-12)

    def test_scene_peg(self):
        # The peg in the hole has 0.05 around it. The other one stands 0.01 deep on four points.
        contacts = self.contacts(program.SCENES / "peg.json")
        self.assertEqual(pairs(contacts), {("plate", "standing"): 4})
        self.assertTrue(all(math.isclose(c["distance"], -0.01, rel_tol=1e-9) for c in contacts))

    def test_scene_fast(self):
        # The bullet has 4.89 to go; the plain one is as far away, and has no contact.
        contacts = self.contacts(program.SCENES / "fast.json")
        self.assertEqual(pairs(contacts), {("wall", "bullet"): 1})
        self.assertAlmostEqual(contacts[0]["distance"], 4.89, delta=1e-12)

    def test_scene_cloth(self):
        # The last file stays where the sequence is over, so its contact ages.
        contacts = self.contacts(program.SCENES / "cloth.json")
        self.assertEqual([(c["step"], c["age"]) for c in contacts], [(3, 0), (4, 1)])
        document = json.loads((program.SCENES / "cloth.json").read_text())
        sequence = document["parts"][0]["geometries"][0]["sequence"]
        sequence["files"] = [str(program.SCENES / file) for file in sequence["files"]]
        document["parts"][0]["geometries"][0]["shape"]["file"] = sequence["files"][0]
        sequence["repeat"] = True
        self.assertEqual([c["step"] for c in self.contacts(self.scene(document), "--steps", 6)], [3, 6])
        explained = self.succeed("explain", program.SCENES / "cloth.json", "--steps", 4).stdout
        self.assertIn("islands: 1 of 1 part", explained)
        self.assertIn("mesh - itself: 1 candidate, 1 examined", explained)

    def test_scene_table(self):
        # The ball overlaps the side of the table by 0.01. The sheet touches by elements only.
        self.assertEqual(pairs(self.contacts(program.SCENES / "table.json")), {("table", "ball"): 3})
        events = self.events(program.SCENES / "table.json")
        found = [(e["step"], e["event"], e["contacts"]) for e in events
                 if (e["part_a"], e["part_b"]) == ("cloth", "table") and e["of"] == "pair"]
        self.assertEqual(found, [(3, "begin", 0)])

    def test_scene_scatter(self):
        # Where the balls are, by the same generator written again; those nearer than two radii touch.
        numbers = splitmix(1)
        balls = [tuple(30 * next(numbers) for _ in range(3)) for _ in range(600)]
        near = {(f"ball[{i}]", f"ball[{j}]") for i in range(600) for j in range(i) if math.dist(balls[i], balls[j]) < 0.8}
        contacts = self.contacts(program.SCENES / "scatter.json", "--steps", 1)
        found = {pair for pair in pairs(contacts) if all(part.startswith("ball") for part in pair)}
        self.assertEqual({frozenset(pair) for pair in found}, {frozenset(pair) for pair in near})
        self.assertGreater(len(near), 5)
        for contact in contacts:
            for side in ("a", "b"):
                name = contact[f"part_{side}"]
                if name.startswith("ball"):
                    ball = balls[int(name[len("ball["):-1])]
                    self.assertGreater(math.dist(contact[f"point_{side}"], ball), 0.4 - 1e-9)
                    self.assertLess(math.dist(contact[f"point_{side}"], ball), 0.4 + 1e-9)

    def test_every_broad_phase_finds_the_same(self):
        document = json.loads((program.SCENES / "scatter.json").read_text())
        found = []
        for broadphase in ("auto", "brute", "tree", "sweep_and_prune", "hash_grid"):
            document["universe"]["broadphase"] = broadphase
            found.append(self.contacts(self.scene(document)))
        self.assertTrue(all(contacts == found[0] for contacts in found))


class Helpers(program.Case):
    """Details of the format, each against plain arithmetic."""

    def document(self, **fields):
        return {"version": 1, "parts": [{"name": "floor", "motion": "static", "geometries": [
            {"shape": {"kind": "plane", "normal": [0, 0, 1]}}]}], **fields}

    def lowest(self, shape, pose, local=None):
        """How deep a shape reaches below the plane z = 0."""
        document = self.document()
        document["parts"].append({"name": "body", "pose": pose, "geometries": [{"shape": shape, "pose": local or {}}]})
        contacts = self.contacts(self.scene(document))
        return min(c["distance"] for c in contacts) if contacts else None

    def test_an_axis_and_degrees_turn_counter_clockwise(self):
        box = {"kind": "box", "half": [1, 2, 3]}
        for axis, degrees, depth in (([1, 0, 0], 90, 2), ([0, 5, 0], 90, 1), ([1, 1, 0], 180, 3), ([0, 0, 1], 33, 3)):
            turned = self.lowest(box, {"axis": axis, "degrees": degrees})
            self.assertAlmostEqual(turned, -depth, delta=1e-15, msg=f"{axis} {degrees}")
        hull = {"kind": "hull", "points": [[1, 0, 0], [0, 0, 0], [0, 1, 0]]}
        # x goes to -z about +y, so the first corner goes down.
        for degrees in (1, 10, 29.5, 44.9, 45.1, 60, 89, 135):
            self.assertAlmostEqual(self.lowest(hull, {"axis": [0, 1, 0], "degrees": degrees}),
                                   -math.sin(math.radians(degrees)), delta=4e-16)
            # The other way round it goes up, and so does as much as 360 degrees less.
            self.assertAlmostEqual(self.lowest(hull, {"axis": [0, 1, 0], "degrees": degrees - 720}),
                                   -math.sin(math.radians(degrees)), delta=4e-15)

    def test_a_quaternion_is_w_x_y_z(self):
        s = math.sqrt(0.5)
        self.assertAlmostEqual(self.lowest({"kind": "box", "half": [1, 2, 3]}, {"quaternion": [s, s, 0, 0]}), -2, delta=1e-12)

    def test_the_pose_of_a_geometry_is_in_the_frame_of_its_part(self):
        depth = self.lowest({"kind": "sphere", "radius": 1}, {"position": [0, 0, 4], "axis": [0, 1, 0], "degrees": 90},
                            {"position": [3.5, 0, 0]})
        self.assertAlmostEqual(depth, -0.5, delta=1e-12)

    def test_tolerances_and_modes(self):
        shape = {"kind": "sphere", "radius": 1}
        document = self.document(universe={"tolerance_mode": "margin"})
        document["parts"].append({"name": "ball", "pose": {"position": [0, 0, 1.05]},
                                  "geometries": [{"shape": shape, "tolerance": 0.1}]})
        self.assertEqual(len(self.contacts(self.scene(document))), 1)
        document["universe"]["tolerance_mode"] = "dead_band"
        self.assertEqual(len(self.contacts(self.scene(document))), 0)

    def test_speculative_and_measured_velocities(self):
        ball = {"shape": {"kind": "sphere", "radius": 1}, "speculative": True}
        document = {"version": 1, "dt": 1, "steps": 3, "parts": [
            {"name": "a", "velocity": {"linear": [1, 0, 0]}, "geometries": [ball]},
            {"name": "b", "motion": "static", "pose": {"position": [2.5, 0, 0]}, "geometries": [{"shape": ball["shape"]}]}]}
        # Within one step the ball would go twice as far as the gap.
        self.assertEqual([c["distance"] for c in self.contacts(self.scene(document), "--steps", 1)], [0.5])
        del ball["speculative"]
        self.assertEqual(self.contacts(self.scene(document)), [])
        document["parts"][0]["script"] = {"velocity": [1, 0, 0]}
        for velocity, told in (("measured", "1 from poses"), ({"spin": {"axis": [0, 0, 2], "degrees_per_second": 90}}, "1 given")):
            document["parts"][0]["velocity"] = velocity
            self.assertIn(told, self.succeed("explain", self.scene(document), "--steps", 2).stdout)

    def test_caps_welds_and_sides(self):
        tile = {"shape": {"kind": "box", "half": [1, 1, 1]}}
        document = {"version": 1, "universe": {"max_contacts": 0}, "parts": [
            {"name": "a", "motion": "static", "pose": {"position": [0, 0, -1]}, "geometries": [tile]},
            {"name": "c", "motion": "static", "pose": {"position": [2, 0, -1]}, "geometries": [tile]},
            {"name": "b", "pose": {"position": [0.505, 0, 0.49]},
             "geometries": [{"shape": {"kind": "box", "half": [0.5, 0.5, 0.5]}}]}]}
        many = self.contacts(self.scene(document))
        document["universe"]["max_pair_contacts"] = 1
        self.assertEqual(set(pairs(self.contacts(self.scene(document))).values()), {1})
        document["universe"] = {"max_contacts": 0, "welds": True}
        welded = self.contacts(self.scene(document))
        # Beside each other the tiles have no side that pushes along x.
        self.assertIn(1, {abs(c["normal"][0]) for c in many})
        self.assertEqual({abs(c["normal"][2]) for c in welded}, {1})
        sheet = {"kind": "mesh", "vertices": [[-9, -9, 0], [9, -9, 0], [0, 9, 0]], "triangles": [[0, 1, 2]]}
        low = {"version": 1, "dt": 1, "steps": 2, "parts": [
            {"name": "sheet", "motion": "static", "geometries": [{"shape": sheet, "keeps_side": True}]},
            {"name": "ball", "pose": {"position": [0, 0, 0.95]}, "script": {"velocity": [0, 0, -1.5]},
             "geometries": [{"shape": {"kind": "sphere", "radius": 1}}]}]}
        # From above at first; the centre has passed the sheet at the second step.
        self.assertAlmostEqual(self.contacts(self.scene(low))[-1]["distance"], -1.55, delta=1e-9)
        low["parts"][0]["geometries"][0]["keeps_side"] = False
        self.assertAlmostEqual(self.contacts(self.scene(low))[-1]["distance"], -0.45, delta=1e-9)

    def test_distance_fields(self):
        corners = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
        faces = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "3 4 8 7", "1 3 7 5", "2 6 8 4"]
        (self.folder / "box.obj").write_text("".join(f"v {x} {y} {z}\n" for x, y, z in corners) +
                                             "".join(f"f {face}\n" for face in faces))
        self.assertAlmostEqual(self.lowest({"kind": "distance_field", "file": "box.obj", "spacing": 0.1}, {}), -1, delta=1e-9)
        reals = [max(abs(x - 1), abs(y - 1), abs(z - 1)) - 0.5 for z in range(3) for y in range(3) for x in range(3)]
        samples = {"kind": "distance_field", "columns": 3, "rows": 3, "layers": 3, "spacing": [1, 1, 1],
                   "origin": [-1, -1, -1], "is_inside_out": False, "reals": reals}
        document = self.document()
        document["parts"] = [{"name": "field", "motion": "static", "geometries": [{"shape": samples}]},
                             {"name": "ball", "pose": {"position": [0, 0, 0.7]}, "geometries": [
                                 {"shape": {"kind": "sphere", "radius": 0.25}}]}]
        self.assertAlmostEqual(self.contacts(self.scene(document))[0]["distance"], -0.05, delta=1e-9)

    def test_arrays_of_shapes(self):
        (self.folder / "points.txt").write_text("0 0 -1, 1 0 0\n-1 0 0 0 1 0")
        (self.folder / "grey.pgm").write_bytes(b"P5\n# two by three\n2 3\n255\n" + bytes([9, 9, 1, 1, 1, 1]))
        points = {"kind": "hull", "file": "points.txt", "scale": 2}
        self.assertAlmostEqual(self.lowest(points, {}), -2, delta=1e-12)
        particles = {"kind": "particles", "centres": [[0, 0, 0, 0.5], [0, 0, -1, 0.25]]}
        self.assertAlmostEqual(self.lowest(particles, {}), -1.25, delta=1e-12)
        field = {"kind": "height_field", "file": "grey.pgm", "spacing_x": 1, "spacing_y": 1}
        document = {"version": 1, "shapes": {"ball": {"kind": "sphere", "radius": 1}}, "parts": [
            {"name": "land", "motion": "static", "geometries": [{"shape": field}]},
            {"name": "low", "pose": {"position": [0.5, 0.05, 1.9]}, "geometries": [{"shape": "ball"}]}]}
        # The last row of the picture, which is dark, is at y = 0.
        self.assertAlmostEqual(min(c["distance"] for c in self.contacts(self.scene(document))), -0.1, delta=1e-12)

    def test_a_rule_names_all_copies_or_one(self):
        document = self.document()
        document["parts"].append({"name": "ball", "pose": {"position": [0, 0, 0.4]},
                                  "grid": {"count": [3, 1, 1], "spacing": [10, 0, 0]},
                                  "geometries": [{"shape": {"kind": "sphere", "radius": 0.5}}]})
        for name, count in (("ball", 0), ("ball[1][0][0]", 2)):
            document["rules"] = [{"a": {"part": "floor"}, "b": {"part": name}, "rule": "disable"}]
            self.assertEqual(len(self.contacts(self.scene(document))), count)
        document["rules"] = [{"a": "any", "b": "any", "rule": "disable"},
                             {"a": {"part": "floor", "geometry": "0"}, "b": {"part": "ball[2][0][0]"}, "rule": "enable"}]
        self.assertEqual([c["part_b"] for c in self.contacts(self.scene(document))], ["ball[2][0][0]"])


if __name__ == "__main__":
    program.main()
