# SPDX-License-Identifier: Apache-2.0
"""`abut lean` names the shapes and features of a scene. That such a build gives the same bits is the test `lean`.

usage: check_lean.py ABUT DIRECT SCENES
"""

import json

import program
from program import SCENES, run

BALL, BOX = {"kind": "sphere", "radius": 1}, {"kind": "box", "half": [1, 1, 1]}
HULL = {"kind": "hull", "points": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]}
GRID = {"kind": "uv_grid", "axis_u": 0, "axis_v": 1, "cells_u": 1, "cells_v": 1, "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
        "triangles": [[0, 1, 2]]}


class Lean(program.Case):
    def named(self, of_parts, **more):
        parts = [{"geometries": [{"shape": shape}]} for shape in of_parts]
        found = json.loads(self.succeed("lean", self.scene({"version": 1, "parts": parts} | more), "--json").stdout)
        self.assertIn(f'"ABUT_SHAPES={";".join(found["shapes"])}"', found["line"])
        self.assertIn(f'"ABUT_FEATURES={";".join(found["features"])}"', found["line"])
        return found["shapes"], found["features"]

    def test_shapes_are_named_once(self):
        self.assertEqual(self.named([BOX, BALL, BALL]), (["sphere", "box"], ["universe"]))

    def test_children_of_composites_count(self):
        self.assertEqual(self.named([{"kind": "composite", "children": [{"shape": BALL}]}])[0], ["sphere", "composite"])

    def test_shapes_that_no_part_has_count(self):
        self.assertEqual(self.named([BALL], shapes={"spare": BOX})[0], ["sphere", "box"])

    def test_a_grid_is_a_mesh(self):
        self.assertEqual(self.named([GRID])[0], ["mesh"])

    def test_a_hull_needs_its_feature(self):
        self.assertEqual(self.named([HULL]), (["hull"], ["universe", "hull"]))

    def test_threads_and_libccd_are_named_where_the_scene_asks(self):
        self.assertEqual(self.named([BALL], universe={"threads": 4})[1], ["universe", "threads"])
        self.assertEqual(self.named([BALL], policies=[{"tags": [0, 0], "algorithm": "libccd_mpr"}])[1], ["universe", "libccd"])

    def test_motion_and_deforming_are_named_where_the_scene_asks(self):
        for flag in ("fast", "speculative"):
            scene = {"version": 1, "parts": [{"geometries": [{"shape": BALL, flag: True}]}]}
            found = json.loads(self.succeed("lean", self.scene(scene), "--json").stdout)
            self.assertEqual(found["features"], ["universe", "motion"])
        self.assertEqual(self.named([BALL], policies=[{"tags": [0, 0], "detail": "elements"}])[1], ["universe", "deforming"])

    def test_a_response_is_named_where_the_scene_has_one(self):
        self.assertEqual(self.named([BALL], dt=0.01, response={})[1], ["universe", "response"])
        self.assertEqual(self.named([BALL], dt=0.01, response={"impacts": True})[1], ["universe", "motion", "response"])

    def test_the_line_is_what_is_printed(self):
        self.assertEqual(self.succeed("lean", SCENES / "stack.json").stdout,
                         'cmake --preset release -B build/lean-scene -D "ABUT_SHAPES=box;plane" -D "ABUT_FEATURES=universe" -D ABUT_WARNINGS=OFF '
                         "-D ABUT_TESTS=OFF -D ABUT_TOOLS=OFF -D ABUT_BENCH=OFF\n")

    def test_a_scene_without_shapes_is_refused(self):
        result = run("lean", self.scene({"version": 1, "parts": []}))
        self.assertEqual(result.returncode, 1)
        self.assertIn("has no shapes", result.stderr)


if __name__ == "__main__":
    program.main()
