# SPDX-License-Identifier: Apache-2.0
"""`abut report` draws by the Python of tools/report, and says what is missing.

usage: check_report.py ABUT DIRECT SCENES
"""

import json
import os
import shutil
import subprocess
import unittest

import program

REPORT = {"version": 1, "machine": {"processor": "one"},
          "universe": {"rows": [{"scene": "pile", "contender": "abut", "milliseconds": 6.0}]}}
DRAWS = any(subprocess.run([os.path.join(folder, "python3"), "-c", "import jinja2, matplotlib"], capture_output=True, check=False).returncode == 0
            for folder in os.environ["PATH"].split(":") if os.access(os.path.join(folder, "python3"), os.X_OK))


class Report(program.Case):
    def run_with(self, path, *arguments):
        return subprocess.run([program.ABUT, "report", *map(str, arguments)], capture_output=True, text=True, check=False,
                              env=os.environ | {"PATH": str(path)})

    @unittest.skipUnless(DRAWS, "there is no Python with Matplotlib and Jinja2")
    def test_a_report_is_drawn(self):
        path = self.scene(REPORT, "report.json")
        result = self.run_with(os.environ["PATH"], path, "--out", self.folder / "page")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("6 ms", (self.folder / "page" / "index.html").read_text(encoding="utf-8"))

    @unittest.skipUnless(DRAWS, "there is no Python with Matplotlib and Jinja2")
    def test_what_got_slower_is_told_by_the_exit_status(self):
        slow = json.loads(json.dumps(REPORT))
        slow["builds"] = {"rows": [{"name": "release", "bytes": 9, "stripped_bytes": 9, "start_milliseconds": 1, "resident_bytes": 9,
                                    "step_microseconds": 1, "libraries": []}]}
        old = json.loads(json.dumps(slow))
        old["builds"]["rows"][0]["bytes"] = 5
        paths = [self.scene(one, name) for one, name in ((slow, "new.json"), (old, "old.json"))]
        result = self.run_with(os.environ["PATH"], paths[0], "--compare", paths[1], "--out", self.folder / "page")
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assertIn("bytes of release is 9, it was 5", result.stdout)

    @unittest.skipUnless(DRAWS, "there is no Python with Matplotlib and Jinja2")
    def test_wrong_reports_and_builds_are_bad_input(self):
        for arguments, word in (((self.scene("{", "broken.json"),), "is no JSON"), (("--build", self.folder), "has no folder bench")):
            result = self.run_with(os.environ["PATH"], *arguments)
            self.assertEqual(result.returncode, 1)
            self.assertIn(word, result.stderr)

    def test_without_python_the_error_says_so(self):
        result = self.run_with(self.folder, "report.json")
        self.assertEqual(result.returncode, 1)
        self.assertIn(f"needs python3, of which PATH, '{self.folder}', has none", result.stderr)

    def test_a_python_without_packages_is_told(self):
        python = self.folder / "python3"
        python.write_text("#!/bin/sh\nexit 1\n", encoding="utf-8")
        python.chmod(0o755)
        result = self.run_with(self.folder, "report.json")
        self.assertEqual(result.returncode, 1)
        self.assertIn("python3-matplotlib and python3-jinja2", result.stderr)

    def test_a_program_without_its_drawing_says_so(self):
        alone = self.folder / "bin" / "abut"
        alone.parent.mkdir()
        shutil.copy(program.ABUT, alone)
        python = self.folder / "python3"
        python.write_text("#!/bin/sh\nexit 0\n", encoding="utf-8")
        python.chmod(0o755)
        result = subprocess.run([alone, "report", "report.json"], capture_output=True, text=True, check=False, env={"PATH": str(self.folder)})
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn(f"{self.folder}/share/abut/report/report.py is missing", result.stderr)


if __name__ == "__main__":
    program.main()
