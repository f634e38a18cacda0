# SPDX-License-Identifier: Apache-2.0
"""What the tests of the command line program share."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ABUT, DIRECT, SCENES = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])


def run(*arguments):
    return subprocess.run([ABUT, *map(str, arguments)], capture_output=True, text=True, check=False)


def number_or_text(text):
    try:
        return int(text)
    except ValueError:
        try:
            return float(text)
        except ValueError:
            return text


class Case(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def scene(self, document, name="scene.json"):
        path = self.folder / name
        path.write_text(document if isinstance(document, str) else json.dumps(document), encoding="utf-8")
        return path

    def succeed(self, *arguments):
        result = run(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def contacts(self, scene, *arguments):
        """Contacts of all steps as a list of dictionaries."""
        out = self.folder / "contacts.json"
        self.succeed("run", scene, "--quiet", "--contacts", out, *arguments)
        return json.loads(out.read_text(encoding="utf-8"))

    def events(self, scene, *arguments):
        out = self.folder / "events.json"
        self.succeed("run", scene, "--quiet", "--events", out, *arguments)
        return json.loads(out.read_text(encoding="utf-8"))


def main():
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
