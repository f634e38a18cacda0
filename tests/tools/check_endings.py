# SPDX-License-Identifier: Apache-2.0
"""Scenes from the standard input, and runs that a signal or a reader ends early.

usage: check_endings.py ABUT DIRECT SCENES
"""

import json
import signal
import subprocess
import time

import program

# A run that no test waits for: two balls that stay in touch, with an event in each step.
ENDLESS = {"version": 1, "steps": 1_000_000_000, "parts": [
    {"name": name, "script": {"velocity": [1e-6, 0, 0]}, "geometries": [{"shape": {"kind": "sphere", "radius": 1}}]}
    for name in ("a", "b")]}


class Standard(program.Case):
    def run_with(self, text, *arguments):
        return subprocess.run([program.ABUT, *map(str, arguments)], input=text, capture_output=True, text=True, check=False,
                              cwd=self.folder)

    def test_a_scene_from_the_standard_input(self):
        for scene in ("stack.json", "filters.json"):
            text = (program.SCENES / scene).read_text()
            result = self.run_with(text, "run", "-", "--quiet", "--contacts", "-", "--json")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual(json.loads(result.stdout), self.contacts(program.SCENES / scene))

    def test_files_lie_in_the_working_folder_then(self):
        (self.folder / "points.txt").write_text("0 0 0 1 0 0 0 1 0 0 0 1")
        document = {"version": 1, "parts": [{"name": "a", "geometries": [{"shape": {"kind": "hull", "file": "points.txt"}}]}]}
        result = self.run_with(json.dumps(document), "check", "-")
        self.assertIn("the standard input: 1 part, 1 geometry", result.stdout)

    def test_mistakes_name_the_standard_input(self):
        result = self.run_with('{"version": 2}', "run", "-")
        self.assertEqual(result.returncode, 1)
        self.assertTrue(result.stderr.startswith("abut: the standard input: version is 2;"), result.stderr)

    def test_two_dashes_end_the_options(self):
        (self.folder / "-x.json").write_text((program.SCENES / "stack.json").read_text())
        self.assertEqual(self.run_with("", "run", "--quiet", "--", "-x.json").returncode, 0)


class Signals(program.Case):
    def started(self, *arguments):
        """A run that has begun to write, with the files that it writes."""
        process = subprocess.Popen([program.ABUT, "run", self.scene(ENDLESS), *arguments], stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, cwd=self.folder)
        for end in (process.stderr.close, process.stdout.close, process.wait, process.kill):
            self.addCleanup(end)  # the last one first
        deadline = time.monotonic() + 60
        while not (self.folder / "contacts.csv.part").exists():
            self.assertLess(time.monotonic(), deadline, "the run has not begun")
            time.sleep(0.01)
        return process

    def test_a_signal_leaves_the_files_as_they_were(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(signal=number):
                (self.folder / "contacts.csv").write_text("before")
                process = self.started("--contacts", "contacts.csv", "--events", "events.json")
                process.send_signal(number)
                _, told = process.communicate(timeout=60)
                self.assertEqual(process.returncode, 130, told)
                self.assertRegex(told, r"^abut: ended by " + number.name + r".* after step \d+ of 1000000000; files are as they "
                                 r"were before\n$")
                self.assertEqual((self.folder / "contacts.csv").read_text(), "before")
                self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["contacts.csv", "scene.json"])

    def test_a_signal_that_the_caller_ignores_is_ignored(self):
        before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
        self.addCleanup(signal.signal, signal.SIGHUP, before)
        process = self.started("--contacts", "contacts.csv")
        process.send_signal(signal.SIGHUP)
        process.send_signal(signal.SIGTERM)
        _, told = process.communicate(timeout=60)
        self.assertIn("ended by SIGTERM", told)

    def test_a_reader_that_goes_away_leaves_no_half_file(self):
        process = self.started("--contacts", "contacts.csv", "--events", "-")
        process.stdout.read(1)
        process.stdout.close()
        self.assertEqual(process.wait(60), 3)
        self.assertIn("cannot write all of the standard output: Broken pipe", process.stderr.read())
        self.assertEqual([p.name for p in self.folder.iterdir()], ["scene.json"])


if __name__ == "__main__":
    program.main()
