# SPDX-License-Identifier: Apache-2.0
"""What the program says about pairs: why they touch or not, how far they are apart, and what kinds meet.

usage: check_queries.py ABUT DIRECT SCENES
"""

import json

import program
from program import run

BALL = {"kind": "sphere", "radius": 1}

# Two balls that overlap by 0.5; each entry changes something of the scene or of the second part.
APART = {
    "": {},
    "motion": {"motions": ("static", "animated")},
    "parking": {"geometry": {"parking": "short_term"}},
    "exclusion": {"both": {"exclusion": [3]}},
    "layers": {"geometry": {"mask": [5]}},
    "rules": {"rules": [{"a": "any", "b": {"part": "b"}, "rule": "disable"}]},
    "distance": {"pose": {"position": [2.5, 0, 0]}},
    "kinds": {"shape": {"kind": "sphere_hole", "radius": 1}},
}


def scene_of(motions=("dynamic", "dynamic"), geometry=None, both=None, rules=(), pose=None, shape=None):
    return {"version": 1, "layers": {"thing": 0, "none": 5}, "rules": list(rules), "parts": [
        {"name": "a", "motion": motions[0], "geometries": [{"shape": shape or BALL, **(both or {})}]},
        {"name": "b", "motion": motions[1], "pose": pose or {"position": [1.5, 0, 0]},
         "geometries": [{"shape": shape or BALL, **(both or {}), **(geometry or {})}]}]}


