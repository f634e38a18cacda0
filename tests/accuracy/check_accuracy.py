# SPDX-License-Identifier: Apache-2.0
"""Runs the benchmark of errors on a few pairs and checks what it writes. No time is judged.

usage: check_accuracy.py PROGRAM ABUT
"""

import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools" / "report"))
import pairs  # noqa: E402

program, abut = "", ""

BOUNDS = {"abut 1e-2": 1e-2, "abut 1e-4": 1e-4, "abut 1e-6": 1e-6, "abut 1e-9": 1e-9, "abut 1e-12": 1e-12}
# What coordinates of 53 bits leave, relative to the size.
ROUNDING = 1e-13


# Kinds of many parts answer within an interval that no bound narrows.
PARTS = {"plane", "mesh", "height_field", "solid_mesh", "distance_field", "particles", "composite"}


def run(*arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False)


class Accuracy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.folder.name) / "new" / "folder"
        cls.result = run("--out", str(cls.out), "--cases", "3", "--repetitions", "1", "--only", "/ordinary/", "--json",
                         str(cls.out / "accuracy.json"))
        cls.rows = []
        if (cls.out / "accuracy.csv").exists():
            with open(cls.out / "accuracy.csv", newline="", encoding="ascii") as file:
                cls.rows = list(csv.DictReader(file))
            cls.json = json.loads((cls.out / "accuracy.json").read_text(encoding="utf-8"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def of(self, question, contender):
        """Rows of two convex shapes."""
        return [row for row in self.rows
                if (row["question"], row["contender"]) == (question, contender) and PARTS.isdisjoint(row["pair"].split("-"))]

    def test_it_succeeds_and_prints_the_tables(self):
        self.assertEqual(self.result.returncode, 0, self.result.stderr)
        for words in ("distance, ordinary", "depth, ordinary", "abut 1e-12", "bullet", "fcl", "ns of abut for each error bound"):
            self.assertIn(words, self.result.stdout)

    def test_every_pair_with_an_oracle_is_asked(self):
        self.assertEqual(len(self.of("distance", "abut")), 36)
        self.assertEqual(len(self.of("cast", "abut")), 36)
        # Depths of curved solids in boxes, hulls and each other are left out.
        self.assertEqual(len(self.of("depth", "abut")), 21)
        self.assertEqual(len(self.of("contacts", "abut")), 21)

    def test_all_contenders_are_there(self):
        for question, count in (("distance", 10), ("depth", 15)):
            self.assertEqual(len({row["contender"] for row in self.rows if row["question"] == question}), count)

    def test_errors_are_within_the_bounds_asked_for(self):
        for name, bound in BOUNDS.items():
            for question in ("distance", "depth"):
                for row in self.of(question, name):
                    with self.subTest(row=row):
                        self.assertLessEqual(float(row["worst_error"]), bound + ROUNDING)
                        self.assertEqual([row[key] for key in ("failed", "outside", "beyond", "wide")], ["0"] * 4)

    def test_intervals_of_many_parts_hold_the_truth(self):
        rows = [row for row in self.rows if row["contender"] == "abut" and row["question"] in ("distance", "depth")
                and not PARTS.isdisjoint(row["pair"].split("-"))]
        self.assertGreater(len(rows), 20)
        for row in rows:
            with self.subTest(row=row):
                self.assertEqual(row["outside"], "0")

    def test_coarse_bounds_are_made_use_of(self):
        # Where a search ends sooner with them; closed forms answer as well as ever.
        errors = [float(row["worst_error"]) for row in self.of("distance", "abut 1e-2")]
        self.assertGreater(max(errors), 1e-4)

    def test_single_precision_is_seen(self):
        errors = [float(row["worst_error"]) for row in self.of("distance", "bullet")]
        self.assertGreater(max(errors), 1e-9)

    def test_peers_have_no_intervals(self):
        self.assertEqual({row["outside"] for row in self.of("distance", "fcl")}, {""})

    def test_json_has_the_same_rows(self):
        self.assertEqual([(row["question"], row["pair"], row["contender"], row["cases"]) for row in self.json["rows"]],
                         [(row["question"], row["pair"], row["contender"], int(row["cases"])) for row in self.rows])
        for one, other in zip(self.json["rows"], self.rows):
            self.assertEqual(sum(one["failures"].values()), int(other["failed"]))
            self.assertEqual(f"{one['worst']:.1e}" if "worst" in one else "", other["worst_error"])

    def test_the_worst_pairs_are_what_was_asked(self):
        """The command of the report: the program abut finds the true distance."""
        path = {"PATH": str(pathlib.Path(abut).parent) + os.pathsep + os.environ["PATH"]}
        for row in self.json["rows"]:
            if row["contender"] != "fcl" or row["question"] not in ("distance", "depth"):
                continue
            with self.subTest(row=row):
                command = pairs.command(self.json, row["worst_pair"]) + " --json"
                result = subprocess.run(command, shell=True, env=os.environ | path, capture_output=True, text=True, check=False)
                self.assertEqual(result.returncode, 0, result.stderr)
                found = json.loads(result.stdout)["distances"][0]
                truth = self.json["pairs"][row["worst_pair"]]["truth"]
                self.assertLessEqual(found["lower"], truth + 1e-12)
                self.assertGreaterEqual(found["upper"], truth - 1e-12)

    def test_mistakes_are_named(self):
        for arguments, word in ((["--cases", "0"], "--cases"), (["--cases"], "--cases"), (["--colour", "red"], "--colour"),
                                (["--only", "nothing"], "--only is 'nothing'")):
            result = run(*arguments)
            self.assertNotEqual(result.returncode, 0)
            self.assertIn(word, result.stderr)
        self.assertIn("usage", run("--help").stdout)


if __name__ == "__main__":
    program, abut = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main()
