# SPDX-License-Identifier: Apache-2.0
"""Runs the benchmark of errors on a few pairs and checks what it writes. No time is judged.

usage: check_accuracy.py PROGRAM
"""

import csv
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

program = ""

BOUNDS = {"abut 1e-2": 1e-2, "abut 1e-4": 1e-4, "abut 1e-6": 1e-6, "abut 1e-9": 1e-9, "abut 1e-12": 1e-12}
# What coordinates of 53 bits leave, relative to the size.
ROUNDING = 1e-13
SVG = "{http://www.w3.org/2000/svg}"


def run(*arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=False)


class Accuracy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.folder.name) / "new" / "folder"
        cls.result = run("--out", str(cls.out), "--cases", "3", "--repetitions", "1", "--only", "/ordinary/")
        cls.rows = []
        if (cls.out / "accuracy.csv").exists():
            with open(cls.out / "accuracy.csv", newline="", encoding="ascii") as file:
                cls.rows = list(csv.DictReader(file))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def of(self, question, contender):
        return [row for row in self.rows if (row["question"], row["contender"]) == (question, contender)]

    def test_it_succeeds_and_prints_the_tables(self):
        self.assertEqual(self.result.returncode, 0, self.result.stderr)
        for words in ("distance, ordinary", "depth, ordinary", "abut 1e-12", "bullet", "fcl", "ns of abut for each error bound"):
            self.assertIn(words, self.result.stdout)

    def test_every_pair_with_an_oracle_is_asked(self):
        self.assertEqual(len(self.of("distance", "abut")), 21)
        # Depths of cylinders in boxes, cylinders and hulls are left out.
        self.assertEqual(len(self.of("depth", "abut")), 17)

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

    def test_coarse_bounds_are_made_use_of(self):
        # Where a search ends sooner with them; closed forms answer as well as ever.
        errors = [float(row["worst_error"]) for row in self.of("distance", "abut 1e-2")]
        self.assertGreater(max(errors), 1e-4)

    def test_single_precision_is_seen(self):
        errors = [float(row["worst_error"]) for row in self.of("distance", "bullet")]
        self.assertGreater(max(errors), 1e-9)

    def test_peers_have_no_intervals(self):
        self.assertEqual({row["outside"] for row in self.of("distance", "fcl")}, {""})

    def test_pictures_have_a_mark_for_each_contender(self):
        for question in ("distance", "depth"):
            root = xml.etree.ElementTree.parse(self.out / f"{question}.svg").getroot()
            words = {element.text for element in root.iter(f"{SVG}text")}
            for row in self.rows:
                if row["question"] == question:
                    self.assertIn(row["contender"], words)
            # In the panel and in the legend.
            rings = [element for element in root.iter(f"{SVG}circle") if element.get("fill") == "#c6dbef"]
            self.assertEqual(len(rings), 2)

    def test_mistakes_are_named(self):
        for arguments, word in ((["--cases", "0"], "--cases"), (["--cases"], "--cases"), (["--colour", "red"], "--colour"),
                                (["--only", "nothing"], "--only is 'nothing'")):
            result = run(*arguments)
            self.assertNotEqual(result.returncode, 0)
            self.assertIn(word, result.stderr)
        self.assertIn("usage", run("--help").stdout)


if __name__ == "__main__":
    program = sys.argv.pop(1)
    unittest.main()