class Check(program.Case):
    def why(self, document, a="a", b="b", *arguments):
        found = json.loads(self.succeed("check", self.scene(document), a, b, "--json", *arguments).stdout)
        self.assertEqual(len(found), 1)
        return found[0]

    def test_each_filter_is_named(self):
        for expected, change in APART.items():
            with self.subTest(expected=expected):
                found = self.why(scene_of(**change))
                self.assertEqual(found["stopped_by"] or "", expected)
                self.assertEqual((found["touch"], found["contacts"]), (not expected, 0 if expected else 1))
                self.assertEqual([a["name"] for a in found["answers"] if not a["yes"]][:1], [expected] if expected else [])
                contacts = self.contacts(self.scene(scene_of(**change)))
                self.assertEqual(len(contacts), found["contacts"])

    def test_two_geometries_of_one_part_never_meet(self):
        document = scene_of()
        document["parts"][0]["geometries"].append({"shape": BALL, "name": "twin"})
        self.assertEqual(self.why(document, "a/0", "a/twin")["stopped_by"], "parts")

    def test_the_text_says_why(self):
        scene = program.SCENES / "filters.json"
        for a, b, words in (
            ("ground", "ghost", ("do not touch at step 1: layers", "the mask of ghost/0 is thing; the layers of ground/0 are ground")),
            ("cart", "trailer", ("do not touch at step 1: rules", "rules[0] disables them")),
            ("twins[0][0][0]", "twins[1][0][0]", ("exclusion NO   they have in common: twins",)),
            ("ground", "parked", ("parking   NO   parked/0 is parked",)),
            ("ground", "door/light", ("motion    NO   ground is static and door is animated; one of them must be dynamic",)),
            ("door", "visitor", ("touch at step 1: 1 contact\n", "distance  yes")),
        ):
            with self.subTest(a=a, b=b):
                text = self.succeed("check", scene, a, b).stdout
                for word in words:
                    self.assertIn(word, text)

    def test_a_hole_is_named(self):
        found = self.why(json.loads((program.SCENES / "peg.json").read_text()), "plate", "free")
        self.assertEqual(found["stopped_by"], "holes")
        self.assertEqual(found["answers"][-1]["says"], "without holes their distance would be -1.2")
        self.assertTrue(self.why(json.loads((program.SCENES / "peg.json").read_text()), "plate", "standing")["touch"])

    def test_the_back_of_a_surface_is_named(self):
        for shape in ({"kind": "mesh", "sides": 1, "vertices": [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]],
                       "triangles": [[0, 1, 2], [0, 2, 3]]},
                      {"kind": "height_field", "spacing_x": 1, "spacing_y": 1, "heights": [[0, 0, 0]] * 3}):
            for height, stopped_by in ((0.5, None), (-0.5, "side"), (-1.5, "distance")):
                with self.subTest(kind=shape["kind"], height=height):
                    document = scene_of(motions=("static", "dynamic"), pose={"position": [0.9, 0.8, height]})
                    document["parts"][0]["geometries"][0]["shape"] = shape
                    found = self.why(document)
                    self.assertEqual((found["touch"], found["stopped_by"] or None), (stopped_by is None, stopped_by))
                    if stopped_by == "side":
                        self.assertIn("from the back", found["answers"][-1]["says"])

    def test_tolerances_and_modes_count(self):
        document = scene_of(geometry={"tolerance": 0.6})
        self.assertEqual(self.why(document)["stopped_by"], "distance")
        document["universe"] = {"tolerance_mode": "margin"}
        document["parts"][1]["pose"] = {"position": [2.5, 0, 0]}
        self.assertTrue(self.why(document)["touch"])
        document["policies"] = [{"tags": [0, 0], "tolerance": 0.1}]
        self.assertEqual(self.why(document)["stopped_by"], "distance")

    def test_a_policy_that_asks_about_boxes(self):
        document = scene_of(pose={"position": [1.5, 1.5, 0]})
        document["policies"] = [{"tags": [0, 0], "detail": "box"}]
        found = self.why(document)
        self.assertEqual((found["touch"], found["contacts"], found["answers"][-1]["name"]), (True, 0, "boxes"))
        document["parts"][1]["pose"]["position"][1] = 2.5
        self.assertEqual(self.why(document)["stopped_by"], "boxes")

    def test_parts_of_several_geometries_give_each_pair(self):
        document = scene_of()
        document["parts"][0]["geometries"].append({"shape": BALL})
        found = json.loads(self.succeed("check", self.scene(document), "a", "b", "--json").stdout)
        self.assertEqual([(f["a"], f["b"]) for f in found], [("a/0", "b/0"), ("a/1", "b/0")])

    def test_a_later_step_is_looked_at(self):
        document = scene_of(pose={"position": [4, 0, 0]})
        document["parts"][1]["script"] = {"velocity": [-1, 0, 0]}
        document["dt"] = 1
        self.assertFalse(self.why(document)["touch"])
        self.assertTrue(self.why(document, "a", "b", "--steps", 4)["touch"])

    def test_what_is_odd_has_its_own_status(self):
        scene = program.SCENES / "filters.json"
        self.assertIn("nothing odd was found", self.succeed("check", scene).stdout)
        self.assertEqual(json.loads(self.succeed("check", scene, "--json").stdout)["findings"], [])
        result = run("check", self.scene(scene_of(geometry={"mask": []})), "--json")
        self.assertEqual(result.returncode, 4)
        finding, = json.loads(result.stdout)["findings"]
        self.assertEqual(finding["a"], "b/0")
        result = run("check", self.scene(scene_of(motions=("static", "static"))))
        self.assertEqual(result.returncode, 4)
        self.assertIn("odd: ", result.stdout)


class Rules(program.Case):
    def test_the_most_specific_rule_is_found(self):
        # Every mixture of rules on every level of both sides: what check says must be what the universe does.
        sides = ({"part": "a", "geometry": "0"}, {"part": "a"}, {"label": 7}, "any")
        others = ({"part": "b", "geometry": "0"}, {"part": "b"}, {"label": 8}, "any")
        document = scene_of()
        document["parts"][0]["geometries"][0]["label"] = 7
        document["parts"][1]["geometries"][0]["label"] = 8
        for i, first in enumerate(sides):
            for j, second in enumerate(others):
                document["rules"] = [{"a": first, "b": others[3 - i], "rule": "disable"},
                                     {"a": second, "b": sides[3 - j], "rule": "enable"},
                                     {"a": sides[j], "b": others[i], "rule": "disable"}]
                found, = json.loads(self.succeed("check", self.scene(document), "a", "b", "--json").stdout)
                with self.subTest(rules=document["rules"]):
                    self.assertEqual(found["stopped_by"], None if self.contacts(self.scene(document)) else "rules")


