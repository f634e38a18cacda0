# SPDX-License-Identifier: Apache-2.0
"""What the command line program writes: contacts and events, the same in every form and in every run.

usage: check_output.py ABUT DIRECT SCENES
"""

import csv
import io
import json
import os
import subprocess
import unittest

import program
from program import run

FIELDS = ("id", "feature_index_a", "feature_index_b", "point_a", "point_b", "normal", "distance", "age")


def rows_of(text):
    return [{name: program.number_or_text(value) for name, value in row.items()} for row in csv.DictReader(io.StringIO(text))]


def flat(record):
    """A record of JSON as a row of a CSV has it."""
    row = {}
    for name, value in record.items():
        if isinstance(value, list):
            row.update({f"{name}_{axis}": number for axis, number in zip("xyz", value)})
        elif isinstance(value, bool):
            row[name] = int(value)
        else:
            row[name] = program.number_or_text(value) if isinstance(value, str) else value
    return row


class Output(program.Case):
    def test_csv_and_json_hold_the_same(self):
        for scene in sorted(program.SCENES.glob("*.json")):
            with self.subTest(scene=scene.name):
                for what in ("contacts", "events") if scene.name != "table.json" else ("contacts", "elements", "events"):
                    table, records = self.folder / f"{what}.csv", self.folder / f"{what}.json"
                    self.succeed("run", scene, "--quiet", f"--{what}", table)
                    self.succeed("run", scene, "--quiet", f"--{what}", records)
                    rows = rows_of(table.read_text())
                    self.assertEqual(rows, [flat(r) for r in json.loads(records.read_text())])
                    self.assertGreater(len(rows), 0)

    def test_contacts_are_those_of_the_c_interface(self):
        direct = subprocess.run([program.DIRECT], capture_output=True, text=True, check=True).stdout.splitlines()
        expected = [[program.number_or_text(word) for word in line.split()] for line in direct[:-1]]
        scene = program.SCENES / "stack.json"
        found = []
        for contact in self.contacts(scene, "--steps", 2):
            row = []
            for field in FIELDS:
                row += contact[field] if isinstance(contact[field], list) else [contact[field]]
            found.append(row)
        self.assertEqual(len(expected), 24)
        self.assertEqual(found, expected)
        summary = json.loads(self.succeed("run", scene, "--steps", 2, "--json").stdout)
        self.assertEqual(summary["hash"], direct[-1])

    def test_elements_are_the_sheet_above_the_table(self):
        # In the third step the sheet is at a height of 0.8 to 0.89, above a face at 0.7.
        out = self.folder / "elements.json"
        self.succeed("run", program.SCENES / "table.json", "--quiet", "--elements", out)
        found = json.loads(out.read_text())
        self.assertEqual({row["step"] for row in found}, {3})
        lines = (program.SCENES / "cloth2.ply").read_text().split("end_header\n")[1].splitlines()
        sheet = [tuple(map(float, line.split())) for line in lines[:16]]
        # The vertices of the sheet that are above the table, each once: above a triangle, or the diagonal between two.
        above = {i for i, place in enumerate(sheet) if abs(place[0]) <= 1.1 and abs(place[1]) <= 1.1}
        vertices = [row["vertex_0"] for row in found if row["kind"].startswith("vertex") and row["of_a"] == 1]
        self.assertEqual(sorted(vertices), sorted(above))
        self.assertEqual(len(above), 4)
        for row in found:
            self.assertEqual((row["part_a"], row["part_b"]), ("cloth", "table"))
            weights = [row[f"weight_{i}"] for i in range(4)]
            self.assertAlmostEqual(sum(weights[:row["of_a"]]), -1, delta=1e-12)
            self.assertAlmostEqual(sum(weights[row["of_a"]:]), 1, delta=1e-12)
            self.assertAlmostEqual(row["gap"], row["distance"] - 0.1, delta=1e-12)
            self.assertEqual((row["toi"], row["age"]), (0, 0))
            if row["of_a"] == 1:
                self.assertAlmostEqual(row["distance"], sheet[row["vertex_0"]][2] - 0.7, delta=1e-12)
                self.assertAlmostEqual(row["normal"][2], -1, delta=1e-12)
        self.assertEqual(len({row["id"] for row in found}), len(found))
        counts = json.loads(self.succeed("run", program.SCENES / "table.json", "--json").stdout)["counts"]["element_contacts"]
        self.assertEqual((counts["last"], counts["total"]), (len(found), len(found)))
        begins = [e["contact_id"] for e in self.events(program.SCENES / "table.json") if (e["of"], e["event"]) == ("element", "begin")]
        self.assertEqual(sorted(begins), sorted(row["id"] for row in found))

    def test_runs_and_threads_give_the_same_bytes(self):
        scene = program.SCENES / "scatter.json"
        files = []
        for threads in (1, 1, 3):
            contacts, events = self.folder / "contacts.csv", self.folder / "events.csv"
            self.succeed("run", scene, "--threads", threads, "--contacts", contacts, "--events", events)
            files.append((contacts.read_bytes(), events.read_bytes()))
        self.assertTrue(files[0] == files[1] == files[2])
        self.assertGreater(files[0][0].count(b"\n"), 1000)

    def test_names_with_separators_are_quoted(self):
        name = 'a "ball", round\u00e9'
        document = {"version": 1, "parts": [
            {"name": name, "geometries": [{"shape": {"kind": "sphere", "radius": 1}, "name": "x,y"}]},
            {"geometries": [{"shape": {"kind": "sphere", "radius": 1}}]}]}
        out = self.folder / "contacts.csv"
        self.succeed("run", self.scene(document), "--quiet", "--contacts", out)
        row, = rows_of(out.read_text(encoding="utf-8"))
        self.assertEqual((row["part_a"], row["geometry_a"], row["part_b"], row["geometry_b"]), (name, "x,y", "parts[1]", 0))
        self.assertEqual(self.contacts(self.scene(document))[0]["part_a"], name)

    def test_without_contacts_there_is_a_header_or_an_empty_list(self):
        scene = self.scene({"version": 1, "parts": []})
        out = self.folder / "none.csv"
        self.succeed("run", scene, "--contacts", out)
        self.assertEqual(out.read_text().count("\n"), 1)
        self.assertTrue(out.read_text().startswith("step,part_a,"))
        self.assertEqual(self.contacts(scene), [])

    def test_the_standard_output_can_take_contacts(self):
        scene = program.SCENES / "stack.json"
        result = self.succeed("run", scene, "--contacts", "-")
        self.assertEqual(len(rows_of(result.stdout)), 12)
        self.assertIn("hash of the last step", result.stderr)
        result = self.succeed("run", scene, "--contacts", "-", "--json", "--quiet")
        self.assertEqual(len(json.loads(result.stdout)), 12)
        self.assertEqual(result.stderr, "")

    def test_the_table_and_its_json(self):
        scene = program.SCENES / "grid.json"
        result = self.succeed("run", scene)
        self.assertEqual(result.stderr, "", "progress is for terminals")
        for word in ("401 parts", "1 steps", "candidate pairs", "touching pairs", "narrow phase", "hash of the last step"):
            self.assertIn(word, result.stdout)
        summary = json.loads(self.succeed("run", scene, "--json", "--steps", 3, "--dt", 0.5).stdout)
        self.assertEqual(summary["counts"]["contacts"], {"min": 1160, "mean": 1160, "max": 1160, "last": 1160, "total": 3480})
        self.assertEqual((summary["steps"], summary["dt"], summary["parts"]), (3, 0.5, 401))
        self.assertEqual(summary["counts"]["examined_pairs"]["last"], 0, "what stands still is not examined again")
        self.assertEqual(self.succeed("run", scene, "--quiet").stdout, "")

    def test_parts_fall_asleep(self):
        scene = json.loads((program.SCENES / "stack.json").read_text())
        self.assertNotIn("sleep", scene["parts"][1])
        path = self.folder / "asleep.json"
        for sleep, first in ((True, 12), ({"steps": 4, "linear_speed": 0}, 6), (False, 99)):
            scene["parts"][1]["sleep"] = sleep
            path.write_text(json.dumps(scene))
            events = json.loads(self.succeed("run", path, "--events", "-", "--json", "--quiet", "--steps", 14).stdout)
            self.assertEqual({e["step"] for e in events if e["asleep"]}, set(range(first, 15)))
            summary = json.loads(self.succeed("run", path, "--json", "--steps", 14).stdout)
            self.assertEqual(summary["counts"]["asleep"]["last"], 0 if first > 14 else 3)

    def test_a_terminal_sees_a_bar(self):
        try:
            ours, theirs = os.openpty()
        except OSError as error:
            raise unittest.SkipTest(f"there are no terminals here: {error}")
        with subprocess.Popen([program.ABUT, "run", program.SCENES / "stack.json"], stdout=subprocess.DEVNULL,
                              stderr=theirs) as process:
            os.close(theirs)
            shown = b""
            try:
                while part := os.read(ours, 4096):
                    shown += part
            except OSError:
                pass  # the end, as Linux reports it
        os.close(ours)
        self.assertIn(b"100%", shown)
        self.assertIn(b"[####", shown)

    def test_explain_prints_the_plan(self):
        scene = program.SCENES / "stack.json"
        text = self.succeed("explain", scene).stdout
        for word in ("broad phase", "box - plane", "12 contacts", "left out"):
            self.assertIn(word, text)
        plan = json.loads(self.succeed("explain", scene, "--json").stdout)
        self.assertEqual(plan["counts"]["contacts"], 12)
        self.assertEqual(json.loads(self.succeed("explain", scene, "--json", "--steps", 2).stdout)["counts"]["kept_pairs"],
                         plan["counts"]["candidate_pairs"])

    def test_explain_pair_prints_every_way_to_the_distance(self):
        scene = self.scene({"version": 1, "parts": [
            {"name": "a", "geometries": [{"shape": {"kind": "box", "half": [1, 1, 1]}}]},
            {"name": "b", "pose": {"position": [3.5, 0, 0]},
             "geometries": [{"name": "core", "shape": {"kind": "box", "half": [1, 1, 1]}}]}]})
        found = json.loads(self.succeed("explain", "pair", scene, "a", "b/core", "--json").stdout)
        self.assertEqual((found["a"]["name"], found["b"]["name"], found["b"]["kind"]), ("a/0", "b/core", "box"))
        ways = {way["ask"]: way for way in found["distances"]}
        self.assertEqual(ways["default"]["by"], "analytic")
        self.assertEqual(ways["algorithm gjk_epa"]["by"], "gjk_epa")
        self.assertIn("ABUT_ALGORITHM_SAT", ways["algorithm sat"]["refusal"])
        for way in ways.values():
            if "refusal" not in way:
                self.assertAlmostEqual(way["lower"], 1.5, places=6)
                self.assertAlmostEqual(way["upper"], 1.5, places=6)
                self.assertGreater(way["microseconds"], 0)
        text = self.succeed("explain", "pair", scene, "a", "b").stdout
        for word in ("a/0 (box) and b/core (box): 0 contacts", "algorithm sat", "analytic", "error_bound 1e-9"):
            self.assertIn(word, text)

    def test_explain_pair_tells_what_a_budget_takes(self):
        scene = self.scene({"version": 1, "parts": [
            {"name": "a", "geometries": [{"shape": {"kind": "cylinder", "radius": 1, "half_height": 1}}]},
            {"name": "b", "pose": {"position": [3.5, 0, 0]},
             "geometries": [{"shape": {"kind": "cone", "radius": 1, "half_height": 1}}]}]})
        table = self.folder / "routes.txt"
        table.write_text("# abut routes 1\ndistance cylinder cone auto 0 1e-06 1e-09\n"
                         "distance cylinder cone auto 0.01 2e-07 0.01\n")
        ask = ("explain", "pair", scene, "a", "b", "--routes", table)
        for options, chosen, words in (
                ((), None, "no time budget: the default, with no error bound"),
                (("--time-budget", "1e-3"), 0, "a time budget of 0.001 s and no error bound: auto with the default error bound"),
                (("--time-budget", "5e-7"), 1, "auto with an error bound of 0.01"),
                (("--time-budget", "1e-9"), 1, "nothing fits, so the cheapest, auto with an error bound of 0.01"),
                (("--time-budget", "5e-7", "--error-bound", "1e-4"), 0,
                 "nothing that keeps the bound fits, so the cheapest, auto with the error bound that is asked for"),
                (("--time-budget", "5e-7", "--error-bound", "1e-12"), None, "nothing keeps the bound by measure")):
            with self.subTest(options=options):
                text = self.succeed(*ask, *options).stdout
                self.assertIn(words, text)
                self.assertIn("nobody has measured this pair of kinds", text, "of contacts there is no row")
                told = json.loads(self.succeed(*ask, *options, "--json").stdout)["routes"]["distance"]
                self.assertEqual([i for i, route in enumerate(told["routes"]) if route["taken"]],
                                 [] if chosen is None else [chosen])
                self.assertIn(words, told["choice"])
        table.write_text("none")
        self.assertIn("routes.txt: text: line 1 is 'none'", run(*ask).stderr)
        self.assertEqual(run("explain", "pair", scene, "a", "b", "--routes", self.folder / "no").returncode, 1)

    def test_tune_writes_what_explain_reads(self):
        table = self.folder / "routes.txt"
        self.succeed("tune", table)
        rows = [line.split() for line in table.read_text().splitlines() if not line.startswith("#")]
        self.assertEqual({row[0] for row in rows}, {"distance", "contacts"})
        bounds = {1e-13, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2}
        for row in rows:
            bound, seconds, worst = map(float, row[4:])
            self.assertTrue(1e-9 < seconds < 1e-2, row)
            self.assertIn(worst, bounds, row)
            self.assertTrue(bound == 0 or worst <= bound, row)
        self.assertIn("0.01", {row[4] for row in rows}, "of curved shapes a coarse bound is cheaper")
        told = json.loads(self.succeed("explain", "pair", program.SCENES / "stack.json", "crate[0][0][0]", "crate[0][0][1]", "--routes", table,
                                       "--json").stdout)["routes"]["contacts"]["routes"]
        self.assertEqual([route["seconds"] for route in told],
                         [float(row[5]) for row in rows if row[:3] == ["contacts", "box", "box"]])

    def test_shapes_lists_all_kinds(self):
        text = self.succeed("shapes").stdout
        kinds = json.loads(self.succeed("shapes", "--json").stdout)
        self.assertEqual([line.split()[0] for line in text.splitlines()], list(kinds))
        self.assertEqual([p["name"] for p in kinds["capsule"]["parameters"]], ["radius", "half_height"])
        self.assertIn("triangles", kinds["mesh"]["arrays"])

    def test_help_and_version(self):
        self.assertIn("usage: abut run", self.succeed("--help").stdout)
        self.assertIn("usage: abut run", self.succeed("run", "--help").stdout)
        self.assertRegex(self.succeed("--version").stdout, r"^abut \d+\.\d+\.\d+\n$")


