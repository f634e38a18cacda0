# SPDX-License-Identifier: Apache-2.0
"""Scenes with a response: bodies that gravity and contacts move, what is written of them, and its picture.

usage: check_motion.py ABUT DIRECT SCENES
"""

import csv
import json
import math
import shutil
import unittest

import program
from program import SCENES, run

GRAVITY = 9.81
FLOOR = {"name": "floor", "motion": "static", "geometries": [{"shape": {"kind": "plane", "normal": [0, 0, 1]}, "tolerance": 1e-3}]}


def ball(height, radius=0.5, **more):
    return {"name": "ball", "pose": {"position": [0, 0, height]},
            "geometries": [{"shape": {"kind": "sphere", "radius": radius}, "tolerance": 1e-3}]} | more


def document(parts, steps, dt=0.01, response=None, **more):
    return {"version": 1, "steps": steps, "dt": dt, "universe": {"tolerance_mode": "margin"}, "response": response or {},
            "parts": parts} | more


class Motion(program.Case):
    def written(self, scene, option):
        out = self.folder / f"{option}.json"
        path = self.scene(scene) if isinstance(scene, dict) else scene
        self.succeed("run", path, "--quiet", f"--{option}", out)
        return json.loads(out.read_text(encoding="utf-8"))

    def refused(self, scene):
        result = run("run", self.scene(scene), "--quiet")
        self.assertEqual(result.returncode, 1, result.stderr)
        return result.stderr

    def test_a_free_ball_falls_along_a_parabola(self):
        steps, dt = 50, 0.01
        states = self.written(document([ball(100)], steps, dt), "states")
        self.assertEqual([row["step"] for row in states], list(range(1, steps + 1)))
        for row in states:
            time = row["step"] * dt
            self.assertAlmostEqual(row["time"], time, delta=1e-12)
            self.assertAlmostEqual(row["velocity"][2], -GRAVITY * time, delta=1e-12)
            self.assertAlmostEqual(row["position"][2], 100 - GRAVITY * time * time / 2, delta=1e-10)
            self.assertEqual(row["part"], "ball")

    def test_a_mass_and_a_density_give_the_momentum(self):
        mass = 4 / 3 * math.pi * 0.5**3 * 700
        for weight, expected in (({"mass": 3}, 3), ({"density": 700}, mass), ({}, mass / 0.7)):
            moving = ball(9, velocity={"linear": [2, 0, 0]}, **weight)
            row = self.written(document([moving], 1, response={"gravity": [0, 0, 0]}), "motion")[0]
            self.assertAlmostEqual(row["momentum"][0], 2 * expected, delta=1e-9 * expected)
            self.assertAlmostEqual(row["kinetic"], 2 * expected, delta=1e-9 * expected)
            self.assertEqual((row["contacts"], row["deepest"]), (0, 0))

    def test_friction_stops_a_box_as_coulomb_says(self):
        box = {"name": "box", "pose": {"position": [0, 0, 0.25]}, "velocity": {"linear": [1, 0, 0]},
               "geometries": [{"shape": {"kind": "box", "half": [0.5, 0.5, 0.25]}, "tolerance": 1e-3, "material": "wood"}]}
        scene = document([FLOOR, box], 100, dt=0.002, materials={"wood": 3},
                         material_pairs=[{"materials": ["wood", 0], "friction": 0.4}])
        for row in self.written(scene, "states"):
            self.assertAlmostEqual(row["velocity"][0], max(0, 1 - 0.4 * GRAVITY * row["time"]), delta=1e-6)

    def test_a_tower_stands(self):
        motion = self.written(SCENES / "tower.json", "motion")
        self.assertLess(motion[-1]["residual"], 1e-6)
        self.assertLess(motion[-1]["deepest"], 1e-4)
        states = [row for row in self.written(SCENES / "tower.json", "states") if row["step"] == 400]
        boxes = [row for row in states if row["part"].startswith("box")]
        for height, row in zip((0.25, 0.75, 1.25, 1.75), boxes, strict=True):
            self.assertAlmostEqual(row["position"][2], height, delta=2e-3)
            self.assertLess(max(map(abs, row["velocity"])), 1e-3)

    def test_csv_and_the_same_bits(self):
        outs = [self.folder / name for name in ("a.csv", "b.csv")]
        for out in outs:
            self.succeed("run", SCENES / "tower.json", "--quiet", "--steps", 20, "--motion", out)
        self.assertEqual(outs[0].read_bytes(), outs[1].read_bytes())
        rows = list(csv.DictReader(outs[0].read_text(encoding="utf-8").splitlines()))
        self.assertEqual(len(rows), 20)
        self.assertIn("momentum_z", rows[0])

    def test_scenes_without_bodies_have_no_states(self):
        for option in ("--states", "--motion"):
            result = run("run", SCENES / "stack.json", option, self.folder / "out.csv")
            self.assertEqual(result.returncode, 1)
            self.assertIn(f"{option} is '{self.folder / 'out.csv'}'; the scene has no response", result.stderr)
            self.assertFalse((self.folder / "out.csv").exists())

    def test_mistakes_are_named(self):
        for change, told in (({"dt": 0}, "dt above 0"), ({"response": {"gravity": 1}}, "response.gravity"),
                             ({"response": {"solver": "magic"}}, "response.solver"),
                             ({"response": {"slop": -1}}, "response.slop"),
                             ({"material_pairs": [{"materials": [1]}]}, "material_pairs[0].materials"),
                             ({"material_pairs": [{"materials": [1, 2], "friction": -1}]}, "material_pairs[0].friction"),
                             ({"parts": [ball(1, mass=1, density=1)]}, "parts[0].mass"),
                             ({"parts": [ball(1, mass=0)]}, "parts[0].mass")):
            with self.subTest(change=change):
                self.assertIn(told, self.refused(document([ball(1)], 1) | change))
        flat = {"name": "sheet", "geometries": [{"shape": {"kind": "plane", "normal": [0, 0, 1]}}]}
        self.assertIn("the body sheet", self.refused(document([flat], 1)))

    @unittest.skipUnless(shutil.which("python3"), "there is no python3, which draws")
    def test_plot_draws(self):
        motion = self.folder / "motion.csv"
        self.succeed("run", SCENES / "tower.json", "--quiet", "--steps", 60, "--motion", motion)
        for name, begin in (("motion.png", b"\x89PNG"), ("motion.svg", b"<?xml")):
            result = run("plot", motion, self.folder / name)
            if "no python3 in PATH has Matplotlib" in result.stderr:
                self.skipTest(result.stderr)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertTrue((self.folder / name).read_bytes().startswith(begin))
        for arguments, told in (((motion, self.folder / "motion.txt"), "expected a name that ends in .png"),
                                ((self.folder / "none.csv", self.folder / "a.png"), "cannot be read"),
                                ((SCENES / "stack.json", self.folder / "a.png"), "is not what abut run --motion writes")):
            result = run("plot", *arguments)
            self.assertEqual(result.returncode, 1, result.stderr)
            self.assertIn(told, result.stderr)
        self.assertFalse((self.folder / "a.png").exists())


if __name__ == "__main__":
    program.main()