class Distance(program.Case):
    BOX = {"shape": {"kind": "box", "half": [1, 1, 1]}, "pose": {"position": [0, 0, 3]}}

    def test_two_shapes_without_a_scene(self):
        found = json.loads(self.succeed("distance", json.dumps(BALL), json.dumps(self.BOX), "--json").stdout)
        self.assertEqual((found["distance"], found["point_a"], found["normal"]), (1, [0, 0, 1], [0, 0, 1]))
        self.assertLessEqual(found["lower"], 1)
        self.assertGreaterEqual(found["upper"], 1)
        text = self.succeed("distance", json.dumps(BALL), json.dumps(self.BOX)).stdout
        for word in ("A (sphere) and B (box)", "distance    1\n", "point of B  [0, 0, 2]", "found by    analytic"):
            self.assertIn(word, text)

    def test_a_peg_has_the_clearance_of_its_hole(self):
        found = json.loads(self.succeed("distance", program.SCENES / "peg.json", "plate", "free", "--json").stdout)
        self.assertAlmostEqual(found["distance"], 0.05, 12)
        self.assertAlmostEqual(found["upper"], 0.05, 12)

    def test_what_holes_leave_is_told(self):
        nothing = json.dumps({"shape": {"kind": "composite", "children": [
            {"shape": {"kind": "box", "half": [1, 1, 1]}}, {"shape": {"kind": "box_hole", "half": [2, 2, 2]}}]}})
        text = self.succeed("distance", nothing, json.dumps(BALL)).stdout
        self.assertIn("inf], as holes have left nothing to be met", text)
        self.assertIsNone(json.loads(self.succeed("distance", nothing, json.dumps(BALL), "--json").stdout)["upper"])

    def test_two_parts_have_the_least_distance_of_their_geometries(self):
        document = scene_of(pose={"position": [9, 0, 0]})
        document["parts"][1]["geometries"].append({"shape": BALL, "name": "near", "pose": {"position": [-4, 0, 0]}})
        found = json.loads(self.succeed("distance", self.scene(document), "a", "b", "--json").stdout)
        self.assertEqual((found["distance"], found["b"]), (3, "b/near (sphere)"))
        found = json.loads(self.succeed("distance", self.scene(document), "a", "b/0", "--json").stdout)
        self.assertEqual(found["distance"], 7)

    def test_mistakes(self):
        plane = {"kind": "plane", "normal": [0, 0, 1]}
        scene = self.scene(scene_of())
        for arguments, words in (
            ([], ("no argument is given", "abut distance [SCENE] A B")),
            (["sphere", "box"], ("A is 'sphere'", '{"kind": "sphere", "radius": 1}')),
            ([json.dumps(BALL), "{"], ("the command line: line 1, column 2",)),
            ([json.dumps({"kind": "orb"}), json.dumps(BALL)], ('A.kind is "orb"', "sphere, box")),
            ([json.dumps(BALL), json.dumps({**self.BOX, "mass": 1})], ("B.mass is 1", "pose, shape")),
            ([json.dumps(plane), json.dumps(plane)], ("plane and plane have no distance", "abut pairs")),
            ([scene, "a", "c"], ("there is no geometry 'c'", "there are: a, b")),
            ([scene, "a", "b/1"], ("there is no geometry 'b/1'", "there are: b/0; did you mean 'b/0'?")),
        ):
            with self.subTest(arguments=arguments):
                result = run("distance", *arguments)
                self.assertEqual(result.returncode, 1)
                self.assertRegex(result.stderr, r"^[ -~]+\n$")
                for word in words:
                    self.assertIn(word, result.stderr)