class Failing(program.Case):
    def test_a_folder_that_is_missing_is_named(self):
        for option in ("--contacts", "--elements", "--events"):
            result = run("run", program.SCENES / "stack.json", option, self.folder / "none" / "out.csv")
            self.assertEqual(result.returncode, 3)
            self.assertIn(str(self.folder / "none" / "out.csv"), result.stderr)
            self.assertIn("No such file or directory", result.stderr)
            self.assertEqual(result.stdout, "")

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs a device that is always full")
    def test_a_full_device_is_reported(self):
        for scene in ("stack.json", "grid.json"):
            result = run("run", program.SCENES / scene, "--contacts", "/dev/full")
            self.assertEqual(result.returncode, 3)
            self.assertIn("cannot write all of /dev/full: No space left on device", result.stderr)
        with open("/dev/full", "w", encoding="utf-8") as full:
            for arguments in (("shapes",), ("explain", program.SCENES / "stack.json"), ("--help",)):
                result = subprocess.run([program.ABUT, *arguments], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
                self.assertEqual(result.returncode, 3, arguments)
                self.assertIn("cannot write all of the standard output", result.stderr)

    def test_what_failed_leaves_the_file_as_it_was(self):
        out = self.folder / "contacts.csv"
        out.write_text("before")
        # The scripts of this scene leave what a number can hold.
        scene = self.scene({"version": 1, "dt": 1e300, "steps": 5, "parts": [
            {"name": "runaway", "script": {"velocity": [1e10, 0, 0]},
             "geometries": [{"shape": {"kind": "sphere", "radius": 1}}]}]})
        result = run("run", scene, "--contacts", out)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("the scripts at step 2", result.stderr)
        self.assertEqual(out.read_text(), "before")
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["contacts.csv", "scene.json"])

    def test_a_file_is_replaced_as_a_whole(self):
        out = self.folder / "contacts.csv"
        out.write_text("before")
        self.succeed("run", program.SCENES / "stack.json", "--contacts", out)
        self.assertTrue(out.read_text().startswith("step,"))
        self.assertEqual([p.name for p in self.folder.iterdir()], ["contacts.csv"])


if __name__ == "__main__":
    program.main()
