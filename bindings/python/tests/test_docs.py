# SPDX-License-Identifier: Apache-2.0
"""The code in docs/python.md prints what stands below it, and the examples run. Needs NumPy."""

import contextlib
import importlib.util
import io
import pathlib
import re
import runpy
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGE = ROOT / "docs" / "python.md"


@unittest.skipUnless(importlib.util.find_spec("numpy"), "NumPy is not installed")
class Page(unittest.TestCase):
    def test_examples_run(self):
        for example in sorted((ROOT / "examples" / "python").glob("*.py")):
            printed = io.StringIO()
            with self.subTest(example.name), contextlib.redirect_stdout(printed):
                runpy.run_path(str(example))
            self.assertRegex(printed.getvalue(), "[1-9][0-9]* contacts|contact 0.25 deep", example.name)

    def test_code_prints_what_the_page_says(self):
        blocks = re.findall(r"```python\n(.*?)```\n```text\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
        self.assertGreater(len(blocks), 5)
        names = {}
        for code, expected in blocks:
            printed = io.StringIO()
            with self.subTest(code), contextlib.redirect_stdout(printed):
                exec(code, names)
            self.assertEqual(printed.getvalue(), expected, code)
        names["universe"].close()


if __name__ == "__main__":
    unittest.main()