class Pairs(program.Case):
    def test_kinds_that_meet(self):
        rows = json.loads(self.succeed("pairs", "--json").stdout)
        kinds = list(json.loads(self.succeed("shapes", "--json").stdout))
        self.assertEqual(len(rows), len(kinds) * (len(kinds) + 1) // 2)
        never = {frozenset((r["a"], r["b"])) for r in rows if not r["contacts"]}
        self.assertIn(frozenset(("plane",)), never)
        self.assertNotIn(frozenset(("plane", "height_field")), never)
        self.assertNotIn(frozenset(("plane", "mesh")), never)
        lines = self.succeed("pairs").stdout.splitlines()
        self.assertEqual([line.split()[1] for line in lines[1:len(kinds) + 1]], kinds)
        self.assertEqual(sum(line.split().count("-") for line in lines[1:len(kinds) + 1]),
                         sum(1 if len(pair) == 1 else 2 for pair in never))

    def test_pairs_of_a_scene_are_those_of_the_universe(self):
        # What the program computes from the scene by itself agrees with what the universe did.
        for scene in sorted(program.SCENES.glob("*.json")):
            with self.subTest(scene=scene.name):
                contacts = self.contacts(scene, "--steps", 1)
                touching = {(f'{c["part_a"]}/{c["geometry_a"]}', f'{c["part_b"]}/{c["geometry_b"]}') for c in contacts}
                rows = json.loads(self.succeed("pairs", scene, "--json").stdout)
                self.assertEqual({(r["a"], r["b"]) for r in rows if r["touch"]}, touching)
                self.assertEqual(sum(r["contacts"] for r in rows), len(contacts))
                self.assertNotIn("detection", {r["stopped_by"] for r in rows}, "every pair that is apart has its reason")

    def test_pairs_with_element_contacts_touch(self):
        scene = program.SCENES / "table.json"
        out = self.folder / "elements.json"
        self.succeed("run", scene, "--quiet", "--elements", out)
        count = len(json.loads(out.read_text()))
        rows = json.loads(self.succeed("pairs", scene, "--steps", 3, "--json").stdout)
        found, = (row for row in rows if (row["a"], row["b"]) == ("cloth/0", "table/0"))
        self.assertEqual((found["touch"], found["contacts"], found["element_contacts"]), (True, 0, count))
        self.assertIn(f"touch at step 3: {count} element contacts", self.succeed("check", scene, "cloth", "table", "--steps", 3).stdout)
        self.assertRegex(self.succeed("pairs", scene, "--steps", 3).stdout, rf"yes +{count} elements")
        # Before, the sheet is farther away than the policy looks.
        self.assertIn("do not touch at step 2: distance", self.succeed("check", scene, "cloth", "table", "--steps", 2).stdout)

    def test_the_text_ends_with_counts(self):
        text = self.succeed("pairs", program.SCENES / "filters.json").stdout
        self.assertIn("16 pairs of boxes overlap at step 1; 5 of them touch", text)
        self.assertRegex(text, r"cart/0 \(box\) +trailer/box \(box\) +no +0 +-0.09\d+ +rules\n")


class Explain(program.Case):
    def test_filters_that_keep_pairs_apart_are_counted(self):
        scene = program.SCENES / "filters.json"
        plan = json.loads(self.succeed("explain", scene, "--json").stdout)
        kept = {row["by"]: row["pairs"] for row in plan["kept_apart"]}
        self.assertEqual(kept, {"motion": 1, "parking": 1, "exclusion": 1, "layers": 1, "rules": 2})
        self.assertEqual(kept["exclusion"] + kept["layers"] + kept["rules"], plan["counts"]["filtered_pairs"])
        text = self.succeed("explain", scene).stdout
        self.assertIn("rules: 2 pairs, such as cart/0 and trailer/box", text)

    def test_pairs_of_kinds_have_a_time(self):
        plan = json.loads(self.succeed("explain", program.SCENES / "stack.json", "--json").stdout)
        self.assertTrue(plan["pairs_of_kinds"])
        for row in plan["pairs_of_kinds"]:
            self.assertGreater(row["microseconds"], 0, row)


if __name__ == "__main__":
    program.main()
