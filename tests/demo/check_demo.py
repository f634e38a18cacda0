# SPDX-License-Identifier: Apache-2.0
"""Runs abut-demo on a small scene and checks what it writes.

usage: check_demo.py PROGRAM DATA_FOLDER
"""

import csv
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

program = ""
data = ""


def run(*arguments):
    return subprocess.run([program, "--data", data, *arguments], capture_output=True, text=True, check=False)


def small_run(out, *arguments, seed=7):
    return run("--steps", "4", "--bodies", "60", "--size", "96x64", "--seed", str(seed), "--out", str(out), *arguments)


def rows_of(path):
    with open(path, newline="", encoding="ascii") as file:
        return list(csv.DictReader(file))


class Demo(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.folder.name) / "first"
        cls.result = small_run(cls.out)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_it_succeeds_and_prints_the_table(self):
        self.assertEqual(self.result.returncode, 0, self.result.stderr)
        for word in ("candidate pairs", "contacts", "element contacts", "narrow phase", "whole step", "cloth"):
            self.assertIn(word, self.result.stdout)

    def test_it_digs(self):
        # 3 m a step, in a bowl of half the volume of a cylinder with a radius of two cells of 74.4 m by 92.6 m.
        dug = float(re.search(r"excavation: ([0-9.]+) million", self.result.stdout)[1])
        self.assertAlmostEqual(dug, 4 * 3 * math.pi * 4 / 2 * 74.4 * 92.6 / 1e6, delta=0.03)

    def test_progress_goes_to_the_error_output_without_control_characters(self):
        self.assertIn("steps: 100%", self.result.stderr)
        self.assertNotIn("\r", self.result.stderr)

    def test_the_same_seed_gives_the_same_bytes_on_one_thread_and_on_all(self):
        again = pathlib.Path(self.folder.name) / "again"
        small_run(again, "--threads", "1")
        for name in ("contacts.csv", "cloth.csv", "steps.csv", "scene.png"):
            self.assertEqual((self.out / name).read_bytes(), (again / name).read_bytes(), name)

    def test_another_seed_gives_other_contacts(self):
        other = pathlib.Path(self.folder.name) / "other"
        small_run(other, seed=8)
        self.assertNotEqual((self.out / "contacts.csv").read_bytes(), (other / "contacts.csv").read_bytes())

    def test_there_is_a_row_for_each_contact_of_the_last_step(self):
        steps = rows_of(self.out / "steps.csv")
        contacts = rows_of(self.out / "contacts.csv")
        self.assertEqual(len(steps), 4)
        self.assertEqual(len(contacts), int(steps[-1]["contacts"]))
        self.assertTrue(all(row["step"] == "4" for row in contacts))

    def test_every_body_touches_the_terrain(self):
        contacts = rows_of(self.out / "contacts.csv")
        touching = {row["body_b"] if row["body_a"] == "0" else row["body_a"] for row in contacts
                    if "0" in (row["body_a"], row["body_b"])}
        self.assertEqual(touching, {str(body) for body in range(1, 61)})

    def test_contacts_keep_what_the_header_promises(self):
        for row in rows_of(self.out / "contacts.csv"):
            a, b = ([float(row[f"point_{side}_{axis}_m"]) for axis in "xyz"] for side in "ab")
            normal = [float(row[f"normal_{axis}"]) for axis in "xyz"]
            distance = float(row["distance_m"])
            self.assertLess(distance, 0.0)
            self.assertAlmostEqual(math.hypot(*normal), 1.0, places=6)
            self.assertAlmostEqual(sum(n * (q - p) for n, p, q in zip(normal, a, b)), distance, delta=2e-5)
            self.assertNotEqual(row["body_a"], row["body_b"])

    def test_a_cloth_lies_on_the_bunny(self):
        # Within twice its thickness of 0.9 m; four steps are long enough to reach the ears, and too short for folds.
        rows = rows_of(self.out / "cloth.csv")
        self.assertGreater(len(rows), 3)
        self.assertEqual({row["other"] for row in rows}, {"statue"})
        self.assertEqual(len({row["contact_id"] for row in rows}), len(rows))
        for row in rows:
            normal = [float(row[f"normal_{axis}"]) for axis in "xyz"]
            self.assertAlmostEqual(math.hypot(*normal), 1.0, places=6)
            self.assertTrue(0.0 < float(row["distance_m"]) <= 1.8)
            self.assertAlmostEqual(float(row["gap_m"]), float(row["distance_m"]) - 0.9, places=5)

    def test_the_picture_has_the_size_asked_for(self):
        start = (self.out / "scene.png").read_bytes()[:24]
        self.assertEqual(start[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">II", start[16:24]), (96, 64))

    def test_a_film_has_a_picture_for_each_second_step(self):
        out = pathlib.Path(self.folder.name) / "film"
        self.assertEqual(small_run(out, "--film", "2").returncode, 0)
        self.assertEqual({path.name for path in (out / "film").iterdir()}, {"1.png", "2.png"})
        self.assertEqual((out / "film" / "2.png").read_bytes(), (out / "scene.png").read_bytes())
        self.assertNotEqual((out / "film" / "1.png").read_bytes(), (out / "scene.png").read_bytes())
        self.assertEqual((out / "contacts.csv").read_bytes(), (self.out / "contacts.csv").read_bytes())

    def test_bad_arguments_are_answered_in_one_line(self):
        for arguments, word in (
            (["--steps", "0"], "--steps"),
            (["--steps", "many"], "many"),
            (["--bodies", "-3"], "--bodies"),
            (["--bodies", "1e3"], "1e3"),
            (["--seed", ""], "--seed"),
            (["--threads", "1025"], "1025"),
            (["--film", "0"], "--film"),
            (["--size", "1280"], "--size"),
            (["--size", "1280x"], "--size"),
            (["--size", "9x9"], "9"),
            (["--colour", "red"], "--colour"),
            (["--out"], "--out"),
            (["--data", "there/is/no/such/folder"], "there/is/no/such/folder"),
        ):
            with self.subTest(arguments=arguments):
                result = run("--out", self.folder.name, *arguments)
                self.assertEqual(result.returncode, 1)
                self.assertIn(word, result.stderr)
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)

    def test_help_is_printed_and_nothing_is_run(self):
        result = run("--help")
        self.assertEqual(result.returncode, 0)
        self.assertIn("--bodies", result.stdout)


if __name__ == "__main__":
    program, data = sys.argv[1:3]
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
